"""How is a kernel called? With its inputs by their names in the book, which NumPy does not know, and unmasked."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from inspect import Parameter, Signature, signature
from typing import Any

import numpy as np

MASKED = "is a masked array: hand over its numbers, as .filled(nan), and mask the result"
"""What is said of an input that is refused for that."""

OPTIONS = {
    "out": None,
    "dtype": None,
    "casting": "same_kind",
    "order": "K",
    "subok": True,
    "axes": np._NoValue,
    "axis": np._NoValue,
}
"""What a call of a generalised ufunc takes by name, with NumPy's defaults."""


def signature_of_call(kernel: Any, names: Iterable[str], *, by_name: bool = False) -> Signature:
    """The signature of a kernel whose inputs have these names, and may be given by them: a ufunc's or a function's.

    An option that an input is named like can be given only beside all inputs, and does not stand in it.
    """
    kind = Parameter.POSITIONAL_OR_KEYWORD if by_name else Parameter.POSITIONAL_ONLY
    if not isinstance(kernel, np.ufunc) and not by_name:
        return signature(kernel)
    inputs = {name: Parameter(name, kind) for name in names}
    known = OPTIONS if isinstance(kernel, np.ufunc) else {"out": None}
    options = [Parameter(name, Parameter.KEYWORD_ONLY, default=value) for name, value in known.items()]
    return Signature([*inputs.values(), *(option for option in options if option.name not in inputs)])


def named(kernel: Any, light: Any) -> Any:
    """The kernel; a ufunc refuses masked arrays and, where it can be told, from NumPy 2.2 on, says how it is called."""
    if not isinstance(kernel, np.ufunc):
        return kernel
    inputs = [each.name for each in signature(light).parameters.values() if each.kind is Parameter.POSITIONAL_ONLY]
    _require_unmasked(kernel, inputs)
    if hasattr(kernel, "__dict__"):
        _, _, text = (kernel.__doc__ or "").partition("\n\n")
        vars(kernel).update(__signature__=signature_of_call(kernel, inputs), __doc__=text)
    return kernel


def _require_unmasked(ufunc: np.ufunc, names: Sequence[str]) -> None:
    """Let the ufunc raise ValueError for masked arrays: NumPy would give its results the masks of its inputs.

    Those have other shapes than results. What is registered here NumPy calls when it wraps a result.
    """
    # Kernels of one's own are made without it: it takes a quarter of what NumPy takes.
    from numpy.ma import core as masked

    def refuse(*operands: Any) -> Any:
        [name, *_] = [name for name, each in zip(names, operands, strict=False) if isinstance(each, np.ma.MaskedArray)]
        # A TypeError NumPy would take for a sign to call it otherwise.
        raise ValueError(f"{ufunc.__name__}: {name} {MASKED}")

    registered: dict[np.ufunc, Any] = vars(masked).get("ufunc_domain", {})
    registered[ufunc] = refuse
