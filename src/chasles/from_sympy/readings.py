"""What is treated: how each class of SymPy expressions is read."""

from __future__ import annotations

from collections.abc import Mapping

from chasles.from_sympy.circular import OF_ANGLES
from chasles.from_sympy.reader import ARITHMETIC, Reading

READINGS: Mapping[type, Reading] = {**ARITHMETIC, **OF_ANGLES}
