# SPDX-License-Identifier: BSD-3-Clause
# Emitted by chasles 0.2.0.
"""What the kernels share: inputs to a common batch, entries to arrays. Made by `chasles emit`; not to be edited."""

from __future__ import annotations

import math
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy

__all__ = ("Batch", "delivered", "prepared")


@dataclass(frozen=True)
class Batch:
    """The batch axes that the inputs of a call have in common, their array library, dtype and device."""

    xp: Any
    shape: tuple[int, ...]
    dtype: Any
    device: Any = None

    def number(self, value: float) -> Any:
        """The number as an array without axes."""
        return self.xp.asarray(value, dtype=self.dtype, device=self.device)

    def special(self, name: str, *arrays: Any) -> Any:
        """A function of SciPy, as the array library offers it; Python's own where NumPy is alone.

        Raises NotImplementedError for a library that has none of it.
        """
        return _special(self.xp, name)(*arrays)

    def array(self, shape: tuple[int, ...], *entries: Any) -> Any:
        """A new array with these entries, row-major, on its core axes."""
        arrays = [self.number(entry) if isinstance(entry, float) else entry for entry in entries]
        spread = [self.xp.broadcast_to(array, self.shape) for array in arrays]
        return self.xp.reshape(self.xp.stack(spread, axis=-1), self.shape + shape)


def prepared(kernel: str, *inputs: tuple[str, Any, tuple[int, ...]]) -> tuple[Any, ...]:
    """The batch of the inputs (name, value, core shape), then each input as nested tuples of its entries.

    Raises ValueError where shapes do not fit, TypeError where an input is not of real numbers.
    """
    xp = _library([value for _, value, _ in inputs])
    device = _device(xp, [value for _, value, _ in inputs])
    arrays = [_real(xp, device, kernel, name, value) for name, value, _ in inputs]
    for (name, _, core), array in zip(inputs, arrays, strict=True):
        found = tuple(array.shape)
        if found[len(found) - len(core) :] != core or len(found) < len(core):
            raise ValueError(f"{kernel}: {name} must have the core shape {core} in its last axes; it has {found}")
    batches = [tuple(array.shape)[: array.ndim - len(core)] for (_, _, core), array in zip(inputs, arrays, strict=True)]
    try:
        shape = numpy.broadcast_shapes(*batches)
    except ValueError:
        given = ", ".join(f"{name} {batch}" for (name, _, _), batch in zip(inputs, batches, strict=True))
        raise ValueError(f"{kernel}: the batch axes do not broadcast: {given}") from None
    # A Python number takes the precision of the arrays beside it, as everywhere in NumPy.
    strong = [array for (_, value, _), array in zip(inputs, arrays, strict=True) if type(value) not in (int, float)]
    batch = Batch(xp, shape, _precision(xp, strong), device)
    alike = (xp.astype(array, batch.dtype, copy=False) for array in arrays)
    return batch, *(_entries(array, core) for (_, _, core), array in zip(inputs, alike, strict=True))


def delivered(out: Any, *results: Any) -> Any:
    """The results, or `out` with the results in it; nothing is stored unless all of them fit."""
    if out is None:
        places: tuple[Any, ...] = (None,) * len(results)
    else:
        places = out if isinstance(out, tuple) else (out,)
    if len(places) != len(results):
        raise ValueError(f"out must hold {len(results)} arrays, not {len(places)}")
    for place, result in zip(places, results, strict=True):
        if place is not None:
            _require_room(place, result)
    given = []
    for place, result in zip(places, results, strict=True):
        if place is None:
            given.append(result if result.ndim else result[()])
        else:
            place[...] = result
            given.append(place)
    return given[0] if len(given) == 1 else tuple(given)


def _library(values: list[Any]) -> Any:
    """The array library of the first input that has one other than NumPy."""
    return next((xp for xp in map(_namespace, values) if xp is not numpy), numpy)


def _namespace(value: Any) -> Any:
    """The array library of a value: NumPy for what has none, as numbers and lists."""
    if hasattr(value, "__array_namespace__"):
        return value.__array_namespace__()
    if not hasattr(value, "__dlpack__"):
        return numpy
    # PyTorch and others spell the array API in their own way, which this package translates.
    try:
        return import_module("array_api_compat").array_namespace(value)
    except ModuleNotFoundError:
        library = type(value).__module__.partition(".")[0]
        raise TypeError(f"arrays of {library} need another package: pip install array-api-compat") from None


def _device(xp: Any, values: list[Any]) -> Any:
    """Where the arrays are; None for NumPy, and where a library puts numbers beside the arrays by itself, as JAX."""
    own = [] if xp is numpy else [value for value in values if _namespace(value) is xp]
    return next((value.device for value in own if hasattr(value, "device") and not hasattr(value, "sharding")), None)


_PLACES = {"jax": "jax.scipy.special", "torch": "torch.special", "cupy": "cupyx.scipy.special"}
_CALLED = {"tgamma": "gamma", "lgamma": "gammaln", "digamma": "psi"}
_PARTS = {
    **{name: ("sici", place) for place, name in enumerate(("si", "ci"))},
    **{name: ("shichi", place) for place, name in enumerate(("shi", "chi"))},
    **{name: ("fresnel", place) for place, name in enumerate(("fresnel_s", "fresnel_c"))},
    **{f"airy_{name}": ("airy", place) for place, name in enumerate(("ai", "ai_prime", "bi", "bi_prime"))},
}
"""Which of the results of a function."""


def _special(xp: Any, name: str) -> Any:
    """The function of the library's special ones, by its name in C."""
    library = xp.__name__.removeprefix("array_api_compat.").partition(".")[0]
    try:
        module = import_module(_PLACES.get(library, "scipy.special"))
    except ModuleNotFoundError:
        module = None
    if name in _PARTS and hasattr(module, _PARTS[name][0]):
        called, part = _PARTS[name]
        return lambda *arrays: getattr(module, called)(*arrays)[part]
    for called in (name, _CALLED.get(name, name)):
        if hasattr(module, called):
            found = getattr(module, called)
            return found if name != "lambertw" else lambda *arrays: _where_real(xp, found(*arrays))
    if xp is numpy and hasattr(math, name.removeprefix("t")):
        return numpy.vectorize(_quiet(getattr(math, name.removeprefix("t"))), otypes=[float])
    raise NotImplementedError(f"{name}: {library} has no such function; with SciPy installed NumPy has")


def _where_real(xp: Any, value: Any) -> Any:
    """The real numbers among complex ones, NaN in place of the others."""
    return xp.where(xp.imag(value) == 0, xp.real(value), xp.nan)


def _quiet(function: Any) -> Any:
    """The function, NaN where it has no value."""

    def called(*numbers: float) -> float:
        try:
            return float(function(*numbers))
        except (ValueError, OverflowError):
            return math.nan

    return called


def _real(xp: Any, device: Any, kernel: str, name: str, value: Any) -> Any:
    if isinstance(value, numpy.ndarray) and hasattr(value, "mask"):
        said = "hand over its numbers, as .filled(nan), and mask the result"
        raise ValueError(f"{kernel}: {name} is a masked array: {said}")
    try:
        array = value if _namespace(value) is xp is not numpy else xp.asarray(value, device=device)
    except (TypeError, ValueError) as error:
        kind = TypeError if isinstance(error, TypeError) else ValueError
        raise kind(f"{kernel}: {name} is no array of numbers: {error}") from None
    if not xp.isdtype(array.dtype, ("bool", "integral", "real floating")):
        raise TypeError(f"{kernel}: {name} must hold real numbers; it holds {array.dtype}")
    return array


def _precision(xp: Any, arrays: list[Any]) -> Any:
    """The dtype to compute in: at least single precision; what is not floating counts as the library's default."""
    default = xp.asarray(0.0).dtype
    dtypes = [array.dtype if xp.isdtype(array.dtype, "real floating") else default for array in arrays] or [default]
    return xp.result_type(xp.float32, *dtypes)


def _entries(array: Any, core: tuple[int, ...]) -> Any:
    """The array split along its core axes, which are its last, into tuples in tuples."""
    if not core:
        return array
    rest = (slice(None),) * (len(core) - 1)
    return tuple(_entries(array[(..., place, *rest)], core[1:]) for place in range(core[0]))


def _require_room(place: Any, result: Any) -> None:
    """Raise where the result cannot be stored in `place` without loss of axes or of the fraction."""
    kind = getattr(place, "dtype", None)
    if kind is None or not _library([place]).isdtype(kind, "real floating"):
        raise TypeError(f"out must be an array of floating-point numbers, not of {kind or type(place).__name__}")
    try:
        fits = numpy.broadcast_shapes(tuple(place.shape), tuple(result.shape)) == tuple(place.shape)
    except ValueError:
        fits = False
    if not fits:
        raise ValueError(f"out has the shape {tuple(place.shape)}, the result {tuple(result.shape)}")
