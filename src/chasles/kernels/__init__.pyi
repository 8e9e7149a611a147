"""The emitted kernels, as type checkers see them; `generated/stubs` declares each."""

from types import ModuleType
from typing import Any, Literal

from chasles.generated.stubs import one as one
from chasles.generated.stubs.kernels import *
from chasles.kernels import array_api as array_api

backend: Literal["c", "numpy"]
instructions: str
make_ufunc: Any
make_light: Any

def written_out() -> ModuleType: ...
