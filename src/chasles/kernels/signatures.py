"""How is a kernel called? With its inputs by their names in the book, which NumPy does not know."""

from __future__ import annotations

from collections.abc import Iterable
from inspect import Parameter, Signature, signature
from typing import Any

import numpy as np

__all__ = ["named", "signature_of_call"]

_OPTIONS = {
    "out": None,
    "dtype": None,
    "casting": "same_kind",
    "order": "K",
    "subok": True,
    "axes": np._NoValue,
    "axis": np._NoValue,
}
"""What a call of a generalised ufunc takes by name, with NumPy's defaults."""


def signature_of_call(kernel: Any, names: Iterable[str]) -> Signature:
    """The signature of a kernel whose inputs have these names: a ufunc's, or that of a function as it is."""
    if not isinstance(kernel, np.ufunc):
        return signature(kernel)
    inputs = [Parameter(name, Parameter.POSITIONAL_ONLY) for name in names]
    options = [Parameter(name, Parameter.KEYWORD_ONLY, default=value) for name, value in _OPTIONS.items()]
    return Signature([*inputs, *options])


def named(kernel: Any, light: Any) -> Any:
    """The kernel, which says how it is called if it is a ufunc that can be told: from NumPy 2.2 on."""
    if isinstance(kernel, np.ufunc) and hasattr(kernel, "__dict__"):
        parameters = signature(light).parameters.values()
        inputs = [each.name for each in parameters if each.kind is Parameter.POSITIONAL_ONLY]
        _, _, text = (kernel.__doc__ or "").partition("\n\n")
        vars(kernel).update(__signature__=signature_of_call(kernel, inputs), __doc__=text)
    return kernel
