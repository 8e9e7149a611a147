"""Walking a derivation: each step's result is computed and decided; the end is compared with the print."""

from chasles.deriving.walk import CheckedDerivation, CheckedStep, walk

__all__ = ["CheckedDerivation", "CheckedStep", "walk"]
