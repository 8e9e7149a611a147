"""Section 2: velocities and accelerations in a moving body, instant centers of one body and of three."""

from chasles.statements import Claim, Condition, Definition, Hypothesis, Kernel, Section, nonzero
from chasles.vocabulary import Symbol, dot, latex, number, over, paren, rate

from .notation import (
    E,
    Q,
    a,
    c,
    c_12,
    c_13,
    c_23,
    omega,
    omega_1,
    omega_2,
    omega_3,
    p,
    phi,
    r,
    v_1,
    v_2,
    v_3,
    zero,
)
from .s01_displacement import turn

velocity_section = Section("2", "Velocity and Acceleration")

angular_velocity = Definition("2.1", omega, rate(phi), says="The angular velocity.")

point_of_moving_body = Definition(
    "2.2",
    p, a + Q @ r,
    says="The position of a point of the body; r does not change.",
    given=(turn,),
    sign="=",
)

velocity_of_point = Claim(
    "2.3",
    rate(p), rate(a) + omega * E @ paren(p - a),
    says="The velocity of a point is that of the landmark, plus what the turning adds.",
    given=(turn, angular_velocity, point_of_moving_body),
    kernel=Kernel(of=(omega, rate(a), a, p)),
)

body_is_turning = nonzero(omega, r"\omega \neq 0")

instant_center_is_at_rest = Condition(
    "2.4",
    rate(a) + omega * E @ paren(c - a), zero,
    says="The point of the body at the instant center has no velocity.",
    assuming=(body_is_turning,),
    on=(c,),
)

instant_center = Claim(
    "2.4",
    c, a + over(1, omega) * E @ rate(a),
    part=2,
    says="The instant center from the velocity of one point.",
    given=(instant_center_is_at_rest,),
    assuming=(body_is_turning,),
    kernel=Kernel(of=(omega, rate(a), a)),
)

velocity_from_center = Claim(
    "2.5",
    rate(p), omega * E @ paren(p - c),
    says="Velocities are at right angles to the line from the instant center, and grow with the distance from it.",
    given=(velocity_of_point, instant_center_is_at_rest),
)

# The sign of the last term is wrong on purpose: the acceleration towards A is minus omega^2 (p - a).
acceleration_of_point = Claim(
    "2.6",
    rate(rate(p)), rate(rate(a)) + rate(omega) * E @ paren(p - a) + omega**2 * paren(p - a),
    says="The acceleration of a point.",
    given=(turn, angular_velocity, point_of_moving_body),
    kernel=Kernel(of=(omega, rate(omega), rate(rate(a)), a, p)),
)


def _distinct(one_: Symbol, other: Symbol) -> Hypothesis:
    """Two bodies that turn alike have no instant center at a finite distance."""
    return nonzero(one_ - other, rf"{latex(one_)} \neq {latex(other)}")


def _shared(part: int, center: Symbol, v: Symbol, w: Symbol, v_other: Symbol, w_other: Symbol) -> Condition:
    return Condition(
        "2.7",
        v + w * E @ center, v_other + w_other * E @ center,
        part=part,
        says="At their instant center two bodies have the same velocity.",
        assuming=(_distinct(w, w_other),),
        on=(center,),
    )


center_of_1_and_2 = _shared(1, c_12, v_1, omega_1, v_2, omega_2)
center_of_1_and_3 = _shared(2, c_13, v_1, omega_1, v_3, omega_3)
center_of_2_and_3 = _shared(3, c_23, v_2, omega_2, v_3, omega_3)

three_centers = Claim(
    "2.8",
    dot(c_12 - c_13, E @ paren(c_23 - c_13)), number(0),
    says="The three instant centers of three bodies lie on a line (Aronhold, Kennedy).",
    given=(center_of_1_and_2, center_of_1_and_3, center_of_2_and_3),
    assuming=(_distinct(omega_1, omega_2), _distinct(omega_1, omega_3), _distinct(omega_2, omega_3)),
)
