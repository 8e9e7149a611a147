"""Verdicts, certificates and counterexamples are the same on either kind of polynomials, whatever the hash seed."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

import pytest

HERE = Path(__file__).parent
EVERY = 40
"""One mutant in so many is decided too: the book's own equations hardly ever fail."""

DECIDE = """
import json, sys
sys.path.insert(0, {here!r})
if {hidden!r}:
    sys.modules["flint"] = None
from dataclasses import asdict, is_dataclass
from chasles.proof.decide import decide_problem
from chasles.proof.judge import Judge
from chasles.proof.rings import backend
from chasles.statements import Claim, Theorem, load, problem_of
from chasles.vocabulary import Misfit
from tests.mutation import mutants_of

assert backend() == {backend!r}, backend()
judge, said, count = Judge(), [], 0


def plain(verdict):
    return json.loads(json.dumps(asdict(verdict), default=str)) | {{"verdict": verdict.name}}


for entry, decision in judge.decide_all(load()):
    forms = [decision.verdict] + ([decision.correction.verdict] if decision.correction else [])
    said.append([entry.number, entry.statement.part, *map(plain, forms)])
    if isinstance(entry.statement, Claim | Theorem) and decision.verdict.true:
        for mutant in mutants_of(entry.statement, "printed", []):
            count += 1
            if count % {every} == 0:
                try:
                    problem = problem_of(mutant.statement, "printed", judge.standing)
                except (Misfit, TypeError):
                    continue
                said.append([str(mutant), plain(decide_problem(problem))])
print(json.dumps(said, indent=0))
"""


def decided(backend: str, seed: int, *, hidden: bool = False, ground: str = "") -> tuple[str, float]:
    """All that is said of the chapter and of some mutants, and how long it took."""
    environment = {**os.environ, "CHASLES_POLYNOMIALS": backend, "PYTHONHASHSEED": str(seed)}
    environment |= {"SYMPY_GROUND_TYPES": ground} if ground else {}
    script = DECIDE.format(here=str(HERE.parent), hidden=hidden, backend=backend, every=EVERY)
    start = time.perf_counter()
    done = subprocess.run(
        [sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=False, timeout=300
    )
    assert done.returncode == 0, done.stderr
    return done.stdout, time.perf_counter() - start


@pytest.mark.slow
def test_both_kinds_of_polynomials_say_the_same(record_property: Callable[[str, object], None]) -> None:
    if find_spec("flint") is None:
        pytest.skip("needs python-flint, to compare with")
    runs = {
        "python-flint": decided("flint", 0),
        "python-flint, another hash seed": decided("flint", 1),
        "SymPy's rings on python-flint's numbers": decided("sympy", 0, ground="flint"),
        "SymPy's rings on Python's numbers": decided("sympy", 1, hidden=True, ground="python"),
    }
    first, _ = runs["python-flint"]
    verdicts = [json.dumps(statement) for statement in json.loads(first)]
    assert sum('"at"' in text for text in verdicts) > 10, "hardly any counterexample is compared"
    assert sum('"certificate"' in text for text in verdicts) > 80, "hardly any certificate is compared"
    for name, (text, _) in runs.items():
        different = [pair for pair in zip(json.loads(first), json.loads(text), strict=True) if pair[0] != pair[1]]
        assert different == [], name
        assert text == first, name
    lines = [f"{seconds:.1f} s  {name}" for name, (_, seconds) in runs.items()]
    record_property("report", "\n".join([f"{len(verdicts)} verdicts are the same on", *lines]))
