"""A short chapter on rigid bodies that move in a plane: a second book, to show how one is written.

Decide it with `chasles --chapter examples/planar/ decide`. One equation, (2.6), is misprinted on purpose.
"""

TITLE = "Motion in a Plane"
SECTIONS = ("s01_displacement", "s02_velocity", "s03_linkages")
