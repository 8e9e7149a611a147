"""Physical dimensions: powers of length, mass and time, halves among them; the radian is dimensionless."""

from __future__ import annotations

import ast
import sys
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from pathlib import Path


@dataclass(frozen=True, slots=True)
class Dimension:
    """A product of powers of length (m), mass (kg) and time (s); those of a root may be halves."""

    length: int | Fraction = 0
    mass: int | Fraction = 0
    time: int | Fraction = 0

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(self.length + other.length, self.mass + other.mass, self.time + other.time)

    def __truediv__(self, other: Dimension) -> Dimension:
        return Dimension(self.length - other.length, self.mass - other.mass, self.time - other.time)

    def __pow__(self, exponent: int | Fraction) -> Dimension:
        return Dimension(self.length * exponent, self.mass * exponent, self.time * exponent)

    def __str__(self) -> str:
        powers = (("kg", self.mass), ("m", self.length), ("s", self.time))
        units = [unit if power == 1 else f"{unit}^{power}" for unit, power in powers if power]
        return " ".join(units) or "no dimension"


def has_units(module: str) -> bool:
    """Whether what a module declares has dimensions: not where a package around it says `UNITS = False`."""
    while module:
        found = getattr(sys.modules.get(module), "UNITS", None)
        if isinstance(found, bool) and _says_units(getattr(sys.modules[module], "__file__", None) or ""):
            return found
        module = module.rpartition(".")[0]
    return True


@cache
def _says_units(file: str) -> bool:
    """Whether a module assigns UNITS or imports it by name: what comes with all names of another, nobody said here."""
    try:
        parts = list(ast.walk(ast.parse(Path(file).read_bytes())))
    except (OSError, ValueError, SyntaxError):
        return True
    stored = {each.id for each in parts if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store)}
    return "UNITS" in stored | {each.asname or each.name for each in parts if isinstance(each, ast.alias)}


NO_DIMENSION = Dimension()
LENGTH = Dimension(length=1)
MASS = Dimension(mass=1)
TIME = Dimension(time=1)
FREQUENCY = NO_DIMENSION / TIME
VELOCITY = LENGTH / TIME
ACCELERATION = VELOCITY / TIME
FORCE = MASS * ACCELERATION
MOMENT = FORCE * LENGTH
