"""Which models of SymPy's own tests of mechanics compile as they come? All whose equations are formed there.

Run it as `python -m benchmarks.compile.sympy_models` from the root of a checkout: it runs these tests of the installed
SymPy, takes every method whose equations of motion they form, compiles it, compares the results with SymPy's matrices
at a point, and writes `benchmarks/compile/SYMPY.md`.
"""

from __future__ import annotations

import inspect
import os
import pkgutil
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from time import process_time
from typing import Any
from unittest.mock import patch

import mpmath
import numpy as np
import sympy as sp
from benchmarks.compile.page import grid
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import KanesMethod, LagrangesMethod
from sympy.physics.mechanics import tests as folder

__all__ = ["cases_of", "compared", "formed"]

DIGITS = 40


def cases_of(module: str) -> Iterator[tuple[str, Callable[[], object]]]:
    """The tests of a module, by name, that take no arguments."""
    for name, value in list(vars(import_module(f"{folder.__name__}.{module}")).items()):
        if name.startswith("test") and inspect.isfunction(value):
            yield name, value
        elif name.startswith("Test") and inspect.isclass(value):
            for method, function in inspect.getmembers(value, inspect.isfunction):
                if method.startswith("test") and len(inspect.signature(function).parameters) == 1:
                    yield f"{name}.{method}", lambda value=value, method=method: getattr(value(), method)()


def formed(test: Callable[[], object], most: int | None = None) -> list[Any]:
    """The methods whose equations a test forms, until it ends or fails; it is stopped after so many."""
    found: dict[int, Any] = {}

    def recording(forming: Callable[..., object]) -> Callable[..., object]:
        def recorded(self: Any, *arguments: Any, **named: Any) -> object:
            result = forming(self, *arguments, **named)
            found[id(self)] = self
            if len(found) == most:
                raise InterruptedError
            return result

        return recorded

    kane, lagrange = KanesMethod.kanes_equations, LagrangesMethod.form_lagranges_equations
    with (
        patch.object(KanesMethod, "kanes_equations", recording(kane)),
        patch.object(LagrangesMethod, "form_lagranges_equations", recording(lagrange)),
        # Some want what pytest sets up for them; what was formed until then counts.
        suppress(Exception),
    ):
        test()
    return list(found.values())


def compared(method: Any, kernel: Any) -> float:
    """The largest difference from SymPy's matrices at a point, and of M a from f, by the largest entry."""
    draw = np.random.default_rng(1).uniform
    point = [draw(0.3, 1.3, argument.shape) for argument in kernel.program.arguments]
    found = dict(zip((each.name for each in kernel.program.results), kernel(*point), strict=True))
    values = {}
    for argument, numbers in zip(kernel.program.arguments, point, strict=True):
        said = _parts(argument.meaning.partition(": ")[2] or argument.name)
        values |= dict(zip(said, np.ravel(numbers), strict=True))
    kinematic = method.kindiffdict() if isinstance(method, KanesMethod) else {}
    matrix, right = (_at(each.subs(kinematic), values) for each in (method.mass_matrix, method.forcing))
    scale = max(np.abs(matrix).max(), np.abs(right).max(), 1.0)
    differences = [np.ravel(found["mass_matrix"]) - matrix.ravel(), np.ravel(found["forcing"]) - right.ravel()]
    if "accelerations" in found:
        unknown = np.concatenate([np.ravel(found[each]) for each in ("accelerations", "multipliers") if each in found])
        unknown[len(method.u) :] *= -1
        scale *= max(np.abs(unknown).max(), 1.0)
        differences.append(matrix @ unknown - right.ravel())
    return float(max(np.abs(each).max() for each in differences) / scale)


def _at(matrix: Any, values: dict[str, Any]) -> np.ndarray:
    """A matrix at a point, with many digits."""
    variables = matrix.atoms(sp.Derivative) | matrix.atoms(AppliedUndef) | matrix.free_symbols
    inner = {part for each in variables for part in sp.preorder_traversal(each) if part != each and part in variables}
    variables -= inner - {part for part in inner if str(part) in values}
    table = {each: sp.Dummy() for each in sorted(variables, key=str) if str(each) in values}
    called = sp.lambdify(list(table.values()), matrix.xreplace(table), "mpmath", cse=True)
    with mpmath.workdps(DIGITS):
        found = called(*(mpmath.mpf(float(values[str(each)])) for each in table))
        return np.array(found.tolist(), dtype=float)


def _parts(said: str) -> list[str]:
    parts, depth = [""], 0
    for letter in said:
        depth += (letter == "(") - (letter == ")")
        if letter == "," and not depth:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def row(name: str, method: Any) -> list[str]:
    """A line of the page."""
    import chasles

    kind, started = type(method).__name__, process_time()
    outputs = ["mass_matrix", "forcing", "accelerations"]
    if isinstance(method, LagrangesMethod) and method.coneqs:
        outputs.append("multipliers")
    reason = ""
    try:
        kernel = chasles.compile(method, outputs=outputs, name="model")
    except ValueError as error:
        reason = "M is singular: no accelerations" if "singular" in str(error) else str(error)
        try:
            kernel = chasles.compile(method, outputs=outputs[:2], name="model")
        except ValueError as refused:
            return [name, kind, "", "", "", str(refused)]
    seconds = f"{process_time() - started:.1f}"
    count = str(sum(kernel.operations.values()))
    return [name, kind, f"`{kernel.signature}`", count, seconds, f"{compared(method, kernel):.1e} {reason}".strip()]


HEAD = """# SymPy's models

`python -m benchmarks.compile.sympy_models` runs the tests of `sympy.physics.mechanics` ({version}) and compiles every
method whose equations of motion they form, as it comes: mass matrix, forcing, accelerations, and multipliers where
there are some. The last column is the largest difference from SymPy's matrices at a point, evaluated with {digits}
digits, and of M a from f. Seconds are processor time for the NumPy kernel, without a C compiler. A mass matrix that is
singular whatever its entries are has no accelerations; its matrices compile. Tests that are not listed form no
equations of motion.
"""


def main() -> None:
    """Run everything."""
    os.environ["CC"] = "no-such-compiler"
    sys.setrecursionlimit(100_000)
    lines = []
    for module in sorted(each.name for each in pkgutil.iter_modules(folder.__path__)):
        for name, test in cases_of(module):
            # The bicycle's test goes on for minutes after its equations are formed.
            methods = formed(test, 1 if name == "test_bicycle" else None)
            for number, method in enumerate(methods, 1):
                said = f"{module}.{name}" + (f" ({number})" if len(methods) > 1 else "")
                lines.append(row(said, method))
                print(*lines[-1], file=sys.stderr, flush=True)
    head = HEAD.format(version=sp.__version__, digits=DIGITS)
    text = head + "\n" + grid(["test", "method", "kernel", "operations", "seconds", "difference"], lines) + "\n"
    (Path(__file__).parent / "SYMPY.md").write_text(text, "utf-8")


if __name__ == "__main__":
    main()
