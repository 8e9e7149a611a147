"""The modules of chasles that the checker imports, directly or not, and how many lines they have."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

CHECKERS = {
    "declared": ("chasles.checker.certificate", "chasles.checker.refutation"),
    "prove": ("chasles.checker.expressions.proof", "chasles.checker.expressions.counterexample"),
}
"""The entrances of the checker: for declared statements, and for questions on SymPy expressions."""


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
