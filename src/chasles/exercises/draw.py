"""New data with nice numbers: drawn by a seed, so that a teacher and a student have the same."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import Any, TypeVar

import sympy as sp

from chasles.exact.evaluate import matrix_of
from chasles.exact.spelling import as_data

_T = TypeVar("_T")


class Draw:
    """Numbers, vectors and rotations, all rational, the same for the same seed."""

    def __init__(self, seed: str) -> None:
        self._random = Random(seed)

    def integer(self, least: int, most: int) -> int:
        """An integer from the least to the most."""
        return self._random.randint(least, most)

    def among(self, things: Sequence[_T]) -> _T:
        """One of the things."""
        return self._random.choice(things)

    def some(self, things: Sequence[_T], count: int) -> list[_T]:
        """So many different ones of the things."""
        return self._random.sample(things, count)

    def vector(self, size: int = 3, most: int = 4) -> Any:
        """A vector of small integers, not all of them zero."""
        while True:
            found = [self.integer(-most, most) for _ in range(size)]
            if any(found):
                return matrix_of([[entry] for entry in found])

    def rotation(self) -> Any:
        """A rotation with rational entries, not the identity: that of a quaternion of small integers."""
        w, (x, y, z) = self.integer(0, 2), self.vector(most=2)
        v = sp.Matrix([x, y, z])
        whole = sp.Matrix([[w**2 - v.dot(v)]])[0] * sp.eye(3) + 2 * v * v.T + 2 * w * v.hat()
        return matrix_of(whole / (w**2 + v.dot(v)))

    def unit(self) -> Any:
        """A vector of length one."""
        return self.rotation()[:, 0]

    def written(self, **data: Any) -> dict[str, Any]:
        """The data as a data file has them."""
        return {key: as_data(value) for key, value in data.items()}
