"""Verdicts as theorems: what the statements say, that Coq accepts them, and that it accepts nothing else."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from chasles.coq.checking import FORBIDDEN, MISSING, CoqVerdict, coq_version, verdicts_of_coq
from chasles.coq.expressions import Unsaid
from chasles.coq.folder import chunks, files_of
from chasles.coq.names import THEORIES, identifier, theory
from chasles.coq.points import refutation
from chasles.coq.proof import proof_of
from chasles.coq.sentences import Claimed, failing
from chasles.coq.statement import CoqStatement
from chasles.coq.theorems import claims_of
from chasles.decisions.session import Session
from chasles.statements import Inverse, Problem, Theorem, load, problem_of
from chasles.statements.problem import Goal
from chasles.verdict import Fails
from chasles.vocabulary import Negative, paren

from ..decided import chapter_session
from ..sampling import WHOLE, sample

needs_coq = pytest.mark.skipif(coq_version() is None, reason=MISSING)
QUICK = ["3.13", "3.46", "3.109", "text 3.8 f", "Thm 3.7.2", "text 3.8 k"]
"""A definition put in, a moving rotation, norms and quotients, integrals; an equation as a theorem, an equivalence."""


@cache
def claims(*numbers: str) -> tuple[Claimed, ...]:
    session = chapter_session()
    entries = session._chapter.select(numbers) if numbers else tuple(session._chapter)  # type: ignore[union-attr]
    return tuple(claims_of([session.decide(entry.statement) for entry in entries]))


def problems(*numbers: str) -> list[tuple[Problem, dict[str, object]]]:
    session = chapter_session()
    decided = [session.decide(entry.statement) for entry in session._chapter.select(numbers)]  # type: ignore[union-attr]
    return [
        (problem_of(each.statement, "printed", each.accepted), dict(each.verdict.certificate))  # type: ignore[arg-type, attr-defined]
        for each in decided
        if hasattr(each.verdict, "certificate") and not isinstance(each.statement, Theorem | Inverse)
    ]


def test_a_statement_reads_like_the_page() -> None:
    claim, witness = claims("3.13")
    assert witness.said.startswith("Definition eq_3_13_1_assumes : Prop :=\n  exists (A : M 4 3) (phi : R)")
    assert claim.said == (
        "Definition eq_3_13_1 : Prop :=\n"
        "  forall (A : M 4 3) (phi : R) (e : M 3 1) (Q E : M 3 3),\n"
        "  (A = below (Q - one 3) (e^T))%M ->\n"
        "  (Q = e * e^T + cos phi *: (one 3 - e * e^T) + sin phi *: E)%M ->\n"
        "  (E = CPM e)%M ->\n"
        "  unit_vector e ->\n"
        "  (A^T * A = (2 * (1 - cos phi)) *: one 3 - (1 - 2 * cos phi) *: e * e^T)%M.\n"
    )


def test_what_moves_is_a_function_of_time() -> None:
    said = claims("3.46")[0].said
    assert "(T : R -> Prop)" in said
    assert "open_set T ->" in said
    assert "rate T Q Q_dot ->" in said
    assert "during T (fun t => rotation (Q t)) ->" in said


@pytest.mark.parametrize(
    ("name", "told"), [("t", "t_"), ("B", "B_"), ("one", "one_"), ("I_C", "I_C"), ("e~", "e_tilde"), ("fun", "fun_")]
)
def test_names_that_mean_something_else_are_changed(name: str, told: str) -> None:
    assert identifier(name) == told


def test_every_true_statement_of_the_chapter_is_said() -> None:
    numbers = [] if WHOLE else sample(dict.fromkeys(entry.number for entry in load()), 4)
    found = claims(*numbers)
    assert [claim.number for claim in found if not claim.said and "no theorem says" not in claim.why_not] == []
    assert len({claim.name for claim in found}) == len(found)
    assert sum(bool(claim.proof) for claim in found) >= (300 if WHOLE else 80)


def test_nothing_is_left_to_belief() -> None:
    assert not [name for name in THEORIES if FORBIDDEN.search(theory(name))]
    assert not [claim.name for claim in claims(*QUICK) if FORBIDDEN.search(claim.proof)]


def mutants(problem: Problem) -> list[Problem]:
    """The same problem, with something else claimed of one side of its last equation."""
    *others, goal = problem.goals
    changed = [Negative(paren(goal.left)), goal.left + goal.left]
    return [replace(problem, goals=(*others, Goal(goal.label, left, goal.right))) for left in changed]


FAILING = ["3.97a", "3.148"] if WHOLE else ["3.97a"]
"""What fails where a unit vector moves, and where nothing does, as also in a slip below."""


def proved() -> list[Claimed]:
    """What is true of these."""
    return [claim for claim in claims(*QUICK) if claim.proof] + [
        claim for claim in claims(*FAILING) if claim.name.endswith("_fails")
    ]


SLIPS = ("3.91", "3.13") if WHOLE else ("3.91",)


def refuted() -> Iterator[Claimed]:
    """What holds, with a point at which something else fails, and that with another point; slips with their points.

    What Coq refuses comes first: it begins anew after each of these.
    """
    session = chapter_session()
    slips = []
    for which, (problem, _) in enumerate(problems(*SLIPS)):
        mutant = mutants(problem)[which - 1]
        verdict = session.verdict_on(mutant)
        assert isinstance(verdict, Fails)
        said = CoqStatement(mutant)
        proof = refutation(f"slip_{which}", said, verdict.counterexample)
        slips.append(Claimed("", "", f"slip_{which}", "", failing(f"slip_{which}", said), proof))
        if which == 0:
            true, elsewhere = proof.replace("slip_0", "true"), proof.replace("slip_0", "elsewhere")
            yield Claimed("", "", "true", "", failing("true", CoqStatement(problem)), true)
            yield Claimed("", "", "elsewhere", "", failing("elsewhere", said), re.sub(r"\(1\)", "(0)", elsewhere))
    yield from slips


def believed() -> Iterator[Claimed]:
    """Something false, admitted and assumed."""
    for name, proof in (
        ("admitted", "Theorem admitted_holds : admitted.\nProof.\nAdmitted.\n"),
        ("assumed", "Axiom no_proof : assumed. Theorem assumed_holds : assumed.\nProof. exact no_proof. Qed.\n"),
        ("sly", "Theorem a : True. Proof. exact Logic.I. Qed. Axiom no : sly. Definition sly_holds : sly := no.\n"),
    ):
        yield Claimed("", "", name, "", f"Definition {name} : Prop := 1 = 2.\n", proof)


def misfits() -> Iterator[Claimed]:
    """What is said not to fit together, and does, or is refused for another reason."""
    for name, equation in (("fits", "e = e"), ("unknown", "e = no_such_name")):
        proof = f"Fail Definition {name} : Prop :=\n  forall (e : M 3 1), {equation}.\n"
        yield Claimed("", "", name, "", "(* *)", proof, is_misfit=True)


@pytest.fixture(scope="module")
def verdicts(coq_cache: Path) -> dict[str, CoqVerdict]:
    """What Coq says of true statements, slips and axioms."""
    true, others = chunks([*proved(), *claims("3.94")]), chunks([*refuted(), *believed(), *misfits()])
    # Coq begins a file anew at each theorem that it refuses: so these are in one of their own.
    parts = [*true, *(replace(part, number=f"{part.number}_others") for part in others)]
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CHASLES_CACHE", str(coq_cache))
        return {each.claim.name: each for each in verdicts_of_coq(parts)}


@needs_coq
def test_coq_accepts(verdicts: dict[str, CoqVerdict]) -> None:
    names = {claim.name for claim in proved()}
    assert {"Thm_3_7_2_1", "text_3_8_k_1"} <= names
    assert {"eq_3_13_1", "eq_3_13_1_assumes", "eq_3_97a_1_as_read_fails"} <= names
    assert [name for name in names if not verdicts[name].accepted] == []


@needs_coq
@pytest.mark.parametrize(("name", "accepted"), [("eq_3_94_1", True), ("fits", False), ("unknown", False)])
def test_a_misfit_is_refused_for_its_sizes(verdicts: dict[str, CoqVerdict], name: str, accepted: bool) -> None:
    assert verdicts[name].accepted == accepted


@needs_coq
def test_coq_accepts_that_slips_fail_and_not_that_what_holds_does(verdicts: dict[str, CoqVerdict]) -> None:
    accepted = {name for name in verdicts if verdicts[name].accepted}
    assert {name for name in verdicts if name.startswith("slip")} <= accepted
    assert not [name for name in accepted if name.startswith(("true", "elsewhere"))]
    assert sum(name.startswith("slip") for name in accepted) == len(SLIPS)


@needs_coq
@pytest.mark.parametrize("name", ["admitted", "assumed", "sly"])
def test_what_is_only_believed_is_not_accepted(verdicts: dict[str, CoqVerdict], name: str) -> None:
    assert not verdicts[name].accepted
    assert verdicts[name].why_not


def test_a_certificate_of_another_statement_makes_no_proof() -> None:
    for problem, certificate in problems("3.13", "3.46"):
        for mutant in mutants(problem):
            with pytest.raises(Unsaid):
                proof_of("mutant", CoqStatement(mutant), certificate)


def test_functions_are_said_entry_by_entry_and_no_point_with_them_yet() -> None:
    session = Session(book=load("chasles.rotations"))
    for entry in session._chapter.select(("1.42", "10.40")):  # type: ignore[union-attr]
        decision = session.decide(entry.statement)
        assert decision.verdict.true
        assert [(bool(claim.proof), bool(claim.why_not)) for claim in claims_of([decision])] == [(True, False)]
        problem = problem_of(decision.statement, "printed", decision.accepted)  # type: ignore[arg-type]
        for mutant in mutants(problem):
            verdict = session.verdict_on(mutant)
            if isinstance(verdict, Fails):
                with pytest.raises(Unsaid):
                    refutation("mutant", CoqStatement(mutant), verdict.counterexample)


def test_files_name_each_other() -> None:
    parts = chunks(claims(*QUICK))
    texts = files_of(parts, {"eq_3_13_1"})
    assert texts["_CoqProject"].splitlines() == ["-R . Chasles", *(name for name in texts if name.endswith(".v"))]
    assert re.findall(r"^Theorem (\w+)", texts[f"{parts[0].proofs}.v"], re.MULTILINE) == ["eq_3_13_1_holds"]


@pytest.fixture
def cache_of_ones_own(coq_cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CHASLES_CACHE", str(shutil.copytree(coq_cache, tmp_path / "cache")))


@needs_coq
@pytest.mark.usefixtures("cache_of_ones_own")
def test_the_command_says_what_coq_accepts_and_does_not_ask_again(
    run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:  # type: ignore[no-untyped-def]
    first = run("decide", "3.13", "--json", "--coq", str(tmp_path / "out"))
    assert first.exit_code == 0
    record = json.loads(first.stdout)["coq"]
    assert record["version"] == coq_version()
    assert [(each["name"], each["accepted"], each["witness"]) for each in record["theorems"]] == [
        ("eq_3_13_1", True, False),
        ("eq_3_13_1_assumes", True, True),
    ]
    assert (tmp_path / "out" / "Statements_1.v").is_file()
    compiled: list[str] = []
    monkeypatch.setattr("chasles.coq.checking._compiled", lambda folder, name, text: compiled.append(name))
    again = run("decide", "3.13", "--json", "--coq", str(tmp_path / "out"))
    assert json.loads(again.stdout)["coq"] == record
    assert compiled == []
    run("decide", "3.13", "--anew", "--coq", str(tmp_path / "out"))
    assert compiled == ["Words"]


def test_without_coq_the_command_writes_and_says_what_is_missing(
    run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:  # type: ignore[no-untyped-def]
    monkeypatch.setattr("chasles.cli.theorems.coq_version", lambda: None)
    done = run("decide", "3.13", "--brief", "--coq", str(tmp_path / "out"))
    assert done.exit_code == 0
    assert MISSING in done.stdout
    assert "Theorem eq_3_13_1_holds" in (tmp_path / "out" / "Proofs_1.v").read_text("utf-8")


def test_a_folder_that_cannot_be_written_is_one_line(run, tmp_path: Path) -> None:  # type: ignore[no-untyped-def]
    (tmp_path / "file").write_text("", "utf-8")
    done = run("decide", "3.13", "--coq", str(tmp_path / "file"))
    assert done.exit_code == 2
    assert "is a file" in done.stderr
