"""Which C compiler is here, and how is it called? With $CC, else cc, and the flags of the C library.

Nothing of -ffast-math: NaN, signed zero and rounding are part of the contract.
"""

from __future__ import annotations

import os
import platform
import shlex
import shutil
import subprocess
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from pathlib import Path

__all__ = ["Compiler", "CompilerFailed", "found"]

_ALWAYS = ("-std=c99", "-fPIC", "-fvisibility=hidden", "-fno-math-errno", "-ffp-contract=off")
_ONCE = ("-O2",)
_BLOCK = ("-O3", "-fno-trapping-math")
_INCLUDES = ("include", "src")
_CONTRACTED = "trigonometry_blocks"
_LEVELS = ("x86-64-v3", "x86-64-v4")
"""Beyond the compiler's own target, in the order of `batches.h`."""
_PATIENCE = 300.0
"""Seconds after which a compiler is given up."""


class CompilerFailed(RuntimeError):
    """The compiler does not do what it should; the message holds its first complaint."""


@dataclass(frozen=True, slots=True)
class Compiler:
    """A compiler: its command, what it says of itself, and for which instructions blocks are compiled."""

    command: tuple[str, ...]
    version: str
    levels: tuple[str, ...]

    def key(self, files: Iterable[str]) -> str:
        """All that the compiled code depends on besides what is in the files."""
        jobs = map(tuple, self._jobs("x", files))
        return repr((self.version, self.levels, platform.machine(), platform.system(), *jobs))

    def shared_object(self, files: Mapping[str, str], folder: Path) -> Path:
        """The shared object made of the files, in the folder. Raises `CompilerFailed`."""
        for path, text in files.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(text, encoding="utf-8")
        jobs = list(self._jobs(".", files))
        objects = [f"{number}.o" for number in range(len(jobs))]
        with ThreadPoolExecutor(min(len(jobs), os.cpu_count() or 1)) as pool:
            commands = [(*self.command, *job, "-o", made) for job, made in zip(jobs, objects, strict=True)]
            list(pool.map(_run, commands, [folder] * len(jobs)))
        _run((*self.command, "-shared", "-o", "made.so", *objects, "-lm"), folder)
        return folder / "made.so"

    def _jobs(self, root: str, files: Iterable[str]) -> Iterator[Sequence[str]]:
        """What to compile, and how, but for where to: blocks for each level, other sources once."""
        shared = (*_ALWAYS, *(f"-I{root}/{include}" for include in _INCLUDES), f"-DCHASLES_LEVELS={len(self.levels)}")
        sources = sorted(path for path in files if path.endswith(".c"))
        blocks = [path for path in sources if path.endswith("_blocks.c")]
        for source in sources:
            if source not in blocks:
                yield (*shared, *_ONCE, "-c", f"{root}/{source}")
        for level, flag in enumerate(self.levels):
            for source in blocks:
                contracted = ("-ffp-contract=fast",) if _CONTRACTED in source else ()
                flags = (*_BLOCK, *contracted, f"-DCHASLES_LEVEL={level}", *((flag,) if flag else ()))
                yield (*shared, *flags, "-c", f"{root}/{source}")


def found(instructions: str) -> Compiler | None:
    """The compiler that $CC names, else cc, for machines of these instructions; None where there is none."""
    command = tuple(shlex.split(os.environ.get("CC", ""))) or ("cc",)
    return _found(command, instructions) if shutil.which(command[0]) else None


@cache
def _found(command: tuple[str, ...], instructions: str) -> Compiler | None:
    try:
        version = _run((*command, "--version"))
    except CompilerFailed:
        return None
    known = instructions in _LEVELS and _offers_vectors(version)
    more = _LEVELS[: _LEVELS.index(instructions) + 1] if known else ()
    return Compiler(command, version, ("", *(f"-march={level}" for level in more)))


def _offers_vectors(version: str) -> bool:
    """Whether the compiler has vector types with shuffles, as `batches.h` asks: gcc from 12 on, or clang."""
    if "clang" in version:
        return True
    first = next((word for word in version.split("\n")[0].split() if word[:1].isdigit()), "0")
    return int(first.split(".")[0]) >= 12


def _run(command: Sequence[str], folder: Path | None = None) -> str:
    try:
        done = subprocess.run(
            command, cwd=folder, capture_output=True, text=True, timeout=_PATIENCE, check=False, errors="replace"
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise CompilerFailed(f"{shlex.join(command)}: {error}") from error
    if done.returncode:
        lines = done.stderr.strip().splitlines()
        said = next((line for line in lines if "error" in line), lines[0] if lines else "it says nothing")
        raise CompilerFailed(f"{shlex.join(command)}: exit status {done.returncode}: {said}")
    return done.stdout
