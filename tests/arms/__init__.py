"""A chapter on rotations and serial arms, written out entry by entry: slips are planted in it, and repaired."""

TITLE = "Rotations and Arms, Entry by Entry"
SECTIONS = ("s01_rotations", "s02_quaternions", "s03_frames", "s04_jacobians")
