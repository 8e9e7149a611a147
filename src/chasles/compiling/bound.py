"""What is proved of a program's rounding errors? That is the work of `chasles.bounds`, where it is installed."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from chasles.lowering.program import Program

__all__ = ["error_bound"]

_ROOM = "chasles.bounds"


def error_bound(program: Program) -> Any:
    """The bound of the program that `chasles.bounds.bound_of_program` proves. Raises `LookupError` without it."""
    try:
        prove = import_module(_ROOM).bound_of_program
    except (ModuleNotFoundError, AttributeError):
        raise LookupError(f"{program.name}: this version proves no error bound of a single program") from None
    return prove(program)
