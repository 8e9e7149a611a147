"""What was proved before need not be proved again: bounds by the hash of all that they depend on, from a manifest."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping

from chasles.bounds.bound import Bound


def remembered(manifest: str) -> dict[str, Bound]:
    """The bounds of a manifest's kernels by their hashes. A damaged manifest, or entry, remembers nothing."""
    try:
        kernels = tomllib.loads(manifest).get("kernels", {})
    except tomllib.TOMLDecodeError:
        return {}
    found: dict[str, Bound] = {}
    for kernel in kernels.values() if isinstance(kernels, Mapping) else ():
        try:
            bound = Bound.from_data(kernel["bound"])
        except (KeyError, TypeError, ValueError, AttributeError):
            continue
        found[bound.program] = bound
    return found
