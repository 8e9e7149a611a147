"""The verdict on every statement is the one on record, and what each assumes is needed or reported.

`pytest tests/test_verdicts.py --update-golden` records the verdicts anew.
"""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

from chasles.decisions.session import Decision
from chasles.statements import Entry, load
from chasles.verdict import Fails, Holds, HoldsUnder, IllFormed, Undecided, Verdict

from .decided import chapter_session

GOLDEN = Path(__file__).parent / "golden" / "verdicts.toml"
HEAD = "# The verdict on every statement; `pytest tests/test_verdicts.py --update-golden` writes this file.\n\n"


@pytest.fixture(scope="module")
def decisions() -> list[tuple[Entry, Decision]]:
    return list(chapter_session().decide_all(load()))


def line(entry: Entry, decision: Decision) -> str:
    """One statement's record."""
    record = {"name": json.dumps(entry.name, ensure_ascii=False), **recorded(decision.verdict)}
    correction = decision.correction
    for place, tried in enumerate(() if correction is None else (correction, *correction.others)):
        key = tried.form if place else "stands"
        record[key] = table({"form": json.dumps(tried.form), **recorded(tried.verdict)})
    return f'"{entry.number} / {entry.statement.part}" = {table(record)}'


def recorded(verdict: Verdict) -> dict[str, str]:
    record = {"verdict": json.dumps(verdict.name)}
    for name in ("needs", "unused", "reason"):
        if said := getattr(verdict, name, ()):
            record[name] = json.dumps(said, ensure_ascii=False)
    if isinstance(verdict, Fails):
        record["at"] = table({json.dumps(k): json.dumps(str(v)) for k, v in sorted(verdict.counterexample.at.items())})
        record["left"], record["right"] = (
            json.dumps(verdict.counterexample.left),
            json.dumps(verdict.counterexample.right),
        )
    return record


def table(record: dict[str, str]) -> str:
    return "{ " + ", ".join(f"{key} = {value}" for key, value in record.items()) + " }"


def differences(old: str, new: str) -> Iterator[str]:
    """What two records say differently, statement by statement."""
    before, after = tomllib.loads(old), tomllib.loads(new)
    for key in [*before, *(key for key in after if key not in before)]:
        if key not in after:
            yield f"({key}) {before[key]['name']} is on record and not declared"
        elif key not in before:
            yield f"({key}) {after[key]['name']} is declared and not on record"
        elif before[key] != after[key]:
            yield f"({key}) was {before[key]}, and is {after[key]}"


def test_the_verdicts_are_those_on_record(decisions: list[tuple[Entry, Decision]], pytestconfig: pytest.Config) -> None:
    found = HEAD + "".join(line(entry, decision) + "\n" for entry, decision in decisions)
    if pytestconfig.getoption("--update-golden"):
        GOLDEN.parent.mkdir(exist_ok=True)
        draft = GOLDEN.with_suffix(".draft")
        draft.write_text(found, encoding="utf-8")
        draft.replace(GOLDEN)
    different = list(differences(GOLDEN.read_text(encoding="utf-8"), found))
    assert not different, "\n".join([*different, "if this is meant: pytest tests/test_verdicts.py --update-golden"])


def test_a_changed_verdict_is_told() -> None:
    one = '"3.2 / 1" = { name = "a", verdict = "holds" }\n'
    other = '"3.2 / 1" = { name = "a", verdict = "holds-under", needs = ["x != 0"] }\n'
    new = '"3.3 / 1" = { name = "b", verdict = "defined" }\n'
    assert not list(differences(one, one))
    assert [text[:9] for text in differences(one, other)] == ["(3.2 / 1)"]
    assert list(differences(one, one + new)) == ["(3.3 / 1) b is declared and not on record"]
    assert list(differences(one + new, one)) == ["(3.3 / 1) b is on record and not declared"]


def test_everything_is_decided(decisions: list[tuple[Entry, Decision]]) -> None:
    verdicts = [(e.number, v) for e, d in decisions for v in (d.verdict, d.correction and d.correction.verdict)]
    assert [pair for pair in verdicts if isinstance(pair[1], Undecided)] == []


def test_what_is_not_well_formed_is_read_in_a_way_that_is(decisions: list[tuple[Entry, Decision]]) -> None:
    for entry, decision in decisions:
        if isinstance(decision.verdict, IllFormed):
            assert decision.correction is not None, f"({entry.number}) is not well-formed, and no reading is given"
            assert not isinstance(decision.correction.verdict, IllFormed), f"({entry.number}) reads no better"


def test_what_stands_in_for_a_print_is_found_by_the_search(decisions: list[tuple[Entry, Decision]]) -> None:
    """Nothing is declared to be right that is not found: a gap of the search would show here."""
    wrong = [(entry, decision) for entry, decision in decisions if not decision.verdict.true]
    assert len(wrong) >= 12
    for entry, decision in wrong:
        assert decision.stands, entry.number
        assert decision.correction is not None
        assert decision.correction.found == "repair", entry.number


def test_every_hypothesis_is_needed_or_reported(decisions: list[tuple[Entry, Decision]]) -> None:
    judged = 0
    for entry, decision in decisions:
        verdict = (
            decision.verdict if decision.verdict.true or decision.correction is None else decision.correction.verdict
        )
        if isinstance(verdict, Holds | HoldsUnder):
            judged += 1
            needs = set(verdict.needs)
            own = {hypothesis.text for hypothesis in entry.statement.assuming}
            assert own <= needs | set(verdict.unused), f"({entry.number}) does not say what became of {own - needs}"
            assert not needs & set(verdict.unused)
    assert judged > 80
