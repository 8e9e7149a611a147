"""Exercise 3.21: the two terms of the angular-acceleration matrix are orthogonal; the accelerations need not be."""

from chasles.derivations.exercises.relative_acceleration import (
    accelerations_are_orthogonal,
    orthogonal_on_average,
    product_of_accelerations,
    rate_of_matrix,
    size_of_first,
    size_of_second,
    terms_are_orthogonal,
    twist_of_axes,
)
from chasles.derivations.notation import Omega, e_1, e_2, e_3, omega, r_C, unit_columns
from chasles.derivations.s03_fixed_point import angular_velocity_matrix_of_vector
from chasles.derivations.s05_acceleration import acceleration_by_matrices, angular_acceleration_matrix

from chasles.exact.evaluate import Value
from chasles.exact.numbers import is_zero, root, sign
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, Picture
from chasles.exercises.worksheet import Worksheet
from chasles.statements.exercise import Answer, Datum, Exercise, Scalar, Truth, Word, vector_shape
from chasles.vocabulary import dot, rate


def solve(sheet: Worksheet) -> str:
    """The claims, at the values; and what the exercise's last sentence says of them."""
    alpha = rate(omega)
    sheet.given({omega: sheet["omega"], alpha: sheet["alpha"], r_C: sheet["r"]})
    sheet.compute(angular_velocity_matrix_of_vector)
    sheet.compute(rate_of_matrix)
    sheet.compute(angular_acceleration_matrix, "The angular-acceleration matrix, and its Cartesian decomposition.")
    trace = sheet.show(
        terms_are_orthogonal.left, "The inner product of its two terms is always zero.", cites=(terms_are_orthogonal,)
    )
    first = root(sheet.show(size_of_first.left, size_of_first.says))
    second = root(sheet.show(size_of_second.left, size_of_second.says))
    angle = "a right angle" if sign(first) and sign(second) else "not defined: one of the terms is zero"
    sheet.step(
        f"The norms. The angle between the terms is {angle}.", ("of the first", first), ("of the second", second)
    )
    product = accelerations(sheet)
    everywhere = not any(sheet.value(twist_of_axes))
    here = is_zero(product)
    sheet.check(size_of_first, "The first norm, from the angular acceleration.")
    sheet.check(size_of_second, "The second norm, from the angular velocity.")
    sheet.check(terms_are_orthogonal, "The inner product is zero.")
    sheet.answer(trace=trace, dot_tangential_centripetal=product, norm_A=first, norm_O2=second)
    verdict = what_holds(here, everywhere)
    sheet.answer(orthogonal_for_this_r=here, orthogonal_for_all_r=everywhere, last_sentence=verdict)
    return "ok"


def accelerations(sheet: Worksheet) -> Value:
    """The product of the two accelerations of a point at r: from the matrices, and from the vectors."""
    tangential = sheet.show(rate(Omega) @ r_C, "The tangential acceleration of a point at r, relative to another.")
    centripetal = sheet.show(Omega**2 @ r_C, "Its centripetal acceleration.", cites=(acceleration_by_matrices,))
    product = sheet.show(dot(rate(Omega) @ r_C, Omega**2 @ r_C), "Their product.", cites=(product_of_accelerations,))
    sheet.refute(accelerations_are_orthogonal, "It is not so.")
    sheet.state(product_of_accelerations)
    sheet.state(orthogonal_on_average)
    sheet.check(product_of_accelerations, "The product, by omega . r and omega x alpha . r.")
    sheet.show(twist_of_axes, "It vanishes for all r if and only if this does.")
    axes = {e_1: sheet.value(unit_columns[0]), e_2: sheet.value(unit_columns[1]), e_3: sheet.value(unit_columns[2])}
    sheet.check(orthogonal_on_average, "Over the three coordinate axes, the products add up to zero.", at=axes)
    arrows = (("omega", sheet["omega"]), ("r", sheet["r"]), ("tangential", tangential), ("centripetal", centripetal))
    origin = 0 * sheet["r"]
    drawn = tuple(Arrow(origin, vector, name) for name, vector in arrows if any(vector))
    sheet.picture = Picture("The relative accelerations of a point", drawn)
    return product


WORDS = (
    "holds: the angular acceleration is parallel to the angular velocity, or one of them is zero",
    "holds for this r, which is normal to omega or to omega x alpha; it fails for others",
    "fails: the accelerations are not orthogonal here; they are on average over all directions of r",
)


def what_holds(here: bool, everywhere: bool) -> str:
    """What the last sentence of the exercise comes to for these data."""
    if everywhere:
        return WORDS[0]
    return WORDS[1] if here else WORDS[2]


def instance(draw: Draw) -> dict[str, Value]:
    """Three vectors."""
    return draw.written(omega=draw.vector(), alpha=draw.vector(), r=draw.vector())


exercise = Exercise(
    "3.21",
    "Orthogonal terms of the angular-acceleration matrix",
    asked=(
        "Show that the two terms of the angular-acceleration matrix (3.86) are orthogonal.",
        "The book adds that this restates that tangential and centripetal accelerations are orthogonal. Does it?",
    ),
    data=(
        Datum("omega", vector_shape(), [0, 0, 1], "angular velocity"),
        Datum("alpha", vector_shape(), [1, 0, 0], "angular acceleration"),
        Datum("r", vector_shape(), [0, 1, 1], "position of one point from another"),
    ),
    assumptions=("norm_A is the norm of the first term, d(Omega)/dt, and norm_O2 that of the second, Omega^2.",),
    stand_ins=dict.fromkeys(
        ("omega", "alpha", "r"),
        "The exercise gives no numbers: omega = (0, 0, 1), alpha = (1, 0, 0), r = (0, 1, 1) stand in, for which the "
        "last sentence of the exercise fails.",
    ),
    solve=solve,
    instance=instance,
    answers=(
        Answer("trace", Scalar(), "tr(A^T B) for the two terms, A = d(Omega)/dt and B = Omega^2"),
        Answer("dot_tangential_centripetal", Scalar(), "the scalar product of the two accelerations at r"),
        Answer("norm_A", Scalar(), "the norm of the first term, the root of tr(A^T A)"),
        Answer("norm_O2", Scalar(), "the norm of the second term"),
        Answer("orthogonal_for_this_r", Truth(), "whether the accelerations are orthogonal at r"),
        Answer("orthogonal_for_all_r", Truth(), "whether they are so for every r"),
        Answer("last_sentence", Word(WORDS), "what the book's last sentence comes to"),
    ),
    synonyms={text.partition(":")[0].partition(",")[0]: text for text in WORDS},
)
