"""The manifest of the emitted kernels of a chapter, as installed here."""

from __future__ import annotations

import tomllib

from chasles.cli.checkout import installed_folder
from chasles.cli.failures import Failure
from chasles.statements import Chapter
from chasles.targets import MANIFEST


def manifest(book: Chapter) -> str:
    """The manifest's text; nothing where nothing was emitted. Raises Failure for one that cannot be read."""
    folder = installed_folder(book)
    if folder is None:
        return ""
    try:
        text = (folder / MANIFEST).read_text("utf-8")
        tomllib.loads(text)
    except FileNotFoundError:
        return ""
    except (OSError, ValueError) as error:
        raise Failure(f"{folder.name}/{MANIFEST} cannot be read ({error}): `chasles emit` writes it anew") from error
    return text
