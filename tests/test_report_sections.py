"""The sections of the report on exercises, kernels and what was measured; proofs and pictures as parts of a page."""

from __future__ import annotations

import json
import re
from math import inf
from pathlib import Path
from types import SimpleNamespace

import pytest

import chasles
from chasles.cli import reporting
from chasles.decisions.session import Session
from chasles.exercises.solution import Solution
from chasles.exercises.solving import solve_with
from chasles.report.html.certificates import proof_in_words
from chasles.report.html.citing import Book
from chasles.report.html.derivations import derivation_view
from chasles.report.html.error_plots import plotted
from chasles.report.html.exercises import worked_exercises, worked_view
from chasles.report.html.formulas import displayed
from chasles.report.html.measured import DamagedEvidence, ErrorAtAngle, ErrorCurve, measured
from chasles.report.html.overview import Trusted
from chasles.report.html.page import PageContents, page
from chasles.report.words import counted
from chasles.statements import Chapter, Claim, Entry, Section, load
from chasles.statements.exercises import exercise_numbers
from chasles.vocabulary import vector

EXERCISE = re.compile(r'<details class="exercise" id="exercise-([0-9-]+)">(.*?)</details>', re.S)
x = vector("x", "x", "any vector")
MANIFEST = """
[kernels.twice]
number = "9.1"
says = "Twice."
signature = "(3)->(3)"
hypotheses = []
operations = { add = 3 }
form = "stated"
[kernels.twice.bound]
program = "0"
reason = ""
guarantees = [{ result = "r", against = "itself", units = "1.01", inputs = "x" }]
"""
TIMES = {
    "machine": {"date": "today", "processor": "P", "cores": 2, "compiler": "cc", "instructions": "", "backend": "c",
                "versions": {"numpy": "2"}},
    "peers": {"chasles_kernels": "chasles", "casadi_c": "CasADi C", "numpy_by_hand": "NumPy"},
    "kernels": {
        "twice": {
            "title": "2x",
            "ns": {"10000": {"chasles_kernels": 2.0, "casadi_c": 5.0, "numpy_by_hand": 1.5}},
            "times_faster": {"10000": {"than": "casadi_c", "ratio": 2.5}},
            "errors": {"here": {"chasles_kernels": 0.5, "numpy_by_hand": None}, "there": {"chasles_kernels": 0.75}},
        },
        "of_another_book": {},
    },
}  # fmt: skip
POINTS = [
    {"phi": 1e-300, "ours": None, "as_typed": None},
    {"phi": 1e-8, "ours": 0.5, "as_typed": None},
    {"phi": 1.0, "ours": 2, "as_typed": 1e9},
    {"pi - phi": 1e-3, "ours": 1, "as_typed": 3},
]
ERRORS = {
    "kernels": {
        "twice": {
            "proved": {"r": {"units": "1.01", "against": "itself"}},
            "float64": {"r": {"proved": {"units": 0.75}}},
            "float32": {"r": {"proved": {"units": 0.5}}},
        }
    },
    "curves": {"twice": {"title": "2x", "points": POINTS}, "of_another_book": {}},
}


def twice(evidence: dict[str, str]) -> str:
    """The page of a chapter with one kernel."""
    from chasles.statements import Kernel

    claim = Claim("9.1", x + x, 2 * x, says="Twice.", kernel=Kernel(of=(x,)))
    book = Chapter("Toys", (Entry("twice", Section("9.1", "Toys"), claim),))
    return page(book, {"twice": Session().decide(claim)}, PageContents(Trusted(1, 0, 0, 1), MANIFEST, evidence))


def test_every_exercise_is_worked(report: dict[str, str]) -> None:
    found = {number.replace("-", "."): body for number, body in EXERCISE.findall(report["index.html"])}
    assert tuple(found) == exercise_numbers()
    assert len(found) == 21
    assert all(body.count('<ol class="steps">') == 1 and "<h4>Answer: " in body for body in found.values())
    for number in ("3.4", "3.5", "3.9", "3.19"):
        body, solution = found[number], solve_with(number, {})
        assert body.count("<li><p>") == len(solution.steps) + len(solution.checks)
        assert f"<h4>Answer: {solution.outcome}</h4>" in body
        assert all(f"<dt><code>{name}</code></dt>" in body for name in solution.answers)
        assert body.count("<figure>") == (solution.picture is not None)


def test_pictures_have_words_and_colours_of_the_page(report: dict[str, str]) -> None:
    pictures = re.findall(r'<svg class="picture".*?</svg>', report["index.html"], re.S)
    assert len(pictures) >= 16
    for picture in pictures:
        assert re.search(r"<title [^>]*>[^<]+</title><desc [^>]*>[^<]+</desc>", picture)
        assert not re.search(r"(fill|stroke):\s*#", picture)
        assert len(picture) < 40_000


def test_where_nothing_can_be_drawn_the_page_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    def figure(self: Solution) -> None:
        raise ImportError("pictures are drawn by nothing here")

    monkeypatch.setattr(Solution, "figure", figure)
    view = worked_view(load(), "3.5")
    assert view.pictures == view.captions == ()
    assert view.without == ("pictures are drawn by nothing here",)


def test_another_chapter_has_none_of_the_exercises() -> None:
    entry = Entry("twice", Section("9.1", "Toys"), Claim("9.1", x + x, 2 * x, says="Twice."))
    assert worked_exercises(Chapter("Toys", (entry,))) == ()


def test_bounds_times_and_errors_are_those_of_the_files() -> None:
    html = twice({"kernels.json": json.dumps(TIMES), "errors.json": json.dumps(ERRORS)})
    row = html.split('<tr id="kernel-twice">')[1].split("</tr>")[0]
    assert "1.01 u of itself, for x" in row
    assert "found 0.75 u, in single precision 0.5 u" in row
    assert "3 add; as stated" in row
    speeds = html.split('<table class="speeds">')[1].split("</table>")[0]
    cells = re.findall(r"<td[^>]*>(?:<strong>)?([^<]*)", speeds)
    assert cells == ["2", "5 CasADi C", "1.5", "2.50", "", "0.75", "lost"]
    assert (
        "2x: at most 2 u as emitted, no digit is right at φ = 1e\N{NON-BREAKING HYPHEN}08 by the formula as typed."
        in html
    )


def test_without_measurements_the_page_says_how_to_measure() -> None:
    html = twice({})
    assert "<code>make bench</code> measures" in html
    assert "<code>python -m benchmarks.errors</code> measures" in html


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("kernels.json", "{"),
        ("kernels.json", "[]"),
        ("kernels.json", json.dumps({**TIMES, "kernels": {"twice": {}}})),
        ("errors.json", json.dumps({"curves": {"twice": {"title": "2x", "points": POINTS[:1]}}})),
        ("errors.json", json.dumps({"curves": {"twice": {"title": "2x", "points": [{"ours": 1}]}}})),
        ("errors.json", json.dumps({"kernels": {"twice": {}}})),
    ],
)
def test_damaged_evidence_is_named(name: str, text: str) -> None:
    with pytest.raises(DamagedEvidence, match=name):
        measured({name: text}, {"twice": "kernel-twice"})


@pytest.mark.parametrize("folder", ["benchmarks/evidence", "evidence"])
def test_evidence_lies_beside_the_declarations(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, folder: str) -> None:
    class Spec:
        submodule_search_locations = (str(tmp_path / "derivations"),)

    monkeypatch.setattr(reporting, "find_spec", lambda name: Spec)
    assert reporting._evidence(load()) == {}
    (tmp_path / folder).mkdir(parents=True)
    (tmp_path / folder / "errors.json").write_text("{}", "utf-8")
    assert reporting._evidence(load()) == {"errors.json": "{}"}


def test_a_plot_has_a_panel_for_each_end() -> None:
    near_zero = ErrorCurve("k", "k", (ErrorAtAngle(False, 1e-8, 1.0, 1e9), ErrorAtAngle(False, 1.0, 1.0, 1.0)))
    both = ErrorCurve("k", "k", (*near_zero.places, ErrorAtAngle(True, 1e-3, 1.0, inf)))
    plots, without = plotted((near_zero, both))
    assert not without
    assert ["π − φ" in drawing for drawing, _ in plots] == [False, True]
    assert plots[0][1] == "k: at most 1 u as emitted, at most 1e+09 u by the formula as typed."
    assert plots[1][1] == "k: at most 1 u as emitted, no digit is right at φ = π − 0.001 by the formula as typed."


@pytest.mark.parametrize(
    ("number", "words"),
    [
        ("3.106", "<code>n_P</code> is found from (text 3.7 a) and put in."),
        ("3.18", "(for <code>e_3^2</code>); <code>cos(phi)^2 + sin(phi)^2 = 1</code> (for <code>sin(phi)^2</code>)"),
        ("Thm 3.3.1", "Rates of a rotation are written by its angular velocity."),
        ("text 3.4.2 h", "either sign: Expanded"),
    ],
)
def test_a_proof_says_what_is_put_in_and_divided_by(number: str, words: str) -> None:
    book = load()
    [entry] = book.select([number])
    certificate = Session(book=book).decide(entry.statement).certificate
    assert certificate is not None
    assert words in " ".join(proof_in_words(Book(book), certificate))


@pytest.mark.parametrize(
    ("latex", "mathml"),
    [
        (r"a = -1", '<mo>=</mo><mo form="prefix">−</mo><mn>1</mn>'),
        (r"\cos \theta \sin \theta", '<mi>θ</mi><mspace width="0.167em" /><mi>sin</mi><mspace width="0.167em" />'),
        (r"\text{tan\_2theta}", "<mtext>tan_2theta</mtext>"),
        (r"\begin{bmatrix}1\\0\end{bmatrix}^T", '<msup><mrow><mo stretchy="true" fence="true" form="prefix">[</mo>'),
    ],
)
def test_formulas_of_solutions_are_spaced(latex: str, mathml: str) -> None:
    assert mathml in displayed(latex)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("number", "outcome"), [("3.9", "solved"), ("3.17", "proved"), ("3.5", "line")])
def test_an_answer_says_what_was_found(number: str, outcome: str) -> None:
    solution = chasles.solve(number)
    assert solution.outcome == outcome
    assert f"Answer: {outcome}" in solution._repr_mimebundle_()["text/plain"]
    assert all(f"Answer: {outcome}" in solution._repr_mimebundle_()[f"text/{kind}"] for kind in ("html", "latex"))


def test_the_steps_of_a_derivation_say_formulas() -> None:
    said = {step.kind: step.reason for step in derivation_view("", chasles.derive("3.18")).steps}
    assert re.sub("<math.*?</math>", "M", said["ansatz"], flags=re.DOTALL) == "M is sought as M"
    assert re.sub("<math.*?</math>", "M", said["solve"], flags=re.DOTALL) == "for M, multiplied by (3.16)"


@pytest.mark.parametrize(
    ("names", "told"), [(["holds-under"], "1 holds under hypotheses"), (["fails", "fails", "holds"], "1 holds, 2 fail")]
)
def test_totals(names: list[str], told: str) -> None:
    assert counted([SimpleNamespace(name=name) for name in names]) == told  # type: ignore[misc]
