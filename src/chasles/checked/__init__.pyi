"""The kernels with their inputs tested, as type checkers see them; `generated/stubs` declares each."""

from chasles.generated.stubs.checked import *
