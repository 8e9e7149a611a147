"""The command line: what it prints for people and for machines, what it says of bad input, how it ends."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import time
from fractions import Fraction
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

import chasles
from chasles.cli import COMMANDS, book, main
from chasles.proof import judge
from chasles.proof.verdict import Undecided
from chasles.statements import Chapter, Claim, Definition, Entry, Section, load, unit
from chasles.vocabulary import cross, dot, scalar, vector

VERDICTS = {"defined", "posed", "assumed", "holds", "holds-under", "fails", "ill-formed", "undecided"}
ROLES = {"definition", "condition", "postulate", "claim", "theorem"}
KEYS = [
    "number", "part", "name", "section", "role", "verdict", "needs", "counterexample", "corrected", "latex",
    "certificate", "milliseconds",
]  # fmt: skip
ESCAPE = "\x1b["

a, b = vector("a", "a", "a vector"), vector("b", "b", "another")
x, y, z = (scalar(name, name, "a number") for name in "xyz")


def run(*words: str, **environment: str | None) -> Result:
    return CliRunner(env={"COLUMNS": None, **environment}).invoke(main, list(words), prog_name="chasles")


def process(*words: str, **environment: str) -> subprocess.CompletedProcess[str]:
    command = (sys.executable, "-c", "from chasles.cli import main; main()", *words)
    kept = {key: value for key, value in os.environ.items() if key not in ("COLUMNS", "CHASLES_DEBUG")}
    return subprocess.run(command, env={**kept, **environment}, capture_output=True, text=True, check=False)


def toy(**statements: object) -> Chapter:
    """A chapter with one section that declares these."""
    section = Section("9.1", "A Toy")
    return Chapter("Toys", tuple(Entry(name, section, statement) for name, statement in statements.items()))


@pytest.fixture
def chapter_is(monkeypatch: pytest.MonkeyPatch):
    def replace(**statements: object) -> None:
        monkeypatch.setattr(book, "load", lambda package: toy(**statements))

    return replace


def records(*words: str) -> list[dict]:
    done = run("decide", "--json", *words)
    assert done.exit_code == 0, done.stderr
    return json.loads(done.stdout)["statements"]


@pytest.fixture(scope="module")
def whole() -> list[dict]:
    return records()


# Help and bad usage


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_help_with_an_example_and_json(name: str) -> None:
    done = run(name, "--help")
    assert done.exit_code == 0
    assert f"Example: chasles {name}" in done.stdout
    assert "--json" in done.stdout


def test_help_names_every_command() -> None:
    done = run("--help")
    assert all(re.search(rf"^  {name} +\w", done.stdout, re.MULTILINE) for name in COMMANDS)


def test_version() -> None:
    assert run("--version").stdout == f"chasles, version {chasles.__version__}\n"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["show", "3.199"], "the book has no equation '3.199'; near it: 3.19"),
        (["show", "3.76"], "near it: 3.76a, 3.76b, 3.76c, 3.76d"),
        (["show", "thm", "3.2.9"], "the book has no equation 'thm'"),
        (["show", "screw_axis_pont"], "near it: screw_axis_point"),
        (["show", " "], "the book has no equation ' '"),
        (["show"], "Missing argument 'NUMBER...'; see `chasles show --help`"),
        (["decide", "3.16", "nonsense"], "no equation 'nonsense'; `chasles list` shows all"),
        (["decide", "--section", "4.1"], "the book has no section '4.1'"),
        (["decide", "--section"], "requires an argument"),
        (["list", "--section", "3.2.9"], "near it: 3.2"),
        (["decied"], "there is no command 'decied'; near it: decide; see `chasles --help`"),
        (["emit", "--what"], "No such option '--what'; see `chasles emit --help`"),
        (["emit", "--out", __file__], "is a file"),
        (["verify", "screw_axis"], "there is no kernel 'screw_axis'; near it: screw_axis_point"),
        (["verify", "--samples", "0"], "'--samples'"),
        (["verify", "--points", "somewhere"], "'--points'"),
    ],
)
def test_bad_input_is_one_clear_line(words: list[str], said: str) -> None:
    done = run(*words)
    assert done.exit_code == 2
    assert done.stdout == ""
    assert done.stderr.startswith("chasles: ")
    assert said in done.stderr
    assert done.stderr.count("\n") == 1


def test_a_declaration_that_does_not_fit_is_named_with_its_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    package = tmp_path / "a_broken_book"
    package.mkdir()
    (package / "__init__.py").write_text('SECTIONS = ("s01",)\n', "utf-8")
    broken = package / "s01.py"
    words = "from chasles.vocabulary import scalar, vector\n\nwrong = vector('a', 'a') + scalar('x', 'x')\n"
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(book, "BOOK", "a_broken_book")
    for text, line, said in [(words, 3, "cannot add"), ("x = = 1\n", 1, "invalid syntax"), ("import no_such\n", 1, "no_such")]:
        broken.write_text(text, "utf-8")
        done = run("decide")
        assert done.exit_code == 2
        assert done.stderr.startswith(f"chasles: {broken}, line {line}: ")
        assert said in done.stderr
        assert done.stderr.count("\n") == 1


def test_contradictory_declarations_are_bad_input(monkeypatch: pytest.MonkeyPatch) -> None:
    twice = Definition("9.1", x, y)
    again = Definition("9.1", y, z)
    monkeypatch.setattr(book, "load", lambda package: toy(twice=twice, again=again))
    done = run("list")
    assert done.exit_code == 2
    assert "twice and again are both declared as (9.1), part 1" in done.stderr


def test_what_nobody_expected_is_one_line_and_a_traceback_on_request(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(package: str) -> Chapter:
        raise RuntimeError("a\nsurprise")

    monkeypatch.setattr(book, "load", fail)
    done = run("decide")
    assert done.exit_code == 1
    assert done.stderr.startswith("chasles: this is a defect of chasles: RuntimeError: a surprise. Please report it")
    assert done.stderr.count("\n") == 1
    assert "Traceback" in run("decide", CHASLES_DEBUG="1").stderr


def test_interruption_is_not_a_traceback(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(package: str) -> Chapter:
        raise KeyboardInterrupt

    monkeypatch.setattr(book, "load", interrupt)
    done = run("decide")
    assert (done.exit_code, done.stderr) == (130, "chasles: stopped\n")


def test_a_reader_may_leave_early() -> None:
    command = f"'{sys.executable}' -c 'from chasles.cli import main; main()' show 3.16 3.18 Thm 3.2.2 | true; echo ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=True)
    assert done.stderr == ""
    assert done.stdout in ("0\n", "1\n")


# Records for machines


def check_record(record: dict) -> None:
    """The structure that programs rely on."""
    assert list(record) == KEYS
    assert isinstance(record["number"], str)
    assert isinstance(record["part"], int)
    assert record["name"].isidentifier()
    assert re.fullmatch(r"\d+(\.\d+)+", record["section"])
    assert record["role"] in ROLES
    assert record["verdict"] in VERDICTS
    assert all(isinstance(need, str) for need in record["needs"])
    assert bool(record["needs"]) == (record["verdict"] == "holds-under")
    assert record["latex"]
    assert record["certificate"] is None or re.fullmatch(r"sha256:[0-9a-f]{64}", record["certificate"])
    assert record["certificate"] or record["verdict"] not in ("holds", "holds-under")
    assert isinstance(record["milliseconds"], float)
    assert (record["counterexample"] is not None) == (record["verdict"] == "fails")
    if found := record["counterexample"]:
        assert list(found) == ["at", "entry", "lhs", "rhs"]
        assert all(str(Fraction(value)) == value for value in found["at"].values())
        assert [isinstance(place, int) for place in found["entry"]] == [True, True]
        assert found["lhs"] != found["rhs"]
    if corrected := record["corrected"]:
        assert list(corrected) == ["latex", "text", "found", "form", "verdict"]
        assert corrected["found"] in ("repair", "declared")
        assert corrected["form"] in ("reading", "corrected")
        assert corrected["verdict"] in VERDICTS


def test_every_record_of_the_book_has_the_structure(whole: list[dict]) -> None:
    for record in whole:
        check_record(record)
    entries = load().entries
    assert [(r["number"], r["part"], r["name"]) for r in whole] == [(*entry.key, entry.name) for entry in entries]


def test_a_record_in_full() -> None:
    (record,) = records("3.57/1")
    assert record["certificate"].startswith("sha256:")
    del record["certificate"], record["milliseconds"]
    dotted = r"\left[ \dot{\mathbf{a}} \cdot \frac{\mathbf{\omega}}{\|\mathbf{\omega}\|^2} \right]"
    assert record.pop("latex").startswith(r"\dot{")
    assert dotted.split(r"\cdot")[0].split("[")[1].strip() in record["corrected"].pop("latex")
    assert record == {
        "number": "3.57",
        "part": 1,
        "name": "axial_velocity_of_landmark_by_dot",
        "section": "3.4.1",
        "role": "claim",
        "verdict": "ill-formed",
        "needs": [],
        "counterexample": None,
        "corrected": {
            "text": "a_dot_par = [a_dot . (omega / |omega|^2)] omega",
            "found": "declared",
            "form": "corrected",
            "verdict": "holds-under",
        },
    }


def test_verdicts_do_not_depend_on_the_hash_seed_or_the_terminal() -> None:
    def decided(**environment: str) -> list[dict]:
        done = process("decide", "--json", "--section", "3.2.1", **environment)
        assert done.returncode == 0, done.stderr
        return [record | {"milliseconds": 0} for record in json.loads(done.stdout)["statements"]]

    assert decided(PYTHONHASHSEED="1") == decided(PYTHONHASHSEED="2", COLUMNS="20", PYTHONIOENCODING="ascii")


def test_numbers_are_found_however_they_are_cited() -> None:
    def found(*words: str) -> list[tuple[str, int]]:
        return [(record["number"], record["part"]) for record in records(*words)]

    whole_number = found("3.4")
    assert len(whole_number) > 1
    assert found("(3.4)") == whole_number
    assert found("3.4/2") == [("3.4", 2)]
    assert found("Thm", "3.2.2", "3.16") == found("thm 3.2.2", "normal_matrix_inverse")
    assert {number for number, _ in found("text", "3.2", "a", "(3.42)")} == {"text 3.2 a", "3.42"}


def test_sections_hold_what_is_below_them(whole: list[dict]) -> None:
    wanted = [r["number"] for r in whole if r["section"] == "3.3" or r["section"].startswith("3.2")]
    assert [record["number"] for record in records("--section", "3.2", "--section", "3.3")] == wanted


# What fails, and what is merely found


def test_a_false_print_is_a_finding(chapter_is) -> None:
    chapter_is(turned=Claim("9.1", cross(a, b), cross(b, a), corrected=-cross(b, a), says="The other way round."))
    (record,) = records()
    check_record(record)
    assert record["verdict"] == "fails"
    assert record["corrected"]["verdict"] == "holds"
    assert record["certificate"] is not None
    done = run("decide")
    assert done.exit_code == 0
    found = record["counterexample"]
    assert re.search(rf"left +{found['lhs']} +\(row {found['entry'][0]}, column {found['entry'][1]}", done.stdout)
    assert re.search(r"instead +a x b = -\(?b x a\)?\n +corrected, it holds\n", done.stdout)
    assert "1 certificates and 1 counterexamples checked again" in done.stdout


def test_a_wrong_correction_fails(chapter_is) -> None:
    chapter_is(turned=Claim("9.1", x + y, x - y, corrected=x + 2 * y, says="Wrong twice."))
    done = run("decide")
    assert done.exit_code == 1
    assert done.stderr == "chasles: what is declared to stand in for the print is not proved: (9.1)\n"


def test_undecided_fails_in_both_outputs(chapter_is, monkeypatch: pytest.MonkeyPatch) -> None:
    chapter_is(sure=Definition("9.1", x, y), unsure=Claim("9.2", x + y, y + x, says="Who knows."))
    monkeypatch.setattr(judge, "decide_problem", lambda *_: Undecided("no idea"))
    for flag in ([], ["--json"], ["--brief"]):
        done = run("decide", *flag)
        assert done.exit_code == 1
        assert done.stderr == "chasles: undecided: (9.2)\n"
    assert "because  no idea" in run("show", "9.2").stdout


def test_a_forged_certificate_fails(chapter_is, monkeypatch: pytest.MonkeyPatch) -> None:
    chapter_is(long=Claim("9.1", dot(a, a) * dot(a, b), dot(a, b), assuming=(unit(a),), says="A unit vector."))
    assert run("decide").exit_code == 0
    decide = judge.decide_problem

    def forged(*of: object):
        verdict = decide(*of)
        entries = verdict.certificate["entries"]
        for entry in entries.values():
            entry["cofactors"] = {label: f"2 + {text}" for label, text in entry["cofactors"].items()}
        return verdict

    monkeypatch.setattr(judge, "decide_problem", forged)
    done = run("decide")
    assert done.exit_code == 1
    assert done.stderr.startswith("chasles: checked again, the verdict on (9.1) is rejected: ")
    assert run("decide", "--no-recheck").exit_code == 0


def test_unused_hypotheses_are_reported(chapter_is) -> None:
    chapter_is(plain=Claim("9.1", x + y, y + x, assuming=(unit(a),), says="Addition commutes."))
    done = run("decide")
    assert done.exit_code == 0
    assert "assumes |a| = 1, which it does not need" in done.stdout


# Pages for people


def test_every_statement_has_a_page(whole: list[dict]) -> None:
    numbers = list(dict.fromkeys(record["number"] for record in whole))
    done = run("show", *numbers, "--latex")
    assert done.exit_code == 0
    for record in whole:
        assert record["name"] in done.stdout
        assert record["certificate"] is None or record["certificate"] in done.stdout
    pages = json.loads(run("show", "--json", *numbers).stdout)["statements"]
    assert len(pages) == len(whole)
    assert all(set(page) == {*KEYS, "says", "text", "given", "assuming", "kernel"} for page in pages)


def test_a_page_in_full() -> None:
    page = run("show", "3.16", "--latex").stdout
    assert page.startswith("(3.16)  ✓ holds under ")
    assert "normal_matrix_inverse, claim in 3.2.1" in page
    assert "printed      (A^T A)^-1 = " in page
    assert r"\left( \mathbf{A}^T \mathbf{A} \right)^{-1} = " in page
    assert "assuming     phi != 0" in page
    assert "kernel       normal_matrix_inverse(e, phi)" in page
    assert re.search(r"certificate  sha256:[0-9a-f]{64}\n", page)
    assert re.search(r"example      satisfies all that is assumed: .*e = \(", page)


def test_list_has_a_line_for_each_number(whole: list[dict]) -> None:
    lines = run("list").stdout.splitlines()
    numbers = list(dict.fromkeys(record["number"] for record in whole))
    for wanted in numbers:
        assert sum(line.startswith(f"{wanted}  ") for line in lines) == 1, wanted
    listed = json.loads(run("list", "--json").stdout)["statements"]
    assert [(entry["number"], entry["part"]) for entry in listed] == [(r["number"], r["part"]) for r in whole]


def test_the_page_of_decisions_names_each_statement_and_the_totals(whole: list[dict]) -> None:
    page = run("decide").stdout
    for record in whole:
        number = record["number"] + (f"/{record['part']}" if record["part"] > 1 else "")
        assert re.search(rf"^{re.escape(number)}  ", page, re.MULTILINE), number
    assert f"{len(whole)} statements: " in page
    assert re.search(r"decided in \d+.* checked again in \d+", page)
    brief = run("decide", "--brief").stdout
    assert len(brief) < len(page) / 2
    assert "(3.57)" in brief


def test_a_pipe_gets_plain_text() -> None:
    for words in (["decide"], ["list"], ["show", "3.57"]):
        page = run(*words).stdout
        assert ESCAPE not in page
        assert not re.search(r"[ \t]$", page, re.MULTILINE)


@pytest.mark.parametrize("width", [30, 60, 80, 160])
def test_pages_keep_to_the_width(width: int) -> None:
    for words in (["decide", "--section", "3.4.1"], ["list"], ["show", "3.57", "Thm 3.2.2", "natural_invariants"]):
        done = run(*words, COLUMNS=str(width))
        assert done.exit_code == 0
        assert max(map(len, done.stdout.splitlines())) <= width


def test_colour_where_it_is_wanted_and_words_where_it_is_not() -> None:
    words = ("decide", "--section", "3.3")
    coloured = process(*words, FORCE_COLOR="1", TERM="xterm", COLUMNS="100").stdout
    assert ESCAPE + "32m" in coloured
    uncoloured = process(*words, FORCE_COLOR="1", NO_COLOR="1", TERM="xterm", COLUMNS="100").stdout
    assert ESCAPE + "32m" not in uncoloured
    assert "✓ holds under" in uncoloured


def test_ascii_terminals_get_ascii_signs() -> None:
    done = process("decide", "3.16", "3.57", "3.22", "3.14", PYTHONIOENCODING="ascii")
    assert done.returncode == 0, done.stderr
    assert done.stdout.isascii()
    assert "+ holds under" in done.stdout
    assert "! ill-formed" in done.stdout


# Speed


def test_deciding_imports_neither_sympy_nor_numpy() -> None:
    pytest.importorskip("flint", reason="SymPy's rings are used where flint is not installed")
    code = (
        "import sys; from chasles.cli import main\n"
        "try: main(['decide', '--section', '3.3'])\n"
        "except SystemExit: print(*{'sympy', 'numpy', 'jinja2', 'mpmath', 'rich.progress'} & set(sys.modules), file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stderr == "\n"


def test_three_sections_are_decided_in_three_seconds() -> None:
    pytest.importorskip("flint", reason="three seconds are promised with flint")
    words = ("decide", "--section", "3.2", "--section", "3.3", "--section", "3.4")
    durations = []
    for _ in range(3):
        started = time.perf_counter()
        done = process(*words)
        durations.append(time.perf_counter() - started)
        assert done.returncode == 0
    assert min(durations) < 3
    (again,) = re.findall(r"checked again in ([\d.]+) (m?s)", done.stdout)
    assert float(again[0]) / (1000 if again[1] == "ms" else 1) < 2
