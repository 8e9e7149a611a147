"""What the chapter brings along is enough, and is checked before it is believed; the rest is searched for."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace as with_fields
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from chasles.cli import main
from chasles.cli.answers import answers
from chasles.decisions.kept_answers import repairs_stand, verdict_stands
from chasles.decisions.memory import Memory
from chasles.decisions.plain_data import from_data, to_data
from chasles.decisions.recalled import ANSWERS, shipped
from chasles.decisions.session import Session
from chasles.deriving import walk
from chasles.exercises.solving import solve_with
from chasles.statements import Chapter, Claim, Definition, Entry, Section, Statement, load, problem_of, unit
from chasles.statements.derivations import declared_derivations
from chasles.statements.exercises import exercise_numbers
from chasles.statements.packages import BOOK
from chasles.verdict import Contradictory, Fails, Holds, IllFormed, Posed
from chasles.vocabulary import Node, Sum, cross, dot, number, vector

from .sampling import WHOLE, sample

ROOT = Path(__file__).resolve().parents[1]
CHAPTER, ROADS, SHIPPED = load(), declared_derivations(), shipped(BOOK)
SEARCHES = (
    "chasles.decisions.session.decided",
    "chasles.decisions.session.repair",
    "chasles.deriving.state.combined",
)
x, y, z, w = (vector(name, name, name) for name in "xyzw")
right = Claim("9.1", dot(x, cross(y, z)), dot(cross(x, y), z))
wrong = Claim("9.2", cross(x, y), cross(y, x))
slip = Claim("9.3", w, 2 * cross(x, y), given=(Definition("9.0", w, 3 * cross(x, y)),))
long = Claim("9.4", dot(x, x), number(1), assuming=(unit(x),))


@pytest.fixture
def searched(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What is searched for."""
    found: list[str] = []

    def noting(search: Callable[..., Any]) -> Callable[..., Any]:
        def note(*words: Any, **more: Any) -> Any:
            found.append(f"{search.__name__} of {words[0]}"[:300])
            return search(*words, **more)

        return note

    for name in SEARCHES:
        module, _, attribute = name.rpartition(".")
        monkeypatch.setattr(name, noting(getattr(import_module(module), attribute)))
    return found


@pytest.fixture
def new_judge(monkeypatch: pytest.MonkeyPatch) -> None:
    """Exercises are solved with a judge of their own, who knows what is shipped and nothing else."""
    judge = Session(book=CHAPTER, memory=Memory(shipped=SHIPPED))
    monkeypatch.setattr("chasles.exercises.decided._session", lambda: judge)


def book_of(*statements: Statement) -> Chapter:
    section = Section("9", "Toys")
    return Chapter("Toys", tuple(Entry(f"s{k}", section, each) for k, each in enumerate(statements)))


def kept_of(book: Chapter, *sentences: Statement) -> dict[str, Any]:
    """What a judge has to say of the sentences, as it would be shipped."""
    judge = Session(book=book)
    for sentence in sentences:
        judge.decide(sentence)
    return json.loads(json.dumps(judge.memory.everything))


@pytest.mark.parametrize("package", [BOOK, "chasles.rotations"])
def test_nothing_of_a_chapter_is_searched_for(package: str, searched: list[str]) -> None:
    book = load(package)
    judge = Session(book=book, memory=Memory(shipped=shipped(package)))
    for entry in sample(book, 5):
        judge.decide(entry.statement)
    assert searched == []
    assert judge.memory.as_data(10**6) == {}


@pytest.fixture(scope="module")
def walker() -> Session:
    return Session(book=CHAPTER, memory=Memory(shipped=SHIPPED))


@pytest.mark.slow
@pytest.mark.sampled(7)
@pytest.mark.parametrize("name", ROADS)
def test_nothing_on_the_roads_is_searched_for(name: str, walker: Session, searched: list[str]) -> None:
    assert walk(ROADS[name], walker).arrives
    assert searched == []


@pytest.mark.sampled(5)
@pytest.mark.usefixtures("new_judge")
@pytest.mark.parametrize("number", exercise_numbers())
def test_nothing_of_the_exercises_is_searched_for(number: str, searched: list[str]) -> None:
    solve_with(number, {})
    assert searched == []


def test_what_is_shipped_is_what_is_found() -> None:
    """`chasles emit --anew` writes what is found into the file."""
    judge = Session(book=CHAPTER)
    for entry in sample(CHAPTER, 11):
        judge.decide(entry.statement)
    for road in sample(ROADS.values(), 24):
        walk(road, judge)
    found = json.loads(json.dumps(judge.memory.everything))
    assert len(found) > 40
    assert {key: SHIPPED.get(key) for key in found} == found


@pytest.mark.slow
@pytest.mark.skipif(not WHOLE, reason="proves everything anew: set CHASLES_TEST_WHOLE=1")
@pytest.mark.parametrize(("package", "folder"), [(BOOK, "generated"), ("chasles.rotations", "rotations/generated")])
def test_the_whole_file_is_what_is_found(package: str, folder: str) -> None:
    book = load(package)
    assert answers(book, Session(book=book))[ANSWERS] == (ROOT / folder / ANSWERS).read_text("utf-8")


FORGED: dict[str, Callable[[Any], Any]] = {
    "another verdict": lambda verdict: Holds({"entries": {}}, {}),
    "a proof of something else": lambda verdict: from_data(kept_of(book_of(right), right).popitem()[1]),
    "a counterexample to something else": lambda verdict: from_data(kept_of(book_of(wrong), wrong).popitem()[1]),
    "it is not decided": lambda verdict: IllFormed("it does not fit"),
    "it is posed": lambda verdict: Posed({}),
    "it is contradictory": lambda verdict: Contradictory(("|x| = 1",)),
    "no verdict": lambda verdict: x,
    "repairs": lambda verdict: (),
}


@pytest.mark.sampled(5)
@pytest.mark.parametrize("forgery", FORGED)
@pytest.mark.parametrize("claim", [right, wrong, long, slip], ids=lambda claim: claim.number)
def test_a_forged_verdict_is_not_believed(claim: Claim, forgery: str, searched: list[str]) -> None:
    true = Session().decide(claim).verdict
    forged = FORGED[forgery](true)
    searched.clear()
    key = Memory().key_of_verdict(problem_of(claim), claim.assuming)
    memory = Memory(shipped={key: json.loads(json.dumps(to_data(forged)))})
    assert Session(memory=memory).decide(claim).verdict == true
    same = isinstance(forged, type(true)) and verdict_stands(problem_of(claim), forged)
    assert bool(searched) is not same


def spoiled(data: Any, key: str = "") -> Any:
    """The data with every cofactor, divisor, value and coordinate changed."""
    match data:
        case dict():
            return {name: spoiled(part, name) for name, part in data.items()}
        case list():
            return [spoiled(part) for part in data]
        case str() if data.lstrip("-").replace("/", "").isdecimal():
            return f"{data.partition('/')[0]}7"
        case _:
            return data


def test_nothing_that_was_spoiled_is_believed(searched: list[str]) -> None:
    """Whatever was done to the file, what is decided is as without it."""
    found = kept_of(book_of(right, wrong, slip, long), right, wrong, slip, long)
    assert len(found) > 5
    searched.clear()
    for claim in (right, wrong, slip, long):
        true = Session(book=book_of(right, wrong, slip, long)).decide(claim)
        memory = Memory(shipped={key: spoiled(data) for key, data in found.items()})
        again = Session(book=book_of(right, wrong, slip, long), memory=memory).decide(claim)
        assert again.verdict.name == true.verdict.name
        assert again.sides == true.sides


@pytest.mark.sampled(4)
@pytest.mark.parametrize("data", [None, 1, "text", [], ["tuple"], ["tuple", 1], ["Repair"], ["Holds"], {"a": 1},
                                  ["Holds", 1, 2, 3], ["Fails", 1], ["Symbol", 1, 2, 3, 4, 5, 6],
                                  ["Holds", {"branches": 1}, {}, ["tuple"]], ["Number", "1"], ["Rate", 1]])  # fmt: skip
def test_what_is_no_answer_is_none(data: Any) -> None:
    true = Session(book=book_of(slip)).decide(slip)
    keys = Session(book=book_of(slip)).memory
    asked = Session(book=book_of(slip), memory=keys)
    asked.decide(slip)
    decision = Session(book=book_of(slip), memory=Memory(shipped=dict.fromkeys(keys.asked, data))).decide(slip)
    assert decision.verdict == true.verdict
    assert data == ["tuple"] or decision.correction == true.correction


@pytest.mark.parametrize("change", ["sides", "verdict", "none of them"])
def test_a_forged_repair_is_not_believed(change: str) -> None:
    judge = Session(book=book_of(slip))
    true = judge.decide(slip)
    ((key, repairs),) = judge.search(slip).items()
    (first, *_) = repairs
    forged: Any = {
        "sides": (with_fields(first, right=4 * cross(x, y)),),
        "verdict": (with_fields(first, verdict=Session().decide(long).verdict),),
        "none of them": ("text",),
    }[change]
    assert not repairs_stand(slip, forged, judge.accepted, (), judge.verdict_on)
    assert repairs_stand(slip, repairs, judge.accepted, (), judge.verdict_on)
    if change != "none of them":
        memory = Memory(shipped={key: to_data(forged)})
        assert Session(book=book_of(slip), memory=memory).decide(slip).correction == true.correction


def test_repairs_of_definitions_are_checked_by_the_claims_that_rest_on_them(searched: list[str]) -> None:
    judge = Session(book=CHAPTER, memory=Memory(shipped=SHIPPED))
    found = 0
    for entry in CHAPTER:
        if isinstance(entry.statement, Definition) and entry.statement.fault:
            (repairs,) = judge.search(entry.statement).values()
            for repair in repairs:
                found += 1
                other = with_fields(repair, right=Sum((repair.right, repair.right)))
                beside = [each.statement for each in CHAPTER if isinstance(each.statement, Statement)]
                assert repairs_stand(entry.statement, (repair,), judge.accepted, beside, judge.verdict_on)
                assert not repairs_stand(entry.statement, (other,), judge.accepted, beside, judge.verdict_on)
    assert found > 1


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", ["velocities_of_a_rigid_body", "rate_of_N", "euler_zyx_body", "left_inverses_of_H"])
def test_a_road_arrives_whatever_was_kept_of_its_combinations(name: str, searched: list[str]) -> None:
    judge = Session(book=CHAPTER, memory=Memory(shipped=SHIPPED))
    walk(ROADS[name], judge)
    combinations = [key for key in judge.memory.asked if isinstance(judge.memory.recalled(key), Node)]
    forged = {key: to_data(Sum((judge.memory.recalled(key), judge.memory.recalled(key)))) for key in combinations}
    assert walk(ROADS[name], Session(book=CHAPTER, memory=Memory(forged, SHIPPED))).arrives
    assert searched


def test_only_what_is_new_is_searched_for(searched: list[str]) -> None:
    """A statement at the end of the book that is changed, and what rests on it."""
    place = CHAPTER.entries.index(CHAPTER.select(["3.145"])[0])
    changed = CHAPTER.entries[place].statement
    assert isinstance(changed, Claim)
    other = with_fields(changed, right=2 * changed.right, corrected=None, reading=None)
    judge = Session(book=CHAPTER, memory=Memory(shipped=SHIPPED))
    for entry in [*sample(CHAPTER, 5), *CHAPTER.entries[place:]]:
        judge.decide(other if entry.statement is changed else entry.statement)
    assert isinstance(judge.decide(other).verdict, Fails)
    assert 1 <= len(searched) <= 3, searched  # by what it is given, and by all that it rests on


COMMANDS = """
import json, re, sys
from hashlib import sha256
from pathlib import Path
if {hidden!r}:
    sys.modules["flint"] = None
from click.testing import CliRunner
from chasles.cli import main
from chasles.algebra.rings import backend

assert backend() == ("sympy" if {hidden!r} else "flint")
said = {{}}
for one in {words!r}:
    done = CliRunner().invoke(main, one)
    timed = r"decided in|all in|index.html|chapter.tex"
    lines = [line for line in done.stdout.splitlines() if not re.search(timed, line)]
    said[" ".join(one)] = done.exit_code, done.stderr, lines
for file in sorted(Path({out!r}).glob("*")):
    said[file.name] = sha256(file.read_bytes()).hexdigest()
print(json.dumps(said))
"""
EVERY_COMMAND = [["decide"], ["derive"], ["repair"], ["report", "--out"], ["decide", "--brief", "--anew"]]
SOME_COMMANDS = [["decide", "3.46"], ["derive", "3.18"], ["repair", "3.148"], ["decide", "3.46", "--brief", "--anew"]]


@pytest.mark.slow
def test_all_commands_say_the_same_without_flint(tmp_path: Path) -> None:
    """On one processor, and with nothing that an earlier run kept; everything proved anew once."""
    environment = {**os.environ, "CHASLES_CACHE": "", "CHASLES_PROCESSES": "1", "COLUMNS": "120", "NO_COLOR": "1"}
    found = []
    out = str(tmp_path / "report")
    commands = EVERY_COMMAND if WHOLE else SOME_COMMANDS
    words = [[*words, out] if words[-1] == "--out" else words for words in commands]
    words += [["solve", number] for number in sample(exercise_numbers(), 20)]
    for hidden in (True, False) if find_spec("flint") else (True,):
        script = COMMANDS.format(hidden=hidden, out=out, words=words)
        done = subprocess.run(
            [sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr
        found.append(json.loads(done.stdout))
    for name, said in found[0].items():
        if not isinstance(said, str):
            assert said[:2] == [0, ""], name
        assert said == found[-1][name], name.replace(out, "OUT")
    checked, anew = " ".join(commands[0]), " ".join(commands[-1])
    assert found[0][checked][2][-1] == found[0][anew][2][-1]


def test_anew_searches_for_all(searched: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CHASLES_CACHE", "")
    monkeypatch.setenv("CHASLES_PROCESSES", "1")
    done = CliRunner().invoke(main, ["decide", "3.18", "--brief"])
    assert (done.exit_code, searched) == (0, [])
    done = CliRunner().invoke(main, ["decide", "3.18", "--brief", "--anew"])
    assert done.exit_code == 0
    assert len(searched) >= 1
