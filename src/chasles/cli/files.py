"""Files that a command reads and writes: read as UTF-8 text or from standard input, written whole or not at all."""

from __future__ import annotations

import sys
from contextlib import suppress
from pathlib import Path

from chasles.cli.failures import BAD_INPUT, Failure

__all__ = ["text_of_file", "write_whole"]


def text_of_file(file: Path) -> str:
    """The text of a file, of standard input for "-". Raises Failure."""
    try:
        return sys.stdin.read() if str(file) == "-" else file.read_text("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is not UTF-8 text"
        raise Failure(f"cannot read {file}: {reason}", BAD_INPUT) from error


def write_whole(file: Path, text: str) -> None:
    """Write a draft beside the file and put it in its place: the file is whole, or as it was. Raises Failure."""
    draft = file.with_name(f".{file.name}.draft")
    try:
        draft.write_text(text, "utf-8")
        draft.replace(file)
    except OSError as error:
        with suppress(OSError):
            draft.unlink(missing_ok=True)
        raise Failure(f"cannot write {file}: {error.strerror}", BAD_INPUT) from error
