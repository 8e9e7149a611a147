"""Exercise 3.18: the rate of the inertia dyad less twice the product of the dyads is skew-symmetric."""

from chasles.derivations.exercises.calculations.turning import graph_of_difference
from chasles.derivations.exercises.x3_17 import proved
from chasles.derivations.notation import I_C, M, W_dyad, half, t
from chasles.derivations.s03_fixed_point import angular_velocity_matrix_of_vector
from chasles.derivations.s08_dynamics import (
    angular_velocity_dyad,
    difference_is_skew,
    inertia_dyad_at_center_of_mass,
    newton_euler_by_dyads,
    rate_of_inertia_dyad,
)

from chasles.exercises.picture import Picture
from chasles.exercises.worksheet import Worksheet
from chasles.statements import Claim, symmetric
from chasles.statements.exercise import Exercise
from chasles.vocabulary import number, paren, rate

I_C_is_symmetric = symmetric(I_C)
_dyads = (
    rate_of_inertia_dyad,
    inertia_dyad_at_center_of_mass,
    angular_velocity_dyad,
    angular_velocity_matrix_of_vector,
)

difference = Claim(
    "Ex 3.18",
    rate(M) - 2 * W_dyad @ M,
    -paren(W_dyad @ M + M @ W_dyad),
    part=2,
    says="The difference, the rate of the dyad substituted.",
    given=_dyads,
)

sum_is_skew = Claim(
    "Ex 3.18",
    (W_dyad @ M + M @ W_dyad).T,
    -(W_dyad @ M + M @ W_dyad),
    part=3,
    says="That sum is skew-symmetric, as W is, and M is symmetric.",
    given=_dyads[1:],
    assuming=(I_C_is_symmetric,),
)

no_power = Claim(
    "Ex 3.18",
    t.T @ paren(rate(M) - 2 * W_dyad @ M) @ t,
    number(0),
    part=4,
    says="Hence the difference drops out of the power.",
    given=_dyads,
    assuming=(I_C_is_symmetric,),
)

rate_of_energy = Claim(
    "Ex 3.18",
    t.T @ M @ rate(t) + half * t.T @ rate(M) @ t,
    t.T @ paren(M @ rate(t) + W_dyad @ M @ t),
    part=5,
    says="What it is good for: the rate of the kinetic energy (3.145) is the power of the wrench in (3.139).",
    given=_dyads,
    assuming=(I_C_is_symmetric,),
)

STEPS = (
    (rate_of_inertia_dyad, "The rate of the inertia dyad, from Exercise 3.17."),
    (difference, "It goes into the difference."),
    (sum_is_skew, "What is left is minus a sum that is skew-symmetric."),
    (difference_is_skew, "So the difference is skew-symmetric, whatever wrench acts on the body."),
    (no_power, "A skew-symmetric matrix makes no power."),
    (
        newton_euler_by_dyads,
        "W M is what multiplies the twist in the Newton-Euler equations: the part of C for a robot.",
    ),
    (rate_of_energy, "So the rate of the energy is the power of the wrench."),
)


def solve(sheet: Worksheet) -> str:
    """A road of decided steps."""
    sheet.picture = Picture("Equal for every x: their difference is skew-symmetric", (graph_of_difference(),))
    return proved(sheet, STEPS)


exercise = Exercise(
    "3.18",
    "A skew-symmetric difference",
    asked=("Show that the rate of the inertia dyad less 2 W M is skew-symmetric, for a single rigid body.",),
    assumptions=("The inertia dyad is that at the center of mass, and the moment of inertia is symmetric.",),
    solve=solve,
)
