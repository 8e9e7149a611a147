"""Expressions nested deeper than Python's stack are read in a thread with a larger one."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextvars import copy_context
from functools import wraps
from typing import ParamSpec, TypeVar

from chasles.lowering.refusal import LoweringError

STACK = 2**29
"""Bytes, of which those are taken that are needed."""
CALLS = 100_000
"""Calls inside each other that fit into it, those that SymPy makes of itself too."""
P = ParamSpec("P")
R = TypeVar("R")


def at_any_depth(function: Callable[P, R]) -> Callable[P, R]:
    """The function, called again with more room where calls are too deep; `LoweringError` where that is not enough."""

    @wraps(function)
    def called(*args: P.args, **options: P.kwargs) -> R:
        try:
            return function(*args, **options)
        except RecursionError:
            before, calls = threading.stack_size(STACK), sys.getrecursionlimit()
        try:
            sys.setrecursionlimit(max(calls, CALLS))
            with ThreadPoolExecutor(1) as pool:
                return pool.submit(copy_context().run, lambda: function(*args, **options)).result()
        except RecursionError:
            raise LoweringError("an expression is nested too deeply: give parts of it as inputs of their own") from None
        finally:
            threading.stack_size(before)
            sys.setrecursionlimit(calls)

    return called
