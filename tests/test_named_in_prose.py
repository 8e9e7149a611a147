"""What lines of prose name, and the time: premises that no display states."""

from __future__ import annotations

import pytest

from chasles.pages.findings_told import line_of
from chasles.pages.page import read_page
from chasles.reading.notation_file import load_notation
from chasles.reading.pages import Kind, printed_page
from chasles.reading.proposal import proposed


def _read(text: str, kind: Kind = "tex") -> list[str]:
    page = printed_page(text, kind)
    found = read_page(page.equations, load_notation(proposed(*page))).equations
    return [line_of(each, "").partition(": ")[2] for each in found]


def _named(text: str, kind: Kind = "tex") -> list[list[str]]:
    return [[each.latex.strip() for each in equation.beside] for equation in printed_page(text, kind).equations]


NAMING = {
    "A disc that rolls with $v = R w$ and $I = m R^2/2$ has": ["v = R w", "I = m R^2/2"],
    "Let $k := a/b$. Then": ["k := a/b"],
    "The angular velocity $w = v/R$ is known, and": ["w = v/R"],
    "We denote by $D$ the discriminant, with $D = b^2 - 4 a c$, so that": ["D = b^2 - 4 a c"],
    "If $a = b$, then": [],
    "At the point $x = a$ we find": [],
    "For a constant speed with $v = 3$,": [],
    "It follows that $v = R w$, hence": [],
    "where $a = b = c$ and $x < a$,": [],
    "such that with $x \\approx a$ or $y = b \\pm c$": [],
}


@pytest.mark.parametrize(("kind", "signs"), [("tex", ("$$", "$$")), ("md", ("$$", "$$")), ("tex", ("\\[", "\\]"))])
@pytest.mark.parametrize("text", NAMING)
def test_prose_names_letters_for_the_display_that_follows(text: str, kind: Kind, signs: tuple[str, str]) -> None:
    assert _named(f"{text}\n{signs[0]} p = q {signs[1]}", kind) == [NAMING[text]]


def test_a_sentence_that_goes_on_names_letters_of_its_display() -> None:
    display = "$$ p = q $$"
    assert _named(f"{display} where $q = a/b$ and $c = d e$. Let $f = g h$. {display}") == [
        ["q = a/b", "c = d e"],
        ["q = a/b", "c = d e", "f = g h"],
    ]


def test_claims_rest_on_what_prose_names_and_displays_define_what_they_define() -> None:
    rolling = r"$$ T = \frac12 m v^2 + \frac12 I w^2 = \frac34 m v^2 $$"
    said = "A disc that rolls with $v = R w$ and $I = m R^2/2$ has the energy "
    assert "open" in _read(rolling)[1]
    assert _read(said + rolling)[1] == "part 2 holds"
    assert _read(rolling.replace("$$", "$$ ", 1) + said.replace("A disc", "where it") + ".")[1] == "part 2 holds"
    assert _read("with $v = R w$ $$ v = a + b $$")[0] == "defines v"


MOTION = r"""
$$ x(t) = A \cos(w t) + B \sin(w t) $$
$$ \dot x(t) = -A w \sin(w t) + B w \cos(w t) $$
$$ \ddot x + w^2 x = 0 $$ Its velocity is $$ v = \frac{dx}{dt} $$
$$ v^2 + w^2 x^2 = w^2 (A^2 + B^2) $$
"""


def test_the_letter_t_is_the_time_where_a_page_has_functions_of_it() -> None:
    still = "holds under A is constant, B is constant, w is constant"
    assert _read(MOTION) == ["defines x(t)", still, still, "part 2 defines v", "holds"]


def test_a_thickness_is_no_time() -> None:
    assert "t is constant" in _read(r"$$ V = a t $$ with a rate $$ \dot V = \dot a t $$")[1]


def test_what_a_page_defines_is_not_taken_to_be_constant() -> None:
    assert "constant" not in _read(r"$$ T = m \dot x^2, \quad E = T + V $$ and $$ \frac{d E}{d t} = \dot V $$")[2]


BEAM = r"$$ w(x) = \frac{P x^2}{6 E I} (3 L - x), \qquad w(L) = \frac{P L^3}{3 E I} $$ Its end, $$ w(\frac{L}{2}) = "


@pytest.mark.parametrize(
    ("value", "verdict"), [(r"\frac{5 P L^3}{48 E I}", "holds"), (r"-\frac{5 P L^3}{48 E I}", "fails")]
)
def test_functions_that_a_page_defines_have_values(value: str, verdict: str) -> None:
    first, second, third = _read(f"{BEAM} {value} $$")
    assert first == "defines w(x)"
    assert second.startswith("part 2 holds")
    assert verdict in third


def test_a_function_that_is_defined_twice_or_bound_has_no_values() -> None:
    twice = r"$$ f(x) = x^2 $$ and elsewhere $$ f(x) = x^3, \quad g(x) = \int_0^x f(s) d s $$"
    page = printed_page(rf"{twice} $$ f(2) = 4, \quad g(2) = 1 $$", "tex")
    assert not any(equation.beside for equation in page.equations)
