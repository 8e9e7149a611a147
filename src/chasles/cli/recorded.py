"""What was emitted, as the manifest that is installed here has it."""

from __future__ import annotations

import tomllib
from importlib.resources import files

from chasles.cli.failures import Failure

__all__ = ["manifest"]

MANIFEST = ("chasles.generated", "MANIFEST.toml")


def manifest() -> str:
    """The manifest's text; nothing where nothing was emitted. Raises Failure for one that cannot be read."""
    package, name = MANIFEST
    try:
        text = files(package).joinpath(name).read_text("utf-8")
        tomllib.loads(text)
    except (ModuleNotFoundError, FileNotFoundError):
        return ""
    except (OSError, ValueError) as error:
        raise Failure(f"generated/{name} cannot be read ({error}): `chasles emit` writes it anew") from error
    return text
