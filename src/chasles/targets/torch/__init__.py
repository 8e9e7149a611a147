"""PyTorch: a module that needs nothing else, whose functions PyTorch may differentiate, map and compile."""

from __future__ import annotations

from chasles.targets.jax import Library, target

_CUBE_ROOT = "xp.copysign(xp.pow(xp.abs({0}), 1 / 3), {0})"
_TORCH = Library(
    title="PyTorch",
    imports="import torch as xp",
    kind="xp.Tensor",
    is_complex="array.is_complex()",
    is_floating="array.is_floating_point()",
    changed="array.to(dtype)",
    device="next((value.device for _, value, _ in inputs if isinstance(value, xp.Tensor)), None)",
    functions={name: f"xp.{name}" for name in ("erf", "erfc", "lgamma", "digamma")} | {"cbrt": _CUBE_ROOT},
)
TARGET = target("torch", _TORCH)
