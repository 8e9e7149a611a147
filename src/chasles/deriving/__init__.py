"""Walking a derivation: each step's result is computed and decided; the end is compared with the print."""

from chasles.deriving.walk import Passage, Road, walk

__all__ = ["Passage", "Road", "walk"]
