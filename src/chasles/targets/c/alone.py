"""Which C does one take away? For each kernel a header and a source, C99 that compiles without a warning of any kind.

There is no allocation, loop, recursion, macro or implicit conversion, truth values are `bool`, no operator's precedence
is relied on, and <math.h> and <stdbool.h> are all that is needed: MISRA C:2012 was in mind. Numbers are compared for
equality where the kernel asks whether one is zero.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from chasles.lowering.program import Op
from chasles.targets.c.functions import PRECISIONS, precisions_of, public_name, single
from chasles.targets.c.language import DIALECTS
from chasles.targets.constants import DOUBLE, Precision
from chasles.targets.dialect import Dialect, Level, Phrase
from chasles.targets.kernel import TargetKernel, signature
from chasles.targets.target import Page


def alone(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    """A header with the contract and a source for each kernel."""
    for kernel in kernels:
        functions = [single(kernel, precision, STRICT) for precision in precisions_of(kernel)]
        name = public_name(kernel, DOUBLE)
        values = {"name": name, "guard": name.upper(), "signature": signature(kernel.program), "functions": functions}
        for suffix in ("h", "c"):
            yield Page(f"{name}.{suffix}", f"alone.{suffix}.jinja", values)


def _dialect(precision: Precision) -> Dialect:
    def declare(name: str, text: str, truth: bool) -> str:
        return f"const {'bool' if truth else precision.name} {name} = {text};"

    # NAN is of type float, which is not to be widened by a choice.
    none = Phrase(f"({precision.name})NAN", Level.SIGN, ())
    plain = DIALECTS[precision]
    spell = {op: phrase if phrase.is_call else _parted(phrase) for op, phrase in plain.spell.items()}
    return replace(plain, spell={**spell, Op.NOT_A_NUMBER: none}, declare=declare)


def _parted(phrase: Phrase) -> Phrase:
    """The phrase with parentheses around every operation in it."""
    return replace(phrase, gaps=tuple(max(gap, Level.SIGN) for gap in phrase.gaps))


STRICT: Mapping[Precision, Dialect] = {precision: _dialect(precision) for precision in PRECISIONS}
"""C without implicit conversions."""
