"""Derivations carried out: each step's result is computed and decided; the last is compared with the printed one."""

from chasles.deriving.walk import CheckedDerivation, CheckedStep, walk

__all__ = ["CheckedDerivation", "CheckedStep", "walk"]
