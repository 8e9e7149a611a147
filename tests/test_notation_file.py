"""Notations in TOML: letters and spellings are found again in print, and what is wrong in a file is told."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import chasles
from chasles.pages.findings_told import line_of
from chasles.reading.equations import read_equations
from chasles.reading.letter_table import BadNotation
from chasles.reading.notation_file import load_notation
from chasles.reading.pages import displayed
from chasles.reading.printed import PrintedEquation
from chasles.reading.proposal import proposed
from chasles.vocabulary import latex

NOTATION = r"""
[operators]
skew      = ['\tilde{#}', '\widetilde{#}', '[#]_\times', '#^\wedge', '[#\times]']
transpose = ['#^T', '#^\mathsf{T}', '#^\top']
norm      = ['\|#\|', '|#|']
identity  = ['\mathbf{1}', 'I', 'I_{3\times3}']
zero      = ['0', '\mathbf{0}']
function  = { '\operatorname{Exp}' = 'exp' }
quaternion_product = '# \otimes #'
adjoint   = '\operatorname{Ad}_{#}'

[symbols]
'\mathbf{Q}'          = { is = "rotation" }
'\mathbf{e}'          = "unit vector"
'\mathbf{r}_{##}'     = { is = "vector", unit = "m" }
'R_{##}'              = { is = "rotation", inverse = 'R_{swapped}' }
'\boldsymbol{\omega}' = "vector"
'\omega_{x|y|z}'      = { is = "component", of = '\boldsymbol{\omega}' }
'\phi'                = "angle"
'm'                   = { is = "scalar", unit = "kg", positive = true, constant = true }
'\mathbf{H}'          = { is = "matrix", shape = [4, 3] }
'p'                   = "quaternion"
'q'                   = "quaternion"
'G'                   = { is = "matrix", shape = [4, 4] }
'S'                   = { stands_for = '\phi \tilde{\mathbf{e}}' }

[section.'2'.symbols]
'm'                   = "rotation"

[equations]
'9' = { reading = '\mathbf{Q}\mathbf{e} = \mathbf{e}' }
"""
LOADED = load_notation(NOTATION)


def read(text: str, **place: str):
    return read_equations([PrintedEquation(text, **place)], LOADED)[0]


@pytest.mark.parametrize(
    ("text", "same"),
    [
        (r"\dot{\mathbf r}_A = [\boldsymbol\omega]_\times \mathbf{r}_A", r"\tilde{\boldsymbol{\omega}} \mathbf{r}_{A}"),
        (r"\mathbf Q^\top = \boldsymbol\omega^\wedge", r"\tilde{\boldsymbol{\omega}}"),
        (r"\mathbf Q = [\boldsymbol\omega\times]", r"\tilde{\boldsymbol{\omega}}"),
        (r"\mathbf Q = \widetilde{\mathbf{r}_A + \mathbf{e}}", r"\tilde{\mathbf{r}_{A} + \mathbf{e}}"),
        (r"R_{AB} = R_{BA}^\mathsf{T}", r"R_{B A}^T"),
        (r"\omega_x^2 = |\boldsymbol\omega|^2", r"\|\boldsymbol{\omega}\|^2"),
        (r"\mathbf{Q} = \operatorname{Exp}(\phi\mathbf e)", r"\operatorname{Exp}(\phi \mathbf{e})"),
        (r"p = q \otimes p", r"q \otimes p"),
        (r"1 = \cos^2\phi + \sin^2 \phi", r"\cos^2 \phi + \sin^2 \phi"),
        (r"\mathbf{r}_A \cdot \mathbf e = \mathbf{r}_A \cdot \mathbf e \times \boldsymbol\omega",
         r"\mathbf{r}_{A} \cdot \left( \mathbf{e} \times \boldsymbol{\omega} \right)"),
        (r"\dot{\mathbf r}_A = \frac{d}{dt}\left(\mathbf Q \mathbf{r}_B\right)",
         r"\frac{d}{dt} \left( \mathbf{Q} \mathbf{r}_{B} \right)"),
        (r"\phi = \frac12 m v", ""),
    ],
)  # fmt: skip
def test_spellings(text: str, same: str):
    found = read(text)
    assert found.status == ("read" if same else "unread")
    if same:
        assert latex(found.readings[0].parts[0].right) == same


def test_letters_know_what_they_are():
    (part,) = read(r"R_{AB} = R_{BA}").readings[0].parts
    assert part.left.meaning == "rotation"
    assert part.right.stands_for == part.left.T
    (part,) = read(r"m = \phi").readings[0].parts
    assert (part.left.meaning, part.left.constant) == ("positive", True)


def test_a_letter_may_be_another_in_a_section():
    assert read(r"m = \mathbf{Q}").readings[0].parts[0].fault
    assert not read(r"m = \mathbf{Q}", section="2 Kinematics").readings[0].parts[0].fault
    assert read(r"m = \mathbf{Q}", section="21 Dynamics").readings[0].parts[0].fault


def test_a_note_says_what_the_print_should_be():
    assert latex(read(r"\mathbf{Q}\mathbf{z}", number="9").readings[0].parts[0].right) == r"\mathbf{e}"


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("[symbol]", "near it: symbols"),
        ("[symbols", "no TOML"),
        ("symbols = 3", "expected a table, found 3"),
        ("[section]\n1 = 3", "expected a table, found 3"),
        ("[page]\nassuming = 'x = y'", "a list of equations"),
        ("[page]\nnotation = 3", "text in quotes, found 3"),
        ("[page]\nunits = 'x'", "true or false"),
        ("[operators]\nskew = 3", "expected a spelling"),
        ("[operators]\nfunction = { '\\f' = 3 }", "text in quotes, found 3"),
        ("[equations]\n1 = { role = 3 }", "text in quotes, found 3"),
        ("[symbols]\nx = { is = ['vector'] }", "text in quotes"),
        ("[symbols]\nx = { is = 'vector', unit = 3 }", "text in quotes, found 3"),
        ("[symbols]\nx = { is = 'vector', constant = 'no' }", "true or false"),
        ("[symbols]\nx = { is = 'array', size = true }", "a whole number, found True"),
        ("[symbols]\nx = { stands_for = 3 }", "text in quotes, found 3"),
        ("[symbols]\nx = { is = 'vektor' }", "near it: vector"),
        ("[symbols]\nx = { iss = 'vector' }", "near it: is"),
        ("[symbols]\n'a + b' = 'vector'", "not one letter"),
        ("[symbols]\n'a_' = 'vector'", "argument"),
        ("[symbols]\nx = { is = 'vector', unit = 'furlong' }", "kg m^2/s"),
        ("[symbols]\nx = { is = 'matrix', shape = 3 }", "[rows, columns]"),
        ("[symbols]\n'x_{1|2}' = { is = 'component', of = 'y' }", "no letter declared before it"),
        ("[symbols]\ny = { stands_for = 'a + b' }", "does not say what a is"),
        ("[symbols]\ny = { stands_for = 'y' }", "[symbols] 'y': what it stands for leads back to it"),
        ("[symbols]\ny = { stands_for = 'z' }\nz = { stands_for = 'y^T' }", "leads back to it"),
        ("[symbols]\n'\\mathbf{y}' = 'vector'\n'\\boldsymbol y' = 'matrix'", "'\\mathbf{y}' is the same letter"),
        ("[operators]\nskwe = '\\tilde{#}'", "near it: skew"),
        ("[operators]\nskew = 'a b c #'", "no pattern"),
        ("[operators]\nskew = '# \\times #'", "expected 1 '#', found 2"),
        ("[page]\nunit = true", "near it: units"),
    ],
)
def test_what_is_wrong_in_a_file_is_told(text: str, why: str):
    with pytest.raises(BadNotation) as told:
        load_notation(text)
    assert why in str(told.value)
    assert "\n" not in str(told.value)


PAGE = [
    r"\mathbf{R}\mathbf{R}^\top = \mathbf{1}, \quad \det(\mathbf{R}) = 1",
    r"\dot{\mathbf{x}} = \boldsymbol{\omega} \times \mathbf{x}' = \boldsymbol{\omega}^\wedge \mathbf{x}'",
    r"\omega_x^2 + \omega_y^2 + \omega_z^2 = \omega \cdot \omega",
    r"x = l_1 \cos\theta_1 + l_2 \cos\theta_2",
    r"{}^A\bar{v}^B = {}^A\bar{v}^C",
    r"\frac{1}{2} m \|\mathbf{v}\|^2 = \begin{bmatrix} a & b \end{bmatrix} \begin{bmatrix} c \\ f_1 \end{bmatrix}",
    r"a = \frac{",
]


def test_a_first_notation_is_proposed():
    equations = [PrintedEquation(text) for text in PAGE]
    text = proposed(equations)
    for line in (
        "transpose = ['#^\\top']",
        "'\\mathbf{R}' = { is = \"rotation\" }  # ? or matrix",
        "'\\boldsymbol{\\omega}' = { is = \"vector\" }",
        "'\\omega_{x|y|z}' = { is = \"component\", of = '\\omega' }",
        "'\\theta_{1}' = { is = \"angle\" }",
        '"\\\\mathbf{x}\'" = { is = "vector" }',
        "'{}^{A}\\bar{v}^{B}' = { is = \"vector\" }",
    ):
        assert line in text.splitlines(), text
    found = read_equations(equations, load_notation(text))
    assert [each.status for each in found] == ["read"] * 6 + ["unread"]


PATTERNS = r"""
[operators]
skew = ['#_\times', '[#]_\times']
inverse = ['#^{-1}']

[symbols]
'v' = 'vector'
'w' = 'vector'
'x_{#}' = 'scalar'
'x_{##}' = 'vector'
'R_{#B}' = 'rotation'
'R_{A#}' = 'matrix'
'\Gamma' = 'matrix'
'\bar{H}(#)' = { is = 'matrix', shape = [4, 3] }
'\rho' = 'scalar'
"""


def parts_of(text: str, *more: str):
    found = read_equations([PrintedEquation(each) for each in (text, *more)], load_notation(PATTERNS))
    return [reading.parts[0] for reading in found[0].readings]


def test_of_two_patterns_the_narrower_one_counts():
    (part,) = parts_of(r"x_a = x_b")
    assert part.left.shape == (1, 1)
    (part,) = parts_of(r"x_{ab} = v")
    assert not part.fault
    with pytest.raises(BadNotation, match=r"'R_\{#B\}' and 'R_\{A#\}' both match R_\{A B\}"):
        parts_of("R_{AB} = 1")


def test_what_matches_nothing_is_known():
    notation = load_notation(PATTERNS)
    read_equations([PrintedEquation(r"R_{CB} = x_a v_\times")], notation)
    assert {r"\Gamma", "w", "x_{##}"} < set(notation.unmatched)
    assert not {"v", "x_{#}", "R_{#B}"} & set(notation.unmatched)


@pytest.mark.parametrize(
    ("text", "more", "left"),
    [
        (r"\Gamma(v) w = 0", (), r"\Gamma(v) w"),
        (r"\Gamma(v)^{-1} = \Gamma^{-1}(w)", (), r"\Gamma(v)^{-1}"),
        (r"\dot\Gamma(v) w = v", (), r"\dot{\Gamma(v)} w"),
        (r"\Gamma(v - w) w = v", (r"\Gamma(v) = 1",), r"\Gamma(v - w) w"),
        (r"\Gamma(v - w) w = v", (), r"\Gamma(v - w) w"),
        (r"\Gamma(v - w) = v", (r"\Gamma w = v",), r"\Gamma \left( v - w \right)"),
        (r"\bar H(-v) w = \bar H(v) w", (), r"\bar{H}(- v) w"),
        (r"\rho(v) w = v", (), r"\rho(v) w"),
        (r"\rho (v + w) = v", (), r"\rho \left( v + w \right)"),
        (r"v_\times w = v", (), r"v_\times w"),
    ],
)
def test_what_stands_in_brackets_behind_a_letter_is_its_argument_if_the_page_has_it_so(text, more, left):
    (part,) = parts_of(text, *more)
    assert part.fault == ""
    assert latex(part.left).replace(" ", "") == left.replace(" ", "")


def test_quaternions_side_by_side_want_a_word():
    (found,) = read_equations([PrintedEquation("p q = p")], LOADED)
    assert "quaternion_product" in found.why


def test_values_of_a_function_are_different_quantities():
    (part,) = parts_of(r"\Gamma(v) = \Gamma(w)")
    assert part.left != part.right


OF_ANY_SIZE = r"""
[operators]
identity = ['\mathbf 1', 'I']
transpose = ['#^T']
norm = ['\|#\|']

[symbols]
'v' = 'vector'
'\xi' = { is = 'array', shape = [6, 1] }
"""


@pytest.mark.parametrize(
    ("text", "shapes"),
    [
        (r"\operatorname{tr}(I) = 6", {(3, 3), (6, 6)}),
        (r"\det(2 I) = 8", {(3, 3), (6, 6)}),
        (r"I^T I = I", {(3, 3), (6, 6)}),
        (r"\mathbf 1 = I", {(3, 3), (6, 6)}),
        (r"I = 1", {(3, 3), (6, 6)}),
        (r"\|0\| = 0", {(1, 1), (3, 1)}),
        (r"I v = v", {(3, 1)}),
        (r"I \xi = \xi", {(6, 1)}),
    ],
)
def test_an_identity_has_every_size_that_nothing_else_says(text, shapes):
    found = read_equations([PrintedEquation(text)], load_notation(OF_ANY_SIZE))[0]
    parts = [reading.parts[0] for reading in found.readings]
    assert not any(part.fault for part in parts)
    assert {part.left.of.shape if part.left.is_scalar else part.left.shape for part in parts} == shapes


def test_a_notation_is_proposed_for_broken_formulas_too():
    pages = (
        r"\hat{}_a = \frac{a + }{b} + \bar{\hat{}} \begin{bmatrix} \vec & a_{b_} \end{bmatrix}",
        r"\frac{a==b}{c}=1",
    )
    assert proposed([PrintedEquation(text) for text in pages]).startswith("[operators]")


ABBREVIATIONS = r"""
[operators]
identity = ['I']
transpose = ['#^T', '#^\mathsf{T}']
quaternion_product = '# #'
quaternion_conjugate = '#^*'

[symbols]
'v' = 'vector'
'w' = 'vector'
'm_{#}' = 'scalar'
'R' = 'rotation'
'a' = 'scalar'
'b' = 'scalar'
'\mathbf{q}' = 'unit quaternion'
'\mathbf{p}' = 'unit quaternion'
'\Delta a' = 'scalar'
"""


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        (r"I_3 v = \mathbf{1} v", [(r"I_{3} v", "=", r"\mathbf{1} v")]),
        (r"0_{3\times3} v = \mathbf{0}", [(r"0_{3 \times 3} v", "=", r"\mathbf{0}")]),
        (r"R = I + 0 \in SO(3)", [("R", "=", "I + 0")]),
        (r"a = b \approx m_1", [("a", "=", "b"), ("b", r"\approx", "m_{1}")]),
        (r"\sum_{i=1}^{3} m_i v = w", [("m_{1} v + m_{2} v + m_{3} v", "=", "w")]),
        (r"a \prod_{i=0}^{1} m_i = b", [(r"a \left( m_{0} m_{1} \right)", "=", "b")]),
        (r"a \pm b = b \mp \Delta a", [("a + b", "=", r"b - \Delta a"), ("a - b", "=", r"b + \Delta a")]),
        (r"\begin{bmatrix} v \\ w \end{bmatrix} = \begin{bmatrix} a & 0 \\ b & 1 \end{bmatrix}"
         r"\begin{bmatrix} w \\ v \end{bmatrix}",
         [(r"\begin{bmatrix} v \\ w \end{bmatrix}", "=",
           r"\begin{bmatrix} a w + 0 v \\ b w + 1 v \end{bmatrix}")]),
        (r"\Delta a\, v = w", [(r"\Delta a v", "=", "w")]),
        (r"\mathbf{pq} = \mathbf{q}^{-1}", [(r"\mathbf{p} \mathbf{q}", "=", r"\mathbf{q}^*")]),
        (r"\langle v, w\rangle = \bigl| R \bigr|", [(r"v \cdot w", "=", r"\det\left( R \right)")]),
        (r"\frac{{}^A d v}{dt} = w", [(r"\frac { {}^{A} d v} { d t}", "=", "w")]),
        (r"\begin{array}{rcl} a &=& b \\ &=& m_1 \end{array}", [("a", "=", "b"), ("b", "=", "m_{1}")]),
        (r"\begin{array}{lr} a = b \; , & v = w \; \end{array}", [("a", "=", "b"), ("v", "=", "w")]),
    ],
)  # fmt: skip
def test_what_a_formula_abbreviates(text, parts):
    (found,) = read_equations(displayed(text, "equation"), load_notation(ABBREVIATIONS))
    said = [(latex(part.left), part.sign, latex(part.right)) for part in found.readings[0].parts]
    assert said == parts


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (r"a \vdots b = 0", r"\vdots stands for what is left out"),
        (r"v \in \mathbb{R}^3", r"\in claims nothing"),
        (r"a = \lim", r"no word for \lim"),
        (r"a = \left\{ \begin{bmatrix} 1 \end{bmatrix} \right.", "\\{ is not closed"),
    ],
)
def test_what_has_no_word_is_told(text, why):
    (found,) = read_equations(displayed(text, "equation"), load_notation(ABBREVIATIONS))
    assert found.status == "unread"
    assert why in found.why


@pytest.mark.parametrize(
    ("text", "right"),
    [
        (r"a = \begin{cases} b, & \text{if } b > 0 \\ -b & b \leq 0. \end{cases}",
         r"\begin{cases} b & b > 0 \\ -b & \text{otherwise} \end{cases}"),
        (r"a = \begin{cases} 0 & a < b \\ 1 & a < 2 b \\ 2 & \text{otherwise} \end{cases}",
         r"\begin{cases} 0 & a < b \\ 1 & a < 2 b \\ 2 & \text{otherwise} \end{cases}"),
        (r"a = \begin{cases} b & b > 0 \\ -b & b < 0 \end{cases}",
         r"\begin{cases} b & b > 0 \\ -b & b < 0 \end{cases}"),
        (r"a = \begin{cases} b & \text{in summer} \\ -b & \text{otherwise} \end{cases}",
         r"\begin{cases} b & \text{in summer} \\ -b & \mathrm{otherwise} \end{cases}"),
        (r"v = b \sum_{i=1}^{n} m_i w", r"b \sum_{i = 1}^{n} m_{i} w"),
        (r"a = v \cdot \sum_i m_i w", r"v \cdot \sum_{i} m_{i} w"),
    ],
)  # fmt: skip
def test_cases_and_sums_over_what_is_no_number(text, right):
    (found,) = read_equations(displayed(text, "equation"), load_notation(ABBREVIATIONS))
    said = [latex(reading.parts[0].right).replace(" ", "") for reading in found.readings]
    assert said == ([right.replace(" ", "")] if right else [])


def test_the_notation_of_the_manual_is_one() -> None:
    notation = Path(__file__).parents[1] / "examples" / "reading" / "kinds.toml"
    page = chasles.read("$$|\\mathbf g|^2 = \\mathbf f\\cdot\\mathbf f$$\n\n$$R_{AB} R_{BA} = I_3$$", notation)
    assert [each.verdict for each in page.equations] == ["holds-under", "holds-under"]


@pytest.mark.parametrize(
    ("assumed", "message"),
    [
        ("m > 0", "'m > 0': expected an equation, and > is no sign of an equation"),
        (r"m = \foo", r"the notation does not say what \foo is"),
        ("m = m +", "something is missing at the end"),
        ("v = m", "cannot equate v (3 x 1) and m"),
        ("", "no relation stands in it"),
    ],
)
def test_what_is_assumed_has_to_be_an_equation(assumed: str, message: str) -> None:
    letters = {"m": "scalar", "a": "scalar", "v": "vector"}
    with pytest.raises(BadNotation, match=re.escape(message)):
        chasles.read("m a = 0", {"symbols": letters, "page": {"assuming": [assumed]}})


@pytest.mark.parametrize("entries", ["A_{##}", "A_{#}"])
def test_a_pattern_of_entries_names_them_by_their_numbers(entries: str) -> None:
    notation = f"[symbols]\n'A' = 'matrix'\n'a' = 'vector'\n'{entries}' = {{ is = 'entry', of = 'A' }}"
    page = r"$$\mathrm{Tr}(A) = A_{11} + A_{2,2} + A_{33}$$ $$A_{12} = A_{21}$$ $$A_{14} = 0$$ $$A_{x} = 0$$"
    found = chasles.read(page, notation).equations
    assert [each.verdict for each in found] == ["holds", "open", "unread", "unread"]
    assert [each.read.why for each in found[2:]] == [
        "A is 3 x 3 and has no column 4: they are counted from 1",
        "A_{x} names no entry of A",
    ]
    columns = "[symbols]\n'a' = 'vector'\n'a_{#}' = { is = 'component', of = 'a' }"
    assert chasles.read(r"$$\|a\|^2 = a_1^2 + a_2^2 + a_3^2$$", columns).equations[0].verdict == "holds"


def test_entries_of_a_matrix_are_proposed_as_such() -> None:
    page = r"$$ B = A^T A \quad (1)$$ $$x = A_{11} + A_{22} + A_{33} + A_{12} \quad (2)$$ $$\mathrm{Tr}(A) = 3 x$$"
    text = proposed(displayed(page, "md"))
    assert "A_{" not in text
    assert "Tr" not in text
    assert [each.verdict for each in chasles.read(page, text).equations] == ["defined", "defined", "open"]


def test_what_does_not_fit_with_a_proposed_notation_is_open() -> None:
    page = r"$$\mathbf{a} = \mathbf{b} + c$$ $$c = \cos d$$ $$c = 3$$"
    text = proposed(displayed(page, "md"))
    first, *_ = chasles.read(page, text).equations
    assert first.verdict == "open"
    assert "if the letters are what is proposed: cannot add" in line_of(first, "page.md")
    first, *_ = chasles.read(page, text.replace("proposed = true", "")).equations
    assert first.verdict == "ill-formed"


def test_what_is_divided_by_pi_is_decided() -> None:
    letters = {"symbols": {"a": "scalar", "b": "scalar"}}
    page = chasles.read(r"$$b = \frac{a}{2\pi} \tag{1}$$" + "\n" + r"$$2\pi b = a \tag{2}$$", letters)
    assert [each.verdict for each in page.equations] == ["defined", "holds"]


def test_an_i_with_the_subscript_one_is_no_identity_in_a_proposal() -> None:
    page = r"$$I_1 \dot\omega_1 - (I_2 - I_3) \omega_2 \omega_3 = 0$$ $$I_3 \dot\omega_3 = 0$$"
    assert "'I_{3}' = " in proposed(displayed(page, "md"))
    assert "'I_{3}'" not in proposed(displayed(r"$$\mathbf{Q} \mathbf{Q}^T = I_3$$", "md"))
