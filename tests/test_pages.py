"""The pages of verdicts and of errata: a line for each number, a section for each slip, and nothing that is not so."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from fractions import Fraction

import pytest

from chasles.decisions.plain_data import from_data, to_data
from chasles.decisions.session import Decision, Session
from chasles.report.decisions import HEADERS
from chasles.report.errata_page import errata_page
from chasles.report.findings import lost_marks
from chasles.report.markdown import code, escaped
from chasles.report.verdict_page import WORST_FIRST, pages, verdict_page
from chasles.report.words import VERDICTS, counted, said
from chasles.statements import Chapter, Claim, Definition, Entry, Section, Statement, load, nonzero
from chasles.verdict import Contradictory, Counterexample, Fails, Undecided
from chasles.vocabulary import column, norm, scalar, vector

from .decided import chapter_session
from .sampling import WHOLE, sample

SECTION = Section("9.1", "On | Bars")
x, y = (vector(letter, letter, "any vector") for letter in "xy")
k = scalar("k", "k", "any number")
right_one = Claim("9.2", norm(x) ** 2, x.T @ x, says="It holds.")
under = Claim("9.10", k / k * x, x, says="It needs something.", assuming=(nonzero(k),))
doubled = Definition("9.1", y, 2 * x, says="Twice.")
wrong = Claim("9.3", 2 * y, 3 * x, says="It fails.", given=(doubled,))
declared = Claim("9.4", x, norm(y) ** 2 * (y - k * x) + 7 * y, says="It fails, and more.", corrected=2 * x - x)
hollow = Claim("9.5", column(x, x), x, says="It does not fit.", reading=column(x, x))
lost = Claim("9.6", column(x, x), x, says="It does not fit, and fails.", reading=column(x, -x))
EVERYTHING = (right_one, under, doubled, wrong, declared, hollow, lost)


def name_of(statement: Statement) -> str:
    return f"s{statement.number}/{statement.part}"


def decided(*statements: Statement, repaired: bool = False) -> tuple[Chapter, dict[str, Decision]]:
    listed = sorted(statements, key=lambda s: not isinstance(s, Definition))
    book = Chapter("Bars", tuple(Entry(name_of(s), SECTION, s) for s in listed))
    judge = Session(book=book if repaired else None)
    return book, {entry.name: judge.decide(entry.statement) for entry in book}


def written(*statements: Statement) -> tuple[str, str]:
    book, decisions = decided(*statements)
    return verdict_page(book, decisions), errata_page(book, decisions)


def row(page: str, number: str) -> list[str]:
    (found,) = [line for line in page.splitlines() if line.startswith(f"| {number} |")]
    return [cell.strip() for cell in re.split(r"(?<!\\)\|", found)[1:-1]]


def slip(page: str, number: str) -> str:
    (found,) = [part for part in re.split(r"\n##+ ", page) if part.startswith(f"{number}\n")]
    return found


def test_every_number_has_one_line_in_order() -> None:
    page, _ = written(*EVERYTHING)
    lines = [line.split(" | ")[0][2:] for line in page.splitlines() if line.startswith("| (")]
    assert lines == ["(9.1)", "(9.2)", "(9.3)", "(9.4)", "(9.5)", "(9.6)", "(9.10)"]
    assert "7 numbered equations and 0 theorems" in page


def test_what_is_of_an_earlier_chapter_is_counted_apart() -> None:
    page, _ = written(*EVERYTHING, Claim("8.1", x, x, says="The same."), Claim("Thm 9.1", x, x, says="The same."))
    assert "7 numbered equations, 1 of earlier chapters, and 1 theorems" in page


def test_verdicts_are_in_their_columns() -> None:
    page, _ = written(*EVERYTHING)
    assert row(page, "(9.1)") == ["(9.1)", "definition", "defined", "", ""]
    assert row(page, "(9.2)") == ["(9.2)", "claim", "holds", "", ""]
    assert row(page, "(9.10)") == ["(9.10)", "claim", "holds under", "k != 0", ""]
    assert row(page, "(9.3)") == ["(9.3)", "claim", "**fails**", "", "**nothing: a gap**"]
    assert row(page, "(9.4)")[4] == "x = 2 x - x (declared: a gap of the search)"
    assert row(page, "(9.5)")[2] == "**ill-formed**"
    assert r"## 9.1 On \| Bars" in page


def test_the_worst_part_is_the_number_s_verdict() -> None:
    page, _ = written(right_one, Claim("9.2", 3 * x, x, part=2))
    assert row(page, "(9.2)")[2] == "**fails**"
    assert row(page, "(9.2)")[4] == "part 2: **nothing: a gap**"


def test_what_was_found_is_told_from_what_was_declared() -> None:
    book, decisions = decided(wrong, doubled, declared, repaired=True)
    page, errata = verdict_page(book, decisions), errata_page(book, decisions)
    assert "found by repair" in row(page, "(9.3)")[4]
    assert "1 are repaired by the search, 1 by what is declared, 0 by nothing" in page
    assert "The search for a repair found it" in slip(errata, "(9.3)")
    assert "It was declared, not found" in slip(written(declared)[1], "(9.4)")


def test_a_counterexample_is_three_lines() -> None:
    _, errata = written(*EVERYTHING)
    said = slip(errata, "(9.3)")
    at = re.search(
        r"- at `x = \((.*)\)`, so that `y = \((.*)\)`\n- the left side is `(.*)` in row (\d), .*\n(.*)", said
    )
    assert at is not None
    of_x, of_y = ([Fraction(number) for number in at[place].split(", ")] for place in (1, 2))
    assert of_y == [2 * value for value in of_x]
    place = int(at[4]) - 1
    assert Fraction(at[3]) == 2 * of_y[place]
    assert at[5] == f"- the right side is `{3 * of_x[place]}`"


def test_the_values_are_those_of_the_decision() -> None:
    book, decisions = decided(wrong, doubled)
    other = Counterexample({"x_1": Fraction(5), "x_2": Fraction(0), "x_3": Fraction(0)}, (1, 1), "20", "15")
    decisions[name_of(wrong)] = Decision(wrong, Fails(other))
    said = slip(errata_page(book, decisions), "(9.3)")
    assert "- at `x = (5, 0, 0)`, so that `y = (10, 0, 0)`\n- the left side is `20` in row 1, column 1\n" in said


def test_a_lost_mark_is_told_from_a_slip() -> None:
    _, errata = written(*EVERYTHING)
    assert slip(errata, "(9.3)").rstrip().endswith("Probably a misprint.")
    assert slip(errata, "(9.5)").rstrip().endswith("Probably a slip of the scan.")
    assert "and a misprint." in slip(errata, "(9.6)")
    assert "and fails:" in slip(errata, "(9.6)")
    assert "No correct form" in slip(errata, "(9.3)")


@pytest.mark.parametrize(
    ("printed", "read", "lost"),
    [
        (
            r"\begin{bmatrix} a b \end{bmatrix}",
            r"\begin{bmatrix} a & b \end{bmatrix}",
            "a separator between two blocks",
        ),
        (r"\dot{\mathbf{F}}", r"\dot{\tilde{\mathbf{F}}}", "a tilde"),
        (r"\dot{\mathbf{e}}", r"\dot{\mathbf{e}}^T", "a superscript"),
        (r"\sin \theta", r"\sin \phi", "theta for phi"),
        (r"\dot{\mathbf{v}}", r"\dot{\boldsymbol{\nu}}", "v for nu"),
        (r"a + b", r"a - b", ""),
        (r"\sin \theta + b", r"\sin \phi", ""),
        (r"a", r"a", ""),
    ],
)
def test_a_lost_mark_is_named(printed: str, read: str, lost: str) -> None:
    found = lost_marks(printed, read)
    assert " ".join((*found.marks, *found.letters)) == lost


def test_the_slips_of_the_scan_are_named(whole: dict[str, str]) -> None:
    for number, words in (
        ("3.77a", "a slip of the scan, which has v for nu."),
        ("3.77b", "a slip of the scan, which has lost a separator between two blocks."),
        ("3.94", "a slip of the scan, which has lost a tilde."),
        ("3.96a", "a slip of the scan, which has lost a superscript, and a misprint."),
    ):
        assert f"Probably {words}" in slip(whole["ERRATA.md"], f"({number})")


def test_only_what_does_not_stand_is_an_erratum() -> None:
    assert "There are none." in written(right_one, under)[1]
    assert len(re.findall("^### ", written(*EVERYTHING)[1], re.MULTILINE)) == 4


def test_what_is_undecided_is_no_verdict() -> None:
    book, decisions = decided(right_one)
    decisions[name_of(right_one)] = Decision(right_one, Undecided("too long"))
    assert row(verdict_page(book, decisions), "(9.2)")[2:] == ["**undecided**", "", "**nothing: a gap**"]
    assert "There are none." in errata_page(book, decisions)


def test_nothing_in_a_text_is_a_mark() -> None:
    assert escaped("|e| = 1, [a_1] * `b`") == r"\|e\| = 1, \[a\_1\] \* \`b\`"
    assert code("a") == "`a`"
    assert code("`a`") == "`` `a` ``"


@pytest.fixture(scope="module")
def judge() -> Session:
    return chapter_session()


@pytest.fixture(scope="module")
def whole(judge: Session) -> dict[str, str]:
    return pages(load(), judge)


def test_the_chapter_is_complete(whole: dict[str, str]) -> None:
    lines = [line for line in whole["VERDICTS.md"].splitlines() if line.startswith("| ") and "---" not in line]
    numbers = [line.split(" | ")[0][2:].strip("()") for line in lines if not line.startswith("| number")]
    assert sorted(numbers) == sorted({escaped(entry.number) for entry in load()})
    assert "\n172 numbered equations, 4 of earlier chapters, and " in whole["VERDICTS.md"]


def test_every_slip_of_the_chapter_is_there(whole: dict[str, str], judge: Session) -> None:
    for entry in load():
        part = f" part {entry.statement.part}" if entry.statement.part > 1 else ""
        heading = f"\n### ({entry.number}){part}\n"
        assert (heading in whole["ERRATA.md"]) == (not judge.decide(entry.statement).verdict.true), entry.number
    assert "No correct form" not in whole["ERRATA.md"]


@pytest.mark.slow
def test_the_pages_are_the_same_for_every_hash_seed(judge: Session) -> None:
    end = None if WHOLE else 60
    program = (
        "import sys; from chasles.decisions.session import Session; from chasles.report.verdict_page import pages\n"
        f"from chasles.statements import Chapter, load; part = Chapter('Part', load().entries[:{end}])\n"
        "sys.stdout.buffer.write(''.join(pages(part, Session(book=load())).values()).encode())"
    )
    expected = "".join(pages(Chapter("Part", load().entries[:end]), judge).values())
    for seed in sample(("1", "2"), 2):
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        made = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, check=True)
        assert made.stdout.decode() == expected


def test_a_contradiction_is_told_wherever_verdicts_are() -> None:
    verdict = Contradictory(("|e| = 1", "m > 0"), {"contradiction": []})
    assert not verdict.true
    assert from_data(to_data(verdict)) == verdict
    assert verdict.reason == "nothing satisfies |e| = 1 and m > 0"
    assert (said(verdict), counted([verdict])) == ("contradictory", "1 contradictory")
    assert {*WORST_FIRST} == {*VERDICTS} == {*HEADERS}
