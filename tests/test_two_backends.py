"""Verdicts, certificates and counterexamples are the same on either kind of polynomials, whatever the hash seed."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from fractions import Fraction
from importlib.util import find_spec
from pathlib import Path
from random import Random
from typing import Any

import pytest

from chasles.algebra.rings import _SympyRing

from .sampling import WHOLE

ROOT = Path(__file__).resolve().parents[1]
EVERY = 60 if WHOLE else 50
"""One mutant in so many is decided too: the book's own equations hardly ever fail."""
STEP = 1 if WHOLE else 13
"""One statement in so many is decided."""

DECIDE = """
import json, sys
sys.path.insert(0, {root!r})
if {hidden!r}:
    sys.modules["flint"] = None
from dataclasses import asdict
from chasles.prover.decide import decide_problem
from chasles.decisions.session import Session
from chasles.algebra.rings import backend
from chasles.statements import Claim, Theorem, load, problem_of
from chasles.vocabulary import Misfit
from tests.mutation import mutants_of

assert backend() == {backend!r}, backend()
judge, said, count = Session(book=load()), {{}}, 0


def plain(verdict):
    return json.loads(json.dumps(asdict(verdict), default=str)) | {{"verdict": verdict.name}}


for entry, decision in judge.decide_all(load().select(sections={sections!r})[::{step}]):
    forms = [decision.verdict] + ([decision.correction.verdict] if decision.correction else [])
    said[f"({{entry.number}}) part {{entry.statement.part}}"] = list(map(plain, forms))
    if isinstance(entry.statement, Claim | Theorem) and decision.verdict.true:
        for count, mutant in enumerate(mutants_of(entry.statement, "printed", []), count + 1):
            if count % {every} == 0:
                try:
                    problem = problem_of(mutant.statement, "printed", judge.accepted)
                except (Misfit, TypeError):
                    continue
                said[str(mutant)] = plain(decide_problem(problem))
print(json.dumps(said, indent=0))
"""


def decided(
    backend: str, seed: int, *, hidden: bool = False, ground: str = "", sections: tuple[str, ...] = ()
) -> tuple[dict[str, Any], float]:
    """All that is said of the chapter and of some mutants, and how long it took."""
    environment = {**os.environ, "CHASLES_POLYNOMIALS": backend, "PYTHONHASHSEED": str(seed)}
    environment |= {"SYMPY_GROUND_TYPES": ground} if ground else {}
    script = DECIDE.format(root=str(ROOT), hidden=hidden, backend=backend, every=EVERY, step=STEP, sections=sections)
    start = time.perf_counter()
    done = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout), time.perf_counter() - start


@pytest.mark.slow
def test_both_kinds_of_polynomials_say_the_same(record_property: Callable[[str, object], None]) -> None:
    if find_spec("flint") is None:
        pytest.skip("needs python-flint, to compare with")
    first, seconds = decided("flint", 0)
    texts = [json.dumps(verdict) for verdict in first.values()]
    assert sum('"at"' in text for text in texts) > (10 if WHOLE else 4), "hardly any counterexample is compared"
    assert sum('"certificate"' in text for text in texts) > 60 // STEP, "hardly any certificate is compared"
    runs = {"SymPy's rings on Python's numbers, another hash seed": decided("sympy", 1, hidden=True, ground="python")}
    if WHOLE:
        runs["python-flint, another hash seed"] = decided("flint", 1)
    lines = [f"{len(first)} verdicts are the same on", f"{seconds:.1f} s  python-flint"]
    for name, (found, seconds) in runs.items():
        assert {key: (said, found.get(key)) for key, said in first.items() if said != found.get(key)} == {}, name
        assert list(found) == list(first), name
        lines.append(f"{seconds:.1f} s  {name}")
    record_property("report", "\n".join(lines))


@pytest.mark.slow
def test_the_numbers_below_the_polynomials_do_not_matter() -> None:
    if find_spec("flint") is None:
        pytest.skip("needs python-flint, to compare with")
    sections = ("3.2", "3.3") if WHOLE else ("3.3",)
    assert decided("sympy", 0, ground="flint", sections=sections)[0] == decided("flint", 0, sections=sections)[0]


@pytest.mark.parametrize("order", ["lex", "grevlex"])
@pytest.mark.parametrize("seed", range(12))
def test_division_is_that_of_the_order(order: str, seed: int) -> None:
    """Quotient and remainder are unique: nothing that is left is divisible, and SymPy's own division finds the same."""
    draw, ring = Random(seed), _SympyRing("xyzw", order)

    def polynomial(terms: int, degree: int) -> Any:
        drawn = {
            tuple(draw.randint(0, degree) for _ in range(4)): Fraction(draw.randint(-5, 5) or 1, draw.randint(1, 4))
            for _ in range(terms)
        }
        return ring.from_terms(drawn)

    for _ in range(6):
        divisor = polynomial(draw.randint(1, 4), 2)
        dividend = polynomial(draw.randint(1, 6), 3) * divisor + polynomial(draw.randint(1, 6), 4)
        quotient, remainder = ring.divide(dividend, divisor)
        assert (quotient, remainder) == dividend.div(divisor)
        assert quotient * divisor + remainder == dividend
        assert dict(quotient) == dict(dividend.div(divisor)[0])
    assert ring.divide(divisor, divisor) == (ring.constant(Fraction(1)), ring.constant(Fraction(0)))
    assert ring.divide(ring.constant(Fraction(0)), divisor)[0] == 0
