"""LaTeX as tokens: one spelling of what looks the same in print, places, and a clear line for what is broken."""

from __future__ import annotations

import re
import tomllib
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chasles.reading.atoms import marks_of
from chasles.reading.lexemes import BadPage
from chasles.reading.respelling import atoms_in

from .sampling import WHOLE

PRINTED: dict[str, str] = tomllib.loads((Path(__file__).parent / "printed.toml").read_text(encoding="utf-8"))


def text_of(latex: str) -> str:
    return " ".join(marks_of(atoms_in(latex)))


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\frac12 x^12", r"\frac { 1 } { 2 } x ^ { 1 } 2"),
        (r"12.5x + .5", "12.5 x + .5"),
        (r"a = 2.", "a = 2"),
        (r"\mathbf p_1^T", r"\mathbf { p } _ { 1 } ^ { T }"),
        (r"x^T_1", "x _ { 1 } ^ { T }"),
        (r"{\bf p}^{\rm T}", r"\mathbf { p } ^ { \mathrm { T } }"),
        (r"\mathbf{\dot p}", r"\dot { \mathbf { p } }"),
        (r"\mathbf{Ab}", r"\mathbf { A } \mathbf { b }"),
        (r"\mathbf{R^T}", r"\mathbf { R } ^ { T }"),
        (r"\boldsymbol{\mathcal{T}}", r"\boldsymbol { \mathcal { T } }"),
        (r"\mathbf{\sin x}", r"\sin \mathbf { x }"),
        (r"\mathbf{e}'_j", r"\mathbf { e } _ { j } '"),
        (r"x^{\prime\prime}", "x ' '"),
        (r"{x_i}^2", "x _ { i } ^ { 2 }"),
        (r"{x^2}^3", "{ x ^ { 2 } } ^ { 3 }"),
        (r"{a + b}c", "a + b c"),
        (r"{}^A R_B", "{ } ^ { A } R _ { B }"),
        (r"= _A p (^B q)", "= { } _ { A } p ( { } ^ { B } q )"),
        (r"\begin{bmatrix} a && b \\ c && d \\ \end{bmatrix}", r"\begin{bmatrix} a & b \\ c & d \end{bmatrix}"),
        (r"\begin{bmatrix} a & \\ & b \end{bmatrix}", r"\begin{bmatrix} a & \\ & b \end{bmatrix}"),
        (r"\begin{bmatrix} & \\ & \end{bmatrix}", r"\begin{bmatrix} & \\ & \end{bmatrix}"),
        (r"\boldsymbol{\mathbf{\mathcal{X}}}", r"\boldsymbol { \mathbf { \mathcal { X } } }"),
        (r"\mbox{\boldmath $\omega$}_1\text{.}", r"\boldsymbol { \omega } _ { 1 }"),
        (r"\left[\begin{array}{cc} a & b \\[2pt] c & d \end{array}\right]^{-1}",
         r"\begin{bmatrix} a & b \\ c & d \end{bmatrix} ^ { - 1 }"),
        (r"\pmatrix{a & b \cr c & d}", r"\begin{pmatrix} a & b \\ c & d \end{pmatrix}"),
        (r"\text{vect}(\Omega), \quad \text{or} \quad a = b. ",
         r"\operatorname{vect} ( \Omega ) , \quad \text{or} \quad a = b"),
        (r"a = b \quad c = d", r"a = b \quad c = d"),
        (r"a = b \\ \quad + c", r"a = b \\ + c"),
        (r"{a \over b}", r"\frac { a } { b }"),
        (r"{\rm tr} A + \mathrm{SO}(3)", r"\operatorname{tr} A + \operatorname{SO} ( 3 )"),
        (r"\operatorname*{arg\,max}_x", r"\operatorname{argmax} _ { x }"),
        (r"\underbrace{a+b}_{c}", "a + b"),
        (r"\left. d \right|_{0}", "d | _ { 0 }"),
        (r"\lVert x \rVert \dfrac{a}{b}", r"\| x \| \frac { a } { b }"),
        (r"A^{\intercal} B\intercal", r"A ^ { \top } B ^ { \top }"),
        (r"a\hspace*{2cm}b\,c\!d\kern-2pt e", r"a \quad b c d e"),
        ("α² × 𝐩₁ − ‖𝒒‖", r"\alpha ^ { 2 } \times \mathbf { p } _ { 1 } - \| \boldsymbol { q } \|"),
        (r"a \label{x} = b % c", "a = b"),
        (r"a := b \coloneqq c \stackrel{!}{=} d", r"a := b := c \triangleq d"),
        ("", ""),
    ],
)  # fmt: skip
def test_one_spelling(latex: str, expected: str) -> None:
    assert text_of(latex) == expected
    assert text_of(expected) == expected


@pytest.mark.parametrize("number", list(PRINTED)[::8])
def test_printed_again_they_are_the_same(number: str) -> None:
    once = text_of(PRINTED[number])
    assert text_of(once) == once


def test_tokens_have_their_places() -> None:
    assert [tuple(atom.place) for atom in atoms_in("a\n  +\\beta % c\n = b", 7, 3)] == [
        ("a", 7, 3), ("+", 8, 3), (r"\beta", 8, 4), ("=", 9, 2), ("b", 9, 4),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("latex", "message", "column"),
    [
        (r"x_a_b", "two scripts _ at one place", 4),
        (r"\frac{a", "{ is not closed", 6),
        (r"a }", "} closes nothing", 3),
        (r"\sqrt", r"an argument is missing after \sqrt", 1),
        (r"x_", "an argument is missing after _", 2),
        (r"\begin{bmatrix} a \end{pmatrix}", r"\begin{bmatrix} is closed by \end{pmatrix}", 19),
        (r"\begin{bmatrix} a", r"\begin{bmatrix} has no \end{bmatrix}", 1),
        (r"\end{x}", r"\end closes nothing", 1),
        (r"\left", r"a bracket is missing after \left", 1),
        ("{" * 1000, "groups nested more than 60 deep", 62),
        (r"\dot" * 1000, "groups nested more than 60 deep", 245),
        ("x" * 30_000, "an equation of more than 20000 tokens: write it as several", 20_001),
    ],
)
def test_what_is_broken_is_said_with_its_place(latex: str, message: str, column: int) -> None:
    with pytest.raises(BadPage) as refused:
        atoms_in(latex)
    assert (str(refused.value), refused.value.column) == (message, column)


MATRICES = st.lists(st.sampled_from(["a", "&", "&&", r"\\", r"\hline", "{}", " "]), max_size=9).map(" ".join)


@given(MATRICES)
def test_matrices_with_empty_cells_are_split(inside: str) -> None:
    once = text_of(rf"\begin{{bmatrix}} {inside} \end{{bmatrix}}")
    assert text_of(once) == once


WORDS = re.split(
    r"\s+",
    r"""\frac \mathbf \bf \rm \left \right \begin \end \begin{bmatrix} \end{bmatrix} \over \sqrt \text \hspace \quad
    \label \operatorname \prime \kern \matrix \underbrace \\ \dot {x} [2pt] * ² α""",
)
PIECES = st.sampled_from([*r"ab12{}[]()&^_'=+-.,|~$%\ ", "\n", "\\\n", *WORDS])


@settings(max_examples=300 if WHOLE else 100, deadline=None)
@given(st.lists(PIECES, max_size=40).map("".join))
def test_whatever_stands_there_it_is_split_or_refused(latex: str) -> None:
    with suppress(BadPage):
        text_of(latex)
