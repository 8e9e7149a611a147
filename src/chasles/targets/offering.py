"""The package of a chapter's kernels: a module that offers them, one that tests their inputs, their C library."""

from __future__ import annotations

from collections.abc import Mapping
from hashlib import sha256

from chasles.targets.kernel import EmissionError, TargetKernel, signature
from chasles.targets.target import Page

KERNELS = "kernels.py"
_FILES = (KERNELS, "kernels.pyi", "checked.py", "CMakeLists.txt")
_TAKEN = ("backend", "checked", "instructions", "one")


def c_sources(texts: Mapping[str, str]) -> dict[str, str]:
    """The files of the C library among what is emitted, by their paths in its folder, without the self-test."""
    library = {path.removeprefix("c/"): text for path, text in texts.items() if path.startswith("c/")}
    return {path: text for path, text in library.items() if path.startswith(("include/", "src/"))}


def digest_of(texts: Mapping[str, str]) -> str:
    """The hash of the files of the C library, after which what is compiled of them is called."""
    return sha256(repr(sorted(c_sources(texts).items())).encode()).hexdigest()


def offering(kernels: tuple[TargetKernel, ...], pages: Mapping[str, str]) -> list[Page]:
    """The pages at the top of a chapter's kernels. Raises EmissionError for a kernel that has the name of a page."""
    taken = [kernel.name for kernel in kernels if kernel.name in _TAKEN]
    if taken:
        raise EmissionError(f"a kernel may not be called {taken[0]}: beside the kernels that is something else")
    rows = []
    for kernel in kernels:
        inputs, outputs = ([item.name for item in part] for part in (kernel.program.arguments, kernel.program.results))
        rows.append(f'"{kernel.name}": {(signature(kernel.program), tuple(inputs), tuple(outputs))}')
    values = {"rows": rows, "digest": digest_of(pages)}
    return [Page(name, f"{name}.jinja", values) for name in _FILES]
