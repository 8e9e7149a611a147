"""Bounds on work that hold on every machine, however busy: calls of Python functions are counted, not seconds."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any

__all__ = ["TooManyCalls", "at_most"]


class TooManyCalls(BaseException):
    """More functions were called than was allowed; nothing that is tested catches this."""


@contextmanager
def at_most(calls: int) -> Iterator[None]:
    """Raises `TooManyCalls` as soon as more Python functions are called in here; a computer does millions a second."""
    left = calls

    def called(frame: FrameType, event: str, argument: Any) -> None:
        nonlocal left
        left -= 1
        if left < 0:
            raise TooManyCalls(f"more than {calls} calls, the last of {frame.f_code.co_qualname}")

    before = sys.gettrace()
    sys.settrace(called)
    try:
        yield
    finally:
        sys.settrace(before)
