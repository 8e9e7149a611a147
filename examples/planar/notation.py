"""Every symbol once: name, LaTeX letter, meaning, dimension.

Positions are columns of two coordinates; angles are in radians, counterclockwise; units
are SI.
"""

from chasles.vocabulary import (
    FREQUENCY,
    LENGTH,
    VELOCITY,
    Identity,
    Symbol,
    Zero,
    array,
    matrix,
    number,
    scalar,
    uniform,
)
from chasles.vocabulary.dimension import Dimension


def place(name: str, letter: str, meaning: str, dimension: Dimension = LENGTH) -> Symbol:
    """A vector of the plane."""
    return array(name, letter, meaning, uniform((2, 1), dimension))


half = number(1) / 2
one = Identity(2)
_quarter_turn = matrix((0, -1), (1, 0))
E = Symbol(
    "E",
    r"\mathbf{E}",
    uniform((2, 2)),
    "quarter turn: E r is r, turned counterclockwise by a right angle",
    constant=True,
    stands_for=_quarter_turn,
)
zero = Zero(2, 1, r"\mathbf{0}")

# One body
phi = scalar("phi", r"\phi", "angle through which the body has turned")
omega = scalar("omega", r"\omega", "angular velocity", FREQUENCY)
Q = array("Q", "Q", "rotation of the body", uniform((2, 2)))
a = place("a", "a", "position of the landmark point A")
a_ = place("a'", "a'", "position of A after the displacement")
p = place("p", "p", "position of any point P of the body")
p_ = place("p'", "p'", "position of P after the displacement")
r = Symbol(
    "r",
    r"\mathbf{r}",
    uniform((2, 1), LENGTH),
    "position of P from A, as the body sees it",
    constant=True,
)
c = place("c", "c", "position of the pole, or of the instant center")

# Three bodies
omega_1, omega_2, omega_3 = (
    scalar(f"omega_{k}", rf"\omega_{k}", f"angular velocity of body {k}", FREQUENCY) for k in (1, 2, 3)
)
v_1, v_2, v_3 = (
    place(f"v_{k}", f"v_{k}", f"velocity of the point of body {k} at the origin", VELOCITY) for k in (1, 2, 3)
)
c_12, c_13, c_23 = (
    place(f"c_{k}", f"c_{{{k}}}", f"instant center of bodies {k[0]} and {k[1]}") for k in ("12", "13", "23")
)

# Linkages
theta = scalar("theta", r"\theta", "angle of the crank")
beta = scalar("beta", r"\beta", "angle of the connecting rod")
omega_rod = scalar("omega_l", r"\omega_\ell", "angular velocity of the connecting rod", FREQUENCY)
psi = scalar("psi", r"\psi", "angle of the output link")
crank = scalar("b", "b", "length of the crank", LENGTH, constant=True)
rod = scalar("l", r"\ell", "length of the connecting rod", LENGTH, constant=True)
output = scalar("h", "h", "length of the output link", LENGTH, constant=True)
frame = scalar("d", "d", "distance of the two fixed pivots", LENGTH, constant=True)
coupler = place("k", "k", "vector along the coupler, from the crank to the output link")
coupler_length = scalar("k", "k", "length of the coupler", LENGTH)
x = scalar("x", "x", "position of the slider from the fixed pivot of the crank", LENGTH)
