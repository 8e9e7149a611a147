"""Exercise 3.10: the angular velocity from the rates of Euler angles, and where the rates cannot be had from it."""

from chasles.derivations.exercises.calculations.euler import (
    conditioning,
    definitions_of,
    singular_set,
    symbolic,
    symbols_by_name,
)
from chasles.derivations.notation import Q, omega

from chasles.exact.evaluate import Value
from chasles.exact.linear import kernel_of, rank_of
from chasles.exact.numbers import is_zero
from chasles.exercises.data import DataError
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Picture
from chasles.exercises.worksheet import Worksheet
from chasles.statements.derivations import derivations_in
from chasles.statements.exercise import Answer, Datum, Else, Exercise, Scalar, Truth, Word, matrix_shape, vector_shape
from chasles.vocabulary import FREQUENCY, inverse, number, vector

SEQUENCES = tuple(f"{i}{j}{k}" for i in "xyz" for j in "xyz" for k in "xyz" if i != j != k)
FRAMES = ("fixed", "body")
rates = vector("theta_dot", r"\dot{\boldsymbol{\theta}}", "rates of the Euler angles", FREQUENCY)
omega_body = vector("omega_body", r"\boldsymbol{\omega}_{\text{body}}", "angular velocity in the body", FREQUENCY)


def solve(sheet: Worksheet) -> str:
    """The roads find W and det W in both frames; angles and rates are put in."""
    if sheet["angles"] is None and (sheet["rates"] is not None or sheet["omega"] is not None):
        raise DataError("angles: expected, as rates or omega are given")
    if sheet["rates"] is not None and sheet["omega"] is not None:
        raise DataError("rates, omega: expected one of them, and got both")
    roads = derivations_in("r13_euler_angles")
    chosen = [roads[f"euler_{sheet['sequence']}_{frame}"] for frame in FRAMES]
    fixed, body = (sheet.walk(road, "A derivation, each step decided.") for road in chosen)
    rotation, axes = definitions_of(chosen[0])
    names = symbols_by_name(rotation.right, fixed["W"], body["W_body"])
    angles = [names[f"theta_{k}"] for k in (1, 2, 3)]
    for axis in axes:
        sheet.values[axis.left] = sheet.value(axis.right)
    known = sheet["angles"] is not None
    values = list(sheet["angles"]) if known else [symbolic(angle.name) for angle in angles]
    sheet.values |= dict(zip(angles, values, strict=True))
    if known:
        sheet.step("The angles.", *zip(angles, values, strict=True))
    turns = tuple(zip(("theta", "phi", "psi"), (angle.name for angle in angles), strict=True))
    sheet.step("The book's eta = [theta, phi, psi]^T holds the angles in the order of the turns.", *turns)
    turned = sheet.compute(rotation, "The rotation: the product of the turns about the three axes.")
    sheet.step("It is, multiplied out,", (Q, turned))
    W_fixed, W_body = (sheet.value(found) for found in (fixed["W"], body["W_body"]))
    says = "In omega = W d(eta)/dt, the columns of W are the axes of the turns, in the fixed frame and in the body's."
    sheet.step(says, ("W in the fixed frame", W_fixed), ("W in the body frame", W_body))
    determinant = sheet.show(fixed["det(W)"], "The determinant, the same in both frames.", named="det(W)")
    sheet.check((body["det(W_body)"], fixed["det(W)"]), "The determinants are equal, as the frames are turned.")
    sheet.answer(W_fixed=W_fixed, W_body=W_body, det=determinant)
    where = singular_set(fixed["det(W)"])
    sheet.picture = Picture(
        f"Euler angles {sheet['sequence']}: W and its singularities", (conditioning(fixed["det(W)"]),)
    )
    sheet.step(
        "W is singular where the first and the third axis are parallel; the second is normal to them.", ("where", where)
    )
    if not known:
        sheet.answer(singular=where, rank="3, and 2 where W is singular")
        return "ok"
    singular = is_zero(determinant)
    sheet.answer(singular=singular, rank=sheet.value(number(rank_of(W_fixed))))
    if sheet["rates"] is not None:
        forward(sheet, W_fixed, W_body)
    elif sheet["omega"] is not None:
        backward(sheet, W_fixed, singular)
    elif singular:
        idle = kernel_of(W_fixed)
        sheet.step("Rates that make no angular velocity are multiples of", *(("rates", way) for way in idle))
    sheet.check((turned.T * W_fixed, W_body), "The rotation turns one W into the other.")
    return "singular" if singular else "ok"


def forward(sheet: Worksheet, W_fixed: Value, W_body: Value) -> None:
    """The angular velocity from the rates."""
    given = sheet["rates"]
    in_fixed, in_body = W_fixed * given, W_body * given
    sheet.step("The rates, and what W makes of them.", (rates, given), (omega, in_fixed), (omega_body, in_body))
    sheet.check((sheet.value(Q) * in_body, in_fixed), "The rotation turns one into the other.")
    sheet.answer(omega_fixed=in_fixed, omega_body=in_body)


def backward(sheet: Worksheet, W_fixed: Value, singular: bool) -> None:
    """The rates from the angular velocity in the fixed frame."""
    sheet.given({omega: sheet["omega"]}, "The angular velocity, in the fixed frame.")
    if singular:
        sheet.step("W has no inverse here: the rates do not follow.", ("rank of W", sheet.answers["rank"]))
        sheet.answer(rates=None)
        return
    found = sheet.show(inverse(Q) @ omega, "The rates.", named="rates", at={Q: W_fixed})
    sheet.check((W_fixed * found, sheet["omega"]), "They make the angular velocity.")
    sheet.answer(rates=found)


def instance(draw: Draw) -> dict[str, Value]:
    """A sequence, angles that are nice parts of pi, and rates."""
    angles = [draw.among(("pi/6", "-pi/4", "pi/3", "pi/2", "0", "2*pi/3", "-pi/6", "pi")) for _ in range(3)]
    return {"sequence": draw.among(SEQUENCES), "angles": angles, **draw.written(rates=draw.vector())}


exercise = Exercise(
    "3.10",
    "The angular velocity from Euler angles",
    asked=(
        "Find the matrix W that makes the angular velocity of the rates of the Euler angles.",
        "Find where W is singular.",
    ),
    data=(
        Datum("sequence", Word(SEQUENCES), "zyz", "the axes, in the order in which they are turned about"),
        Datum("angles", vector_shape(), None, "the angles, in the order in which they are applied"),
        Datum("rates", vector_shape(), None, "their rates"),
        Datum("omega", vector_shape(), None, "or the angular velocity in the fixed frame"),
    ),
    statuses=("ok", "singular"),
    assumptions=(
        "Each rotation is about an axis of the frame as turned so far (intrinsic).",
        "The book's angles theta, phi, psi are read as those of the first, the second and the third turn.",
    ),
    stand_ins={"sequence": "The book refers to another chapter for the angles; the sequence zyz stands in."},
    solve=solve,
    instance=instance,
    answers=(
        Answer("W_fixed", matrix_shape(), "W by rows: angular velocity in the fixed frame from the rates"),
        Answer("W_body", matrix_shape(), "the same with the angular velocity in the body's frame"),
        Answer("det", Scalar(), "the determinant of W"),
        Answer("singular", Truth(), "whether W is singular at these angles", given="angles"),
        Answer("rank", Scalar(), "the rank of W", given="angles"),
        Answer("omega_fixed", vector_shape(), "the angular velocity in the fixed frame", given="rates"),
        Answer("omega_body", vector_shape(), "the angular velocity in the body's frame", given="rates"),
        Answer("rates", Else(vector_shape()), "the rates of the angles; null if they do not follow", given="omega"),
    ),
)
