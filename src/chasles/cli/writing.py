"""Files for people, written whole or not at all."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from uuid import uuid4

from chasles.cli.failures import FAILED, Failure

__all__ = ["write_whole"]


def write_whole(folder: Path, texts: Mapping[str, str]) -> None:
    """Make the files in the folder read as `texts`, other files there left alone.

    No file changes before all drafts are on the disk. Raises Failure where that is not possible.
    """
    drafts: dict[Path, Path] = {}
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in texts.items():
            draft = folder / f".{name}.{uuid4().hex}.draft"
            drafts[draft] = folder / name
            draft.write_text(text, encoding="utf-8", newline="\n")
        for draft, place in drafts.items():
            draft.replace(place)
    except OSError as error:
        where = error.filename2 or error.filename or folder
        raise Failure(f"cannot write to {folder}: {error.strerror or error} ({where})", FAILED) from error
    finally:
        for draft in drafts:
            with suppress(OSError):
                draft.unlink(missing_ok=True)
