"""Which C compiler is here, and how is it called? With $CC, else cc, and the flags of the C library.

Nothing of -ffast-math: NaN, signed zero and rounding are part of the contract.
"""

from __future__ import annotations

import os
import platform
import re
import shlex
import shutil
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from dataclasses import replace as with_fields
from functools import cache
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path

from chasles.compiling.store import kept
from chasles.kernels.chapter import LEVELS

_ALWAYS = ("-std=c99", "-fPIC", "-fvisibility=hidden", "-fno-math-errno", "-ffp-contract=off")
_ONCE = ("-O2",)
_BLOCK = ("-O3", "-fno-trapping-math")
_INCLUDES = ("-Iinclude", "-Isrc")
_CONTRACTED = "src/trigonometry_blocks.c"
_CIRCULAR = ("chasles_sincos", "sine_of", "directions")
"""What blocks take from there: `cosine_of` holds the second."""
_FIXED = ("src/batches.c", _CONTRACTED)
_FIXED_HEADERS = ("src/batches.h", "src/vectors.h")
"""What knows no kernel, and so came with the package, or else is compiled once and kept."""
_PATIENCE = 300
"""Seconds of processor time after which a compiler, or a part that it has started, is ended."""
_OUT_OF_TIME = re.compile(r"^(-24|152) |cpu ?time limit", re.IGNORECASE)
"""How a command ends then, and what it says where it was a part."""


class CompilerFailed(RuntimeError):
    """The compiler does not do what it should; the message holds its first complaint."""


@dataclass(frozen=True, slots=True)
class _Job:
    """A source to be compiled, and the flags."""

    source: str
    flags: tuple[str, ...]

    @property
    def ready(self) -> str:
        """What the object of it is called that came with the package."""
        level = next((f"_{flag[-1]}" for flag in self.flags if flag.startswith("-DCHASLES_LEVEL=")), "")
        return f"{Path(self.source).stem}{level}.o"


@dataclass(frozen=True, slots=True)
class Compiler:
    """A compiler: its command, what it says of itself, and the flags of each level, of which `least` are left out.

    Code without the first levels is for machines of this one's instructions alone.
    """

    command: tuple[str, ...]
    version: str
    levels: tuple[str, ...]
    least: int = 0

    @property
    def key(self) -> str:
        """All that the compiled code depends on besides what is in the files."""
        flags = (_ALWAYS, _INCLUDES, _ONCE, _BLOCK, self.levels, self.least)
        return repr((self.version, platform.machine(), platform.system(), flags))

    def shared_object(self, files: Mapping[str, str], folder: Path) -> Path:
        """The shared object made of the files, in the folder. Raises `CompilerFailed`."""
        for path, text in files.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(text, encoding="utf-8")
        jobs = list(self._jobs(files))
        objects = [f"{number}.o" for number in range(len(jobs))]
        with ThreadPoolExecutor(min(len(jobs), os.cpu_count() or 1)) as pool:
            list(pool.map(self._make, jobs, [files] * len(jobs), [folder / name for name in objects]))
        _run((*self.command, "-shared", "-o", "made.so", *objects, "-lm"), folder)
        return folder / "made.so"

    def _make(self, job: _Job, files: Mapping[str, str], place: Path) -> None:
        """Compile; what is the same for all kernels is taken from the package or the cache where these have it."""

        def made() -> bytes:
            _run((*self.command, *job.flags, "-c", job.source, "-o", place.name), place.parent)
            return place.read_bytes()

        ready = _ready(files) / job.ready
        if job.source in _FIXED and ready.is_file():
            place.write_bytes(ready.read_bytes())
        elif job.source in _FIXED:
            machine = self.version, platform.machine(), platform.system()
            texts = [files[path] for path in (job.source, *_FIXED_HEADERS)]
            place.write_bytes(kept(sha256(repr((machine, job, texts)).encode()).hexdigest(), made))
        else:
            made()

    def _jobs(self, files: Mapping[str, str]) -> Iterator[_Job]:
        """Blocks for each level, the largest first, and other sources once: with the first, where that runs anyway."""
        count, least = len(self.levels), self.least
        shared = (*_ALWAYS, *_INCLUDES, f"-DCHASLES_LEVELS={count}", *([f"-DCHASLES_LEAST={least}"] if least else ()))
        sources = sorted(path for path in files if path.endswith(".c"))
        blocks = [path for path in sources if path.endswith("_blocks.c")]
        others = [path for path in sources if path not in blocks]
        circular = any(word in files[path] for path in blocks if path not in _FIXED for word in _CIRCULAR)
        # To start a compiler takes longer than what it has to do for these.
        along = [path for path in others if least and path not in _FIXED]
        included = [word for path in along for word in ("-include", path)]
        for level, flag in reversed(list(enumerate(self.levels))[least:]):
            for source in blocks:
                if source != _CONTRACTED or circular:
                    contracted = ("-ffp-contract=fast",) if source == _CONTRACTED else ()
                    flags = (*_BLOCK, *contracted, f"-DCHASLES_LEVEL={level}", *((flag,) if flag else ()))
                    if included and source not in _FIXED:
                        flags, included = (*flags, "-DCHASLES_BLOCKS_ALONE", *included), []
                    yield _Job(source, (*shared, *flags))
        for source in others:
            if source not in along:
                yield _Job(source, (*shared, *_ONCE))


def _ready(files: Mapping[str, str]) -> Path:
    """The folder of the objects that the package brought of the same texts, as cmake/extension.cmake calls it.

    They serve whatever levels are compiled: none depends on how many there are.
    """
    extension = find_spec("chasles._kernels")
    hashes = [sha256(files[path].encode()).hexdigest() for path in (*_FIXED, *_FIXED_HEADERS)]
    place = Path(extension.origin or "") if extension else Path()
    return place.parent / "objects" / sha256("".join(hashes).encode()).hexdigest()


def found(instructions: str, *, alone: bool = False) -> Compiler | None:
    """The compiler that $CC names, else cc, for machines of these instructions; None where there is none.

    For machines of fewer instructions, too, unless for these `alone`.
    """
    command = tuple(shlex.split(os.environ.get("CC", ""))) or ("cc",)
    compiler = _found(command, instructions) if shutil.which(command[0]) else None
    return with_fields(compiler, least=len(compiler.levels) - 1) if compiler and alone else compiler


@cache
def _found(command: tuple[str, ...], instructions: str) -> Compiler | None:
    try:
        version = _run((*command, "--version"))
    except CompilerFailed:
        return None
    known = instructions in LEVELS and _offers_vectors(version)
    more = LEVELS[1 : LEVELS.index(instructions) + 1] if known else ()
    return Compiler(command, version, ("", *(f"-march={level}" for level in more)))


def _offers_vectors(version: str) -> bool:
    """Whether the compiler has vector types with shuffles, as `batches.h` asks: gcc from 12 on, or clang."""
    if "clang" in version:
        return True
    first = next((word for word in version.split("\n")[0].split() if word[:1].isdigit()), "0")
    return int(first.split(".")[0]) >= 12


def _run(command: Sequence[str], folder: Path | None = None) -> str:
    """What the command says. The system ends it, and cc1 below cc, after so much work, however busy the machine is."""
    limited = ("sh", "-c", f'ulimit -S -t {_PATIENCE}; exec "$@"', "sh", *command)
    called = limited if os.name == "posix" else command
    try:
        done = subprocess.run(
            called, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False,
            errors="replace", env={**os.environ, "LC_ALL": "C"},
        )  # fmt: skip
    except OSError as error:
        raise CompilerFailed(f"{shlex.join(command)}: {error}") from error
    if done.returncode:
        lines = done.stderr.strip().splitlines()
        said = next((line for line in lines if "error" in line), lines[0] if lines else "it says nothing")
        if _OUT_OF_TIME.search(f"{done.returncode} {done.stderr}"):
            said = f"it was stopped after {_PATIENCE} seconds of processor time"
        raise CompilerFailed(f"{shlex.join(command)}: exit status {done.returncode}: {said}")
    return done.stdout
