"""An emitted kernel: its entry in the manifest, and the function itself."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache
from importlib.resources import files
from typing import Any

from chasles import kernels
from chasles.bounds.bound import Bound
from chasles.display import Displayed


@dataclass(frozen=True, slots=True)
class EmittedKernel(Displayed):
    """A kernel with its number, what it says, its signature and what is proved of it; called, it is the kernel.

    `verdict` is that of its statement, `hypotheses` what the proof assumes; `expected` gives the result its meaning.
    `operations` are counted by kind. `form` is "stated", or "offered" where it is made of other words, proved equal.
    `bound` says, for each result, how many roundings u it may be off, u = 2^-53, in single precision 2^-24.
    """

    name: str
    number: str
    says: str
    signature: str
    verdict: str
    hypotheses: tuple[str, ...]
    expected: tuple[str, ...]
    operations: dict[str, int]
    form: str
    bound: tuple[str, ...]

    def __call__(self, *inputs: Any, **options: Any) -> Any:
        """What `chasles.kernels` gives by this name."""
        return getattr(kernels, self.name)(*inputs, **options)


def kernel(name: str) -> EmittedKernel:
    """What is known of the kernel of that name. Raises LookupError for a name that is no kernel's."""
    known = _manifest()
    if name not in known:
        near = get_close_matches(str(name), known, 3)
        hint = f"did you mean {' or '.join(near)}?" if near else "dir(chasles.kernels) lists all"
        raise LookupError(f"there is no kernel {name!r}: {hint}")
    said = known[name]
    return EmittedKernel(
        name=name,
        **{field: said[field] for field in ("number", "says", "signature", "verdict", "operations", "form")},
        hypotheses=tuple(said["hypotheses"]),
        expected=tuple(said["expected"]),
        bound=Bound.from_data(said["bound"]).in_words if "bound" in said else (),
    )


@cache
def _manifest() -> dict[str, dict[str, Any]]:
    """What was emitted, by name."""
    kernels.written_out()
    text = (files("chasles.generated") / "MANIFEST.toml").read_text("utf-8")
    found: dict[str, dict[str, Any]] = tomllib.loads(text)["kernels"]
    return found
