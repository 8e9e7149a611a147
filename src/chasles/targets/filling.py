"""How a template becomes text: by Jinja, which compiles it once, as Python does a module, and in the same folder."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from contextlib import suppress
from functools import cache
from importlib.util import cache_from_source
from pathlib import Path
from pickle import UnpicklingError

import jinja2
from jinja2.bccache import Bucket

from chasles.cache import keep


class _Layout(jinja2.Environment):
    """Templates in which a key of a table is never taken for a method of Python's dictionaries."""

    def getattr(self, obj: object, attribute: str) -> object:
        if isinstance(obj, Mapping) and hasattr(dict, attribute):
            raise jinja2.TemplateRuntimeError(
                f"the key {attribute!r} is the name of a method of dictionaries: rename it"
            )
        return super().getattr(obj, attribute)


class _Bytecode(jinja2.BytecodeCache):
    """What templates were compiled to; a file that cannot be read or written is none."""

    def get_cache_key(self, name: str, filename: str | None = None) -> str:
        return cache_from_source(filename or name)

    def get_source_checksum(self, source: str) -> str:
        return super().get_source_checksum(f"{jinja2.__version__} {source}")

    def load_bytecode(self, bucket: Bucket) -> None:
        with suppress(OSError, EOFError, UnpicklingError), Path(bucket.key).open("rb") as file:
            bucket.load_bytecode(file)

    def dump_bytecode(self, bucket: Bucket) -> None:
        if not sys.dont_write_bytecode:
            with suppress(OSError):
                Path(bucket.key).parent.mkdir(exist_ok=True)
                keep(Path(bucket.key), bucket.bytecode_to_string())


@cache
def layout(templates: Path) -> jinja2.Environment:
    """The templates of a folder."""
    return _Layout(
        loader=jinja2.FileSystemLoader(templates),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
        bytecode_cache=_Bytecode(),
    )
