"""The book: one module a section, in the book's order, each equation declared as it is printed."""

if __name__ != "chasles.derivations":
    raise ImportError(
        f"the derivations were imported as {__name__!r}; import them as 'chasles.derivations', "
        "so that no statement exists twice"
    )

TITLE = "Fundamentals of Rigid-Body Mechanics"
SOURCE = "J. Angeles, Fundamentals of Robotic Mechanical Systems, 4th edition, Springer, 2014, Chapter 3"
SECTIONS = (
    "s02_screw",
    "s03_fixed_point",
    "s04_twist",
    "s05_acceleration",
    "s06_moving_frame",
    "s07_statics",
    "s08_dynamics",
    "x3_10_euler_angles",
)
CONVENTIONS = (
    "Units are SI.",
    "3 x 3 matrices act on columns from the left.",
    "Twists hold the angular part first and wrenches the moment first.",
    "Euler angles come in the order of the turns, each about an axis as the turns before have left it.",
)
"""What the heads of generated files say of what numbers mean."""
