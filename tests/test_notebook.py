"""What a notebook displays: valid HTML, LaTeX that converts, plain text; nothing is decided or simplified for it."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from types import FrameType
from typing import Any
from warnings import catch_warnings, simplefilter

import pytest
import sympy
from latex2mathml.converter import convert

import chasles
from chasles import prove
from chasles.compiling.kernel import CompiledKernel
from chasles.decisions.decision import Certificate
from chasles.decisions.session import Session
from chasles.deriving import walk
from chasles.display import Displayed
from chasles.report.records import certificate_hash
from chasles.statements import Claim, Inverse, Statement, load
from chasles.statements.derivations import derivations_in
from chasles.verdict import Counterexample, Fails, Undecided

from .parsed_page import Parsed
from .sampling import sample

BOOK = load()
X, Y = sympy.symbols("x y")
NUMBERS = ("3.4", "3.18", "3.57", "3.96a", "3.96e", "3.148", "Thm 3.2.2")
HOSTILE = "<script>alert('1 & 2')</script> $x_1^2$ 100% \\input{x} #"


def things() -> Iterator[tuple[str, Any]]:
    """One of each kind that is displayed, and some more."""
    judge = Session(book=BOOK)
    for entry in BOOK.select(NUMBERS):
        decision = judge.decide(entry.statement)
        name = f"{entry.number}/{entry.statement.part}"
        yield f"{name} decided", decision
        yield f"{name} verdict", decision.verdict
        if decision.certificate is not None:
            yield f"{name} certificate", decision.certificate
        if decision.correction is not None:
            yield from ((f"{name} repair {repair.left}", repair) for repair in decision.correction.repairs)
    inverse = next(entry for entry in BOOK if isinstance(entry.statement, Inverse))
    yield "inverse", judge.decide(inverse.statement)
    yield "its certificate", judge.decide(inverse.statement).certificate
    road = derivations_in("r02_screw_axis")["point_of_the_screw_axis"]
    yield "derivation", road
    yield "road", walk(road, judge)
    yield "chapter", BOOK
    yield "expression", BOOK.select(["3.18"])[0].statement.right
    yield "proved", prove(sympy.sin(X) ** 2 + sympy.cos(X) ** 2, 1)
    refuted = prove(sympy.sin(2 * X), sympy.sin(X))
    yield "refuted", refuted
    yield "counterexample", refuted.counterexample
    yield "undecided", Undecided("no time was left")
    yield "kernel", chasles.kernel("screw_axis_point")
    yield "compiled", chasles.compile(sympy.sin(X) * Y, [X, Y], jacobian=True)


@pytest.fixture(scope="module")
def shown() -> dict[str, Any]:
    return dict(things())


def formulas(latex: str) -> list[str]:
    """The formulas in a text: in displays, and between dollars that are not escaped."""
    displayed = re.findall(r"\\\[(.*?)\\\]", latex, re.DOTALL)
    rest = re.sub(r"\\\[.*?\\\]", "", latex, flags=re.DOTALL)
    return displayed + re.findall(r"(?<!\\)\$(.*?)(?<!\\)\$", rest, re.DOTALL)


def require_fine(html: str) -> Parsed:
    page = Parsed(html)
    assert page.mistakes == []
    tags = {tag for tag, _ in page.tags}
    assert not tags & {"script", "merror", "link", "img", "a", "body", "html"}
    assert not page.ids, "two displays on one page would have the same"
    return page


def test_every_kind_is_displayed(shown: dict[str, Any]) -> None:
    for thing in shown.values():
        require_displayed(thing)


def require_displayed(thing: Any) -> None:
    bundle = thing._repr_mimebundle_()
    assert list(bundle) == ["text/plain", "text/html", "text/latex"]
    assert bundle["text/html"] == thing._repr_html_() == thing._repr_html_()
    assert bundle["text/latex"] == thing._repr_latex_()
    require_fine(bundle["text/html"])
    assert bundle["text/plain"].strip()
    assert max(map(len, bundle["text/plain"].splitlines())) < 6000
    for formula in formulas(bundle["text/latex"]):
        assert "<math" in convert(formula)


def test_every_statement_of_the_book_is_displayed() -> None:
    for entry in sample(BOOK, 5):
        page = require_fine(entry._repr_html_())
        assert entry.statement.says in page.visible
        assert entry.name in page.visible
        assert any(tag == "math" for tag, _ in page.tags)
        assert formulas(entry._repr_latex_())
        for formula in formulas(entry._repr_latex_()):
            assert "<math" in convert(formula)


def test_all_that_is_known_is_shown(shown: dict[str, Any]) -> None:
    page = Parsed(shown["3.18/1 decided"]._repr_html_()).visible
    for words in ("(3.18)", "holds under", "The point of the screw axis nearest the origin."):
        assert words in page
    certificate = shown["3.18/1 certificate"]
    assert certificate_hash(certificate) in page
    assert "checked again" not in page, "whether it was is not known here"
    assert r"$\|\mathbf{e}\| = 1$" in shown["3.18/1 decided"]._repr_latex_()
    wrong = Parsed(shown["3.57/1 decided"]._repr_html_()).visible
    for words in ("cannot equate", "Right is", "the vector factor", "is added"):
        assert words in wrong
    refuted = Parsed(shown["3.148/1 decided"]._repr_html_()).visible
    for words in ("fails", "the left side is", "the right side is", "so that"):
        assert words in refuted
    assert "cos(x) = 0" in shown["refuted"]._repr_html_()
    assert "e_3^2" in Parsed(certificate._repr_html_()).visible
    kernel = Parsed(shown["kernel"]._repr_html_()).visible
    (bound,) = chasles.kernel("screw_axis_point").bound
    for words in ("screw_axis_point", "(3),(),(3),(3)->(3)", "phi != 0, |e| = 1", bound, "19 multiply"):
        assert words in kernel
    assert "void chasles_expression(" in Parsed(shown["compiled"]._repr_html_()).visible
    road = Parsed(shown["road"]._repr_html_()).visible
    assert "complete; all results are as printed" in road
    assert "not yet checked" in shown["derivation"]._repr_html_()
    assert "Section" not in shown["chapter"]._repr_html_()
    assert "The Screw of a Rigid-Body Motion" in shown["chapter"]._repr_html_()


def test_what_is_asked_for_is_made(shown: dict[str, Any]) -> None:
    thing = shown["expression"]
    assert list(thing._repr_mimebundle_(include={"text/html"})) == ["text/html"]
    assert list(thing._repr_mimebundle_(exclude={"text/html"})) == ["text/plain", "text/latex"]
    assert thing._repr_latex_().startswith(r"$\displaystyle \frac{")


def test_nothing_that_is_displayed_is_markup(shown: dict[str, Any]) -> None:
    entry = BOOK.select(["3.4"])[0]
    assert isinstance(entry.statement, Claim)
    point = {"x": 1}
    found = Counterexample(point, (1, 1), HOSTILE, HOSTILE, HOSTILE)  # type: ignore[arg-type]
    hostile = [
        replace(entry.statement, says=HOSTILE),
        replace(entry, name=HOSTILE),
        replace(BOOK, title=HOSTILE),
        found,
        Fails(found),
        Undecided(HOSTILE),
        Certificate(division=[[HOSTILE, HOSTILE]], witness={HOSTILE: "1"}),
        replace(shown["3.4/1 decided"], verdict=Fails(replace(found, at={}))),
        replace(shown["derivation"], says=HOSTILE),
        replace(shown["kernel"], says=HOSTILE, bound=(HOSTILE,)),
        replace(next(shown[name] for name in shown if "repair" in name), changes=(HOSTILE,)),
    ]
    for thing in hostile:
        assert HOSTILE in require_fine(thing._repr_html_()).visible, type(thing)
        latex = thing._repr_latex_()
        assert r"\input" not in latex
        assert not re.search(r"(?<!\\)[%#]", latex), latex
        for formula in formulas(latex):
            assert "<math" in convert(formula)


def called(work: Callable[[], object]) -> dict[str, int]:
    """The files of which functions are called, and how often."""
    found: dict[str, int] = {}

    def note(frame: FrameType, event: str, _: object) -> None:
        if event == "call":
            found[frame.f_code.co_filename] = found.get(frame.f_code.co_filename, 0) + 1

    before = sys.getprofile()
    sys.setprofile(note)
    try:
        work()
    finally:
        sys.setprofile(before)
    return found


DECIDING = re.compile(
    r"sympy/(simplify|solvers|polys|matrices|core|integrals|series)/|chasles/prove\.py|chasles/lowering|"
    r"chasles/(prover/(decide|certifying)|points/search|algebra/normal_form|checker|from_sympy|"
    r"repairs/(modular_test|one_term|ranking|repair|several_terms|single_edits)|decisions/session)"
)
CALLS = 400_000
"""A tenth of a second or less."""


def test_display_decides_and_simplifies_nothing(shown: dict[str, Any]) -> None:
    """By what is called, so that neither a cache nor a fast machine hides it; and by how much, so that it is fast."""
    for name, thing in shown.items():
        thing._repr_mimebundle_()
        found = called(thing._repr_mimebundle_)
        names = {Path(file).as_posix() for file in found}
        assert any(file.endswith("report/notebook/html.py") for file in names)
        assert sorted(file for file in names if DECIDING.search(file)) == [], name
        assert sum(found.values()) < CALLS, name


def test_deciding_would_be_seen() -> None:
    entry = BOOK.select(["3.4"])[0]
    found = called(lambda: Session().decide(entry.statement))
    assert any(DECIDING.search(Path(file).as_posix()) for file in found)
    found = called(lambda: sympy.simplify(sympy.sin(X) ** 2 + sympy.cos(X) ** 2))
    assert any(DECIDING.search(Path(file).as_posix()) for file in found)


def test_solutions_are_displayed_as_they_were_worked() -> None:
    solution = chasles.solve("3.5")
    bundle = solution._repr_mimebundle_()
    assert bundle["text/plain"].startswith("Exercise 3.5  The Plücker coordinates of a joint axis")
    assert "<math" in bundle["text/html"]
    assert Parsed(bundle["text/html"]).mistakes == []
    assert len(formulas(bundle["text/latex"])) > 5
    for formula in formulas(bundle["text/latex"]):
        assert "<math" in convert(formula)
    names = {Path(file).as_posix() for file in called(solution._repr_mimebundle_)}
    assert not [
        file for file in names if re.search(r"sympy/(simplify|solvers)/|chasles/(prover|decisions/session)", file)
    ]


def test_ipython_shows_them(shown: dict[str, Any]) -> None:
    formatters = pytest.importorskip("IPython.core.formatters", reason="needs IPython, which the manual brings")
    decision = shown["3.18/1 decided"]
    bundle, _ = formatters.DisplayFormatter().format(decision)
    assert bundle["text/html"] == decision._repr_html_()
    assert bundle["text/plain"].startswith("(3.18)  ✓ holds under")


CELLS = {
    "decided": "decided",
    "verdict": "decided.verdict",
    "certificate": "decided.certificate",
    "repair": "repaired.correction.repairs[0]",
    "entry": "book.select(['3.18'])[0]",
    "statement": "book.select(['3.18'])[0].statement",
    "expression": "book.select(['3.18'])[0].statement.right",
    "chapter": "book",
    "proved": "chasles.prove(sympy.sin(x) ** 2 + sympy.cos(x) ** 2, 1)",
    "refuted": "refuted",
    "counterexample": "refuted.counterexample",
    "derivation": "derivations_in('r02_screw_axis')['point_of_the_screw_axis']",
    "kernel": "chasles.kernel('screw_axis_point')",
    "compiled": "chasles.compile(sympy.sin(x) * y, [x, y])",
    "solution": "chasles.solve('3.5')",
}
OPENING = """
import chasles, sympy
from chasles.decisions.session import Session
from chasles.statements import load
from chasles.statements.derivations import derivations_in
book = load()
judge = Session(book=book)
decided = judge.decide(book.select(["3.18"])[0].statement)
repaired = judge.decide(book.select(["3.96e"])[0].statement)
x, y = sympy.symbols("x y")
refuted = chasles.prove(sympy.sin(2 * x), sympy.sin(x))
"""


@pytest.fixture(scope="module")
def cells() -> dict[str, list[Any]]:
    """What a kernel of its own sends for each cell."""
    nbformat = pytest.importorskip("nbformat", reason="needs nbclient")
    nbclient = pytest.importorskip("nbclient", reason="needs nbclient")
    pytest.importorskip("ipykernel", reason="needs ipykernel")
    new = nbformat.v4.new_code_cell
    printing = new("from chasles.cli.commands.show import command\ncommand.main(['3.18'], standalone_mode=False)")
    book = nbformat.v4.new_notebook(cells=[new(OPENING), *map(new, CELLS.values()), printing])
    with catch_warnings():
        simplefilter("ignore")  # what Jupyter warns of is its own matter
        nbclient.NotebookClient(book, timeout=None, kernel_name="python3").execute()
    assert book.cells[0].outputs == []
    return dict(zip([*CELLS, "printing"], (cell.outputs for cell in book.cells[1:]), strict=True))


@pytest.mark.sampled(7)
@pytest.mark.slow
@pytest.mark.parametrize("name", CELLS)
def test_a_kernel_displays_each_once(name: str, cells: dict[str, list[Any]]) -> None:
    """In a kernel Rich would display by itself, and CLICOLOR_FORCE is set."""
    (output,) = cells[name]
    assert output.output_type == "execute_result"
    assert sorted(output.data) == ["text/html", "text/latex", "text/plain"]
    assert output.data["text/plain"].strip()
    assert "\x1b" not in output.data["text/plain"]


@pytest.mark.slow
def test_a_command_in_a_kernel_prints(cells: dict[str, list[Any]]) -> None:
    assert {output.output_type for output in cells["printing"]} == {"stream"}
    assert "(3.18)" in "".join(output.text for output in cells["printing"])


def test_an_emitted_kernel_is_told_and_called() -> None:
    record = chasles.kernel("rotation_from_axis_angle")
    assert (record.number, record.signature) == ("2.49", "(3),()->(3,3)")
    assert sum(record.operations.values()) == 24
    assert record([0.0, 0.0, 1.0], 0.0).tolist() == [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    assert isinstance(record, Displayed)
    with pytest.raises(LookupError, match=r"there is no kernel 'rotation_from_axis': did you mean rotation_from_axis_"):
        chasles.kernel("rotation_from_axis")


def test_what_is_not_displayed_says_so() -> None:
    class Novelty(Displayed):
        pass

    with pytest.raises(TypeError, match="how to display Novelty"):
        Novelty()._repr_html_()
    assert issubclass(CompiledKernel, Displayed)
    assert issubclass(Statement, Displayed)
