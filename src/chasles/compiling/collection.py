"""Python's search for cycles of objects that nothing reads, held off while a kernel is made.

Expressions and programs are no cycles: what goes through all of them again and again finds next to nothing.
"""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def collection_held_off() -> Iterator[None]:
    """Within it no cycles are looked for; afterwards again, if they were before."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()
