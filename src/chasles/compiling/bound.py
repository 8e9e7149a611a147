"""What is proved of a program's rounding errors? That is the work of `chasles.bounds`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from chasles.bounds.box import BoxBound, bound_of_program
from chasles.lowering.program import Program


def error_bound(program: Program, box: Mapping[str, Any], dtype: Any, *, in_numpy: bool = False) -> BoxBound:
    """The bound that `chasles.bounds.bound_of_program` proves.

    Raises ModuleNotFoundError, which says what to install, where that needs python-flint.
    """
    try:
        return bound_of_program(program, box, dtype, in_numpy=in_numpy)
    except ModuleNotFoundError as error:
        if error.name != "flint":
            raise
        raise ModuleNotFoundError(
            f"{program.name}: an error bound with sines, exponentials and the like needs python-flint; install "
            "it with: pip install 'chasles[fast]'",
            name="flint",
        ) from None
