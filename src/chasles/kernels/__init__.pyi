"""The emitted kernels, as type checkers see them; `generated/stubs` declares each."""

from typing import Any, Literal

from chasles.generated.stubs import one as one
from chasles.generated.stubs.kernels import *

backend: Literal["c", "numpy"]
instructions: str
make_ufunc: Any
