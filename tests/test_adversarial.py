"""No kernel gives a wrong number, whatever goes in: a sample of what `python -m benchmarks.adversarial` throws.

CHASLES_ADVERSARIAL is how many inputs each kernel gets in each precision; without it a few kernels get a few.
"""

from __future__ import annotations

import json
import math
import os
import sys
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from chasles import kernels

pytest.importorskip("flint")
ROOT = Path(__file__).resolve().parents[1]
if not (ROOT / "benchmarks").exists() or kernels.backend != "c":
    pytest.skip("needs the checkout and compiled kernels", allow_module_level=True)
sys.path.insert(0, str(ROOT))

from benchmarks.adversarial.builds import builds  # noqa: E402
from benchmarks.adversarial.exact import Exact  # noqa: E402
from benchmarks.adversarial.inputs import KINDS, drawn  # noqa: E402
from benchmarks.adversarial.throwing import kernels_of, thrown  # noqa: E402
from benchmarks.adversarial.verdicts import Judge  # noqa: E402
from benchmarks.error_table import page  # noqa: E402
from benchmarks.errors import measured  # noqa: E402

from .sampling import WHOLE  # noqa: E402

ASKED = int(os.environ.get("CHASLES_ADVERSARIAL", "0"))
FEW = ("plucker_line", "natural_rate_matrix", "instant_screw", "newton_euler_twist_rate")
PRECISIONS = [np.float64, np.float32]
EVIDENCE = ROOT / "benchmarks" / "evidence"


@pytest.fixture(scope="module")
def tried() -> dict[str, Any]:
    return {one.kernel.name: one for one in kernels_of(() if ASKED else FEW)}


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory, hasty_compiler: str) -> Any:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CC", hasty_compiler)
        return builds(tmp_path_factory.mktemp("builds"))


@pytest.mark.slow
def test_no_number_is_wrong(tried: dict[str, Any], made: Any) -> None:
    for one in tried.values():
        for dtype in PRECISIONS:
            outcome = thrown(one, made, dtype, ASKED or 9 * (20 if WHOLE else 10))
            assert not outcome.storage
            assert not outcome.undecided
            assert not {what: n for what, n in outcome.faults.items() if what != "nothing"}, outcome.shown
            assert outcome.results > 5 * 10


@pytest.mark.slow
@pytest.mark.parametrize("dtype", PRECISIONS)
def test_a_wrong_number_is_found(tried: dict[str, Any], dtype: type[np.floating[Any]]) -> None:
    """A result off by a hundred roundoffs, a zero in the place of NaN, and NaN in that of a number."""
    one = tried["plucker_line"]
    judge = Judge(one.kernel, one.groups, dtype)
    judged = judge.judged([[1.0, 0.0, 0.0], [1.0, 3.0, 4.0]])
    assert judged is not None
    right = [0.0, 0.6, 0.8, 0.0, -0.8, 0.6]
    assert not list(judge.faults(judged, [right]))
    wrong = [0.0, 0.6 * (1 + 100 * float(np.finfo(dtype).eps)), *right[2:]]
    assert [(f.what, f.entry) for f in judge.faults(judged, [wrong])] == [("number", 1)]
    assert {f.what for f in judge.faults(judged, [[math.nan] * 6])} == {"nothing"}
    singular = judge.judged([[1.0, 2.0, 3.0], [1.0, 2.0, 3.0]])
    assert singular is not None
    assert len(list(judge.faults(singular, [[0.0] * 6]))) == 6
    assert not list(judge.faults(singular, [[math.nan] * 6]))


@pytest.mark.slow
def test_a_result_below_the_normal_numbers_is_not_any_number(tried: dict[str, Any]) -> None:
    """What steps without digits explain is right; ten times as much is wrong, and so is the same above them."""
    one = tried["newton_euler_twist_rate"]
    judge = Judge(one.kernel, one.groups, np.float64)
    least, inertia = 5e-324, [0.34, -0.51, -0.1, -0.51, 7.7, -0.13, -0.1, -0.13, 0.2]
    judged = judge.judged([inertia, [1.0], [0.0] * 6, [1e-318, -4e-318, -4e-318, 0.0, 0.0, 0.0]])
    assert judged is not None
    exact = [float(value[0]) for value in judged.values[0][0] if value is not None]
    assert 0 < abs(exact[0]) < np.finfo(np.float64).tiny
    explained = judge._vanishing(judged, 0, 0)
    assert 10 * least < explained < 1e-3 * abs(exact[0])
    assert not list(judge.faults(judged, [[exact[0] + explained / 2, *exact[1:]]]))
    assert [f.entry for f in judge.faults(judged, [[exact[0] + 10 * explained, *exact[1:]]])] == [0]
    above = judge.judged([inertia, [1.0], [0.0] * 6, [1e-300, -4e-300, -4e-300, 0.0, 0.0, 0.0]])
    assert above is not None
    exact = [float(value[0]) for value in above.values[0][0] if value is not None]
    assert [f.entry for f in judge.faults(above, [[exact[0] * (1 + 1e-9), *exact[1:]]])] == [0]


@pytest.mark.slow
def test_exact_values_are_those_of_the_formula(tried: dict[str, Any]) -> None:
    exact = Exact(tried["plucker_line"].kernel.program)
    (values,) = exact([[1e-300, 0.0, 0.0], [1e-300, 3e-320, 4e-320]])
    assert [float(value[0]) for value in values if value is not None][:3] == pytest.approx([0, 0.6, 0.8], rel=1e-3)
    assert exact([[1.0, 2.0, 3.0], [1.0, 2.0, 3.0]]) == [[None] * 6]
    assert exact([[None, 2.0, 3.0], [1.0, 2.0, 5.0]]) == [[None] * 6]


@pytest.mark.slow
@pytest.mark.parametrize("dtype", PRECISIONS)
def test_inputs_are_of_every_kind(tried: dict[str, Any], dtype: type[np.floating[Any]]) -> None:
    program = tried["natural_rate_matrix"].kernel.program
    e, phi = drawn(program.name, program.arguments, dtype, 100 * len(KINDS))
    assert e.dtype == phi.dtype == dtype
    assert np.isnan(e).any()
    assert np.isinf(phi).any()
    assert (abs(phi[np.isfinite(phi)]) > 1e15).any()
    assert ((phi != 0) & (abs(phi) < np.finfo(dtype).tiny)).any()
    assert (phi == 0).any()


@pytest.mark.slow
def test_no_measured_error_is_larger_than_proved(tried: dict[str, Any]) -> None:
    compared = 0
    for name in FEW:
        found = measured(tried[name], 60)
        compared += within_bounds(found, found["proved"])
    assert compared >= 8


def test_no_error_of_the_evidence_is_larger_than_proved() -> None:
    """Against what is proved of the kernels now, not of those that were measured."""
    evidence = json.loads((EVIDENCE / "errors.json").read_text("utf-8"))
    listed = tomllib.loads((ROOT / "generated" / "MANIFEST.toml").read_text("utf-8"))["kernels"]
    assert set(evidence["kernels"]) == set(listed)
    compared = 0
    for name, kernel in listed.items():
        proved = {g["result"]: g for g in kernel["bound"]["guarantees"]}
        compared += within_bounds(evidence["kernels"][name], proved)
    assert compared > 200
    assert (ROOT / "benchmarks" / "ERRORS.md").read_text("utf-8") == page(evidence)


def within_bounds(found: dict[str, Any], proved: dict[str, Any]) -> int:
    compared = 0
    for dtype in ("float64", "float32"):
        for result, worst in found[dtype].items():
            if proved.get(result):
                assert worst["proved"]["units"] <= float(proved[result]["units"]), (result, worst)
                compared += 1
    return compared


def test_curves_show_what_the_printed_formulas_lose() -> None:
    curves = json.loads((EVIDENCE / "errors.json").read_text("utf-8"))["curves"]
    for name in ("natural_rate_matrix", "natural_rate_matrix_dot", "screw_axis_point"):
        (point,) = (p for p in curves[name]["points"] if p.get("phi") == 1e-7)
        assert point["ours"] < 10
        assert point["as_typed"] is None or point["as_typed"] > 1e6
    assert all(p["ours"] is not None and p["ours"] < 10 for p in curves["natural_invariants"]["points"])
