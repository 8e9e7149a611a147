"""Loops over items, vectorised: a program spelled on registers, each of which holds a number of several items.

Nearly as in C.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from chasles.lowering.program import Op
from chasles.targets.c.language import RESERVED
from chasles.targets.constants import DOUBLE, SINGLE, Precision, literals
from chasles.targets.dialect import ARITHMETIC, Dialect, Level, Phrase, call, flat

_USED = """
    LANES LANESF GROUPS GROUPSF LIST LISTF SHUFFLE LOWER UPPER LOWERF UPPERF EVENF ODDF IN_ORDER IN_ORDERF
    doubles floats truths truthsf double_2 double_4 float_4 pair groups at steps stream copied angles sines cosines g i
    stream_lines prefetch prefetch_to_write packed is_packed
"""
_CALLED = """
    spread roots alike less equal choose row put_row sine_of cosine_of directions
    fabs_of load_1 load_2 load_3 load_4 store_1 store_2 store_3 store_4 store_all
    take_1 take_2 take_3 take_4 give_1 give_2 give_3 give_4
"""
_MOST_OPERANDS = 64
_NUMBERED = {
    f"{stem}{place}" for stem in ("at", "step", "down", "across", "item", "result") for place in range(_MOST_OPERANDS)
}
_RESERVED = RESERVED | {*_USED.split(), *_CALLED.split(), *(f"{word}f" for word in _CALLED.split())} | _NUMBERED
_NAME = re.compile(r"(?<![\w.])[A-Za-z_]")


def register(precision: Precision) -> str:
    """The type of a register of numbers."""
    return f"{precision.name}s"


def spread(text: str, precision: Precision) -> str:
    """The text, as a register even where it holds constants only."""
    return text if _NAME.search(text) else f"spread{precision.suffix}({text})"


def _dialect(precision: Precision) -> Dialect:
    suffix = precision.suffix
    spell: Mapping[Op, Phrase] = {
        **ARITHMETIC,
        Op.SQUARE_ROOT: call(f"roots{suffix}"),
        Op.SINE: call(f"sine_of{suffix}"),
        Op.COSINE: call(f"cosine_of{suffix}"),
        Op.ARCTANGENT2: call(f"directions{suffix}", 2),
        Op.LESS: call(f"less{suffix}", 2),
        Op.EQUAL: call(f"equal{suffix}", 2),
        Op.SELECT: call(f"choose{suffix}", 3),
        Op.NOT_A_NUMBER: Phrase(f"spread{suffix}(NAN)", Level.ATOM, ()),
    }

    def declare(name: str, text: str, truth: bool) -> str:
        kind = f"truths{suffix}" if truth else register(precision)
        return f"const {kind} {name} = {spread(text, precision)};"

    def function(name: str, operands: int) -> Phrase:
        return call(f"{name}_of{suffix}", operands)

    return Dialect(
        spell, literals(precision), flat, declare, _RESERVED, lift=f"spread{suffix}({{}})", function=function
    )


ON_REGISTERS: Mapping[Precision, Dialect] = {precision: _dialect(precision) for precision in (DOUBLE, SINGLE)}
