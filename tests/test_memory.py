"""Verdicts that are remembered are those that were found; what is remembered is checked again; work is spread."""

from __future__ import annotations

import json
import multiprocessing
import multiprocessing.synchronize
import os
import signal
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from chasles.algebra.values import InPi
from chasles.checker.certificate import check
from chasles.cli.outcome import decide
from chasles.decisions import processes as spreading
from chasles.decisions import recalled
from chasles.decisions.decision import Decision
from chasles.decisions.memory import Memory
from chasles.decisions.plain_data import from_data, to_data
from chasles.decisions.prediction import predict
from chasles.decisions.processes import spread
from chasles.decisions.session import Session
from chasles.report.closure import closure
from chasles.statements import Claim, Hypothesis, Inverse, Statement, load, rotation
from chasles.statements.inequalities import inequality
from chasles.verdict import Fails, Holds, HoldsUnder, Undecided, Verdict
from chasles.vocabulary import PI, Node, cos, cross, rate, scalar, sin, square, vector, walk
from chasles.vocabulary.functions import arccos, arcsin

from .sampling import WHOLE

a, b = (vector(name, name, name) for name in "ab")
phi, Q = scalar("phi", "phi", "an angle"), square("Q", "Q", "a rotation")
BOOK = load()
SOME = [e for k, e in enumerate(BOOK) if WHOLE or k % 9 == 0 or isinstance(e.statement, Inverse)]
"""The statements that are decided."""


def outcome(decision: Decision) -> Any:
    """All but the time it took."""
    return decision.verdict, decision.correction, decision.given


@pytest.fixture(scope="module")
def decisions() -> tuple[Session, list[Decision]]:
    judge = Session(book=BOOK)
    return judge, [judge.decide(entry.statement) for entry in SOME]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where earlier runs keep what they found, of a chapter that brings nothing along."""
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path / "kept"))
    monkeypatch.setattr(recalled, "shipped", lambda package: {})
    return tmp_path / "kept"


def section(number: str) -> list[Any]:
    return [entry for entry in BOOK if entry.section.number == number]


def as_text(value: Any) -> Any:
    return json.loads(json.dumps(value))


def test_every_word_and_verdict_survives_as_plain_data(decisions: tuple[Session, list[Decision]]) -> None:
    sides = [side for e in BOOK if isinstance(e.statement, Statement) for side in e.statement.printed]
    nodes = {node for side in sides for node in walk(side)}
    fitting = [node for node in nodes if node.fault is None]
    assert len(fitting) > 1000
    assert all(from_data(as_text(to_data(node))) == node for node in fitting)
    for decision in decisions[1]:
        if decision.verdict.name not in ("defined", "assumed"):
            assert from_data(as_text(to_data(decision.verdict))) == from_data(to_data(decision.verdict))


def remembered(left: Node, right: Node, *assuming: Hypothesis) -> Verdict:
    """A verdict, recalled in another run."""
    claim = Claim("9.1", left, right, assuming=assuming)
    judge = Session()
    verdict = judge.decide(claim).verdict
    again = Session(memory=Memory(as_text(judge.memory.as_data(10))))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("chasles.decisions.session.decided", forbidden)
        assert again.decide(claim).verdict == verdict
    return again.decide(claim).verdict


def test_multiples_of_pi_survive() -> None:
    for verdict in (remembered(phi * cos(phi), PI * 1), remembered(phi * cos(phi) * PI, PI * cos(phi) * phi)):
        point = verdict.counterexample.at if isinstance(verdict, Fails) else verdict.witness  # type: ignore[attr-defined]
        assert isinstance(point["phi"], InPi)
        assert str(point["phi"]).endswith("pi")


def test_numbers_of_points_that_are_no_fractions_survive() -> None:
    within_half_a_turn = inequality(phi >= 0), inequality(phi <= PI)
    shown = [remembered(phi, inverse(of(phi)), *within_half_a_turn) for inverse, of in ((arccos, cos), (arcsin, sin))]
    assert [isinstance(verdict, Fails) for verdict in shown] == [False, True]
    points = [verdict.counterexample.at if isinstance(verdict, Fails) else verdict.witness for verdict in shown]  # type: ignore[attr-defined]
    assert not any(isinstance(point["phi"], int | Fraction) for point in points)
    for nonsense in ("", "x", "pi/", "1 1", "().__class__", "sqrt(", "[1]"):
        with pytest.raises(ValueError, match=r"coordinate|plain"):
            from_data({"x": nonsense})


def test_proofs_by_spins_survive() -> None:
    verdict = remembered(rate(Q) @ Q.T, -(Q @ rate(Q).T), rotation(Q))
    assert isinstance(verdict, HoldsUnder)
    assert verdict.certificate["spins"] is True
    check(Claim("9.1", rate(Q) @ Q.T, -(Q @ rate(Q).T), assuming=(rotation(Q),)), "printed", verdict.certificate)


def test_nothing_else_is_made_of_data() -> None:
    with pytest.raises(ValueError, match="no verdict and no repair"):
        from_data(["Path", "/"])
    with pytest.raises(ValueError, match="has 1 to 1 fields"):
        from_data(["Index"])
    with pytest.raises(TypeError, match="Path is not kept"):
        to_data(Path("/"))


def test_what_is_remembered_is_what_was_decided(decisions: tuple[Session, list[Decision]]) -> None:
    judge, found = decisions
    kept = as_text(judge.memory.as_data(10_000))
    # The claims by which a definition is repaired are decided when the repair is recalled.
    once = Session(book=BOOK, memory=Memory(kept))
    for entry in SOME:
        once.decide(entry.statement)
    kept = as_text(once.memory.as_data(10_000))
    again = Session(book=BOOK, memory=Memory(kept))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("chasles.decisions.session.decided", forbidden)
        patch.setattr("chasles.decisions.session.repair", forbidden)
        for entry, decision in zip(SOME, found, strict=True):
            assert as_text_of(again.decide(entry.statement)) == as_text_of(decision)
    assert not again.memory.has_learned


def forbidden(*_: object) -> None:
    raise AssertionError("asked for again")


def as_text_of(decision: Decision) -> str:
    """A certificate may hold tuples where JSON has lists."""
    return json.dumps([to_data(each) if each else None for each in kept_of(decision)])


def kept_of(decision: Decision) -> Iterator[Any]:
    if decision.verdict.name not in ("defined", "assumed"):
        yield decision.verdict
    if decision.correction is not None:
        yield decision.correction.repairs
        yield decision.correction.sides


def test_another_question_is_not_answered_by_the_old_answer() -> None:
    right = Claim("9.1", cross(a, b), -cross(b, a))
    wrong = Claim("9.1", cross(a, b), cross(b, a))
    judge = Session()
    assert isinstance(judge.decide(right).verdict, Holds)
    later = Session(memory=Memory(as_text(judge.memory.as_data(10))))
    assert isinstance(later.decide(wrong).verdict, Fails)


def test_what_is_not_decided_is_asked_again() -> None:
    memory = Memory()
    memory.remember("key", Undecided("no time"))
    assert memory.as_data(10) == {}
    memory.remember("other", ())
    assert memory.as_data(10) == {"other": ["tuple"]}


def test_old_answers_give_way_to_new_ones() -> None:
    memory = Memory({str(k): ["tuple"] for k in range(5)})
    memory.settle("3", True)
    assert list(memory.as_data(3)) == ["3", "0", "1"]
    assert memory.recalled("7") is None
    memory.settle("3", False)
    assert "3" not in memory.as_data(5)


def test_foresight_changes_no_verdict(
    decisions: tuple[Session, list[Decision]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(spreading, "processors", lambda: 2)
    judge = Session(book=BOOK)
    predict(judge, [entry.statement for entry in SOME])
    for entry, decision in zip(SOME, decisions[1], strict=True):
        assert outcome(judge.decide(entry.statement)) == outcome(decision)


def test_inverses_are_foreseen(decisions: tuple[Session, list[Decision]], monkeypatch: pytest.MonkeyPatch) -> None:
    inverses = [(d.statement, d) for d in decisions[1] if isinstance(d.statement, Inverse)]
    judge = Session(book=BOOK)
    for statement, _ in inverses:
        for given in statement.relied_on:
            judge.decide(given)
    predict(judge, [statement for statement, _ in inverses])
    monkeypatch.setattr("chasles.decisions.session.decided", forbidden)
    assert len(inverses) >= 3
    for statement, decision in inverses:
        assert outcome(judge.decide(statement)) == outcome(decision)


def test_work_is_spread_and_comes_back_in_order(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(spreading, "processors", lambda: 3)
    # Other tests may have left threads behind, beside which nothing is forked.
    monkeypatch.setattr(spreading.threading, "active_count", lambda: 1)
    pieces = list(range(50))
    found = spread(lambda n: (n * n, os.getpid()), pieces, seconds=0.1)
    assert [square for square, _ in found] == [n * n for n in pieces]
    if spreading.sys.platform.startswith("linux"):
        assert os.getpid() not in {worker for _, worker in found}
    assert {worker for _, worker in spread(lambda _: (0, os.getpid()), pieces, seconds=0.0001)} == {os.getpid()}
    with pytest.raises(ZeroDivisionError):
        spread(lambda n: 1 // n, pieces, seconds=0.1)


def refusing(error: BaseException) -> Callable[..., Any]:
    def refuse(*_: object, **__: object) -> None:
        raise error

    return refuse


@pytest.fixture
def three(monkeypatch: pytest.MonkeyPatch) -> None:
    """Work is spread over three processes."""
    if not spreading.sys.platform.startswith("linux"):
        pytest.skip("nothing is forked here")
    monkeypatch.setattr(spreading, "processors", lambda: 3)
    monkeypatch.setattr(spreading.threading, "active_count", lambda: 1)


@pytest.mark.parametrize(
    ("what", "error"),
    [
        ("_multiprocessing.SemLock", FileNotFoundError(2, "No such file or directory")),
        ("_multiprocessing.SemLock", PermissionError(13, "Permission denied")),
        ("_multiprocessing.SemLock", OSError(28, "No space left on device")),
        ("_multiprocessing.SemLock", OSError(38, "Function not implemented")),
        ("concurrent.futures.process._check_system_limits", NotImplementedError("no semaphores")),
        ("concurrent.futures.ProcessPoolExecutor", ImportError("This platform lacks a functioning sem_open")),
        ("multiprocessing.get_context", ValueError("cannot find context for 'fork'")),
        ("os.fork", BlockingIOError(11, "Resource temporarily unavailable")),
        ("os.fork", OSError(12, "Cannot allocate memory")),
        ("os.pipe", OSError(24, "Too many open files")),
    ],
)
@pytest.mark.usefixtures("three")
def test_without_processes_the_work_is_done_here(
    what: str, error: BaseException, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(what, refusing(error))
    assert spread(lambda n: (n, os.getpid()), range(20), seconds=0.1) == [(n, os.getpid()) for n in range(20)]
    with pytest.raises(FileNotFoundError, match="of the work"):
        spread(refusing(FileNotFoundError("of the work")), range(20), seconds=0.1)


@pytest.mark.usefixtures("three")
def test_no_process_is_left_behind_where_some_could_be_forked(monkeypatch: pytest.MonkeyPatch) -> None:
    fork, forked, before = os.fork, [], set(multiprocessing.active_children())

    def once() -> int:
        if forked:
            raise BlockingIOError(11, "Resource temporarily unavailable")
        forked.append(True)
        return fork()

    monkeypatch.setattr(os, "fork", once)
    assert spread(lambda n: n * n, range(20), seconds=0.1) == [n * n for n in range(20)]
    for child in set(multiprocessing.active_children()) - before:
        child.join(5)
    assert forked
    assert set(multiprocessing.active_children()) <= before


@pytest.mark.usefixtures("three")
def test_where_a_process_is_killed_the_work_is_done_here() -> None:
    here = os.getpid()

    def work(piece: int) -> int:
        if os.getpid() != here:
            os.kill(os.getpid(), signal.SIGKILL)
        return piece

    assert spread(work, range(20), seconds=0.1) == list(range(20))


def test_a_second_run_only_checks_again(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first, _ = decide(section("3.3"), BOOK)
    (kept,) = folder.iterdir()
    before = kept.read_bytes()
    monkeypatch.setattr("chasles.decisions.session.decided", forbidden)
    second, _ = decide(section("3.3"), BOOK)
    assert [outcome(d) for _, d in second.decided] == [outcome(d) for _, d in first.decided]
    assert second.rechecked is not None
    assert second.rechecked.certificates == first.rechecked.certificates > 0  # type: ignore[union-attr]
    assert kept.read_bytes() == before


def test_what_was_tampered_with_is_decided_anew(folder: Path) -> None:
    first, _ = decide(section("3.3"), BOOK)
    (kept,) = folder.iterdir()
    answers = json.loads(kept.read_text())
    proofs = sorted(key for key, answer in answers.items() if answer[0] in ("Holds", "HoldsUnder"))
    answers[proofs[0]], answers[proofs[-1]] = answers[proofs[-1]], answers[proofs[0]]
    kept.write_text(json.dumps(answers))
    second, _ = decide(section("3.3"), BOOK)
    assert not list(second.failures)
    assert [outcome(d) for _, d in second.decided] == [outcome(d) for _, d in first.decided]
    assert json.loads(kept.read_text()) != answers


@pytest.mark.sampled(2)
@pytest.mark.parametrize("text", ["", "{", "[]", '{"a": 1}'])
def test_a_broken_cache_is_none(folder: Path, text: str) -> None:
    decide(section("3.3"), BOOK)
    (kept,) = folder.iterdir()
    good = kept.read_text()
    kept.write_text(text)
    found, _ = decide(section("3.3"), BOOK)
    assert not list(found.failures)
    assert set(json.loads(good)) <= set(json.loads(kept.read_text()))


def test_a_cache_that_cannot_be_written_is_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path / "file"))
    found, _ = decide(section("3.3"), BOOK)
    assert not list(found.failures)


def test_another_engine_has_another_cache(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    decide(section("3.3"), BOOK)
    (first,) = folder.iterdir()
    monkeypatch.setattr(recalled, "LIBRARIES", ())
    decide(section("3.3"), BOOK)
    (second,) = folder.iterdir()
    assert first != second


def test_a_verdict_that_is_rejected_without_a_cache_is_a_failure(monkeypatch: pytest.MonkeyPatch) -> None:
    from chasles.cli import rechecking

    monkeypatch.setattr(recalled, "shipped", lambda package: {})
    monkeypatch.setenv("CHASLES_CACHE", "")
    monkeypatch.setattr(rechecking, "spread", lambda work, pieces, seconds: ["not proved" for _ in pieces])
    found, _ = decide(section("3.3"), BOOK)
    assert any("is rejected: not proved" in line for line in found.failures)


def test_what_is_kept_is_of_all_the_code_that_decides() -> None:
    """Whatever is loaded to decide is part of the engine, but what only displays."""
    # `chasles.prove` and motions are loaded where functions of scalars occur only.
    without = ("chasles.decisions.session", "chasles.deriving", "chasles.points.search")
    loaded = closure(*without, "chasles.prove", "chasles.repairs.real_test")
    rooms = {name.split(".")[1] for name in loaded if "." in name}
    assert rooms - {"display", "several", "nearest"} == set(recalled.ENGINE)
