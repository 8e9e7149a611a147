"""Exercise 3.9: the angular velocity of small rotations."""

from chasles.derivations.exercises.calculations.series import FUNCTIONS, PHI, leading_term
from chasles.derivations.notation import e, omega, phi
from chasles.derivations.s02_screw import rotation_from_axis_angle
from chasles.derivations.s03_fixed_point import angular_velocity, angular_velocity_matrix

from chasles.exercises.picture import Graph, Picture
from chasles.exercises.worksheet import Worksheet
from chasles.statements import Claim, unit
from chasles.statements.exercise import Exercise
from chasles.vocabulary import cos, cross, paren, rate, sin

angular_velocity_of_axis_and_angle = Claim(
    "Ex 3.9",
    omega,
    rate(phi) * e + sin(phi) * rate(e) + paren(1 - cos(phi)) * cross(e, rate(e)),
    says="The angular velocity by the rates of axis and angle, whatever the angle.",
    given=(angular_velocity_matrix, angular_velocity, rotation_from_axis_angle),
    assuming=(unit(e),),
)

what_is_no_rate = Claim(
    "Ex 3.9",
    omega - rate(phi * e),
    paren(sin(phi) - phi) * rate(e) + paren(1 - cos(phi)) * cross(e, rate(e)),
    part=2,
    says="What is left of it without the rate of phi e.",
    given=(angular_velocity_matrix, angular_velocity, rotation_from_axis_angle),
    assuming=(unit(e),),
)


def solve(sheet: Worksheet) -> str:
    """Omega - d(phi e)/dt has two terms; each is expanded in phi."""
    sheet.state(angular_velocity_of_axis_and_angle)
    sheet.state(what_is_no_rate, "The first term and one part of the second are the rate of phi e; what is left is:")
    terms = {name: leading_term(name) for name in ("sin(phi) - phi", "1 - cos(phi)")}
    sheet.step("Their Taylor series about phi = 0 begin with", *((name, term) for name, (term, _) in terms.items()))
    order = min(order for _, order in terms.values())
    sheet.step(
        "So omega is the rate of phi e, up to terms of this order in phi.",
        ("order", order),
        cites=(what_is_no_rate,),
    )
    sheet.answer(vector="phi*e", order=order)
    curves = tuple((f"|{name}|", abs(function)) for name, function in FUNCTIONS.items())
    sheet.picture = Picture("What keeps omega from being the rate of phi e", (Graph("phi", PHI, (0, 1), curves),))
    return "ok"


exercise = Exercise(
    "3.9",
    "The angular velocity of small rotations",
    asked=("Show that for small angles the angular velocity is the rate of a vector, and find that vector.",),
    solve=solve,
)
