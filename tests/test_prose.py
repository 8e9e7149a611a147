"""What the prose of a page says of its letters, in the words of textbooks."""

from __future__ import annotations

import pytest

from chasles.pages.page import read_page
from chasles.reading.glyphs import letter_in
from chasles.reading.notation_file import load_notation
from chasles.reading.pages import Kind, printed_page
from chasles.reading.proposal import proposed
from chasles.reading.prose import said_of_letters

SAID = {
    r"For a unit vector $\mathbf{e}$ and an angle $\phi$ the rotation is": {
        r"\mathbf{e}": "unit vector",
        r"\phi": "angle",
    },
    r"where $\hat{n}$ is the unit vector along the axis": {r"\hat{n}": "unit vector"},
    r"Let $R(t)$ be a rotation matrix.": {"R": "rotation"},
    r"with $\mathbf{u}$ and $\mathbf{v}$ unit vectors": {},
    r"the unit vectors $\mathbf{u}$ and $\mathbf{v}$": {r"\mathbf{u}": "unit vector", r"\mathbf{v}": "unit vector"},
    r"$\mathbf{u}$ and $\mathbf{v}$ are unit vectors": {r"\mathbf{u}": "unit vector", r"\mathbf{v}": "unit vector"},
    r"a \emph{symmetric matrix}~$\mathbf{A}$, say": {r"\mathbf{A}": "symmetric"},
    r"$M$ is the symmetric, positive definite mass matrix of the arm": {"M": "symmetric"},
    r"$q$ denotes a unit quaternion": {"q": "unit quaternion"},
    r"$R \in SO(3)$ and $\mathbf{n} \in \mathbb{S}^2$": {"R": "rotation", r"\mathbf{n}": "unit vector"},
    r"$\mathbf{p}, \mathbf{q} \in \mathbb{R}^{3}$": {r"\mathbf{p}": "vector", r"\mathbf{q}": "vector"},
    r"with $\|\mathbf{e}\| = 1$ and $\lVert f \rVert=1$": {r"\mathbf{e}": "unit vector", "f": "unit vector"},
    r"a pendulum of mass $m$ and length $\ell$": {"m": "scalar", r"\ell": "scalar"},
    r"the axis of the rotation matrix $R$": {"R": "rotation"},
    # What only sounds so.
    r"the center of mass $\mathbf{c}$": {},
    r"where $\mathbf{c}$ is the center of mass": {},
    r"$n$ is not a unit vector, and no rotation matrix $A$": {"A": "matrix"},
    r"the non-unit vector $n$": {"n": "vector"},
    r"$f$ is the mass flow rate": {},
    r"the vector $a$ and later the scalar $a$": {},
}


@pytest.mark.parametrize("text", SAID)
def test_nouns_beside_letters_say_what_they_are(text: str) -> None:
    found = said_of_letters(printed_page(text, "tex").remarks, "")
    assert {letter: said["is"] for letter, said in found.items()} == {letter_in(k): v for k, v in SAID[text].items()}


PAGE = r"""
With a unit vector {0}\mathbf{{e}}{1}, a body of mass {0}m{1} and the length {0}\ell{1} of a rope,
"""
EQUATIONS = r"""
$$ \mathbf{e} \times (\mathbf{e} \times \mathbf{p}) = \mathbf{e} (\mathbf{e} \cdot \mathbf{p}) - \mathbf{p} $$
$$ \frac{d}{dt} (m v^2) = 2 m v \dot{v} $$
$$ \frac{d}{dt} (\ell^2) = 2 \ell \dot{\ell} $$
"""


@pytest.mark.parametrize(("kind", "signs"), [("tex", ("$", "$")), ("tex", (r"\(", r"\)")), ("md", ("$", "$"))])
def test_what_is_proposed_is_what_the_prose_says(kind: Kind, signs: tuple[str, str]) -> None:
    page = printed_page(PAGE.format(*signs) + EQUATIONS, kind)
    notation = proposed(*page)
    assert r"""'\mathbf{e}' = { is = "unit vector" }""" in notation
    assert """'m' = { is = "scalar", constant = true, positive = true }""" in notation
    assert r"""'\ell' = { is = "scalar", positive = true }""" in notation  # it has a rate
    found = read_page(page.equations, load_notation(notation))
    assert [each.verdict for each in found.equations] == ["holds-under", "holds", "holds"]


def test_roles_of_structured_text_are_prose_too() -> None:
    text = "The unit vector :math:`\\mathbf{e}` and the mass :math:`m`.\n\n.. math:: m = 1\n"
    page = printed_page(text, "rst")
    assert [remark.latex for remark in page.remarks] == [r"\mathbf{e}", "m"]
    assert len(said_of_letters(page.remarks, "")) == 2
    assert len(page.equations) == 1
