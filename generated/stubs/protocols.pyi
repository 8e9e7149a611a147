"""What the kernels take, and what they say of themselves. Made by `chasles emit`; not to be edited.

A `Ufunc` is a `numpy.ufunc`. Where nothing was compiled a NumPy function stands in, which takes `out` alone and lacks
the attributes.
"""

from collections.abc import Sequence
from typing import Any, Literal, Protocol, TypeAlias, TypedDict

import numpy as np
from numpy.typing import DTypeLike, NDArray

Real: TypeAlias = np.floating[Any] | np.integer[Any] | np.bool
Array: TypeAlias = NDArray[np.floating[Any]]
Casting: TypeAlias = Literal["no", "equiv", "safe", "same_kind", "unsafe"]
Order: TypeAlias = Literal["K", "A", "C", "F"]
Axes: TypeAlias = Sequence[int | tuple[int, ...]]

class Reals(Protocol):
    """What NumPy reads as an array of real numbers; itself one, or one of another library."""

    def __array__(self) -> NDArray[Real]: ...

Row: TypeAlias = float | Reals | Sequence[float | Reals]
Numbers: TypeAlias = Row | Sequence[Row] | Sequence[Sequence[Row]]
Light: TypeAlias = float | Array

class Options(TypedDict, total=False):
    """What the call of a ufunc takes by name, beside `out`."""

    dtype: DTypeLike | None
    casting: Casting
    order: Order
    subok: bool
    axes: Axes
    axis: int

class Ufunc(Protocol):
    """What NumPy says of a ufunc."""

    @property
    def __name__(self) -> str: ...
    @property
    def nin(self) -> int: ...
    @property
    def nout(self) -> int: ...
    @property
    def nargs(self) -> int: ...
    @property
    def ntypes(self) -> int: ...
    @property
    def types(self) -> list[str]: ...
    @property
    def signature(self) -> str: ...

class Checked(Protocol):
    """What a kernel that tests its inputs says of itself: the kernel, its inputs, and what must hold of them."""

    __name__: str
    inputs: Any
    demands: Any
    kernel: Any
