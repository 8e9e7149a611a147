"""The identities that are kept as a yardstick: read, true by numbers, and none decided wrongly."""

from __future__ import annotations

from pathlib import Path

import pytest
from sympy.core.function import AppliedUndef

from .sampling import WHOLE

ROOT = Path(__file__).resolve().parents[1]
if not (ROOT / "benchmarks").exists():
    pytest.skip("needs the checkout", allow_module_level=True)

from benchmarks.identities import measure  # noqa: E402
from benchmarks.identities.numbers import agreement  # noqa: E402
from benchmarks.identities.pairs import built, load  # noqa: E402
from benchmarks.identities.textbook import identities  # noqa: E402

PAIRS = load(ROOT / "benchmarks" / "identities" / "from_sympy.txt")


def test_what_is_kept_is_true_by_numbers_and_what_is_falsified_is_not() -> None:
    kept = [pair for pair in PAIRS if pair.kind == "real"][::40]
    assert len(kept) > 10
    for pair in kept:
        left = built(pair.left)
        assert agreement(left, built(pair.right)) == "equal", pair
        assert not pair.wrong or agreement(left, built(pair.wrong)) == "different", pair
    plain = [item for item in identities() if not item.given and not item.left.atoms(AppliedUndef)][::10]
    assert len(plain) > 10
    assert {agreement(item.left, item.right) for item in plain} <= {"equal", "complex"}


@pytest.mark.parametrize("name", ["textbook", "sympy"])
def test_nothing_is_decided_wrongly(name: str) -> None:
    questions = measure.textbook() if name == "textbook" else measure.of_sympy("real")
    every = {"textbook": 11, "sympy": 25} if WHOLE else {"textbook": 120, "sympy": 500}
    found = measure.measure(name, questions, every[name], verbose=True)
    assert found["WRONG"] == found["broken"] == 0
    assert found["right"] > found.total() * (0.9 if name == "textbook" else 0.5)
