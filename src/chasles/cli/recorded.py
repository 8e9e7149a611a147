"""The manifest of the emitted kernels of a chapter, as installed here."""

from __future__ import annotations

import tomllib
from importlib.resources import files

from chasles.cli.failures import Failure
from chasles.statements import Chapter
from chasles.statements.packages import generated_package
from chasles.targets import MANIFEST

__all__ = ["manifest"]


def manifest(book: Chapter) -> str:
    """The manifest's text; nothing where nothing was emitted. Raises Failure for one that cannot be read."""
    try:
        text = files(generated_package(book.package)).joinpath(MANIFEST).read_text("utf-8")
        tomllib.loads(text)
    except (ModuleNotFoundError, FileNotFoundError):
        return ""
    except (OSError, ValueError) as error:
        raise Failure(f"generated/{MANIFEST} cannot be read ({error}): `chasles emit` writes it anew") from error
    return text
