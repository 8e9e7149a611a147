"""The kernels and decisions among the tools that people have: Dask, xarray, pandas, SciPy, threads, joblib.

No code of ours stands between: each test is what a user would write. `docs/interoperation.md` has a row for each.
"""

from __future__ import annotations

import json
import pickle
import re
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import RigidTransform, Rotation

from chasles import checked, kernels, load
from chasles.decisions.session import Session
from chasles.report.records import record

PAGE = Path(__file__).resolve().parents[1] / "docs" / "interoperation.md"
SEQUENCES = ["".join(letters) for letters in product("xyz", repeat=3) if letters[0] != letters[1] != letters[2]]
AXIS = np.array([0.6, 0.0, 0.8])
needs_ufuncs = pytest.mark.skipif(kernels.backend != "c", reason="needs compiled kernels: a function has no signature")
NUMBERS = ("3.16", "3.18", "3.57")
"""One that holds under a hypothesis, one made of another, one that is printed wrong and repaired."""


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    """Two processes of one machine, as one would use many of several."""
    distributed = pytest.importorskip("distributed", reason="needs the extra `dist`")
    options = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    with distributed.LocalCluster(**options) as cluster, distributed.Client(cluster) as client:
        yield client


def core_sizes(kernel: Any) -> dict[str, int]:
    """What Dask has to be told: it takes a frozen dimension for a name."""
    return {size: int(size) for size in re.findall(r"\d+", kernel.signature)}


def screws(da: Any) -> tuple[Any, Any, Any, Any]:
    """Motions of which each process holds one chunk of twenty at a time."""
    phi = da.linspace(0.1, 3.0, 200_000, chunks=10_000)
    a = da.random.default_rng(1).standard_normal((200_000, 3), chunks=(10_000, 3))
    return AXIS, phi, a, 2.0 * a


@needs_ufuncs
def test_dask_arrays(client: Any) -> None:
    da = pytest.importorskip("dask.array")
    kernel, inputs = kernels.screw_axis_point, screws(da)
    found = da.apply_gufunc(kernel, kernel.signature, *inputs, output_dtypes=float, output_sizes=core_sizes(kernel))
    assert (found.shape, found.dtype, found.numblocks) == ((200_000, 3), float, (20, 1))
    assert found.nbytes == 20 * found.blocks[0].nbytes
    sums = client.compute(found.sum(axis=0)).result()
    pieces = [kernel(AXIS, *(array.blocks[k].compute() for array in inputs[1:])) for k in (0, 19)]
    np.testing.assert_array_equal(client.compute(found.blocks[0]).result(), pieces[0])
    np.testing.assert_array_equal(client.compute(found.blocks[19]).result(), pieces[1])
    whole = kernel(AXIS, *(array.compute() for array in inputs[1:]))
    np.testing.assert_allclose(sums, whole.sum(axis=0), rtol=1e-9)


@needs_ufuncs
def test_dask_asks_a_gufunc_with_sizes_of_its_own() -> None:
    """Why the recipe is needed: a direct call probes with cores of size 1 (dask/dask#5097)."""
    da = pytest.importorskip("dask.array")
    with pytest.raises(ValueError, match="output_dtypes"):
        kernels.cross_product_matrix(da.ones((4, 3), chunks=(2, 3)))


def test_xarray_objects() -> None:
    xr = pytest.importorskip("xarray")
    kernel = kernels.point_after_displacement
    time = np.linspace(0.0, 1.0, 8)
    Q = xr.DataArray(
        kernels.rotation_from_axis_angle(AXIS, time), dims=("time", "row", "column"), coords={"time": time}
    )
    p = xr.DataArray(np.arange(6.0).reshape(2, 3), dims=("point", "column"), coords={"point": ["tip", "heel"]})
    a = xr.DataArray(np.ones((8, 3)), dims=("time", "column"))
    options = {
        "input_core_dims": [["row", "column"], ["column"], ["column"], ["column"]],
        "output_core_dims": [["xyz"]],
    }
    found = xr.apply_ufunc(kernel, Q, a, 2 * a, p, **options)
    assert found.dims == ("time", "point", "xyz")
    assert list(found.point.values) == ["tip", "heel"]
    np.testing.assert_array_equal(found.time.values, time)
    expected = kernel(Q.values[:, None], np.ones(3), 2 * np.ones(3), p.values)
    np.testing.assert_array_equal(found.values, expected)
    chunked = xr.apply_ufunc(
        kernel,
        Q.chunk(time=2),
        a,
        2 * a,
        p,
        **options,
        dask="parallelized",
        output_dtypes=[float],
        dask_gufunc_kwargs={"output_sizes": {"xyz": 3}},
    )
    assert chunked.chunks is not None
    np.testing.assert_array_equal(chunked.compute().values, expected)


def test_pandas_columns() -> None:
    pd = pytest.importorskip("pandas")
    index = pd.Index(["wrist", "elbow"], name="joint")
    frame = pd.DataFrame(
        {"e_x": [0.0, 0.6], "e_y": [0.0, 0.0], "e_z": [1.0, 0.8], "phi": [0.5, 1.5]}, index=index, dtype="float64"
    )
    Q = kernels.rotation_from_axis_angle(frame[["e_x", "e_y", "e_z"]].to_numpy(), frame["phi"].to_numpy())
    r, r_0 = kernels.euler_rodrigues_parameters(Q)
    frame[["r_x", "r_y", "r_z"]], frame["r_0"] = r, r_0
    assert frame.index is index
    np.testing.assert_allclose(frame["r_0"], np.cos(frame["phi"] / 2))
    np.testing.assert_allclose(frame["r_z"], frame["e_z"] * np.sin(frame["phi"] / 2))


def test_a_pandas_frame_is_no_array() -> None:
    """Why `.to_numpy()` is needed: pandas takes a call of a gufunc over, and applies it to columns."""
    pd = pytest.importorskip("pandas")
    frame = pd.DataFrame(np.arange(9.0).reshape(3, 3), columns=list("xyz"))
    with pytest.raises(TypeError, match=r"plucker_line: p_2 is a DataFrame, no array: .*\.to_numpy\(\)"):
        checked.plucker_line(frame.to_numpy(), frame + 1)
    if kernels.backend == "c":
        with pytest.raises(ValueError, match="Shape of passed values"):
            kernels.plucker_line(frame, frame + 1)


ROTATIONS = Rotation.from_rotvec(np.random.default_rng(5).uniform(-1.7, 1.7, (100, 3)))


def test_scipy_rotations_out() -> None:
    """A matrix of ours is SciPy's: active, columns from the right. e phi is its rotation vector, [r; r0] its quat."""
    e, phi = ROTATIONS.as_rotvec() / ROTATIONS.magnitude()[:, None], ROTATIONS.magnitude()
    Q = kernels.rotation_from_axis_angle(e, phi)
    point = np.array([1.0, 2.0, 3.0])
    np.testing.assert_allclose(Q, ROTATIONS.as_matrix(), atol=1e-15)
    np.testing.assert_allclose(Q @ point, ROTATIONS.apply(point), atol=1e-14)
    r, r_0 = kernels.euler_rodrigues_parameters(Q)
    theirs = ROTATIONS.as_quat(canonical=True, scalar_first=False)
    np.testing.assert_allclose(np.concatenate([r, r_0[:, None]], axis=-1), theirs, atol=1e-15)
    assert Rotation.from_matrix(Q).approx_equal(ROTATIONS, atol=1e-14).all()


def test_scipy_rotations_in() -> None:
    Q = ROTATIONS.as_matrix()
    e, phi = kernels.natural_invariants(Q)
    np.testing.assert_allclose(e * phi[:, None], ROTATIONS.as_rotvec(), atol=1e-14)
    quaternion = ROTATIONS.as_quat()
    np.testing.assert_allclose(
        kernels.rotation_from_euler_rodrigues(quaternion[:, :3], quaternion[:, 3]), Q, atol=1e-15
    )
    u, u_0 = kernels.linear_invariants(Q)
    np.testing.assert_allclose(u, e * np.sin(phi)[:, None], atol=1e-14)
    np.testing.assert_allclose(u_0, np.cos(phi), atol=1e-14)
    first, second = ROTATIONS[0], ROTATIONS[1]
    np.testing.assert_allclose((second * first).as_matrix(), Q[1] @ Q[0], atol=1e-15)


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_scipy_euler_angles(sequence: str) -> None:
    """Capitals turn about the body's axes, as we do; small letters about fixed ones, in the opposite order."""
    angles = np.random.default_rng(6).uniform(-3.1, 3.1, (50, 3))
    Q = getattr(kernels, f"rotation_from_euler_{sequence}")(angles)
    np.testing.assert_allclose(Q, Rotation.from_euler(sequence.upper(), angles).as_matrix(), atol=2e-15)
    fixed = Rotation.from_euler(sequence[::-1], angles[:, ::-1])
    np.testing.assert_allclose(Q, fixed.as_matrix(), atol=2e-15)
    back = Rotation.from_matrix(Q).as_euler(sequence.upper())
    again = getattr(kernels, f"rotation_from_euler_{sequence}")(back)
    np.testing.assert_allclose(again, Q, atol=1e-12)


def test_scipy_rigid_transforms() -> None:
    """The displacement of a body: Q and where its landmark goes; SciPy's translation is where the origin goes."""
    a, a_prime = np.array([1.0, 2.0, 3.0]), np.array([0.5, -1.0, 4.0])
    points = np.random.default_rng(7).standard_normal((10, 3))
    for turn in ROTATIONS[:5]:
        Q = turn.as_matrix()
        motion = RigidTransform.from_components(a_prime - Q @ a, turn)
        np.testing.assert_allclose(
            kernels.point_after_displacement(Q, a, a_prime, points), motion.apply(points), atol=1e-14
        )
        line, d_0, phi = kernels.screw_of_motion(Q, a, a_prime)
        e, p_0 = line[:3], np.cross(line[:3], line[3:])
        np.testing.assert_allclose(phi * e, motion.as_exp_coords()[:3], atol=1e-12)
        np.testing.assert_allclose(motion.apply(p_0), p_0 + d_0 * e, atol=1e-12)


def test_threads_give_the_same() -> None:
    random = np.random.default_rng(8)
    inputs = [(AXIS, random.uniform(-3, 3, 2000), *random.standard_normal((2, 2000, 3))) for _ in range(16)]
    alone = [kernels.screw_axis_point(*each) for each in inputs]
    light = [kernels.one.rotation_from_axis_angle(np.tile(e, (2000, 1)), phi) for e, phi, *_ in inputs]
    with ThreadPoolExecutor(2) as pool:
        together = list(pool.map(lambda each: kernels.screw_axis_point(*each), inputs))
        rotations = pool.map(
            lambda each: kernels.one.rotation_from_axis_angle(np.tile(each[0], (2000, 1)), each[1]), inputs
        )
        np.testing.assert_array_equal(list(rotations), light)
    np.testing.assert_array_equal(together, alone)


def lets_others_run(work: Callable[[], object], times: int) -> bool:
    """Whether another thread runs while this one works, which no thread does unless the lock is given away."""
    gate, ran = threading.Lock(), threading.Event()
    gate.acquire()

    def other() -> None:
        with gate:
            ran.set()

    thread = threading.Thread(target=other)
    thread.start()
    before = sys.getswitchinterval()
    # A thread that waits for the interpreter asks for it after this many seconds: never.
    sys.setswitchinterval(1e5)
    try:
        gate.release()
        for _ in range(times):
            work()
            if ran.is_set():
                break
        found = ran.is_set()
    finally:
        sys.setswitchinterval(before)
    thread.join()
    return found


@pytest.mark.skipif(not getattr(sys, "_is_gil_enabled", lambda: True)(), reason="there is no lock to give away")
def test_the_interpreter_is_free_while_a_kernel_runs() -> None:
    e, phi = np.tile(AXIS, (200_000, 1)), np.linspace(0.0, 3.0, 200_000)
    out = np.empty((200_000, 3, 3))
    assert lets_others_run(lambda: kernels.rotation_from_axis_angle(e, phi, out=out), 5000)
    assert lets_others_run(lambda: kernels.one.rotation_from_axis_angle(e, phi), 5000)
    assert not lets_others_run(lambda: sum(range(200_000)), 20)


def decisions() -> Callable[[str], list[dict[str, Any]]]:
    """A function of a number alone; made here, so that it travels to other processes by value."""

    def decided(number: str) -> list[dict[str, Any]]:
        from chasles import load
        from chasles.decisions.session import Session
        from chasles.report.records import record

        book = load()
        return [record(entry, Session(book=book).decide(entry.statement)) for entry in book.select([number])]

    return decided


def timeless(records: list[list[dict[str, Any]]]) -> Any:
    """The records without how long each took."""
    return json.loads(json.dumps(records), object_hook=lambda found: {**found, "milliseconds": 0})


@pytest.fixture(scope="module")
def one_after_the_other() -> Any:
    found = timeless([decisions()(number) for number in NUMBERS])
    assert {one["verdict"] for each in found for one in each} >= {"holds-under", "ill-formed"}
    return found


def test_dask_spreads_decisions(client: Any, one_after_the_other: Any) -> None:
    assert timeless(client.gather(client.map(decisions(), NUMBERS))) == one_after_the_other


def test_joblib_spreads_decisions(one_after_the_other: Any) -> None:
    joblib = pytest.importorskip("joblib")
    found = joblib.Parallel(n_jobs=2)(joblib.delayed(decisions())(number) for number in NUMBERS)
    assert timeless(found) == one_after_the_other


def test_decisions_travel_whole() -> None:
    """Not only their records: a decision and its statement come out of a pickle as they went in."""
    book = load()
    judge = Session(book=book)
    for entry in book.select(NUMBERS):
        decision = judge.decide(entry.statement)
        again = pickle.loads(pickle.dumps(decision))
        assert record(entry, again) == record(entry, decision)


def test_kernels_travel() -> None:
    kernel = kernels.screw_axis_point
    assert pickle.loads(pickle.dumps(kernel)) is kernel


def rows() -> list[tuple[str, str]]:
    """The rows of the table on the page: what works, and the test that shows it."""
    found = re.findall(r"^\| ([^|]+?) +\|.*\| `(tests/\w+\.py::\w+)` +\|$", PAGE.read_text("utf-8"), re.MULTILINE)
    assert len(found) >= 10
    return found


@pytest.mark.skipif(not PAGE.exists(), reason="needs the checkout")
def test_every_row_of_the_page_has_its_test() -> None:
    root = PAGE.parents[1]
    named = {test.partition("::")[::2] for _, test in rows()}
    for file, name in sorted(named):
        assert f"\ndef {name}(" in (root / file).read_text("utf-8"), f"{file} has no {name}"
    text = Path(__file__).read_text("utf-8")
    here = {name for name in re.findall(r"^def (test_\w+)", text, re.MULTILINE) if "page" not in name}
    assert here <= {name for _, name in named}, "a test without its row"
