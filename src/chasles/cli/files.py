"""Files that a command reads and writes: read as UTF-8 text or from standard input, written whole or not at all."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from uuid import uuid4

from chasles.cli.failures import BAD_INPUT, FAILED, Failure


def text_of_file(file: Path) -> str:
    """The text of a file, without a byte order mark, of standard input for "-". Raises Failure."""
    try:
        return sys.stdin.read() if str(file) == "-" else file.read_text("utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is not UTF-8 text"
        raise Failure(f"cannot read {file}: {reason}", BAD_INPUT) from error


def write_whole(file: Path, text: str) -> None:
    """The file is whole, or as it was. Raises Failure."""
    if not file.name:
        raise Failure("cannot write a file without a name", BAD_INPUT)
    try:
        replace_whole({file: text})
    except OSError as error:
        raise Failure(f"cannot write {file}: {error.strerror}", BAD_INPUT) from error


def write_files(folder: Path, texts: Mapping[str, str | bytes]) -> None:
    """Make the files in the folder hold `texts`, other files there left alone; all are whole, or as they were.

    Raises Failure.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        replace_whole({folder / name: text for name, text in texts.items()})
    except OSError as error:
        where = error.filename2 or error.filename or folder
        raise Failure(f"cannot write to {folder}: {error.strerror or error} ({where})", FAILED) from error


def replace_whole(texts: Mapping[Path, str | bytes]) -> None:
    """Make the files hold `texts`: none changes before all drafts are on the disk. Raises OSError."""
    drafts: dict[Path, Path] = {}
    try:
        for file, text in texts.items():
            draft = file.with_name(f".{file.name}.{uuid4().hex}.draft")
            drafts[draft] = file
            draft.write_bytes(text if isinstance(text, bytes) else text.encode())
        for draft, file in drafts.items():
            draft.replace(file)
    finally:
        for draft in drafts:
            with suppress(OSError):
                draft.unlink(missing_ok=True)
