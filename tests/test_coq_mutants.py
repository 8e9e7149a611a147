"""Coq refuses what is not so: statements with something else claimed, other words, and other cofactors.

Each mutant keeps the proof of what it was made from. One Coq reads all of them, and goes on after what it refuses.
"""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import cache
from itertools import chain, islice
from pathlib import Path

import pytest

from chasles import vocabulary as w
from chasles.coq.checking import MISSING, compile_theories, coq_version
from chasles.coq.expressions import Unsaid
from chasles.coq.proof import proof_of
from chasles.coq.sentences import holding
from chasles.coq.statement import CoqStatement
from chasles.decisions.session import Session
from chasles.statements import Inverse, Problem, Theorem, load, problem_of
from chasles.statements.problem import Goal
from chasles.verdict import Fails
from chasles.vocabulary import Negative, paren

from .decided import chapter_session
from .sampling import WHOLE, sample

pytestmark = [pytest.mark.skipif(coq_version() is None, reason=MISSING), pytest.mark.slow]
MANY = 300 if WHOLE else 10
"""So many mutants of each kind, of what has the shortest proofs."""
COFACTOR = re.compile(r"(?<= _ _ \()(\([^;]*?\)) \* \(")


@cache
def proved() -> tuple[tuple[str, Problem, str, str], ...]:
    """What holds of a sample, with its statement and its proof in Coq, the shortest proofs first."""
    found = []
    for session in (chapter_session(), Session(book=load("chasles.rotations"))):
        for entry in sample(session._chapter, 6):  # type: ignore[arg-type]
            decision = session.decide(entry.statement)
            certificate = getattr(decision.verdict, "certificate", None)
            if certificate is None or isinstance(decision.statement, Theorem | Inverse):
                continue
            problem = problem_of(decision.statement, "printed", decision.accepted)
            try:
                said = CoqStatement(problem)
                name = f"m{len(found)}"
                found.append((name, problem, holding(name, said), proof_of(name, said, certificate)))
            except Unsaid:
                continue
    return tuple(sorted(found, key=lambda each: (len(each[3]), each[0])))


def changed_statements() -> Iterator[tuple[str, str, str]]:
    """The opposite of a side of the last equation, or twice a side, in place of the side."""
    yield from mutants("s", lambda left: (Negative(paren(left)), left + left))


def changed_words() -> Iterator[tuple[str, str, str]]:
    """One word in place of another, on a side of the last equation."""
    yield from mutants("w", lambda left: (w.replace(left, {node: other}) for node, other in other_words(left)))


def other_words(side: w.Node) -> Iterator[tuple[w.Node, w.Node]]:
    """Parts of an expression, and what stands in their place."""
    for node in dict.fromkeys(w.walk(side)):
        match node:
            case w.Call("cos" | "sin" as function, argument):
                yield node, w.Call("sin" if function == "cos" else "cos", argument)
            case w.Sum((first, w.Negative(second), *others)):
                yield node, w.Sum((first, second, *others))
            case w.Sum((first, second, *others)):
                yield node, w.Sum((first, w.Negative(second), *others))
            case w.Skew() | w.Determinant() | w.Trace() | w.Cross() | w.Vect() | w.Norm() | w.Dot():
                yield node, paren(w.Negative(node))
            case w.Transpose(of) if of.shape == node.shape:
                yield node, of


def mutants(kind: str, changed: Callable[[w.Node], Iterable[w.Node]]) -> Iterator[tuple[str, str, str]]:
    """Statements with another left side of the last equation that fail at a point, with the proofs of true ones."""
    session = chapter_session()
    for name, problem, _, proof in proved():
        *others, goal = problem.goals
        for count, left in enumerate(islice(changed(goal.left), 4)):
            mutant = replace(problem, goals=(*others, Goal(goal.label, left, goal.right)))
            if isinstance(session.verdict_on(mutant), Fails):
                yield renamed(name, f"{name}_{kind}{count}", holding(name, CoqStatement(mutant)), proof)


def changed_cofactors() -> Iterator[tuple[str, str, str]]:
    """Three times what something that vanishes is multiplied by."""
    for name, _, said, proof in proved():
        for count, found in enumerate(islice(COFACTOR.finditer(proof), 3)):
            text = f"{proof[: found.start(1)]}(3 * {found[1]}){proof[found.end(1) :]}"
            yield renamed(name, f"{name}_c{count}", said, text)


def renamed(name: str, mutant: str, said: str, proof: str) -> tuple[str, str, str]:
    """Statement and proof under another name."""
    return mutant, re.sub(rf"\b{name}\b", mutant, said), re.sub(rf"\b{name}(_holds)?\b", rf"{mutant}\1", proof)


@pytest.fixture
def theories(coq_cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("CHASLES_CACHE", str(coq_cache))
    compile_theories(tmp_path)
    return tmp_path


def accepted(theories: Path, mutants: Iterable[tuple[str, str, str]]) -> tuple[set[str], set[str]]:
    """The names of those that are statements, and of those that are proved."""
    parts = [f"{said}{proof}Abort All.\nCheck {name}. Check {name}_holds.\n" for name, said, proof in mutants]
    command = ["coqtop", "-q", "-R", ".", "Chasles"]
    text = "From Chasles Require Import Forms.\n" + "".join(parts)
    done = subprocess.run(command, cwd=theories, input=text, capture_output=True, text=True, check=True)
    answers = re.sub(r"^(\w+ < )+", "", done.stdout, flags=re.MULTILINE)
    told = re.findall(r"^(m\w+?)(_holds)?\s*\n?\s+: ", answers, re.MULTILINE)
    return {name for name, holds in told if not holds}, {name for name, holds in told if holds}


def test_what_is_so_is_accepted_and_what_is_not_so_is_refused(theories: Path) -> None:
    true = [(name, said, proof) for name, _, said, proof in proved()[:MANY]]
    kinds = [list(islice(kind(), MANY)) for kind in (changed_statements, changed_words, changed_cofactors)]
    assert [len(mutants) for mutants in kinds] == [MANY] * 3
    names = {name for name, *_ in true}
    statements, proved_ones = accepted(theories, [*true, *chain(*kinds)])
    assert proved_ones == names
    assert names <= statements
    for mutants in kinds:  # some are not even statements
        assert sum(name in statements for name, *_ in mutants) >= 0.9 * MANY
