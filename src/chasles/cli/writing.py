"""Files for people, written whole or not at all."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from chasles.cli.failures import FAILED, Failure
from chasles.cli.files import replace_whole


def write_whole(folder: Path, texts: Mapping[str, str | bytes]) -> None:
    """Make the files in the folder hold `texts`, other files there left alone.

    No file changes before all drafts are on the disk. Raises Failure where that is not possible.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        replace_whole({folder / name: text for name, text in texts.items()})
    except OSError as error:
        where = error.filename2 or error.filename or folder
        raise Failure(f"cannot write to {folder}: {error.strerror or error} ({where})", FAILED) from error
