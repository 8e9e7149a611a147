"""Fractions that are derivatives: rates, partial derivatives, and others."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import NamedTuple

from chasles.reading.atoms import Atom, Atoms, said_of
from chasles.reading.commands import DOTS, FUNCTIONS, LETTERS, MARKS, WITH_LIMITS

SIGNS = ("d", "D", r"\partial", r"\delta", r"\Delta")
COMMAND = re.compile(r"\\[A-Za-z]+")
KNOWN = LETTERS | FUNCTIONS | WITH_LIMITS | {*DOTS}


class Derivative(NamedTuple):
    """What stands behind the sign above and below the stroke, and how often the derivative is taken; 0 is unclear."""

    sign: str
    order: int
    of: Atoms
    by: Atoms
    in_frame: bool = False

    @property
    def rate(self) -> int:
        """How many times it is the derivative by the time t; 0 if it is another."""
        power = [] if self.order == 1 else [str(self.order)]
        is_by_time = len(self.by) == 1 and said_of((self.by[0].bare,)) == "t"
        is_rate = is_by_time and self.sign == "d" and not self.in_frame and not (self.by[0].sub or self.by[0].primes)
        return self.order if is_rate and [*map(said_of, self.by[0].sups)] == power else 0

    @property
    def is_of_its_own(self) -> bool:
        """Whether no word says it: df/dx, Df/Dt, a higher partial one, a rate in a frame."""
        is_higher = self.order != 1 or any(atom.text == r"\partial" for atom in self.by)
        is_total = self.sign in ("d", "D") or is_undefined(self.sign)
        return not self.rate and bool(self.by) and (is_total or (self.sign == r"\partial" and is_higher))


def differential(atoms: Atoms) -> str:
    r"""The sign of a differential that stands first, upright or in italics; empty where none does.

    A command that nothing defines is one where it stands first above and below a stroke, as in \frac{\pl f}{\pl t}.
    """
    sign = said_of((atoms[0].bare,)).removeprefix(r"\mathrm ") if atoms else ""
    return sign if sign in SIGNS or is_undefined(sign) else ""


def is_undefined(sign: str) -> bool:
    """Whether it is a command that is neither a letter nor a function of LaTeX."""
    return bool(COMMAND.fullmatch(sign)) and sign not in KNOWN


@lru_cache(maxsize=4096)
def derivative(atom: Atom) -> Derivative | None:
    """The derivative that a fraction is; None if it is none."""
    if atom.kind != "COMMAND_OF_TWO" or "frac" not in atom.text:
        return None
    above, below = atom.arguments
    in_frame = bool(above) and above[0].kind == "GROUP" and not above[0].arguments[0]
    above = above[in_frame:]
    if above and above[0].text in MARKS and differential(above[0].arguments[0]):  # another derivative than d/dt
        in_frame, above = True, (*above[0].arguments[0], *above[1:])
    sign = differential(above)
    if not sign or sign != differential(below) or above[0].sub or below[0].sub:
        return None
    power = [said_of(sup) for sup in above[0].sups] or ["1"]
    order = int(power[0]) if power[0].isdigit() and len(power) == 1 else 0
    return Derivative(sign, order, above[1:], below[1:], in_frame)
