"""What does one take away of a compiled expression? Files in a language that need nothing of this package."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from chasles.compiling.sources import ORIGIN
from chasles.lowering.refusal import LoweringError
from chasles.targets import EmissionError, TargetKernel, place, taken_away
from chasles.targets.emit import HEAD
from chasles.targets.kernel import require_plain


def written(kernel: TargetKernel, folder: Path, targets: str | Iterable[str], license: str) -> tuple[Path, ...]:
    """The files of the kernel below the folder, one folder a target: all of them are written, or nothing is.

    Raises `LoweringError` for a target that there is not or that cannot spell the kernel, OSError where a file cannot
    be written.
    """
    _, made = HEAD
    require_plain(license, "license")
    try:
        names = (targets,) if isinstance(targets, str) else tuple(targets)
        texts = taken_away([kernel], names, head=(f"SPDX-License-Identifier: {license}", made), origin=ORIGIN)
    except EmissionError as error:
        raise LoweringError(str(error)) from None
    place(folder, texts)
    return tuple(folder / path for path in texts)
