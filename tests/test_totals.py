"""Sums over the members of a collection: decided, checked, printed; what is assumed of each member counts."""

from __future__ import annotations

import sys
from typing import Any

import pytest

from chasles.decisions.session import Session
from chasles.statements import Claim, Condition, Definition, positive, rotation, unit
from chasles.verdict import HoldsUnder, Undecided
from chasles.vocabulary import (
    LENGTH,
    MASS,
    Identity,
    Misfit,
    column,
    cross,
    dot,
    integral,
    latex,
    norm,
    plain,
    rate,
    scalar,
    square,
    vector,
)
from chasles.vocabulary.arguments import WrongArgument
from chasles.vocabulary.nodes import lifted
from chasles.vocabulary.totals import members, total

from .decided import claim, proved, refuted

n, x, y = scalar("n", "n", ""), scalar("x_i", "x_i", ""), scalar("y_i", "y_i", "")
m = scalar("m_i", "m_i", "", MASS, constant=True)
r, e, R = vector("r_i", "r_i", "", LENGTH), vector("e_i", "e_i", ""), square("R_i", "R_i", "")
M, c, a, w = (
    scalar("M", "M", "", MASS),
    vector("c", "c", "", LENGTH),
    vector("a", "a", "", LENGTH),
    vector("w", "w", ""),
)
mean = scalar("mean", r"\bar{x}", "")
i, j = members("i", n, m, r, e, R), members("i", n, x, y)
mass = Definition("0.1", M, total(m, i))
centre = Definition("0.2", c, total(m * r, i) / M, assuming=(positive(M),))
average = Definition("0.3", mean, 1 / n * total(x, j))
nothing = column(0, 0, 0)


TRUE = [
    claim(total(m * (r - c), i), nothing, given=(mass, centre)),
    claim(total(cross(r, m * cross(w, r)), i), total(m * (dot(r, r) * Identity(3) - r @ r.T), i) @ w),
    claim(
        total(m * norm(r - a) ** 2, i),
        total(m * norm(r - c) ** 2, i) + M * norm(c - a) ** 2,
        given=(mass, centre),
    ),
    claim(total(a, i), n * a),
    claim(rate(total(m * r, i)), total(m * rate(r), i)),
    claim(total(x - mean, j), 0, given=(average,)),
    claim(1 / n * total((x - mean) ** 2, j), 1 / n * total(x**2, j) - mean**2, given=(average,)),
    claim(total(dot(e, e), i), n, unit(e)),
    claim(total(norm(e), i), n, unit(e)),
    claim(total(m * dot(e, e), i), total(m, i), unit(e)),
    claim(total(R.T @ R, i), n * Identity(3), rotation(R)),
    claim(total(dot(e, rate(e)), i), 0, unit(e)),
    claim(total(y, j), n, given=(Condition("0", y, lifted(1), on=(y,)),)),
]
FALSE = [
    claim(total(m * (r + c), i), nothing, given=(mass, centre)),
    claim(total(a, i), a),
    claim(total(x, j) ** 2, total(x**2, j)),
    claim(1 / n * total((x - mean) ** 2, j), 1 / n * total(x**2, j) + mean**2, given=(average,)),
    claim(total(dot(e, e), i), 2 * n, unit(e)),
    claim(total(e, i), nothing, unit(e)),
    claim(total(x, j), n * x),
]


@pytest.mark.parametrize("said", TRUE, ids=lambda said: f"{said.left} = {said.right}")
def test_true_ones_are_proved(said: Claim) -> None:
    proved(said)


@pytest.mark.parametrize("said", FALSE, ids=lambda said: f"{said.left} = {said.right}")
def test_false_ones_are_refuted(said: Claim) -> None:
    refuted(said)


def test_a_condition_on_each_is_summed() -> None:
    posed = Condition("0", x * y, lifted(0), on=(x, y))
    assert Session().decide(claim(total(x * y, j), 0, given=(posed,))).verdict.needs == ()
    refuted(claim(total(x + y, j), 0, given=(posed,)))


def test_what_is_assumed_of_each_is_assumed_of_elements_of_a_body() -> None:
    """The integral of a unit vector's square is that of one: once this was refuted at moments of no unit vectors."""
    rho, u = scalar("rho", r"\rho", "", constant=True), vector("u", "u", "")
    said = claim(integral(rho * dot(u, u), rho, u), integral(rho, rho, u), unit(u))
    verdict = Session().decide(said).verdict
    assert isinstance(verdict, HoldsUnder), verdict
    assert verdict.needs == ("|u| = 1 for each",)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    "said",
    [
        claim(total(x**2, j), n, given=(Condition("0", x**2, lifted(1), on=(x,)),)),
        claim(total(dot(e, e) ** 3, i), n, unit(e)),
        claim(total(x**2 * y**2, j), 0, given=(Condition("0", x * y, lifted(0), on=(x, y)),)),
    ],
    ids=str,
)
def test_what_may_follow_of_each_is_not_refuted(said: Claim) -> None:
    assert isinstance(Session().decide(said).verdict, Undecided)


def test_they_are_printed() -> None:
    assert latex(total(m * r, i)) == r"\sum_{i=1}^{n} m_i \mathbf{r}_i"
    assert latex(total(x - y, j) * 2) == r"\left[ \sum_{i=1}^{n} \left( x_i - y_i \right) \right] 2"
    assert plain(total(x, j)) == "sum over i to n of x_i"
    assert total(m * r, i).measure == (m * r).measure


def test_units_are_the_chapters() -> None:
    """Who imports all names of a module of words keeps units, and a sum has those of its members."""
    words = [module for name, module in sys.modules.items() if name.startswith("chasles.vocabulary.")]
    assert not [module for module in words if hasattr(module, "UNITS")]
    assert total(m, i).measure == m.measure
    assert (total(m, i) * c + total(m * r, i)).fault is None


def test_the_sum_of_python_adds() -> None:
    assert sum([r, a, c]) == r + a + c  # type: ignore[list-item]


def test_mistakes_are_told() -> None:
    made: list[tuple[Any, str]] = [
        (lambda: members("i", n), "takes an index, a scalar for how many"),
        (lambda: members("i", c, x), "takes an index, a scalar for how many"),
        (lambda: members("i", n, x + y), "symbols"),
        (lambda: total(m * r + x, i), "cannot add"),
    ]
    for make, said in made:
        with pytest.raises((WrongArgument, Misfit, TypeError), match=said):
            make()
