"""Seconds that a tool takes in a new process; run by the benchmark, with a pickled model and the tool's name.

Processor time, of the compiler too, in all of its threads and processes, and of what the tool imports besides SymPy.
"""

from __future__ import annotations

import logging
import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

import sympy as sp
from benchmarks.compile.formula import Formula
from benchmarks.compile.models import METHODS, Model, of_method

__all__ = ["compiled", "in_new_process", "method_compiled"]


def spent() -> float:
    """Processor time so far, of this process and of those that it waited for."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


def timed(make: Callable[[], Any]) -> tuple[Any, float]:
    """What is made, and the seconds."""
    started = spent()
    made = make()
    return made, spent() - started


def compiled(model: Model) -> Any:
    """The kernel of chasles."""
    import chasles

    inputs = {name: sp.Matrix(group) for name, group in model.inputs.items()}
    return chasles.compile(sp.Matrix(model.entries), inputs, name="model")


def method_compiled(method: Any) -> Any:
    """The accelerations of a method of SymPy."""
    import chasles

    return chasles.compile(method, outputs="accelerations", name="model")


def in_new_process(model: Model | str, cache: str, limit: float, tool: str = "chasles") -> float | str:
    """Seconds of a tool in a new process with this cache; the last line of what it says where it fails.

    For the name of a method chasles makes the accelerations, a peer the mass matrix and the forcing.
    """
    held = Path(cache) / "model.pickle"
    held.parent.mkdir(parents=True, exist_ok=True)
    held.write_bytes(pickle.dumps(model))
    command = [sys.executable, "-m", "benchmarks.compile.making", str(held), tool]
    # Bytecode is written once, when a package is installed or first used: all peers have theirs.
    inherited = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    try:
        done = subprocess.run(
            command,
            env={**inherited, "CHASLES_CACHE": cache},
            capture_output=True,
            text=True,
            timeout=limit,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return f"more than {limit:.0f} s"
    return float(done.stdout) if done.returncode == 0 else done.stderr.strip().splitlines()[-1]


if __name__ == "__main__":
    sys.setrecursionlimit(100_000)
    held = pickle.loads(Path(sys.argv[1]).read_bytes())

    if isinstance(held, str):
        method = METHODS[held]()
        held = method if sys.argv[2] == "chasles" else of_method("method", held, method, whole=True)

    def made() -> object:
        """The tool's kernel, with what it imports."""
        if sys.argv[2] == "chasles":
            return compiled(held) if isinstance(held, Model) else method_compiled(held)
        return import_module(f"benchmarks.peers.{sys.argv[2]}").make([Formula(held)])

    logging.disable(logging.WARNING)
    print(timed(made)[1])
