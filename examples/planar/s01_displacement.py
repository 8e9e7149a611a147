"""Section 1: where a body comes to lie, and the point about which it is turned there."""

from chasles.statements import Claim, Condition, Definition, Kernel, Section, nonzero
from chasles.vocabulary import cos, cot, paren, sin

from .notation import E, Q, a, a_, c, half, one, p, p_, phi

displacement_section = Section("1", "Displacement")

turn = Definition(
    "1.1",
    Q, cos(phi) * one + sin(phi) * E,
    says="The rotation through the angle phi.",
    kernel=Kernel(of=(phi,)),
)

turn_is_orthogonal = Claim(
    "1.2",
    Q.T @ Q, one,
    says="A rotation keeps lengths and angles.",
    given=(turn,),
)

displaced_point = Definition(
    "1.3",
    p_, a_ + Q @ paren(p - a),
    says="Where a point of the body lies after the displacement.",
    given=(turn,),
    kernel=Kernel(of=(phi, a, a_, p)),
)

body_turns = nonzero(sin(phi / 2), r"\phi \neq 0")

pole_stays = Condition(
    "1.4",
    c, a_ + Q @ paren(c - a),
    says="The pole is the point that the displacement leaves where it is.",
    given=(turn,),
    assuming=(body_turns,),
    on=(c,),
)

pole = Claim(
    "1.5",
    c, half * (a + a_) + half * cot(phi / 2) * E @ paren(a_ - a),
    says="The pole lies on the perpendicular bisector of A and its new place.",
    given=(turn, pole_stays),
    assuming=(body_turns,),
    kernel=Kernel(of=(phi, a, a_)),
)
