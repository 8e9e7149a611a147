"""Functions by the number of their inputs and results, and what they take. Made by `chasles emit`; not to be edited.

`Ufunc` protocols are of `numpy.ufunc`. Where nothing was compiled a NumPy function stands in, which takes `out` alone
and lacks the attributes.
"""

from collections.abc import Sequence
from typing import Any, Literal, Protocol, TypeAlias, TypeVar

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

Result = TypeVar("Result", covariant=True)

class Call1x1(Protocol[Result]):
    """A call with 1 in and 1 out."""

    def __call__(
        self,
        x1: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        dtype: DTypeLike | None = None,
        casting: Casting = ...,
        order: Order = ...,
        subok: bool = ...,
        axes: Axes = ...,
        axis: int = ...,
    ) -> Result: ...

class Ufunc1x1(Ufunc, Call1x1[Result], Protocol[Result]):
    """A ufunc that is called so."""

class Checked1x1(Checked, Call1x1[Result], Protocol[Result]):
    """A kernel that is called so and tests its inputs."""

class Light1x1(Protocol[Result]):
    """A function that takes one element or a contiguous batch, all of one precision."""

    def __call__(
        self,
        x1: float | Array,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Result: ...

class Call1x2(Protocol[Result]):
    """A call with 1 in and 2 out."""

    def __call__(
        self,
        x1: Numbers,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
        dtype: DTypeLike | None = None,
        casting: Casting = ...,
        order: Order = ...,
        subok: bool = ...,
        axes: Axes = ...,
        axis: int = ...,
    ) -> Result: ...

class Ufunc1x2(Ufunc, Call1x2[Result], Protocol[Result]):
    """A ufunc that is called so."""

class Checked1x2(Checked, Call1x2[Result], Protocol[Result]):
    """A kernel that is called so and tests its inputs."""

class Light1x2(Protocol[Result]):
    """A function that takes one element or a contiguous batch, all of one precision."""

    def __call__(
        self,
        x1: float | Array,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
    ) -> Result: ...

class Call2x1(Protocol[Result]):
    """A call with 2 in and 1 out."""

    def __call__(
        self,
        x1: Numbers, x2: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        dtype: DTypeLike | None = None,
        casting: Casting = ...,
        order: Order = ...,
        subok: bool = ...,
        axes: Axes = ...,
        axis: int = ...,
    ) -> Result: ...

class Ufunc2x1(Ufunc, Call2x1[Result], Protocol[Result]):
    """A ufunc that is called so."""

class Checked2x1(Checked, Call2x1[Result], Protocol[Result]):
    """A kernel that is called so and tests its inputs."""

class Light2x1(Protocol[Result]):
    """A function that takes one element or a contiguous batch, all of one precision."""

    def __call__(
        self,
        x1: float | Array, x2: float | Array,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Result: ...

class Call3x1(Protocol[Result]):
    """A call with 3 in and 1 out."""

    def __call__(
        self,
        x1: Numbers, x2: Numbers, x3: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        dtype: DTypeLike | None = None,
        casting: Casting = ...,
        order: Order = ...,
        subok: bool = ...,
        axes: Axes = ...,
        axis: int = ...,
    ) -> Result: ...

class Ufunc3x1(Ufunc, Call3x1[Result], Protocol[Result]):
    """A ufunc that is called so."""

class Checked3x1(Checked, Call3x1[Result], Protocol[Result]):
    """A kernel that is called so and tests its inputs."""

class Light3x1(Protocol[Result]):
    """A function that takes one element or a contiguous batch, all of one precision."""

    def __call__(
        self,
        x1: float | Array, x2: float | Array, x3: float | Array,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Result: ...

class Call3x2(Protocol[Result]):
    """A call with 3 in and 2 out."""

    def __call__(
        self,
        x1: Numbers, x2: Numbers, x3: Numbers,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
        dtype: DTypeLike | None = None,
        casting: Casting = ...,
        order: Order = ...,
        subok: bool = ...,
        axes: Axes = ...,
        axis: int = ...,
    ) -> Result: ...

class Ufunc3x2(Ufunc, Call3x2[Result], Protocol[Result]):
    """A ufunc that is called so."""

class Checked3x2(Checked, Call3x2[Result], Protocol[Result]):
    """A kernel that is called so and tests its inputs."""

class Light3x2(Protocol[Result]):
    """A function that takes one element or a contiguous batch, all of one precision."""

    def __call__(
        self,
        x1: float | Array, x2: float | Array, x3: float | Array,
        /,
        *,
        out: tuple[Array | None, Array | None] | None = None,
    ) -> Result: ...

class Call3x3(Protocol[Result]):
    """A call with 3 in and 3 out."""

    def __call__(
        self,
        x1: Numbers, x2: Numbers, x3: Numbers,
        /,
        *,
        out: tuple[Array | None, Array | None, Array | None] | None = None,
        dtype: DTypeLike | None = None,
        casting: Casting = ...,
        order: Order = ...,
        subok: bool = ...,
        axes: Axes = ...,
        axis: int = ...,
    ) -> Result: ...

class Ufunc3x3(Ufunc, Call3x3[Result], Protocol[Result]):
    """A ufunc that is called so."""

class Checked3x3(Checked, Call3x3[Result], Protocol[Result]):
    """A kernel that is called so and tests its inputs."""

class Light3x3(Protocol[Result]):
    """A function that takes one element or a contiguous batch, all of one precision."""

    def __call__(
        self,
        x1: float | Array, x2: float | Array, x3: float | Array,
        /,
        *,
        out: tuple[Array | None, Array | None, Array | None] | None = None,
    ) -> Result: ...

class Call4x1(Protocol[Result]):
    """A call with 4 in and 1 out."""

    def __call__(
        self,
        x1: Numbers, x2: Numbers, x3: Numbers, x4: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        dtype: DTypeLike | None = None,
        casting: Casting = ...,
        order: Order = ...,
        subok: bool = ...,
        axes: Axes = ...,
        axis: int = ...,
    ) -> Result: ...

class Ufunc4x1(Ufunc, Call4x1[Result], Protocol[Result]):
    """A ufunc that is called so."""

class Checked4x1(Checked, Call4x1[Result], Protocol[Result]):
    """A kernel that is called so and tests its inputs."""

class Light4x1(Protocol[Result]):
    """A function that takes one element or a contiguous batch, all of one precision."""

    def __call__(
        self,
        x1: float | Array, x2: float | Array, x3: float | Array, x4: float | Array,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Result: ...

class Call5x1(Protocol[Result]):
    """A call with 5 in and 1 out."""

    def __call__(
        self,
        x1: Numbers, x2: Numbers, x3: Numbers, x4: Numbers, x5: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        dtype: DTypeLike | None = None,
        casting: Casting = ...,
        order: Order = ...,
        subok: bool = ...,
        axes: Axes = ...,
        axis: int = ...,
    ) -> Result: ...

class Ufunc5x1(Ufunc, Call5x1[Result], Protocol[Result]):
    """A ufunc that is called so."""

class Checked5x1(Checked, Call5x1[Result], Protocol[Result]):
    """A kernel that is called so and tests its inputs."""

class Light5x1(Protocol[Result]):
    """A function that takes one element or a contiguous batch, all of one precision."""

    def __call__(
        self,
        x1: float | Array, x2: float | Array, x3: float | Array, x4: float | Array, x5: float | Array,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Result: ...

class Call7x1(Protocol[Result]):
    """A call with 7 in and 1 out."""

    def __call__(
        self,
        x1: Numbers, x2: Numbers, x3: Numbers, x4: Numbers, x5: Numbers, x6: Numbers, x7: Numbers,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
        dtype: DTypeLike | None = None,
        casting: Casting = ...,
        order: Order = ...,
        subok: bool = ...,
        axes: Axes = ...,
        axis: int = ...,
    ) -> Result: ...

class Ufunc7x1(Ufunc, Call7x1[Result], Protocol[Result]):
    """A ufunc that is called so."""

class Checked7x1(Checked, Call7x1[Result], Protocol[Result]):
    """A kernel that is called so and tests its inputs."""

class Light7x1(Protocol[Result]):
    """A function that takes one element or a contiguous batch, all of one precision."""

    def __call__(
        self,
        x1: float | Array, x2: float | Array, x3: float | Array, x4: float | Array, x5: float | Array, x6: float | Array, x7: float | Array,
        /,
        *,
        out: Array | tuple[Array | None] | None = None,
    ) -> Result: ...
