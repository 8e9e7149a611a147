"""Chapters written to LaTeX and read in the notation of their declarations: the same words, the same verdicts."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace as with_fields
from itertools import islice
from pathlib import Path

import pytest
from click.testing import CliRunner

import chasles
from chasles.cli import main
from chasles.decisions.session import Session
from chasles.pages.chapter_notation import notation_of_chapter
from chasles.prover.decide import decide_problem
from chasles.reading.equations import read_equations
from chasles.reading.printed import PrintedEquation
from chasles.reading.reading import ReadEquation, Reading
from chasles.statements import Chapter, Claim, Entry, Statement, load
from chasles.vocabulary import Identity, latex
from chasles.vocabulary.notation import Notation

from .meaning import Meaning
from .mutation import Mutant, mutants_of
from .sampling import WHOLE, sample
from .slips import without_marks
from .test_mutants import letters_of, problem, symbols_in
from .test_reading import sides_of

ANOTHER = {"chasles.derivations": {("3.94", 1), ("3.99", 1)}, "chasles.rotations": set[tuple[str, int]]()}
"""What is read as something else: a misprinted matrix of zeros, and one letter for two quantities in two frames."""


def in_print(entry: Entry, statement: Statement) -> PrintedEquation:
    text = f"{latex(statement.left)} {statement.sign} {latex(statement.right)}"
    return PrintedEquation(text, section=entry.section.number)


def says(reading: Reading, statement: Statement) -> bool:
    return sides_of(reading.parts) == sides_of([statement])


def of_chapter(chapter: Chapter, every: int) -> list[tuple[Statement, ReadEquation]]:
    entries = [entry for entry in chapter if isinstance(entry.statement, Statement)]
    chosen = [(entry, entry.statement) for entry in sample(entries, every) if isinstance(entry.statement, Statement)]
    read = read_equations([in_print(*each) for each in chosen], notation_of_chapter(chapter))
    return [(statement, each) for (_, statement), each in zip(chosen, read, strict=True)]


@pytest.mark.parametrize("package", sorted(ANOTHER))
def test_every_declaration_is_read_back(package: str) -> None:
    found = of_chapter(load(package), 4)
    other = {(s.number, s.part) for s, read in found if not any(says(each, s) for each in read.readings)}
    assert other <= ANOTHER[package]
    usual = sum(bool(read.readings) and says(read.readings[0], statement) for statement, read in found)
    assert usual >= 0.97 * len(found)


@pytest.fixture(scope="module")
def shelf(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A folder with a new chapter in it, which is forgotten afterwards."""
    folder, known = tmp_path_factory.mktemp("shelf"), list(sys.path)
    done = CliRunner().invoke(main, ["new", str(folder / "shelved")])
    assert done.exit_code == 0, done.output
    yield folder
    sys.path[:] = known
    for name in [name for name in sys.modules if f"{name}.".startswith("shelved.")]:
        del sys.modules[name]


@pytest.fixture
def mine(shelf: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(shelf)
    return shelf / "shelved"


def test_a_new_chapter_is_read_back(mine: Path) -> None:
    chapter = load(mine)
    found = of_chapter(chapter, 1)
    assert len(found) > 4
    assert all(read.status == "read" and says(read.readings[0], statement) for statement, read in found)
    page = chasles.read(r"\mathbf{H} = \mathbf{1} - 2 \mathbf{n} \mathbf{n}^T", chapter)
    assert [each.verdict for each in page.equations] == ["defined"]


@pytest.mark.parametrize(
    ("form", "printed"), [(r"\mathbf{I}_{#1}", r"\mathbf{I}_3"), (r"\mathbf{E}_{#1}", r"\mathbf{E}_{3}"), ("I", "I")]
)
def test_an_identity_is_read_as_the_chapter_prints_it(
    mine: Path, form: str, printed: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    chapter = load(mine)
    monkeypatch.setattr(sys.modules["shelved"], "NOTATION", Notation({Identity: form}), raising=False)
    page = chasles.read(rf"\mathbf{{H}} = {printed} - 2 \mathbf{{n}} \mathbf{{n}}^T", chapter)
    assert [each.verdict for each in page.equations] == ["defined"]


@pytest.mark.parametrize("name", ["./shelved", "shelved", "shelved.notation"])
def test_a_chapter_is_a_notation(mine: Path, name: str) -> None:
    Path("page.md").write_text("$$\\mathbf{H} \\mathbf{p} = \\mathbf{H} \\mathbf{p}$$\n", encoding="utf-8")
    done = CliRunner().invoke(main, ["read", "page.md", "--notation", name])
    assert done.exit_code == 0, done.output
    assert "page.md:1: holds" in done.output


@pytest.mark.parametrize(
    ("name", "why"),
    [("./nowhere", "is no chapter"), ("nowhere", "there is no notation 'nowhere'"), ("json", "does not say what")],
)
def test_what_is_no_notation_is_told(mine: Path, name: str, why: str) -> None:
    Path("page.md").write_text("$$\\mathbf{H} = \\mathbf{p}$$\n", encoding="utf-8")
    done = CliRunner().invoke(main, ["read", "page.md", "--notation", name])
    assert done.exit_code in (1, 2)
    assert why in done.output
    assert "Traceback" not in done.output


EVERY_STATEMENT, EVERY = (1, 1) if WHOLE else (30, 8)
"""Of one claim in so many, one mutant in so many."""


def mutants(chapter: Chapter, judge: Session) -> list[tuple[Entry, Mutant]]:
    found = []
    letters = letters_of(chapter)
    claims = [(entry, entry.statement) for entry in chapter if isinstance(entry.statement, Claim)]
    for place, (entry, claim) in enumerate(claims[::EVERY_STATEMENT]):
        original = problem(claim, "printed", judge, [])
        if original is not None:
            meaning = Meaning.of(original, without_marks(symbols_in(original), letters).values())
            made = mutants_of(claim, "printed", [], meaning, letters, [])
            found += [(entry, each) for each in islice(made, place % EVERY, None, EVERY)]
    return found


def verdict(claim: Claim, reading: Reading | None, judge: Session) -> str:
    """The verdict on a claim, or on what was read of it."""
    if reading is not None:
        (part,) = reading.parts
        claim = with_fields(claim, left=part.left, right=part.right, sic=True)
    asked = problem(claim, "printed", judge, [])
    return "ill-formed" if asked is None else decide_problem(asked, claim.assuming).name


@pytest.mark.slow
def test_mutants_have_the_verdicts_of_their_declarations() -> None:
    """By the usual reading; where it has another, one of the readings that are told has that of the declaration."""
    chapter = load("chasles.rotations")
    judge = Session(book=chapter)
    chosen = mutants(chapter, judge)
    read = read_equations([in_print(e, m.statement) for e, m in chosen], notation_of_chapter(chapter))  # type: ignore[arg-type]
    tally: Counter[str] = Counter()
    unlike = []
    for (_, mutant), each in zip(chosen, read, strict=True):
        claim = mutant.statement
        assert isinstance(claim, Claim)
        if not each.readings:
            tally["unread"] += 1
            continue
        declared = verdict(claim, None, judge)
        verdicts = [verdict(claim, reading, judge) for reading in each.readings]
        tally["usual" if verdicts[0] == declared else "told" if declared in verdicts else "unlike"] += 1
        unlike += [str(mutant)] if declared not in verdicts else []
    assert not unlike, unlike
    assert len(chosen) > 40
    assert tally["unread"] <= 0.005 * len(chosen), tally
    assert tally["usual"] >= 0.95 * len(chosen), tally
