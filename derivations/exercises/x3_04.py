"""Exercise 3.4: one wrench measured in two frames; is it one, and how are the frames turned?"""

from chasles.derivations.exercises.calculations.lines import direction_of, normal_to
from chasles.derivations.notation import Q, e, one, phi, q, q_0
from chasles.derivations.s02_screw import rotation_from_axis_angle
from chasles.derivations.s04_twist import natural_invariants, rotation_from_linear_invariants

from chasles.exact.evaluate import Value, matrix_of
from chasles.exact.numbers import angle, is_zero
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, Picture
from chasles.exercises.worksheet import Worksheet, equal
from chasles.statements import Claim, Condition, rotation
from chasles.statements.exercise import (
    Answer,
    Datum,
    Else,
    Exercise,
    ListOf,
    Scalar,
    Truth,
    Word,
    matrix_shape,
    vector_shape,
)
from chasles.vocabulary import FORCE, MOMENT, PI, cos, cross, dot, inverse, row, sin, vector

n_1, n_2 = (vector(f"n_{k}", f"n_{k}", f"moment in frame {k}", MOMENT) for k in (1, 2))
f_1, f_2 = (vector(f"f_{k}", f"f_{k}", f"force in frame {k}", FORCE) for k in (1, 2))
INVARIANTS = {
    "n.n": (dot(n_1, n_1), dot(n_2, n_2)),
    "f.f": (dot(f_1, f_1), dot(f_2, f_2)),
    "n.f": (dot(n_1, f_1), dot(n_2, f_2)),
}

moment_is_turned = Condition("Ex 3.4", n_1, Q @ n_2, says="Both frames measure one moment.", on=(n_1,))
force_is_turned = Condition("Ex 3.4", f_1, Q @ f_2, part=2, says="Both frames measure one force.", on=(f_1,))

invariance = {
    name: Claim(
        "Ex 3.4",
        *sides,
        part=part,
        says=f"A rotation keeps {name}.",
        given=(moment_is_turned, force_is_turned),
        assuming=(rotation(Q),),
    )
    for part, (name, sides) in enumerate(INVARIANTS.items(), 3)
}
three_vectors_are_turned = Claim(
    "Ex 3.4",
    row(n_1, f_1, cross(n_1, f_1)),
    Q @ row(n_2, f_2, cross(n_2, f_2)),
    part=6,
    says="A rotation turns n, f and n x f alike.",
    given=(moment_is_turned, force_is_turned),
    assuming=(rotation(Q),),
)


def solve(sheet: Worksheet) -> str:
    """Three invariants decide whether there is a rotation; three vectors give it where it is the only one."""
    sheet.given({n_1: sheet["n1"], f_1: sheet["f1"], n_2: sheet["n2"], f_2: sheet["f2"]}, "The two measurements.")
    violated = [name for name, claim in invariance.items() if not sheet.holds(claim)]
    for k in (0, 1):
        sheet.answer(**{f"invariants_{k + 1}": [sheet.value(pair[k]) for pair in INVARIANTS.values()]})
    sheet.answer(compatible=not violated, violated=violated)
    if violated:
        sheet.step(f"The measurements differ in {', '.join(violated)}: no rotation takes one to the other.")
        sheet.answer(unique=None, R=None, phi=None, e=None)
        return "incompatible"
    unique = not is_zero(sheet.value(dot(cross(n_1, f_1), cross(n_1, f_1))))
    sheet.values[Q] = only_rotation(sheet) if unique else some_rotation(sheet)
    sheet.check(moment_is_turned, "R takes the moment in frame 2 to that in frame 1.")
    sheet.check(force_is_turned, "R takes the force in frame 2 to that in frame 1.")
    sheet.check((sheet.satisfied(rotation(Q)) * 1, 1), "R is a rotation.")
    sheet.answer(unique=unique, R=sheet.value(Q), **axis_and_angle(sheet))
    origin = sheet["n1"] * 0
    arrows = tuple(Arrow(origin, sheet[key], f"{key[0]} in frame {key[1]}") for key in ("n1", "f1", "n2", "f2"))
    sheet.picture = Picture("The components in both frames", arrows)
    return "compatible"


def axis_and_angle(sheet: Worksheet) -> dict[str, Value]:
    """Of the rotation that is bound."""
    if not sheet.invert(natural_invariants, "Its axis and its angle."):
        return {"phi": sheet.value(PI) * 0, "e": None}
    turned = angle(sheet.value(cos(phi)), sheet.value(sin(phi)))
    sheet.given({phi: turned}, "The angle with that cosine and sine.")
    sheet.check(rotation_from_axis_angle, "Axis and angle give R back.")
    return {"phi": turned, "e": sheet.value(e)}


def with_another_rotation(sheet: Worksheet, given: dict[str, Value]) -> list[dict[str, Value]]:
    """Where R is not unique, any that does it, with its own axis and angle."""
    if sheet.answers["unique"] is not False or given.get("R") is None:
        return []
    trial = Worksheet(sheet.data)
    trial.values = sheet.values | {Q: matrix_of(given["R"])}
    sides = [sheet.sides(turned, None) for turned in (moment_is_turned, force_is_turned)]
    if trial.satisfied(rotation(Q)) and all(equal(trial.value(left), trial.value(right)) for left, right in sides):
        return [{"R": given["R"], **axis_and_angle(trial)}]
    return []


def only_rotation(sheet: Worksheet) -> Value:
    """From three independent vectors in both frames."""
    before, after = row(n_2, f_2, cross(n_2, f_2)), row(n_1, f_1, cross(n_1, f_1))
    says = "n, f and n x f are independent: they determine R."
    return sheet.show(after @ inverse(before), says, named="R", cites=(three_vectors_are_turned,))


def some_rotation(sheet: Worksheet) -> Value:
    """N and f are along one line, or vanish: R may be followed by any rotation about that line."""
    after, before = (direction_of(sheet[f"n{k}"], sheet[f"f{k}"]) for k in (1, 2))
    if after is None:
        sheet.step("Both vectors vanish: every rotation will do, the identity as well as any.")
        return sheet.value(one)
    sheet.step("n and f are along one line, in both frames:", ("in frame 1", after), ("in frame 2", before))
    sheet.step("R may be followed by any rotation about that line: it is not unique. Here is the one of least angle.")
    if equal(after, -before):
        turn = {e: normal_to(after), phi: sheet.value(PI)}
        return sheet.compute(rotation_from_axis_angle, "A half-turn about a normal to the line.", at=turn)
    at = {n_2: before, n_1: after}
    turn = {q: sheet.value(cross(n_2, n_1), at), q_0: sheet.value(dot(n_2, n_1), at)}
    return sheet.compute(rotation_from_linear_invariants, "About their vector product.", at=turn)


def instance(draw: Draw) -> dict[str, Value]:
    """One wrench in two frames; now and then, two wrenches."""
    turn, moment, force = draw.rotation(), draw.vector(), draw.vector()
    other = force if draw.integer(0, 3) else draw.vector()
    return draw.written(n1=turn * moment, f1=turn * force, n2=moment, f2=other)


exercise = Exercise(
    "3.4",
    "One wrench, two sensors",
    asked=(
        "Show by invariants that the two measurements can be of one wrench.",
        "Find the rotation that takes coordinates in the second frame to those in the first.",
    ),
    data=(
        Datum("n1", vector_shape(), [0, 0, 5], "moment in frame 1"),
        Datum("f1", vector_shape(), [0, 2, 0], "force in frame 1"),
        Datum("n2", vector_shape(), ["-5/3", "-10/3", "10/3"], "moment in frame 2"),
        Datum("f2", vector_shape(), ["-4/3", "4/3", "2/3"], "force in frame 2"),
    ),
    statuses=("compatible", "incompatible"),
    solve=solve,
    instance=instance,
    symbols={"R": (Q,), "phi": (phi,), "e": (e,)},
    signs=(("phi", "e"),),
    turns=("phi",),
    alternatives=with_another_rotation,
    answers=(
        *(Answer(f"invariants_{k}", vector_shape(), f"n.n, f.f and n.f in frame {k}") for k in (1, 2)),
        Answer("compatible", Truth(), "whether both measurements can be of one wrench"),
        Answer("violated", ListOf(Word(tuple(INVARIANTS)), 0), "the invariants that differ, in this order"),
        Answer("unique", Else(Truth()), "whether only one rotation does it; null if none does"),
        Answer("R", Else(matrix_shape()), "the rotation from frame 2 to frame 1, by rows; null if there is none"),
        Answer("phi", Else(Scalar()), "its angle in radians, in [0, pi]; null if there is none"),
        Answer("e", Else(vector_shape()), "the unit direction of its axis; null if it has none"),
    ),
)
