"""The modules of chasles that the checker imports, directly or not, and how many lines they have."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

DECLARED = "chasles.checker.certificate", "chasles.checker.refutation"
PROVE = "chasles.checker.expressions.proof", "chasles.checker.expressions.counterexample"
ON_DEMAND = (
    "chasles.checker.any_size.proof",
    "chasles.checker.any_size.at_sizes",
    "chasles.checker.expressions.induction",
    "chasles.checker.expressions.scalars",
    "chasles.checker.expressions.slopes",
    "chasles.checker.inequalities.squares",
    "chasles.statements.bounds",
    "chasles.statements.expanding",
    "chasles.statements.field_equations",
)
CHECKERS = {"declared": DECLARED, "prove": PROVE, "all": (*DECLARED, *PROVE, *ON_DEMAND)}
"""The entrances of the checker: for declared statements, for questions on SymPy expressions, and for both with what is
loaded only where a statement has functions, letters for sizes, fields, inequalities or divisors between bounds."""


def closure(*names: str) -> dict[str, Path]:
    """The file of each module of chasles that is loaded with the named ones, read from their imports."""
    found: dict[str, Path] = {}
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        spec = find_spec(name) if name not in found else None
        if spec is None or spec.origin is None:
            continue
        found[name] = Path(spec.origin)
        waiting += [name.rpartition(".")[0]] if "." in name else []
        waiting += (each for each in _imported(ast.parse(found[name].read_text("utf-8")).body) if _is_module(each))
    return found


def lines(checker: str) -> int:
    """How many lines the closure of a checker has."""
    return sum(len(path.read_text("utf-8").splitlines()) for path in closure(*CHECKERS[checker]).values())


def _imported(statements: list[ast.stmt]) -> Iterator[str]:
    """What may be modules of chasles among what is imported when a module is loaded."""
    for statement in statements:
        match statement:
            case ast.Import(names):
                yield from (alias.name for alias in names if alias.name.startswith("chasles"))
            case ast.ImportFrom(str() as module, names) if module.startswith("chasles"):
                yield from (module, *(f"{module}.{alias.name}" for alias in names))


def _is_module(name: str) -> bool:
    try:
        return find_spec(name) is not None
    except ModuleNotFoundError:
        return False
