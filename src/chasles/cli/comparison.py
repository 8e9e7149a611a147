"""Kernels as installed here compared with 50 digits of their statements, and which of their errors are failures."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from hashlib import sha256
from importlib import import_module
from itertools import product
from time import perf_counter
from types import ModuleType
from typing import Any

import numpy as np

from chasles.cli.checkout import generated_folder, installed_folder
from chasles.cli.failures import BAD_INPUT, Failure, complain, failing
from chasles.decisions.session import Session
from chasles.lowering.cost import roundings
from chasles.lowering.lower import lower
from chasles.lowering.refusal import LoweringError
from chasles.nearest import nearest
from chasles.numerics.sampling import Unsatisfiable
from chasles.numerics.specification import Specification, specification_of
from chasles.numerics.specification_of_inverse import specification_of_inverse
from chasles.numerics.verify import Evidence, verify
from chasles.report.evidence import is_wrong, worst_of
from chasles.report.waiting import progress
from chasles.report.words import number_of, seconds
from chasles.statements import Chapter, Entry, Inverse, Kernel, Theorem
from chasles.statements.packages import BOOK, generated_package, imported

Asked = tuple[Entry, Kernel]
PRECISIONS: tuple[type[np.floating[Any]], ...] = (np.float64, np.float32)


def installed_kernels(book: Chapter) -> ModuleType:
    """The module of the kernels that programs get here.

    Raises Failure where there are none, and the chapter asks for some.
    """
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        with failing(ImportError):
            kernels = _offered(book) if book.package != BOOK else import_module("chasles.kernels")
    complain(str(warning.message) for warning in caught)
    return kernels


def _offered(book: Chapter) -> ModuleType:
    """The module of another chapter's kernels, from where they were written last."""
    folder = installed_folder(book)
    if folder is not None:
        is_own = folder == generated_folder(book, folder)
        name = generated_package(book.package) if is_own else f"written_{sha256(str(folder).encode()).hexdigest()}"
        return import_module(f"{imported(folder, name).__name__}.kernels")
    if any(entry.kernels for entry in book):
        raise Failure(f"there is no {book.package}.generated: `chasles emit` writes the kernels of this chapter there")
    return ModuleType(book.package)


def asking(book: Chapter, names: Sequence[str]) -> list[Asked]:
    """The kernels of these names with their statements, all of the book without names. Raises Failure for others."""
    known = {kernel.name: (entry, kernel) for entry in book.entries for kernel in entry.kernels}
    for name in names:
        if name not in known:
            raise Failure(f"there is no kernel {name!r}{nearest(name, list(known))}", BAD_INPUT)
    return [known[name] for name in names or known]


def compared(
    asked: Sequence[Asked], kernels: ModuleType, strategies: Sequence[str], samples: int, session: Session
) -> Iterator[Evidence]:
    """The evidence on each kernel, precision by precision. Raises Failure where there is nothing to compare."""
    made = [each for each in asked if hasattr(kernels, each[1].name) or not _is_refused(*each, session)]
    tasks = list(product(made, PRECISIONS, strategies))
    for (entry, kernel), precision, strategy in progress(tasks, len(tasks), "Comparing with 50 digits"):
        name = kernel.name
        function = getattr(kernels, name, None)
        if function is None:
            raise Failure(
                f"the kernels installed here ({backend_of(kernels)}) lack {name}: "
                "run `chasles emit`, then `make compile`, for another chapter `chasles build`"
            )
        options = {"dtype": precision, "strategies": (strategy,), "samples": samples, "batched": True}
        said = f"{name} cannot be compared with ({entry.number}): "
        with failing(LoweringError, Unsatisfiable, TypeError, before=said):
            evidence = verify(_specification(entry, kernel, session), function, **options)
        yield evidence


def backend_of(kernels: ModuleType) -> str:
    """Whether the kernels are compiled ("c") or written out in NumPy."""
    return getattr(kernels, "backend", "numpy")


def _is_refused(entry: Entry, kernel: Kernel, session: Session) -> bool:
    """Whether no kernel is made of a declaration, which is told with the reason."""
    try:
        lower(entry, session.decide, kernel)
    except LoweringError as why:
        complain((f"not compared: {why}",))
        return True
    return False


def _specification(entry: Entry, kernel: Kernel, session: Session) -> Specification:
    program = lower(entry, session.decide, kernel)
    of = entry.statement
    assert not isinstance(of, Theorem)
    names = [result.name for result in program.results]
    if isinstance(of, Inverse):
        return specification_of_inverse(program.name, of, kernel, names, roundings(program), session.accepted)
    return specification_of(program.name, of, kernel, names, roundings(program), session.accepted)


@dataclass(frozen=True, slots=True)
class Verification:
    """The evidence on kernels of a backend ("c" or "numpy"), and how long it took to gather it."""

    backend: str
    evidence: tuple[Evidence, ...]
    seconds: float

    @property
    def wrong(self) -> tuple[str, ...]:
        """The kernels that do not compute what their statements say."""
        return tuple(dict.fromkeys(found.kernel for found in self.evidence if is_wrong(found)))

    @property
    def lossy(self) -> tuple[str, ...]:
        """The others that lose digits somewhere."""
        names = dict.fromkeys(found.kernel for found in self.evidence if not found.passed)
        return tuple(name for name in names if name not in self.wrong)

    @property
    def in_words(self) -> Iterator[str]:
        """Totals, the largest errors and the time."""
        count = len({found.kernel for found in self.evidence})
        points = sum(found.samples - found.skipped for found in self.evidence)
        compared = f"{number_of(count, 'kernel')} ({self.backend}) compared with 50 digits"
        yield f"{compared} at {number_of(points, 'point')} in {seconds(self.seconds)}"
        if self.evidence:
            yield worst_of(self.evidence)
        if self.lossy:
            yield f"digits are lost near singular points by {', '.join(self.lossy)}; `chasles verify` shows where"

    def failures(self, strict: bool) -> Iterator[str]:
        """A line for each kind of failure; lost digits are one only if `strict`."""
        if self.wrong:
            yield f"not what the statements say: {', '.join(self.wrong)}"
        if self.lossy and strict:
            yield f"these kernels lose digits: {', '.join(self.lossy)}"

    def as_json(self) -> dict[str, Any]:
        """All of it as plain data."""
        return {
            "backend": self.backend,
            "seconds": round(self.seconds, 3),
            "wrong": list(self.wrong),
            "lossy": list(self.lossy),
            "evidence": [found.as_json() for found in self.evidence],
        }


def verified(
    asked: Sequence[Asked], kernels: ModuleType, strategies: Sequence[str], samples: int, session: Session
) -> Verification:
    """Compare the kernels asked for at so many points of each kind, in each precision."""
    started = perf_counter()
    evidence = tuple(compared(asked, kernels, strategies, samples, session))
    return Verification(backend_of(kernels), evidence, perf_counter() - started)
