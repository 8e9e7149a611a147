"""How does a program become a function that is called? Its texts are compiled once; what was compiled is loaded."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path
from typing import Any
from warnings import warn

from chasles import kernels
from chasles.compiling.compiler import CompilerFailed, found
from chasles.compiling.packing import packing_of
from chasles.compiling.recall import Sources
from chasles.compiling.store import loaded
from chasles.kernels.chapter import functions_of
from chasles.lowering.program import Program


def sources_of_program(program: Program, *, narrowed: bool = True) -> tuple[Sources, dict[str, str]]:
    """The texts of a program: those that a user sees, and the files that are compiled."""
    # What is kept needs no languages: they are imported where texts are written.
    from chasles.compiling.sources import sources_of

    return sources_of(program, narrowed=narrowed)


def compiled(program: Program, sources: Sources, files: dict[str, str], doc: str, levels: str) -> tuple[Any, Any]:
    """The ufunc of the compiled program and its light function; None where nothing compiles or nothing makes these."""
    compiler = found(kernels.instructions, alone=levels == "own") if kernels.make_ufunc is not None else None
    if compiler is None or not sources.paths:
        return None, None

    def made(folder: Path) -> Path:
        return compiler.shared_object(files or sources_of_program(program)[1], folder)

    try:
        library = loaded(sha256(repr((compiler.key, sources.digest)).encode()).hexdigest(), made)
    except (CompilerFailed, OSError) as error:
        warn(f"{program.name} runs as NumPy kernel: it could not be compiled: {error}", RuntimeWarning, stacklevel=5)
        return None, None
    packing = packing_of(program)
    inner = program if packing is None else packing.program
    names = ([item.name for item in items] for items in (inner.arguments, inner.results))
    return functions_of(library, 0, program.name, doc, sources.packed, *names)
