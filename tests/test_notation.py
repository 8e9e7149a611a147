"""Each chapter prints words in its own notation, whatever other chapters are loaded beside it."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from types import ModuleType
from typing import Any, ClassVar

import pytest
from latex2mathml.converter import convert

from chasles.report.html.formulas import latex_for_mathml
from chasles.statements import symmetric, unit
from chasles.statements.matrices import invertible, orthonormal_columns, skew_symmetric
from chasles.vocabulary import (
    CPM,
    Identity,
    Node,
    Rate,
    Transpose,
    bracket,
    cos,
    cot,
    cross,
    det,
    dot,
    inverse,
    latex,
    matrix,
    norm,
    number,
    rate,
    scalar,
    sin,
    square,
    tan,
    tr,
    vect,
    vector,
)
from chasles.vocabulary.arguments import WrongArgument
from chasles.vocabulary.fitting import word
from chasles.vocabulary.functions import arctan, cosh
from chasles.vocabulary.notation import Notation
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.spelling import spell
from chasles.vocabulary.typesetting import Latex

DECLARATIONS = """
from chasles.vocabulary import scalar, square, vector
a = vector("a", "a", "a vector")
b = vector("b", "b", "a vector")
R = square("R", "R", "a matrix")
s = scalar("s", r"\\sigma", "a number")
"""
FORMS: dict[Any, str] = {
    CPM: r"[#1]_\times",
    Transpose: r"#1^\top",
    inverse: r"#1^{\mathrm{inv}}",
    norm: "|#1|",
    vect: r"#1^\vee",
    cross: r"#1 \wedge #2",
    dot: r"\langle #1, #2 \rangle",
    tr: r"\operatorname{tr}(#1)",
    det: r"\left|#1\right|",
    Identity: r"I_{#1}",
    Rate: r"\frac{d #1}{d t}",
    "sin": r"\mathrm{s}_{#1}",
}


@word
class SymmetricPart(Shorthand):
    """The symmetric part of a square matrix."""

    of: Node
    function: ClassVar[str] = "sym"

    @property
    def definition(self) -> Node:
        return (self.of + self.of.T) / 2


def chapter(name: str, **contents: Any) -> ModuleType:
    """A package of that name, with symbols in a module of its own."""
    package, symbols = ModuleType(name), ModuleType(f"{name}.notation")
    vars(package).update(contents)
    sys.modules |= {name: package, symbols.__name__: symbols}
    exec(compile(DECLARATIONS, f"{name}.py", "exec"), vars(symbols))
    return symbols


@pytest.fixture(name="own")
def chapter_with_a_notation() -> Iterator[ModuleType]:
    yield chapter("of_its_own", NOTATION=Notation(FORMS))
    del sys.modules["of_its_own"], sys.modules["of_its_own.notation"]


@pytest.fixture(name="plain")
def chapter_without() -> Iterator[ModuleType]:
    yield chapter("of_the_usual")
    del sys.modules["of_the_usual"], sys.modules["of_the_usual.notation"]


def test_words_are_printed_in_the_forms_of_their_chapter(own: ModuleType) -> None:
    a, b, R, s = own.a, own.b, own.R, own.s
    table: list[tuple[Node, str]] = [
        (CPM(a), r"[\mathbf{a}]_\times"),
        (CPM(a + b) @ R, r"[\mathbf{a} + \mathbf{b}]_\times \mathbf{R}"),
        (CPM(a) ** 2, r"[\mathbf{a}]_\times^2"),
        (R.T @ R - Identity(3), r"\mathbf{R}^\top \mathbf{R} - I_{3}"),
        ((R @ R).T, r"\left( \mathbf{R} \mathbf{R} \right)^\top"),
        (inverse(R), r"\mathbf{R}^{\mathrm{inv}}"),
        (norm(a - b), r"|\mathbf{a} - \mathbf{b}|"),
        (vect(R - R.T), r"\left( \mathbf{R} - \mathbf{R}^\top \right)^\vee"),
        (cross(a, b), r"\mathbf{a} \wedge \mathbf{b}"),
        (cross(cross(a, b), a), r"\mathbf{a} \wedge \mathbf{b} \wedge \mathbf{a}"),
        (cross(a, cross(b, a)), r"\mathbf{a} \wedge \left( \mathbf{b} \wedge \mathbf{a} \right)"),
        (dot(a, a + b), r"\langle \mathbf{a}, \mathbf{a} + \mathbf{b} \rangle"),
        (2 * tr(R), r"2 \operatorname{tr}(\mathbf{R})"),
        (det(R @ R), r"\left|\mathbf{R} \mathbf{R}\right|"),
        (rate(a), r"\frac{d \mathbf{a}}{d t}"),
        (sin(s) * R, r"\mathrm{s}_{\sigma} \mathbf{R}"),
    ]
    for hypothesis, printed in [
        (unit(a), r"|\mathbf{a}| = 1"),
        (symmetric(R), r"\mathbf{R} = \mathbf{R}^\top"),
        (skew_symmetric(R), r"\mathbf{R} = -\mathbf{R}^\top"),
        (orthonormal_columns(R), r"\mathbf{R}^\top \mathbf{R} = I_{3}"),
        (invertible(R), r"\left|\mathbf{R}\right| \neq 0"),
    ]:
        assert hypothesis.latex == printed
    for node, printed in table:
        assert latex(node) == printed
        assert "<math" in convert(latex_for_mathml(node))


def test_brackets_within_brackets_may_be_round(own: ModuleType) -> None:
    inner = own.a + own.b
    for round_brackets, opening in ((False, "["), (True, "(")):
        sys.modules["of_its_own"].NOTATION = Notation({}, round_brackets=round_brackets)  # type: ignore[attr-defined]
        assert latex(2 * (own.a + 2 * inner)).startswith(rf"2 \left{opening}")
        assert latex(bracket(inner)).startswith(r"\left[")


def test_functions_of_letters_and_fractions_may_have_no_brackets() -> None:
    angle = scalar("x", r"\theta_{1}", "an angle")
    usual, bare = Latex(), Latex(Notation({}, bare_arguments=True))
    for node, shown, short in (
        (tan(angle / 2), r"\tan\left( \frac{\theta_{1}}{2} \right)", r"\tan \frac{\theta_{1}}{2}"),
        (cosh(angle) ** 2, r"\cosh^2\left( \theta_{1} \right)", r"\cosh^2 \theta_{1}"),
        (cot(angle + 1) ** 2, *2 * (r"\cot^2\left( \theta_{1} + 1 \right)",)),
        (arctan(scalar("z", "z", "")), *2 * (r"\arctan z",)),
        (angle * cos(2 * angle), r"\theta_{1} \cos\left( 2 \theta_{1} \right)", r"\theta_{1} \cos 2 \theta_{1}"),
        (angle * cos(2 * angle) * angle, *2 * (r"\theta_{1} \cos\left( 2 \theta_{1} \right) \theta_{1}",)),
    ):
        assert (spell(node, usual).text, spell(node, bare).text) == (shown, short)


def test_what_stands_beside_each_other_is_a_product(own: ModuleType) -> None:
    sys.modules["of_its_own"].NOTATION = Notation({cross: "#1 #2"})  # type: ignore[attr-defined]
    a, b = own.a, own.b
    assert latex(2 * cross(a, b)) == rf"2 {latex(a)} {latex(b)}"
    assert latex(cross(cross(a, b), a)) == f"{latex(a)} {latex(b)} {latex(a)}"
    assert "left" in latex(cross(a, cross(a, b)))


def test_chapters_do_not_mix(own: ModuleType, plain: ModuleType) -> None:
    assert latex(CPM(own.a)) == r"[\mathbf{a}]_\times"
    assert latex(CPM(plain.a)) == r"\text{CPM}\left( \mathbf{a} \right)"
    assert latex(own.R.T) == r"\mathbf{R}^\top"
    assert latex(plain.R.T) == r"\mathbf{R}^T"
    assert own.a == plain.a, "the notation is no part of what a symbol is"


def test_a_word_of_ones_own_has_a_form_by_its_class_or_its_name(own: ModuleType) -> None:
    sys.modules["of_its_own"].NOTATION = Notation({SymmetricPart: r"\overline{#1}"})  # type: ignore[attr-defined]
    assert latex(SymmetricPart(own.R)) == r"\overline{\mathbf{R}}"
    sys.modules["of_its_own"].NOTATION = Notation({"sym": r"\{#1\}"})  # type: ignore[attr-defined]
    assert latex(SymmetricPart(own.R)) == r"\{\mathbf{R}\}"


@pytest.mark.parametrize(
    ("forms", "reason"),
    [
        ({CPM: r"\hat{a}"}, "name its 1 part(s)"),
        ({cross: r"#1 \times"}, "for Cross has to name its 2 part(s)"),
        ({CPM: "#1 #2"}, "for Skew has to name its 1 part(s)"),
        ({3: "#1"}, "3 is no word"),
        ({len: "#1"}, "is no word"),
        ({CPM: 7}, "7 for Skew"),
    ],
)
def test_a_form_that_does_not_fit_its_word_is_refused(forms: dict[Any, Any], reason: str) -> None:
    with pytest.raises(WrongArgument, match=re.escape(reason)):
        Notation(forms)


def test_a_notation_that_is_none_is_told(own: ModuleType) -> None:
    sys.modules["of_its_own"].NOTATION = {CPM: "#1"}  # type: ignore[attr-defined]
    with pytest.raises(TypeError, match="write Notation"):
        latex(own.a)


def test_numbers_alone_are_printed_as_usual() -> None:
    assert latex(number(2)) == "2"


OMEGA = r"{}^{\mathcal{B}}\boldsymbol{\omega}_{\mathcal{B}/\mathcal{N}}"
TURNED = r"{}^{I_k}_{G}\mathbf{R}"


def test_frames_stand_before_their_letters() -> None:
    """Dots, powers and components belong to the letter, and not to the scripts that stand before it."""
    omega, R, p = vector("omega", OMEGA, ""), square("R", TURNED, ""), vector("p", "{}^A p_B", "")
    printed = {
        rate(omega): r"{}^{\mathcal{B}}\dot{\boldsymbol{\omega}}_{\mathcal{B}/\mathcal{N}}",
        omega.x: r"{}^{\mathcal{B}}\omega_{\mathcal{B}/\mathcal{N},x}",
        rate(rate(R)): r"{}^{I_k}_{G}\ddot{\mathbf{R}}",
        R[1, 2]: r"{}^{I_k}_{G}R_{12}",
        R.T: TURNED + "^T",
        R**2: TURNED + "^2",
        p.z: "{}^A p_{B,z}",
    }
    for node, said in printed.items():
        assert latex(node) == said


def test_functions_of_letters_may_have_brackets() -> None:
    style, x = Latex(Notation({}, bare_arguments=False)), scalar("x", "x", "an angle")
    assert spell(cos(x) ** 2 * x, style).text == r"\cos^2\left( x \right) x"
    assert spell(arctan(x), style).text == r"\arctan\left( x \right)"


def test_a_line_of_a_matrix_may_begin_with_a_bracket(own: ModuleType) -> None:
    """Once the report ended with an error of its converter: to LaTeX, too, such a bracket is an option."""
    said = matrix((CPM(own.a), CPM(own.b)), (CPM(own.b), CPM(own.a)))
    assert latex(said).count("{}[") == 2
    assert convert(latex_for_mathml(said)).count("<mtr>") == 2
