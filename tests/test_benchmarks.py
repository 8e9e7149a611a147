"""The peers of the benchmarks compute what chasles computes: like is compared with like."""

from __future__ import annotations

import json
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[1]
if not (ROOT / "benchmarks").exists():
    pytest.skip("needs the checkout", allow_module_level=True)
sys.path.insert(0, str(ROOT))

from benchmarks import cost, threads  # noqa: E402
from benchmarks.formulas import KERNELS  # noqa: E402
from benchmarks.peers import OURS, PEERS  # noqa: E402
from benchmarks.points import batch, references  # noqa: E402
from benchmarks.tables import details, summary  # noqa: E402

WRAPPERS = {"sympy_ufuncify", "sympy_autowrap"}
SLOW = WRAPPERS | {"numba_jit", "casadi_c", "symforce_cpp", "sympy_codegen_c", "sympy_cse_c"}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", [pytest.param(n, marks=pytest.mark.slow) if n in SLOW else n for n in (OURS, *PEERS)])
def test_a_peer_gives_the_right_values(name: str) -> None:
    peer = pytest.importorskip(f"benchmarks.peers.{name}", exc_type=ImportError)
    # SymPy's wrappers run a build of seconds for each kernel.
    made = peer.make(KERNELS if name not in WRAPPERS else KERNELS[3:5])
    assert made
    for kernel in KERNELS:
        if kernel.name not in made:
            continue
        inputs = batch(kernel, 5)
        right = np.array(references(kernel, inputs), dtype=float)
        call = made[kernel.name].call
        if made[kernel.name].batched:
            np.testing.assert_allclose(call(*inputs), right, rtol=1e-12, atol=1e-13)
            out = np.full_like(right, np.nan)
            call(*inputs, out=out)
            np.testing.assert_allclose(out, right, rtol=1e-12, atol=1e-13)
        np.testing.assert_allclose(call(*(x[2] for x in inputs)), right[2], rtol=1e-12, atol=1e-13)


def test_threads_do_the_whole_batch() -> None:
    done: list[slice] = []
    with ThreadPoolExecutor(2) as pool:
        times = list(threads.rounds(done.append, 11, 2, pool))
    assert len(times) == threads.ROUNDS
    assert {(piece.start, piece.stop) for piece in done} == {(0, 5), (5, 11)}
    for call in threads.calls(4).values():
        call(slice(0, 4))
    assert "2: 2.00 x by the clock, 1.00 x" in next(threads.lines({"name": {"10": {"1": [4, 4], "2": [2, 8]}}}))


def test_the_page_is_that_of_the_evidence() -> None:
    evidence = json.loads((ROOT / "benchmarks" / "evidence" / "kernels.json").read_text("utf-8"))
    assert (ROOT / "benchmarks" / "README.md").read_text("utf-8") == summary(evidence)
    assert all(title in details(evidence) for title in evidence["peers"].values())
    missed = json.loads(json.dumps(evidence))
    missed["kernels"]["natural_rate_matrix"]["times_faster"]["10000"]["ratio"] = 0.5
    assert "0.5 (>= 5: **miss**)" in summary(missed)


def test_the_cost_model_is_the_one_that_was_measured() -> None:
    evidence = json.loads((ROOT / "benchmarks" / "evidence" / "cost.json").read_text("utf-8"))
    assert evidence["model"] == cost.model()
    assert evidence["rank correlation"]["cost and entries"] > 0.7
    weights, measured = evidence["model"]["weights"], evidence["in additions"]
    assert all(1 / 2 < measured[name] / weights[name] < 2 for name in measured)


def test_ranks_are_correlated() -> None:
    assert cost.rank_correlation([1, 2, 2, 9], [1, 4, 4, 5]) == pytest.approx(1)
    assert cost.rank_correlation([1, 2, 3], [3, 2, 1]) == pytest.approx(-1)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("op", ["add", "divide", "sine and cosine"])
def test_what_is_timed_are_so_many_operations(op: str) -> None:
    words = {"sine and cosine": ("sine", "cosine")}.get(op, (op,))
    counts = [cost.chained(op, length).operations for length in (8, 24)]
    assert [[found[word] for word in words] for found in counts] == [[8] * len(words), [24] * len(words)]
