"""Roles and premises without a person: what each equation of a page is, in its order, and from what it follows."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import pytest

import chasles
from chasles.pages.deduction import Deduction
from chasles.pages.facts import divisors, facts_of, kind_in_meaning
from chasles.pages.findings_told import told
from chasles.pages.notes import EquationNote
from chasles.pages.premises import Premises, balancing, chosen_rules
from chasles.statements import Definition, Statement, rotation, unit
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    Identity,
    Integral,
    Node,
    Symbol,
    Zero,
    at,
    column,
    cos,
    cross,
    det,
    dot,
    norm,
    number,
    paren,
    rate,
    scalar,
    sin,
    square,
    tr,
    vector,
)

from .counted import at_most

a, b, c, d, p, r = (vector(name, name, "a vector") for name in "abcdpr")
e = vector("e", "e", "unit vector along the axis")
Q = square("Q", "Q", "rotation")
M, N = square("M", "M", "a matrix"), square("N", "N", "a matrix")
x, y, s, m, k = (scalar(name, name, "a scalar") for name in "xysmk")
phi = scalar("phi", r"\phi", "an angle")
omega = vector("omega", r"\omega", "angular velocity", FREQUENCY)
one = Identity(3)
turn = e @ e.T + cos(phi) * (one - e @ e.T) + sin(phi) * CPM(e)
Equation = tuple[Node, str, Node]


def eq(left: Node, right: Node, sign: str = "=") -> Equation:
    return left, sign, right


def said(equations: Sequence[Equation], roles: Sequence[str] = ()) -> list[str]:
    """The verdicts on equations in a row, open ones as such."""
    deduction = Deduction(Premises(lambda symbol: facts_of(symbol, kind_in_meaning(symbol))))
    found = []
    for number_, (left, sign, right) in enumerate(equations, 1):
        role = roles[number_ - 1] if number_ <= len(roles) else ""
        finding = deduction.say(str(number_), 1, left, sign, right, EquationNote(role))
        found.append("open" if finding.open else finding.verdict.name)
    return found


PAGES: dict[str, tuple[list[Equation], list[str]]] = {
    "an identity": ([eq(CPM(a) @ b, cross(a, b))], ["holds"]),
    "an identity with a sign lost": ([eq(CPM(a) @ b, -CPM(b) @ a), eq(CPM(a) @ b, CPM(b) @ a)], ["holds", "fails"]),
    "a factor lost": ([eq(cos(2 * phi), 2 * cos(phi) ** 2 - 1), eq(sin(2 * phi), sin(phi) * cos(phi))],
                      ["holds", "fails"]),
    "a fact of the notation": ([eq(Q.T @ Q, one), eq(norm(e) ** 2, number(1)), eq(det(Q), number(1))],
                               ["holds-under", "holds-under", "holds-under"]),
    "of a symbol without a fact": ([eq(M.T @ M, one), eq(norm(a) ** 2, number(1))], ["open", "open"]),
    "a definition and what follows": ([eq(c, cross(a, b)), eq(dot(c, a), number(0)), eq(c, -cross(b, a))],
                                      ["defined", "holds", "holds"]),
    "a definition, and a sign lost": ([eq(c, cross(a, b)), eq(c, cross(b, a))], ["defined", "fails"]),
    "a definition, and another letter": ([eq(c, cross(a, b) + r), eq(d, b), eq(c, cross(a, p) + r)],
                                         ["defined", "defined", "fails"]),
    "another value": ([eq(x, number(2)), eq(x, number(4))], ["defined", "open"]),
    "another choice of two letters": ([eq(x, dot(a, b)), eq(x, dot(a, c))], ["defined", "open"]),
    "a term more, which one letter would cancel": (
        [eq(y, x * s), eq(y, x * (s + (m - k) * x))], ["defined", "open"]),
    "defined on the right": ([eq(cross(a, b), c), eq(dot(c, a), number(0))], ["defined", "holds"]),
    "an axis, which is a condition": ([eq(Q @ e, e)], ["open"]),
    "an axis, which follows": ([eq(Q, turn), eq(Q @ e, e)], ["defined", "holds-under"]),
    "a condition on what was used": ([eq(p, a + x * e), eq(e.T @ p, number(0))], ["defined", "open"]),
    "two lines meet": ([eq(p, a + x * c), eq(p, b + y * d)], ["defined", "open"]),
    "points are displaced alike": ([eq(c, b - a), eq(d, r - p), eq(c, d)], ["defined", "defined", "open"]),
    "an open equation is used": ([eq(p - a, Q @ (r - b)), eq(p, a + Q @ (r - b))], ["open", "holds-under"]),
    "two open equations, no verdict of a contradiction": (
        [eq(p - a, Q @ (r - b)), eq(p, a - Q @ (r - b))], ["open", "open"]),
    "a line, which is a condition": (
        [eq(cross(b - a, p - a), Zero(3, 1)), eq(cross(b - a, p) + cross(a, b - a), Zero(3, 1))],
        ["open", "holds-under"]),
    "an open equation is a rule": (
        [eq(c, b - a), eq(d, r - p), eq(c, d), eq(c, r - p)], ["defined", "defined", "open", "holds-under"]),
    "a screw axis, which is a condition": (
        [eq(Q, turn), eq(d, b - a), eq(x, e.T @ d), eq(c, x * e), eq(e.T @ p, number(0)),
         eq(c, d + (Q - one) @ (p - a))],
        ["defined", "defined", "defined", "defined", "open", "open"]),
    "a divisor": ([eq(r, a / norm(a)), eq(dot(r, r), number(1))], ["defined", "holds-under"]),
    "rates follow": ([eq(at(p), at(Q) @ a, "="), eq(rate(at(p)), rate(at(Q)) @ a + Q @ rate(a))],
                     ["defined", "holds"]),
    "defined twice": ([eq(r, a), eq(s, x), eq(r, b, ":="), eq(cross(r, a), Zero(3, 1)), eq(cross(r, b), Zero(3, 1))],
                      ["defined", "defined", "defined", "holds", "holds"]),
    "ill-formed": ([eq(p, Q), eq(a, b + one @ c)], ["ill-formed", "defined"]),
    "used, then defined": ([eq(M @ a, b), eq(M, N, r"\equiv"), eq(tr(M), tr(N))], ["defined", "defined", "holds"]),
    "a wrong law gives nothing away": ([eq(norm(a), number(2)), eq(norm(a), number(3)), eq(dot(a, b), dot(c, b))],
                                       ["open", "open", "open"]),
    "a motion, which is a law": ([eq(rate(p), cross(omega, p)), eq(dot(p, rate(p)), number(0))],
                                 ["defined", "holds"]),
    "a motion, of a letter that is said to be something": (
        [eq(p, cross(a, b)), eq(rate(p), cross(omega, p)), eq(rate(p), cross(p, omega))], ["defined", "open", "open"]),
}  # fmt: skip


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", PAGES)
def test_equations_in_a_row_get_roles_and_premises(name: str) -> None:
    equations, verdicts = PAGES[name]
    assert said(equations) == verdicts


def test_a_person_may_say_what_an_equation_is() -> None:
    page = [eq(norm(a), number(1)), eq(dot(a, a), number(1)), eq(norm(b), number(1))]
    assert said(page, ["law"]) == ["assumed", "holds-under", "open"]
    assert said(page, ["claim", "claim", "claim"])[2] == "fails"


@pytest.mark.parametrize(("symbol", "fact"), [(Q, rotation), (e, unit), (M, None), (a, None)])
def test_a_meaning_that_begins_with_a_kind_says_it(symbol: Symbol, fact: Callable[[Node], object] | None) -> None:
    found = facts_of(symbol, kind_in_meaning(symbol))
    assert found == (() if fact is None else (fact(symbol),))


def test_divisors_are_named_once() -> None:
    sides = (a / (2 * norm(a)), paren(x / (1 - cos(phi))) * b / norm(a) ** 2, column(x / y, 1, 2))
    assert [h.text for h in divisors(sides)] == ["|a| != 0", "1 - cos(phi) != 0", "y != 0"]


AXIAL = [eq(Q, turn), eq(e, paren(Q - Q.T) @ a)]


def test_what_a_definition_rests_on_is_not_defined_by_it() -> None:
    assert said([eq(Q, turn), eq(a, e), eq(e, -a)]) == ["defined", "defined", "fails"]
    assert said(AXIAL) == ["defined", "open"]


LOST: list[tuple[Equation, Equation]] = [
    (eq(CPM(a).T, -CPM(a)), eq(CPM(a).T, CPM(a))),
    (eq(tr(e @ e.T), number(1)), eq(tr(e @ e.T), number(2))),
    (eq(norm(cross(a, b)) ** 2, norm(a) ** 2 * norm(b) ** 2 - dot(a, b) ** 2),
     eq(norm(cross(a, b)) ** 2, norm(a) ** 2 * norm(b) ** 2 + dot(a, b) ** 2)),
    (eq(cross(a, cross(b, c)), dot(a, c) * b - dot(a, b) * c),
     eq(cross(a, cross(b, c)), dot(a, c) * b + dot(a, b) * c)),
    (eq(cos(x + y), cos(x) * cos(y) - sin(x) * sin(y)), eq(cos(x + y), cos(x) * cos(y) + sin(x) * sin(y))),
    (eq(sin(2 * phi), 2 * sin(phi) * cos(phi)), eq(sin(2 * phi), 2 * sin(phi) * sin(phi))),
    (eq(CPM(a) @ CPM(b), b @ a.T - dot(a, b) * one), eq(CPM(a) @ CPM(b), b @ a.T + dot(a, b) * one)),
    (eq((M @ N).T, N.T @ M.T), eq((M @ N).T, M.T @ N.T)),
    (eq(Q @ CPM(a) @ Q.T, CPM(Q @ a)), eq(Q.T @ CPM(a) @ Q.T, CPM(Q @ a))),
    (eq(Q @ cross(a, b), cross(Q @ a, Q @ b)), eq(Q @ cross(a, b), cross(Q @ a, Q.T @ b))),
    (eq(e @ e.T, one + CPM(e) @ CPM(e)), eq(e @ e.T, one - CPM(e) @ CPM(e))),
    (eq(cos(phi) ** 2, (1 + cos(2 * phi)) / 2), eq(cos(phi) ** 2, (1 + sin(2 * phi)) / 2)),
]  # fmt: skip


@pytest.mark.parametrize(("right", "wrong"), LOST)
def test_one_mark_is_found(right: Equation, wrong: Equation) -> None:
    assert said([right])[0] in ("holds", "holds-under")
    assert said([wrong]) == ["fails"]


def rules_of(*definitions: Definition) -> dict[tuple[Symbol, int], Statement]:
    return {(each.left, 0): each for each in definitions if isinstance(each.left, Symbol)}


def test_what_stands_on_one_side_is_said_otherwise_the_last_first() -> None:
    first, second = Definition("1", d, cross(a, b)), Definition("2", c, p)
    third = Definition("3", s, dot(p, d))
    place = {id(each): k for k, each in enumerate((first, second, third))}
    rules = rules_of(first, second, third)
    found = [[each.number for each in some.values()] for some in balancing(s, dot(c, d), rules, place)]
    assert found == [["3"], ["3", "2"]], "d stands on both sides, and stays"


def test_no_rule_makes_the_same_for_all_elements_what_an_integral_is_over() -> None:
    density = scalar("rho", r"\rho", "density", constant=True)
    body = Integral(density * p, density, (p,))
    assert not chosen_rules((body, c), rules_of(Definition("1", p, a)))
    assert chosen_rules((body, c), rules_of(Definition("1", p, p_0 := r + a), Definition("2", c, p_0))).keys() == {
        (c, 0)
    }


def test_rules_for_rates_do_not_lead_in_circles() -> None:
    """x says what y is, and the rate of y what the rate of x is."""
    there, back = Definition("1", p, cross(a, r)), Definition("2", rate(r), rate(p))
    rules: dict[tuple[Symbol, int], Statement] = {(p, 0): there, (r, 1): back}
    assert len(chosen_rules((p, rate(r), rate(p)), rules)) == 1


def test_a_power_of_many_factors_is_not_written_out() -> None:
    page = r"\[ L = (1 - x)^{1750763} \log y \] \[ L + 1 = 1 + (1 - x)^{1750763} \log y \] \[ A^{1750763} = A L \]"
    with at_most(calls=20_000_000):
        found = chasles.read(page, {"symbols": {"L": "scalar", "x": "scalar", "y": "positive", "A": "matrix"}}, "tex")
    assert found.counts["read"] == 3


def test_what_another_section_says_otherwise_is_a_premise_in_its_own() -> None:
    page = r"""
# Global
$$ R = B A $$
$$ B = R A^{-1} $$
# Local
$$ A B = R $$
$$ A^{-1} A B = A^{-1} R $$
$$ B = A^{-1} R $$
"""
    found = chasles.read(page, {"symbols": dict.fromkeys("ABR", "matrix")}, "md").equations
    assert [each.verdict for each in found] == ["defined", "holds-under", "open", "holds-under", "holds-under"]
    assert found[2].finding
    assert found[2].finding.instead


def test_a_letter_t_that_is_no_number_is_not_the_time() -> None:
    page = r"$$x(t) = t \cdot t$$ $$\frac{dx}{dt} = \dot{x}$$"
    assert [each.verdict for each in chasles.read(page, {"symbols": {"x": "scalar", "t": "vector"}}).equations]


OF_TWO_SECTIONS = {
    **dict.fromkeys((r"\mathbf{a}", r"\mathbf{b}", r"\mathbf{c}", r"\mathbf{v}", r"\mathbf{h}"), "vector"),
    **dict.fromkeys(("E", "m", "k", "x", "y", "X", "Y", "Z", "f", "X'", "Y'"), "scalar"),
    r"\mathbf{R}": "matrix",
    r"\boldsymbol{\omega}": "vector",
    r"\theta": "angle",
}
TURN = r"\begin{bmatrix} \cos\theta & -\sin\theta & 0 \\ \sin\theta & \cos\theta & 0 \\ 0 & 0 & 1 \end{bmatrix}"


def of_sections(*equations: str) -> list[str]:
    """What is told of equations of a section each."""
    page = "\n".join(rf"\section{{S}} \begin{{equation}} {each} \end{{equation}}" for each in equations)
    return [told(each) for each in chasles.read(page, {"symbols": OF_TWO_SECTIONS}, "tex").equations]


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (rf"\mathbf{{R}} = {TURN}", rf"\mathbf{{R}} = {TURN.replace('-', '')}"),
        (r"E = \frac{1}{2} m y^2 + \frac{1}{2} k x^2", r"E = \frac{1}{2} m y^2 - \frac{1}{2} k x^2"),
        (r"E = m y^2 + \frac{1}{2} k x^2", r"E = m y^3 + \frac{1}{2} k x^2"),
        (r"m\dot{\mathbf{v}} = \boldsymbol{\omega} \times \mathbf{h} + k \mathbf{a}",
         r"m\dot{\mathbf{v}} = \boldsymbol{\omega} \times \mathbf{h} - k \mathbf{a}"),
        (r"\mathbf{c} = \mathbf{a} \times \mathbf{b} + k m \mathbf{v}",
         r"\mathbf{c} = \mathbf{b} \times \mathbf{a} + k m \mathbf{v}"),
    ],
)  # fmt: skip
def test_what_another_section_states_but_for_one_mark_is_told(one: str, other: str) -> None:
    for first, second in ((one, other), (other, one)):
        found = of_sections(first, second)
        assert found[1].startswith("open: differs from (1) in one mark"), found
        assert not any("differs" in each for each in of_sections(first, first))


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (r"x = \frac{1}{2} m y", r"x = -\frac{1}{2} m y"),  # of few letters: they are used again
        (r"E = m y + k x + f X", r"E = m y + k x + f Y"),  # another letter
        (r"E = m y + k x + f X", r"E = m y - k x - f X"),  # more than one mark
        (r"E = m y + k x + f X", r"E = k x + f X + m y"),
    ],
)
def test_what_another_section_says_of_other_letters_is_no_slip(one: str, other: str) -> None:
    assert "differs" not in of_sections(one, other)[1]


def test_an_equation_does_not_fail_by_a_later_one_where_one_between_says_what_is_true() -> None:
    """An image that is upside down, and one that is not: its place is said of the second."""
    inverted, upright = r"\frac{Z}{f} = -\frac{X}{X'} = -\frac{Y}{Y'}", r"\frac{Z}{f} = \frac{X}{X'} = \frac{Y}{Y'}"
    said = r"X' = f\frac{X}{Z}, \quad Y' = f\frac{Y}{Z}"
    page = "".join(rf"\[ {each} \] " for each in (inverted, upright, said))
    assert "fails" not in [each.verdict for each in chasles.read(page, {"symbols": OF_TWO_SECTIONS}, "tex").equations]
    page = "".join(rf"\[ {each} \] " for each in (inverted, said))
    assert "fails" in [each.verdict for each in chasles.read(page, {"symbols": OF_TWO_SECTIONS}, "tex").equations]
