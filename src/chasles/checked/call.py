"""A kernel that tests its inputs before it computes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from math import prod
from typing import Any

import numpy as np

from chasles.checked.hypotheses import TESTS, BrokenHypothesis, Numbers, is_finite
from chasles.kernels.signatures import MASKED, signature_of_call

Inputs = tuple[tuple[str, tuple[int, ...]], ...]
Demands = tuple[tuple[str, str, tuple[str, ...], Callable[..., Any] | None], ...]


class Checked:
    """A kernel, called alike: what it gives is the kernel's, once its inputs are found to be what it expects.

    Raises ValueError and TypeError as the module says, before anything is stored in `out`.
    """

    def __init__(self, name: str, kernel: Callable[..., Any], inputs: Inputs, demands: Demands) -> None:
        self.kernel = kernel
        self.inputs = inputs
        self.demands = demands
        self.__name__ = name
        self.__signature__ = signature_of_call(kernel, (each for each, _ in inputs))
        self.__doc__ = f"{kernel.__doc__}\nThe inputs are tested: see `chasles.checked`."

    def __repr__(self) -> str:
        return f"<checked kernel {self.__name__}>"

    def __call__(self, *operands: Any, **options: Any) -> Any:
        """What the kernel gives."""
        count = len(self.inputs)
        if len(operands) < count:
            names = ", ".join(name for name, _ in self.inputs)
            raise TypeError(f"{self.__name__} takes {count} inputs ({names}), and {len(operands)} are given")
        arrays = list(self._arrays(operands[:count], _moves(options, count)))
        precision = options.get("dtype") or _precision(operands[:count], arrays)
        batch = self._batch(arrays)
        with np.errstate(all="ignore"):
            self._require_finite(arrays)
            self._require(arrays, float(np.sqrt(np.finfo(np.dtype(precision)).eps)))
            self._require_values(arrays, batch)
        return self.kernel(*operands, **options)

    def _arrays(self, operands: Sequence[Any], moves: Sequence[Any]) -> Iterator[Numbers]:
        """The inputs as arrays of floats, core axes last."""
        for (name, core), operand, move in zip(self.inputs, operands, moves, strict=True):
            if hasattr(operand, "__array_ufunc__") and not isinstance(operand, np.ndarray | np.generic):
                # NumPy would hand it the whole call, and a pandas frame applies the kernel to its columns.
                kind = type(operand).__name__
                raise TypeError(f"{self.__name__}: {name} is a {kind}, no array: hand over its values, as .to_numpy()")
            if isinstance(operand, np.ma.MaskedArray):
                raise ValueError(f"{self.__name__}: {name} {MASKED}")
            try:
                array = np.asarray(operand)
            except ValueError as error:
                raise ValueError(f"{self.__name__}: {name} is no array of numbers: {error}") from None
            if array.dtype.kind not in "biuf":
                raise TypeError(f"{self.__name__}: {name} must hold real numbers; it holds {array.dtype}")
            if move is not None and array.ndim >= len(core):
                array = np.moveaxis(array, move, range(-len(core), 0))
            if array.shape[array.ndim - len(core) :] != core or array.ndim < len(core):
                raise ValueError(f"{self.__name__}: {name} must have the shape {_expected(core)}; it has {array.shape}")
            yield array if array.dtype.kind == "f" else array.astype(np.float64)

    def _batch(self, arrays: Sequence[Numbers]) -> tuple[int, ...]:
        """The batch axes that the inputs have in common."""
        batch: tuple[int, ...] = ()
        for (name, core), array in zip(self.inputs, arrays, strict=True):
            own = array.shape[: array.ndim - len(core)]
            try:
                batch = np.broadcast_shapes(batch, own)
            except ValueError:
                said = f"the batch axes {own} of {name} do not broadcast with {batch}, those of the inputs before it"
                raise ValueError(f"{self.__name__}: {said}") from None
        return batch

    def _require_finite(self, arrays: Sequence[Numbers]) -> None:
        for (name, core), array in zip(self.inputs, arrays, strict=True):
            if not np.isfinite(array).all():
                self._refuse((name,), "all entries are finite", is_finite(_flat(array, core)))

    def _require(self, arrays: Sequence[Numbers], tolerance: float) -> None:
        """The hypotheses that a test of numbers decides."""
        for kind, text, names, _ in self.demands:
            if kind in TESTS:
                parts = [_flat(array, core) for core, array in self._named(names, arrays)]
                self._refuse(names, text, TESTS[kind](parts, tolerance))

    def _require_values(self, arrays: Sequence[Numbers], batch: tuple[int, ...]) -> None:
        """What must not vanish: broken where it does and the kernel has no value, not where there is a limit."""
        for _, text, names, divisor in self.demands:
            if divisor is None:
                continue
            subjects = [array for _, array in self._named(names, arrays)]
            zero = np.asarray(divisor(*subjects)) == 0
            if zero.any():
                lost = zero & _any_over(np.broadcast_to(zero, batch) & self._valueless(arrays, batch), zero.shape)
                self._refuse(names, text, BrokenHypothesis(lost, np.zeros(lost.shape), "the kernel has no value there"))

    def _valueless(self, arrays: Sequence[Numbers], batch: tuple[int, ...]) -> Any:
        """Where some entry of some result is NaN."""
        results = self.kernel(*arrays)
        results = results if isinstance(results, tuple) else (results,)
        return np.logical_or.reduce([np.isnan(r).reshape(*batch, -1).any(axis=-1) for r in results])

    def _named(self, names: Sequence[str], arrays: Sequence[Numbers]) -> list[tuple[tuple[int, ...], Numbers]]:
        """The core shapes and arrays of some inputs."""
        by_name = {name: (core, array) for (name, core), array in zip(self.inputs, arrays, strict=True)}
        return [by_name[name] for name in names]

    def _refuse(self, names: Sequence[str], text: str, finding: BrokenHypothesis) -> None:
        """Raise ValueError if the finding says that something is broken somewhere."""
        if not finding.broken.any():
            return
        index = tuple(map(int, np.argwhere(finding.broken)[0]))
        place = f" at index {index}" if index else ""
        found = finding.says.format(float(finding.amount[index]))
        raise ValueError(f"{self.__name__}: {', '.join(names)}{place}: {text} does not hold: {found}")


def twins(kernels: object, record: Mapping[str, tuple[Inputs, Demands]]) -> dict[str, Checked]:
    """The kernels of a module with their inputs tested, by name; the record says what they take and what must hold."""
    return {name: Checked(name, getattr(kernels, name), *known) for name, known in record.items()}


def _flat(array: Numbers, core: tuple[int, ...]) -> Numbers:
    """The array with its core entries on one axis, in double precision."""
    return array.reshape(*array.shape[: array.ndim - len(core)], prod(core)).astype(np.float64)


def _any_over(mask: Any, shape: tuple[int, ...]) -> Any:
    """Whether the mask holds anywhere along the axes over which an array of the shape is spread."""
    mask = mask.any(axis=tuple(range(mask.ndim - len(shape))))
    spread = tuple(axis for axis, (own, size) in enumerate(zip(shape, mask.shape, strict=True)) if own != size)
    return mask.any(axis=spread, keepdims=True)


def _expected(core: tuple[int, ...]) -> str:
    return f"(..., {', '.join(map(str, core))})" if core else "(...)"


def _moves(options: dict[str, Any], count: int) -> Sequence[Any]:
    """Where the core axes of each input are, if `axes` or `axis` says so."""
    if options.get("axes") is not None:
        return tuple(options["axes"][:count])
    return (options.get("axis"),) * count


def _precision(operands: Sequence[Any], arrays: Sequence[Numbers]) -> Any:
    """The type that is computed in: Python's numbers take that of the arrays beside them."""
    strong = [array.dtype for operand, array in zip(operands, arrays, strict=True) if type(operand) not in (int, float)]
    return np.result_type(np.float32, *(strong or [np.dtype(np.float64)]))
