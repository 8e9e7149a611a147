"""What the prose of a page says of its letters, in the words of textbooks."""

from __future__ import annotations

from time import process_time

import pytest

import chasles
from chasles.decisions.session import Session
from chasles.pages.findings_told import line_of
from chasles.pages.page import read_page
from chasles.reading.glyphs import letter_in
from chasles.reading.notation_file import load_notation
from chasles.reading.pages import Kind, printed_page
from chasles.reading.proposal import proposed
from chasles.reading.prose import lead_of, said_of_letters

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
    r"Let $m$, $c$ and $k$ be positive constants.": {"m": "scalar", "c": "scalar", "k": "scalar"},
    r"where $a, b > 0$ and $\rho$ is the density of the fluid": {"a": "scalar", "b": "scalar", r"\rho": "scalar"},
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


@pytest.mark.parametrize(
    ("text", "letters"),
    [
        (r"\omega_n = \sqrt{\frac{k}{m}}, \quad \zeta = \frac{c}{2\sqrt{k\,m}}", {"k", "m"}),
        (r"f_0 = \frac{1}{2\pi\sqrt{L C_1 \lambda}}", {"L", "C_1", r"\lambda"}),
        (r"\sqrt{1 - 2x} + \sqrt[3]{y} + \sqrt{z^2} + \sqrt{\sin u} + \sqrt{\det A}", set()),
        (r"\sqrt{D} = 1, \quad D = b^2 - 4 a c", set()),
    ],
)
def test_letters_of_products_under_roots_are_proposed_as_positive(text: str, letters: set[str]) -> None:
    notation = proposed(printed_page(f"$$ {text} $$", "tex").equations)
    found = {letter.strip("'") for letter, _, said in (line.partition(" = ") for line in notation.splitlines())
             if "positive = true" in said}  # fmt: skip
    assert {letter_in(each) for each in found} == {letter_in(each) for each in letters}


@pytest.mark.parametrize("said", ["Let $m$ and $k$ be positive constants, and", ""])
def test_what_holds_of_positive_letters_alone_says_so(said: str) -> None:
    page = r"$$ w = \sqrt{\frac{k}{m}}, \quad z = \frac{c}{2\sqrt{k m}} $$ hence $$ 2 z w = \frac{c}{m} $$"
    assert _read(f"{said} {page}")[2].endswith(" holds under m > 0, k > 0")


def test_roles_of_structured_text_are_prose_too() -> None:
    text = "The unit vector :math:`\\mathbf{e}` and the mass :math:`m`.\n\n.. math:: m = 1\n"
    page = printed_page(text, "rst")
    assert [remark.latex for remark in page.remarks] == [r"\mathbf{e}", "m"]
    assert len(said_of_letters(page.remarks, "")) == 2
    assert len(page.equations) == 1


LEADING = {
    "The equation of motion is": True,
    "The equations of motion of the pendulum (see the figure) are": True,
    "By Newton's second law, the force is known. The body obeys": True,
    "where the state satisfies the differential equation": True,
    "Hooke's law states that": True,
    "We assume that": True,
    "subject to the constraint": True,
    "The system is governed by\n\n": True,
    "From the equation of motion we obtain": False,
    "Substituting into the equations of motion gives": False,
    "Inserting this, the equation of motion is": False,
    "The rotation satisfies the identity": False,
    "It obeys a law. It follows that": False,
    "The kinetic energy is": False,
    "whereas the *Euler equation* then takes the form": True,
    "The equations of motion of the cart can now be written as": True,
    "Its position is obviously perpendicular to the axis, i.e.,": True,
    "If the pitch is zero, the twist is a pure rotation, and the velocity is": False,
}


@pytest.mark.parametrize("text", LEADING)
@pytest.mark.parametrize(("kind", "opening"), [("tex", "$$"), ("tex", "\\begin{equation}"), ("md", "$$"), ("rst", "")])
def test_a_sentence_may_lead_to_a_law_and_not_to_what_follows(text: str, kind: Kind, opening: str) -> None:
    closing = opening.replace("begin", "end")
    display = f"\n\n.. math:: a + b = 1\n\n{text}\n\n.. math:: c + d = 2\n"
    page = display if kind == "rst" else f"{opening} a + b = 1 {closing}\n{text}\n{opening} c + d = 2 {closing}"
    first, second = printed_page(page, kind).equations
    assert not lead_of(first.before).is_posed
    assert lead_of(second.before).is_posed == LEADING[text]


def test_a_sentence_may_lead_to_a_case_to_what_follows_or_to_the_same_again_and_cite_others() -> None:
    assert lead_of("Hence the two screws are reciprocal if").is_case
    assert lead_of("this holds. It follows that").follows
    assert not lead_of("Both are given by").follows
    assert lead_of("At time $t = 0$ the position and the velocity are").is_local
    assert not lead_of("At time $t = 0$ it rests. Its velocity is").is_local
    assert lead_of("$$a = b$$\n\nor, equivalently,\n").again == lead_of("$$a = b$$\n\nor\n").again
    said = r"From Eqs. (3.4) and (3.5b), with \eqref{eq:x}, {eq}`two` and :eq:`three`,"
    assert lead_of(said).cited == ("three", "two", "eq:x", "3.5b", "3.4")


PENDULUM = r"""
A pendulum with the angle $\theta$ has the equation of motion
\begin{equation} \ddot{\theta} + \frac{g}{\ell} \sin\theta = 0 \end{equation}
and the energy
\begin{equation} E = \frac12 m \ell^2 \dot\theta^2 - m g \ell \cos\theta, \end{equation}
so that
\begin{equation} \dot{E} = 0. \end{equation}
"""


def _read(page: str) -> list[str]:
    printed = printed_page(page, "tex")
    found = read_page(printed.equations, load_notation(proposed(*printed)))
    return [line_of(each, "").partition(": ")[2] for each in found.equations]


def test_what_follows_from_a_law_of_the_page_may_need_that_letters_are_constant() -> None:
    law, energy, rate = _read(PENDULUM)
    assert law == "(1) assumed"
    assert energy.startswith("(2) defines E")
    assert rate == "(3) holds under (1), ell is constant, g is constant, m is constant"


def test_a_chapter_of_the_page_has_the_same_verdicts() -> None:
    printed = printed_page(PENDULUM, "tex")
    page = read_page(printed.equations, load_notation(proposed(*printed)))
    verdicts = [Session().decide(entry.statement).verdict.name for entry in page.chapter.entries]
    assert verdicts == ["assumed", "defined", "holds-under"]


def test_a_letter_with_a_rate_on_the_page_is_not_taken_for_constant() -> None:
    *_, rate, other = _read(PENDULUM + r"$$ \dot{g} = g - 1 $$")
    assert rate.startswith("(3) open")
    assert "g_dot" in other or "open" in other


def test_what_is_led_to_as_a_law_is_decided_where_it_can_be() -> None:
    right, wrong = _read(
        r"For a unit vector $\mathbf{e}$ the projection satisfies"
        r"$$ (\mathbf{e} \mathbf{e}^T)^2 = \mathbf{e} \mathbf{e}^T $$ and the governing equation is"
        r"$$ \mathbf{e} \times (\mathbf{e} \times \mathbf{v})"
        r" = (\mathbf{e} \cdot \mathbf{v}) \mathbf{e} + \mathbf{v} $$"
    )
    assert right.endswith("holds under |e| = 1")
    assert "fails" in wrong or "slip" in wrong


@pytest.mark.parametrize(
    "page",
    [
        r"\newcommand{\a}{" + "x+" * 7000 + "}\n" + r"the mass $\a$ is " * 20_000,
        "x" + " " * 239 + "$$ a = b $$" + ("x" + " " * 239 + "$$ c = d $$") * 200,
        ("x" + "\n \t" * 80 + "$$ a = b $$") * 200,
    ],
)
def test_hostile_prose_takes_no_more_work_than_its_length(page: str) -> None:
    before = process_time()
    found = printed_page(page, "tex")
    assert not any(lead_of(each.before).is_posed for each in found.equations)
    assert not found.remarks
    assert process_time() - before < 10


LETTERS = {
    "symbols": {
        "A": {"is": "matrix", "shape": [4, 3]},
        "b": {"is": "matrix", "shape": [4, 1]},
        "Q": "rotation",
        "e": "unit vector",
        **dict.fromkeys("acpq", "vector"),
        **dict.fromkeys("wxyzTV", "scalar"),
    },
    "operators": {"transpose": ["#^T"], "identity": ["I"]},
}
LED_TO = {
    r"""The point satisfies $$A p = b$$ where
$$A \equiv \begin{bmatrix} Q - I \\ e^T \end{bmatrix}, \quad b \equiv \begin{bmatrix} (Q - I) a \\ 0 \end{bmatrix}$$
Multiplying this by the transpose, $$A^T A p = A^T b.$$""": ["assumed", "defined", "defined", "holds-under"],
    r"One can write $$q - a = Q (p - a)$$ and hence $$q = a + Q (p - a).$$": ["open", "holds-under"],
    r"$$x = y + z$$ If $$y = z$$ then $$x = 2 z.$$": ["defined", "assumed", "holds-under"],
    r"The initial conditions are $$x = 0, \quad y = z$$ The sum is $$w = x + y$$ and $$w^2 = z^2.$$": [
        "assumed",
        "assumed",
        "defined",
        "open",
    ],
    r"Here $$x < z$$ The *Euler equation* is $$x^2 + x y = z$$ or $$w x = z + 1$$": ["open", "assumed", "assumed"],
    r"$$w = \underbrace{x^2}_T - \underbrace{x z}_{V} + \underbrace{y}_{y > 0}$$ $$w - T = y - V$$ $$w = y - T - V$$": [
        "defined",
        "holds",
        "fails",
    ],
}


@pytest.mark.parametrize("page", LED_TO)
def test_what_leads_to_equations_or_is_named_beside_them_counts(page: str) -> None:
    found = chasles.read(page, LETTERS, "md")
    assert [each.verdict for each in found.equations] == LED_TO[page]


def test_what_the_displays_say_by_others_is_not_taken_for_constant() -> None:
    page = r"of mass $M$ \[ M = \rho V \] and \[ p = M v \] with \[ p = \rho V v \]"
    printed = printed_page(page, "tex")
    notation = proposed(printed.equations, printed.remarks)
    assert "constant" not in notation
    assert [each.verdict for each in chasles.read(page, notation, "tex").equations] == ["defined", "defined", "holds"]


def test_what_is_defined_by_what_is_defined_is_looked_at_once() -> None:
    lines = "".join(rf"\[ a_{{{k + 3}}} = a_{{{k}}} b + a_{{{k + 1}}} c + a_{{{k + 2}}} \]" for k in range(1, 40))
    started = process_time()
    notation = {"symbols": {"a_{##}": "scalar", "b": "scalar", "c": "scalar"}}
    page = chasles.read(lines + r"\[ \dot a_{40} = b \]", notation, "tex")
    assert page.counts["defined"] == 39
    assert process_time() - started < 10
