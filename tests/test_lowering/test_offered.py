"""A form that a person offers: used once it is proved equal, refused with a point that shows it where it is not."""

from __future__ import annotations

from dataclasses import replace

import pytest

from chasles.lowering.declaration import requested
from chasles.lowering.equivalence.requests import differences
from chasles.lowering.lower import program_of
from chasles.lowering.offered import counterexample, in_words
from chasles.lowering.program import Op
from chasles.lowering.refusal import LoweringError
from chasles.lowering.request import Output, composed
from chasles.statements import Definition, Entry, Kernel, Section
from chasles.targets.commission import kernel_of
from chasles.targets.kernel import EmissionError
from chasles.vocabulary import LENGTH, column, cos, cot, cross, dot, norm, scalar, sin, vector

x, y, phi = (scalar(name, name, "a number") for name in ("x", "y", "phi"))
u, w = vector("u", "u", "a vector"), vector("w", "w", "a vector")
z = scalar("z", "z", "a number")


def entry(right, form, of, results=()):
    statement = Definition("9.8", z if right.is_scalar else w, right, kernel=Kernel(of=of, results=results, form=form))
    return Entry("made", Section("9", "Tests"), statement)


def test_the_program_is_made_of_the_form(book):
    kernel = kernel_of(entry(x * x - y * y, (x - y) * (x + y), (x, y)), book.judge.decide)
    assert kernel.heading.form == "offered"
    assert dict(kernel.program.operations) == {Op.ADD: 1, Op.SUBTRACT: 1, Op.MULTIPLY: 1}


def test_without_a_form_it_is_made_of_the_statement(book):
    assert kernel_of(entry(x * x - y * y, None, (x, y)), book.judge.decide).heading.form == "stated"


def test_an_unequal_form_is_refused_with_a_point(book):
    with pytest.raises(
        EmissionError, match=r"made: the offered form is not equal to \(9\.8\), as one sees at"
    ) as error:
        kernel_of(entry(x * x - y * y, (x - y) * (x - y), (x, y)), book.judge.decide)
    assert "of z is" in str(error.value)


def test_a_form_that_divides_by_more_is_refused(book):
    with pytest.raises(EmissionError, match=r"made: the offered form is not proved to equal \(9\.8\).*divides by"):
        kernel_of(entry(x * y, x * y * y / y, (x, y)), book.judge.decide)


def test_a_form_may_divide_by_other_words_for_the_same(book):
    kernel = kernel_of(entry(sin(phi) / (1 - cos(phi)), cot(phi / 2), (phi,)), book.judge.decide)
    assert kernel.program.operations[Op.DIVIDE] == 1


def test_a_wrong_form_of_one_result_is_named():
    outputs = (Output("one", "", x + y), Output("other", "", x * y))
    request = composed("f", (x, y), outputs, form=(x + y, x * x))
    name, point = counterexample(request)
    assert name == "other"
    assert "of other is" in in_words((name, point))
    right = replace(request, form=(y + x, y * x))
    assert counterexample(right) is None
    assert differences(right, program_of(right)) == ()


def test_every_offered_form_of_the_book_is_refused_with_one_sign_changed(book):
    for name, statement in book.statements.items():
        form = statement.kernel.form
        if form is not None:
            wrong = requested(statement, book.judge.decide, replace(statement.kernel, name=name, form=-form))
            assert differences(wrong, program_of(wrong)) != ()
            assert counterexample(wrong) is not None


@pytest.mark.parametrize(
    ("right", "form", "of", "results", "said"),
    [
        (x * y, cross(u, u), (x, y), (), "made: the form offered for z does not fit"),
        (x * y, scalar("l", "l", "", LENGTH), (x, y), (), "made: the form offered for z does not fit"),
        (
            column(x, y, x),
            column(x, y),
            (x, y),
            ("a", "b", "c"),
            "made: its form has 2 blocks, and 3 results are",
        ),
        (dot(u, u), norm(w) ** 2, (u,), (), "made: w is free"),
    ],
)
def test_a_form_that_does_not_fit_is_refused(book, right, form, of, results, said):
    with pytest.raises(LoweringError, match=said):
        requested(entry(right, form, of, results), book.judge.decide)


def test_a_form_is_part_of_what_is_declared():
    from chasles.statements.fingerprint import fingerprint

    plainly, offered = entry(x * y, None, (x, y)), entry(x * y, y * x, (x, y))
    assert fingerprint(plainly.statement) != fingerprint(offered.statement)
