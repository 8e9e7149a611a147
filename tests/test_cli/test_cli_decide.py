"""What `chasles decide` tells machines, what it takes for a failure, and how long it takes."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from dataclasses import replace
from fractions import Fraction

import pytest

from chasles.decisions import session as judge
from chasles.statements import Claim, Definition, load, unit
from chasles.verdict import Undecided
from chasles.vocabulary import cross, dot, scalar, vector

VERDICTS = {"defined", "posed", "assumed", "holds", "holds-under", "fails", "ill-formed", "contradictory", "undecided"}
ROLES = {"definition", "condition", "postulate", "claim", "theorem"}
KEYS = [
    "number", "part", "name", "section", "role", "verdict", "needs", "contradictory", "counterexample", "corrected",
    "latex", "certificate", "coq", "milliseconds",
]  # fmt: skip

a, b = vector("a", "a", "a vector"), vector("b", "b", "another")
x, y, z = (scalar(name, name, "a number") for name in "xyz")


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
    assert bool(record["contradictory"]) == (record["verdict"] == "contradictory")
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
        assert corrected["form"] in ("reading", "repair", "corrected")
        assert corrected["verdict"] in VERDICTS


def test_every_record_of_the_book_has_the_structure(whole: list[dict]) -> None:
    for record in whole:
        check_record(record)
    entries = load().entries
    assert [(r["number"], r["part"], r["name"]) for r in whole] == [(*entry.key, entry.name) for entry in entries]


def test_a_record_in_full(records) -> None:
    (record,) = records("3.57/1")
    assert record["certificate"].startswith("sha256:")
    del record["certificate"], record["coq"], record["milliseconds"]
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
        "contradictory": [],
        "counterexample": None,
        "corrected": {
            "text": "a_dot_par = [a_dot . (omega / |omega|^2)] omega",
            "found": "repair",
            "form": "repair",
            "verdict": "holds-under",
        },
    }


def test_verdicts_do_not_depend_on_the_hash_seed_or_the_terminal(process) -> None:
    def decided(**environment: str) -> list[dict]:
        done = process("decide", "--json", "--section", "3.2.1", **environment)
        assert done.returncode == 0, done.stderr
        return [record | {"milliseconds": 0} for record in json.loads(done.stdout)["statements"]]

    assert decided(PYTHONHASHSEED="1") == decided(PYTHONHASHSEED="2", COLUMNS="20", PYTHONIOENCODING="ascii")


def test_numbers_are_found_however_they_are_cited(records) -> None:
    def found(*words: str) -> list[tuple[str, int]]:
        return [(record["number"], record["part"]) for record in records(*words)]

    whole_number = found("3.4")
    assert len(whole_number) > 1
    assert found("(3.4)") == whole_number
    assert found("3.4/2") == [("3.4", 2)]
    assert found("Thm", "3.2.2", "3.16") == found("thm 3.2.2", "normal_matrix_inverse")
    assert {number for number, _ in found("text", "3.2", "a", "(3.42)")} == {"text 3.2 a", "3.42"}


def test_sections_hold_what_is_below_them(records, whole: list[dict]) -> None:
    wanted = [r["number"] for r in whole if r["section"] == "3.3" or r["section"].startswith("3.2")]
    assert [record["number"] for record in records("--section", "3.2", "--section", "3.3")] == wanted


def test_a_false_print_is_a_finding(run, records, chapter_is) -> None:
    chapter_is(turned=Claim("9.1", cross(a, b), cross(b, a), says="The other way round."))
    (record,) = records()
    check_record(record)
    assert record["verdict"] == "fails"
    assert record["corrected"]["verdict"] == "holds"
    assert record["certificate"] is not None
    done = run("decide")
    assert done.exit_code == 0
    found = record["counterexample"]
    assert re.search(rf"left +{found['lhs']} +\(row {found['entry'][0]}, column {found['entry'][1]}", done.stdout)
    assert re.search(r"instead +a x b = -\(?b x a\)?\n +as repaired, it holds\n", done.stdout)
    assert "1 certificate and 1 counterexample checked again" in done.stdout


DECLARED = r"\({}\) \(.*test_cli_decide\.py, line \d+\)"


def test_a_wrong_correction_fails(run, chapter_is) -> None:
    chapter_is(turned=Claim("9.1", x + y, x - y, corrected=x + 2 * y, says="Wrong twice."))
    done = run("decide")
    assert done.exit_code == 1
    assert re.fullmatch(rf"chasles: the declared correction is not proved: {DECLARED.format('9.1')}\n", done.stderr)


def test_undecided_fails_in_both_outputs(run, chapter_is, monkeypatch: pytest.MonkeyPatch) -> None:
    chapter_is(sure=Definition("9.1", x, y), unsure=Claim("9.2", x + y, y + x, says="Who knows."))
    monkeypatch.setattr(judge, "decided", lambda *_: Undecided("no idea"))
    for flag in ([], ["--json"], ["--brief"]):
        done = run("decide", *flag)
        assert done.exit_code == 1
        assert re.fullmatch(rf"chasles: undecided: {DECLARED.format('9.2')}\n", done.stderr)
    assert "because  no idea" in run("show", "9.2").stdout


def test_a_forged_certificate_fails(run, chapter_is, monkeypatch: pytest.MonkeyPatch) -> None:
    chapter_is(long=Claim("9.1", dot(a, a) * dot(a, b), dot(a, b), assuming=(unit(a),), says="A unit vector."))
    assert run("decide").exit_code == 0
    decide = judge.decided

    def forged(*of: object):
        verdict = decide(*of)
        return replace(verdict, certificate=verdict.certificate | {"division": []})

    monkeypatch.setattr(judge, "decided", forged)
    done = run("decide")
    assert done.exit_code == 1
    assert done.stderr.startswith("chasles: checked again, the verdict on (9.1) is rejected: ")
    assert run("decide", "--no-recheck").exit_code == 0


def test_unused_hypotheses_are_reported(run, chapter_is) -> None:
    chapter_is(plain=Claim("9.1", x + y, y + x, assuming=(unit(a),), says="Addition commutes."))
    done = run("decide")
    assert done.exit_code == 0
    assert "assumes |a| = 1, which it does not need" in done.stdout


def test_deciding_imports_neither_sympy_nor_numpy() -> None:
    pytest.importorskip("flint", reason="SymPy's rings are used where flint is not installed")
    code = (
        "import sys; from chasles.cli import main\n"
        "try: main(['decide', '--section', '3.3'])\n"
        "except SystemExit: print(*{'sympy', 'numpy', 'jinja2', 'mpmath'} & set(sys.modules), file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stderr == "\n"
