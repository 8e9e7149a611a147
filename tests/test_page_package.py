"""What `chasles read --out` writes: a chapter that says the same, decided the same, in which edits are kept."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
from benchmarks.reading.parity import as_page, compared
from click.testing import Result
from tests.test_cli.test_cli_read import NOTATION, PAGE, run

from chasles.decisions.session import Session
from chasles.pages.chapter_notation import notation_of_chapter
from chasles.pages.folder import RECORD
from chasles.pages.package import package_of
from chasles.pages.page import read, read_page
from chasles.pages.page_chapter import chapter_of
from chasles.pages.python_layout import WIDTH, laid_out
from chasles.pages.python_source import PythonSource, imports
from chasles.reading.pages import displayed
from chasles.statements import load
from chasles.statements.fingerprint import fingerprint

from .sampling import sample


@pytest.mark.parametrize("package", ["chasles.derivations", "chasles.rotations"])
def test_a_statement_written_as_python_is_the_same(package: str) -> None:
    for entry in sample(load(package).entries, 23):
        source = PythonSource()
        text = source.text(entry.statement)
        names = {"__name__": "written"}
        exec(imports(source.used), names)
        laid = laid_out(text, indent=4)
        assert ast.dump(ast.parse(laid)) == ast.dump(ast.parse(text))
        assert all(len(line) <= WIDTH or '"' in line for line in f"    {laid}".splitlines())
        assert fingerprint(eval(text, names)) == fingerprint(entry.statement), entry.name


def test_a_chapter_written_as_a_package_is_the_same(tmp_path: Path) -> None:
    chapter = load(Path(__file__).parents[1] / "examples" / "planar")
    folder = tmp_path / "written_planar"
    folder.mkdir()
    for name, text in package_of(chapter, {}).items():
        (folder / name).write_text(text, "utf-8")
    again = load(folder)
    assert [(each.name, fingerprint(each.statement)) for each in again] == [
        (each.name, fingerprint(each.statement)) for each in chapter
    ]


def out(tmp_path: Path, name: str) -> Result:
    return run(tmp_path, "--out", str(tmp_path / name))


def test_what_is_written_is_decided_as_the_page_was(tmp_path: Path) -> None:
    out(tmp_path, "as_written")
    session = Session()
    found = [session.decide(entry.statement).verdict.name for entry in load(tmp_path / "as_written")]
    page = read(PAGE, NOTATION)
    told = [each.finding.verdict.name for each in page.equations if each.finding and not each.finding.open]
    assert [each for each in found if each != "assumed"] == told


def test_what_a_person_has_changed_is_kept(tmp_path: Path) -> None:
    folder = tmp_path / "with_edits"
    out(tmp_path, "with_edits")
    (module,) = folder.glob("s*.py")
    written = module.read_text("utf-8")
    name = written.rpartition("\nequation_")[2].partition(" ")[0]
    edited = written.replace(f"equation_{name} = Postulate(", f"equation_{name} = Postulate(  # mine", 1)
    edited += "\nscale = Fraction(1, 2)\n"
    edited = edited.replace('"""\n\n', '"""\n\nfrom fractions import Fraction\n', 1)
    module.write_text(edited, "utf-8")
    for _ in range(2):
        assert out(tmp_path, "with_edits").exit_code in (0, 1)
        again = module.read_text("utf-8")
        assert again.count("# mine") == edited.count("# mine") == 1
        assert "scale = Fraction(1, 2)" in again
    assert load(folder).entries
    for record in ("[", "[]", '{"s1.py": 1}'):
        (folder / RECORD).write_text(record, "utf-8")
        assert RECORD in out(tmp_path, "with_edits").stderr
    module.write_text("equation = (", "utf-8")
    (folder / RECORD).unlink()
    assert f"{module}:1: " in out(tmp_path, "with_edits").stderr


def test_a_chapter_printed_as_a_page_gets_no_verdict_that_its_declarations_contradict() -> None:
    chapter = load(Path(__file__).parents[1] / "examples" / "planar")
    page = read_page(displayed(as_page(chapter), "tex"), notation_of_chapter(chapter))
    found = [(read, declared) for _, read, declared in compared(page, chapter)]
    assert len(found) > 20
    assert all(
        read == declared for read, declared in found if read in ("fails", "ill-formed") or declared == "ill-formed"
    )
    assert not [each for each in found if each == ("holds", "fails")]


def test_what_is_open_is_assumed_in_the_chapter_misfits_of_a_proposal_too() -> None:
    letters = {r"\mathbf{a}": {"is": "vector"}, r"\mathbf{b}": {"is": "vector"}, "A": {"is": "matrix"}}
    text = "$$\\mathbf{a} + 1 = \\mathbf{b}$$\n\n$$A^T = A$$\n"
    page = read(text, {"symbols": letters, "page": {"proposed": True}})
    assert [each.finding.open for each in page.equations if each.finding] == [True, True]
    chapter, _ = chapter_of("page", page.equations)
    assert [each.statement.role for each in chapter] == ["postulate", "postulate"]


def test_a_fault_of_another_kind_is_not_told_of_the_record(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "chapter").mkdir()
    (tmp_path / "chapter" / RECORD).write_text("[]", "utf-8")
    assert RECORD in out(tmp_path, "chapter").output
    monkeypatch.setattr("chasles.pages.folder.package_of", lambda *_: int("none"))
    assert RECORD not in out(tmp_path, "other").output


def test_long_expressions_are_broken_where_a_formatter_breaks_them() -> None:
    long = f"f(({'a' * 60}, {'b' * 60},), c * (d + e) ** 2)"
    assert laid_out(long) == f"f(\n    (\n        {'a' * 60},\n        {'b' * 60},\n    ),\n    c * (d + e) ** 2,\n)"
    assert laid_out(f"x + {'y' * 115}", 4) == f"x\n    + {'y' * 115}"
    assert laid_out(f'"(,{"+" * 120}"', 4) == f'"(,{"+" * 120}"'
