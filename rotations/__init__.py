"""Rotations and rigid motions: one module a section, each equation decided; what every text on robotics uses."""

if __name__ != "chasles.rotations":
    raise ImportError(
        f"the chapter was imported as {__name__!r}; import it as 'chasles.rotations', so that no statement exists twice"
    )

TITLE = "Rotations and Rigid Motions"
SOURCE = "the mathematics as it is generally known, in words of our own"
SECTIONS = (
    "s1_rotations",
    "s2_quaternions",
)
