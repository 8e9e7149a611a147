"""A chapter with `UNITS = False`: dimensions are not checked there, shapes are."""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import chasles.statements
import chasles.vocabulary
from chasles.decisions.session import Session
from chasles.statements import DeclarationError, load
from chasles.vocabulary import Misfit
from chasles.vocabulary.shorthand import opened

SYMBOLS = """\
from chasles.statements import *
from chasles.vocabulary import *
first = Section("1", "First")
x, v, f = vector("x", "x", "x", LENGTH), vector("v", "v", "v", VELOCITY), vector("f", "f", "f", FORCE)
a, t, m = scalar("a", "a", "a"), scalar("t", "t", "t", TIME), scalar("m", "m", "m", MASS)
A, S = square("A", "A", "A"), array("S", "S", "S", column(x, v))
B = abbreviation("B", "B", CPM(x), "B")
rho, r = scalar("rho", r"\\rho", "density", MASS), vector("r", "r", "r", LENGTH)
"""
ONLY_WITHOUT_UNITS = [
    "x + v",
    "rate(x) + x",
    "rate(rate(x)) - A @ x",
    "rate(dot(x, x)) + dot(x, x)",
    "rate(cos(a)) + cos(a)",
    "rate(a * x) + f",
    "column(a, t, m) + x",
    "cos(t)",
    "sin(rate(a)) + rate(a)",
    "norm(x) + 1",
    "tr(A) + m",
    "rate(A) + A",
    "rate(x / 2) + x",
    "CPM(x) + A",
    "B + A",
    "rate(B) @ v + B @ v",
    "dot(S, S)",
    "rate(column(x, v)) + S",
    "integral(rho * r, rho, r) + f",
    "at(x) + rate(at(x))",
    "det(column(row(a, t), row(m, a)))",
    "over(1, a) + t",
]
MISSHAPEN = ["x + a", "A @ x + A", "x @ v", "CPM(A)", "tr(x)", "dot(x, a)", "det(x)", "cos(x)", "S + x", "column(x, A)"]


@pytest.fixture
def module(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Callable[..., ModuleType]:
    def made(text: str, units: bool | None) -> ModuleType:
        package, section = ModuleType("plain"), ModuleType("plain.s1")
        if units is not None:
            vars(package)["UNITS"] = units
        monkeypatch.setitem(sys.modules, "plain", package)
        monkeypatch.setitem(sys.modules, "plain.s1", section)
        exec(compile(f"{SYMBOLS}{text}\n", str(tmp_path / "s1.py"), "exec"), vars(section))
        return section

    return made


@pytest.mark.parametrize("text", ONLY_WITHOUT_UNITS)
def test_dimensions_are_not_checked(module: Callable[..., Any], text: str) -> None:
    assert module(f"made = {text}", False).made.fault is None
    for units in (None, True):
        with pytest.raises(Misfit):
            module(f"made = {text}", units)


@pytest.mark.parametrize("text", MISSHAPEN)
@pytest.mark.parametrize("units", [None, True, False])
def test_shapes_are(module: Callable[..., Any], text: str, units: bool | None) -> None:
    with pytest.raises((Misfit, TypeError)):
        module(f"made = {text}", units)


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        ('Claim("1.2", rate(rate(x)) + x, A @ rate(x) + rate(A) @ x + x, given=(system,))', "holds"),
        ('Claim("1.2", rate(rate(x)) + x, A @ rate(x) - rate(A) @ x + x, given=(system,))', "fails"),
        ('Claim("1.2", rate(dot(x, x)), 2 * dot(x, A @ x), given=(system,))', "holds"),
        ('Claim("1.2", rate(dot(x, x)), dot(x, A @ x), given=(system,))', "fails"),
        ('Claim("1.2", rate(cos(a)) + a, a - sin(a) * rate(a))', "holds"),
        ('Claim("1.2", t + m, m + t + a)', "fails"),
        ('Claim("1.2", t * a, rate(t) * a + t * rate(a))', "fails"),
    ],
)
def test_its_claims_are_decided_and_repaired(module: Callable[..., Any], claim: str, verdict: str) -> None:
    section = module(f'system = Definition("1.1", rate(x), A @ x)\nclaim = {claim}', False)
    decision = Session(book=chasles.statements.Chapter("Plain", ())).decide(section.claim)
    assert decision.verdict.name == verdict
    assert decision.stands


@pytest.mark.parametrize("units", ['"no"', "0", "None", "()"])
def test_units_are_there_or_not(tmp_path: Path, units: str) -> None:
    (tmp_path / "unsaid").mkdir()
    (tmp_path / "unsaid" / "__init__.py").write_text(f'SECTIONS = ("s1",)\nUNITS = {units}\n', "utf-8")
    try:
        with pytest.raises(DeclarationError, match=r"UNITS is .*: make it True or False: UNITS = False for"):
            load(tmp_path / "unsaid")
    finally:
        del sys.modules["unsaid"]


def test_units_do_not_come_with_all_names_of_another_module(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "bare_letters.py").write_text(f"UNITS = False\n{SYMBOLS}")
    (tmp_path / "resting.py").write_text(f"# UNITS are said nowhere\nfrom bare_letters import *\n{SYMBOLS}")
    (tmp_path / "choosing.py").write_text(f"from bare_letters import *\nUNITS = False\n{SYMBOLS}")
    monkeypatch.syspath_prepend(tmp_path)
    resting, choosing = import_module("resting"), import_module("choosing")
    with pytest.raises(Misfit, match="cannot add"):
        resting.x + resting.v
    assert (choosing.x + choosing.v).shape == (3, 1)


def test_a_chapter_with_units_beside_it_changes_nothing(module: Callable[..., Any]) -> None:
    """What is known of an equal expression of the other chapter is not taken for it: its dimension is another one."""
    for units in (True, False):
        made = module("made = rate(a)", units).made
        assert opened(made).measure == made.measure
    assert made != module("made = rate(a)", True).made
