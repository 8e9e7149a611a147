"""Beside each other: `chasles.compile`, and what one would use instead, on models of mechanics.

Run it as `python -m benchmarks.compile [MODELS] [--curve] [--methods] [--rounds N]` from the root of a checkout; peers
that are not installed are left out. It writes `benchmarks/evidence/compile.json` and `benchmarks/compile/RESULTS.md`,
which keeps the figures of models that are not measured again. Not part of `make bench`.
"""

from __future__ import annotations

import argparse
import json
import logging
import sys
import tempfile
from collections.abc import Callable, Iterable, Mapping
from importlib import import_module
from pathlib import Path
from statistics import median
from typing import Any

import mpmath
import numpy as np
from benchmarks.compile.formula import Formula
from benchmarks.compile.making import compiled, in_new_process, method_compiled
from benchmarks.compile.models import METHODS, MODELS, Model, chain_in_the_plane, of_method
from benchmarks.compile.page import page
from benchmarks.kernels import machine
from benchmarks.timing import interleaved

HERE = Path(__file__).resolve().parent
EVIDENCE = HERE.parent / "evidence" / "compile.json"
PEERS = ("sympy_lambdify", "sympy_cse_c", "numba_jit", "wrenfold_cpp", "symforce_cpp", "casadi_c")
BATCH = 10_000
POINTS = 12
DIGITS = 50
PATIENCE = 300.0
"""Seconds after which a tool is given up in a new process."""
LONG = 60.0
"""A peer that took so many seconds is not asked for what is larger."""
SIZES = (1, 2, 4, 8, 16, 36, 70, 180, 350, 700, 1050)
"""Masses of the chain of the curve, of some 19 operations each."""

Call = Callable[..., Any]


def installed() -> dict[str, Any]:
    """The peers' modules."""
    found = {}
    for name in PEERS:
        try:
            found[name] = import_module(f"benchmarks.peers.{name}")
        except ImportError as error:
            print(f"{name} is left out: {error}", file=sys.stderr)
    return found


def points(model: Model, many: int) -> list[np.ndarray]:
    """Inputs away from zero, always the same."""
    draw = np.random.default_rng(len(model.entries))
    return [draw.uniform(0.4, 1.4, (many, len(group))) for group in model.inputs.values()]


def references(formula: Formula, inputs: Iterable[np.ndarray]) -> np.ndarray:
    """The results at the first points, correctly rounded."""
    context = mpmath.MPContext()
    context.dps = DIGITS
    rows = zip(*(x[:POINTS] for x in inputs), strict=True)
    found = [formula.of(context, *([context.mpf(float(x)) for x in group] for group in row)) for row in rows]
    return np.array([[context.mpf(x) for x in row] for row in found], dtype=object)


def error(call: Call, inputs: Iterable[np.ndarray], right: np.ndarray) -> float:
    """The largest error in 2^-53 of the largest entry of a result."""
    found = call(*(np.ascontiguousarray(x[:POINTS]) for x in inputs))
    largest = np.array([max(map(abs, row)) for row in right])[:, None]
    return float((abs(found - right) / largest).max() * 2**53)


def measured(model: Model, modules: Mapping[str, Any], rounds: int) -> dict[str, Any]:
    """What each tool takes to make the model's kernel, and what that takes to run."""
    formula = Formula(model)
    inputs = points(model, BATCH)
    right = references(formula, inputs)
    row: dict[str, Any] = {"says": model.says, "results": len(model.entries), "inputs": formula.inputs, "tools": {}}
    calls: dict[str, Call] = {}
    with tempfile.TemporaryDirectory() as cache:
        making = {when: in_new_process(model, cache, PATIENCE) for when in ("cold", "warm")}
        row["tools"]["chasles"] = making
        if isinstance(making["warm"], float):
            with_cache(cache)
            kernel = compiled(model)
            calls["chasles"] = kernel
            making["operations"] = sum(kernel.operations.values())
            making["backend"] = kernel.backend
    for name, module in modules.items():
        row["tools"][name] = tool = {}
        with tempfile.TemporaryDirectory() as room:
            tool["cold"] = in_new_process(model, room, PATIENCE, name)
        try:
            made = module.make([formula])["model"]
        except Exception as failure:
            tool["cold"] = f"{type(failure).__name__}: {failure}"[:200]
            continue
        tool["operations"] = made.operations
        calls[name] = made.call
    for name, call in calls.items():
        row["tools"][name]["error"] = error(call, inputs, right)
    out = np.empty((BATCH, len(model.entries)))
    first = [np.ascontiguousarray(x[0]) for x in inputs]
    running = interleaved({name: lambda c=call: c(*inputs, out=out) for name, call in calls.items()}, rounds)
    alone = {name: getattr(call, "one", call) for name, call in calls.items()}
    single = interleaved({name: lambda c=call: c(*first) for name, call in alone.items()}, rounds)
    for name in calls:
        row["tools"][name] |= {"batch": median(running[name]) / BATCH * 1e9, "call": median(single[name]) * 1e6}
    return row


def solved(name: str, modules: Mapping[str, Any], rounds: int) -> dict[str, Any]:
    """Accelerations of a method: solved on the way, or by NumPy from mass matrix and forcing."""
    method = METHODS[name]()
    model = of_method("method", "accelerations", method, whole=True)
    formula, inputs, size = Formula(model), points(model, BATCH), len(method.u)
    right = references(formula, inputs)
    with mpmath.workdps(DIGITS):
        matrices = [(mpmath.matrix(row[: size**2].reshape(size, size).tolist()), row[size**2 :]) for row in right]
        right = np.array([list(mpmath.lu_solve(M, mpmath.matrix(f.tolist()))) for M, f in matrices], dtype=object)
    row: dict[str, Any] = {"says": "accelerations", "results": size, "tools": {}}
    with tempfile.TemporaryDirectory() as cache:
        row["tools"]["chasles"] = {when: in_new_process(name, cache, PATIENCE) for when in ("cold", "warm")}
        with_cache(cache)
        kernel = method_compiled(method)
    row["tools"]["chasles"]["operations"] = sum(kernel.operations.values())
    calls: dict[str, Call] = {"chasles": in_order(kernel, method, model)}
    for peer, module in modules.items():
        with tempfile.TemporaryDirectory() as room:
            row["tools"][peer] = tool = {"cold": in_new_process(name, room, PATIENCE, peer)}
        try:
            made = module.make([formula])["model"]
        except Exception as failure:
            tool["cold"] = f"{type(failure).__name__}: {failure}"[:200]
            continue

        def both(*given: np.ndarray, call: Call = made.call) -> np.ndarray:
            flat = call(*given)
            matrix, force = flat[..., : size**2], flat[..., size**2 :, None]
            return np.linalg.solve(matrix.reshape(*matrix.shape[:-1], size, size), force)[..., 0]

        calls[peer] = both
    for each, call in calls.items():
        row["tools"][each]["error"] = error(call, inputs, right)
    first = [np.ascontiguousarray(x[0]) for x in inputs]
    running = interleaved({name: lambda c=call: c(*inputs) for name, call in calls.items()}, rounds)
    single = interleaved({name: lambda c=call: c(*first) for name, call in calls.items()}, rounds)
    for each in calls:
        row["tools"][each] |= {"batch": median(running[each]) / BATCH * 1e9, "call": median(single[each]) * 1e6}
    return row


def in_order(kernel: Any, method: Any, model: Model) -> Call:
    """The kernel, called with the arrays of the model."""
    named = {"q": "q", "u": "u", "F": "specified", "p": "parameters"}
    assert [named[name] for name in model.inputs] == list(kernel.inputs)
    flat = [argument.shape == () for argument in kernel.program.arguments]
    return lambda *given: kernel(*(x[..., 0] if alone else x for x, alone in zip(given, flat, strict=True)))


def with_cache(folder: str) -> None:
    """Let chasles find there what another process made."""
    import os

    os.environ["CHASLES_CACHE"] = folder


def curve(modules: Mapping[str, Any], rounds: int) -> list[dict[str, Any]]:
    """The chain of springs at all sizes; a tool that takes too long is not asked again."""
    left = dict(modules)
    rows = []
    for size in SIZES:
        row = measured(chain_in_the_plane(size), left, rounds)
        row["masses"] = size
        rows.append(row)
        print(json.dumps(row), file=sys.stderr)
        left = {name: each for name, each in left.items() if not is_late(row["tools"][name]["cold"])}
    return rows


def is_late(seconds: float | str) -> bool:
    """Whether it took too long, or failed."""
    return not isinstance(seconds, float) or seconds > LONG


def main() -> None:
    """Measure, and write the page."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("models", nargs="*", choices=[*MODELS, []], help="models; all if none is named")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--curve", action="store_true", help="the curve over size")
    parser.add_argument("--methods", action="store_true", help="equations of motion, solved")
    given = parser.parse_args()
    sys.setrecursionlimit(100_000)
    logging.disable(logging.WARNING)
    modules = installed()
    found = json.loads(EVIDENCE.read_text("utf-8")) if EVIDENCE.exists() else {"models": {}}
    found["machine"] = machine()
    for name in given.models or ([] if given.curve or given.methods else MODELS):
        found["models"][name] = measured(MODELS[name](), modules, given.rounds)
        print(name, json.dumps(found["models"][name]["tools"]), file=sys.stderr, flush=True)
        keep(found)
    if given.methods:
        found["methods"] = {name: solved(name, modules, given.rounds) for name in METHODS}
    if given.curve:
        found["curve"] = curve(modules, given.rounds)
    keep(found)


def keep(found: dict[str, Any]) -> None:
    """Write the figures and their page."""
    found["models"] = {name: found["models"][name] for name in MODELS if name in found["models"]}
    EVIDENCE.write_text(json.dumps(found, indent=1) + "\n", "utf-8")
    (HERE / "RESULTS.md").write_text(page(found), "utf-8")


if __name__ == "__main__":
    main()
