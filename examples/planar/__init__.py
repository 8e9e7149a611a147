"""A short chapter on rigid bodies that move in a plane, to show how a chapter is written.

`chasles --chapter examples/planar/ decide` decides it. One equation, (2.6), is misprinted
on purpose.
"""

TITLE = "Motion in a Plane"
SECTIONS = ("s01_displacement", "s02_velocity", "s03_linkages")
