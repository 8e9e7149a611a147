"""What is installed, which kernels run and whether they are up to date: as plain data, with what is wrong."""

from __future__ import annotations

import json
import os
import platform
import re
import subprocess
import sys
import sysconfig
import tomllib
import warnings
from collections.abc import Iterator, Mapping
from contextlib import suppress
from importlib import import_module, metadata
from pathlib import Path
from typing import Any

from chasles import __version__, cache
from chasles.report.closure import CHECKERS, lines

Data = dict[str, Any]
_BACKEND, _INSTRUCTIONS = "CHASLES_BACKEND", "CHASLES_INSTRUCTIONS"
_REQUIRED = re.compile(r"[A-Za-z0-9._-]+")
_EMITTED = "chasles.generated"
_EXTRAS = {"fast": "python-flint", "plots": "matplotlib"}
"""Extras that commands make use of where they are there."""


def examined() -> Data:
    """All that is found, by topic; what could not be found out is None."""
    kernels = _kernels()
    return {
        "chasles": _chasles(),
        "python": _python(),
        "libraries": {name: _version(name) for name in _required()},
        "extras": {name: _version(name) for name in _EXTRAS.values()},
        "kernels": kernels,
        "compiler": _compiler(kernels["instructions"] or ""),
        "generated": _generated(),
        "checker": {name: lines(name) for name in CHECKERS},
        "cache": _cache(),
    }


def problems(found: Mapping[str, Any]) -> Iterator[str]:
    """A line for each thing that is wrong, with what to do; none where all is well."""
    version, installed = found["chasles"]["version"], found["chasles"]["installed_version"]
    if installed != version:
        yield f"chasles is {version}, but what is installed says {installed}: install it again"
    missing = [name for name, seen in found["libraries"].items() if seen is None]
    if missing:
        yield f"required and not installed: {', '.join(missing)}; pip install {' '.join(missing)}"
    kernels, generated = found["kernels"], found["generated"]
    if kernels["error"]:
        yield f"the kernels do not load as asked: {kernels['error']}"
    if generated["error"]:
        yield f"whether the generated files are fresh cannot be told: {generated['error']}"
    for what, names in (("stale", generated["stale"]), ("missing", generated["missing"])):
        if names:
            yield f"generated kernels that are {what}: {_some(names)}; run `chasles emit`"
    if generated["superfluous"]:
        yield f"generated for no statement: {_some(generated['superfluous'])}; run `chasles emit`"
    if kernels["outdated"]:
        yield f"kernels installed here that differ from the generated ones: {_some(kernels['outdated'])}; install again"


def _some(names: list[str]) -> str:
    return ", ".join(names[:4]) + (f" and {len(names) - 4} more" if len(names) > 4 else "")


def _chasles() -> Data:
    folder = Path(__file__).parents[1]
    installed, editable = None, False
    with suppress(metadata.PackageNotFoundError, ValueError):
        distribution = metadata.distribution("chasles")
        installed = distribution.version
        origin = json.loads(distribution.read_text("direct_url.json") or "{}")
        editable = bool(origin.get("dir_info", {}).get("editable"))
    return {
        "version": __version__,
        "installed_version": installed,
        "folder": str(folder),
        "editable": editable,
    }


def _python() -> Data:
    enabled = getattr(sys, "_is_gil_enabled", lambda: True)()
    return {
        "version": platform.python_version(),
        "implementation": platform.python_implementation(),
        "executable": sys.executable,
        "system": f"{platform.system()} {platform.machine()}",
        "free_threaded": bool(sysconfig.get_config_var("Py_GIL_DISABLED")),
        "gil_enabled": enabled,
    }


def _required() -> list[str]:
    """What the installed distribution requires without extras."""
    try:
        lines = metadata.requires("chasles") or []
    except metadata.PackageNotFoundError:
        return []
    found = (_REQUIRED.match(line) for line in lines if "extra ==" not in line)
    return [match[0] for match in found if match]


def _version(name: str) -> str | None:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return None


def _kernels() -> Data:
    """Which kernels a program gets here, and whether they are those of the generated folder."""
    found: Data = {
        "backend": None, "asked": os.environ.get(_BACKEND) or None, "instructions": None, "best_instructions": None,
        "count": 0, "outdated": [], "note": None, "error": None,
    }  # fmt: skip
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            kernels = import_module("chasles.kernels")
        except ImportError as error:
            found["error"] = str(error)
            return found
    found["note"] = "; ".join(str(warning.message) for warning in caught) or None
    found["backend"] = kernels.backend
    found["instructions"] = kernels.instructions or None
    found["best_instructions"] = _best_instructions(kernels.instructions)
    emitted = _manifest().get("kernels", {})
    hashes = {name: str(getattr(kernels, name, None).__doc__) for name in emitted}
    found["count"] = sum(callable(getattr(kernels, name, None)) for name in emitted)
    found["outdated"] = [name for name, heading in hashes.items() if emitted[name]["derivation"] not in heading]
    return found


def _best_instructions(used: str) -> str | None:
    """The best that the compiled kernels can use on this machine; they choose it themselves where nothing insists."""
    if not os.environ.get(_INSTRUCTIONS):
        return used or None
    free = {name: value for name, value in os.environ.items() if name != _INSTRUCTIONS}
    code = "import chasles.kernels; print(chasles.kernels.instructions)"
    done = subprocess.run([sys.executable, "-c", code], env=free, capture_output=True, text=True, check=False)
    return done.stdout.strip() or None


def _compiler(instructions: str) -> Data | None:
    """The compiler that `chasles.compile` takes; None where there is none."""
    try:
        from chasles.compiling.compiler import found
    except ImportError:
        return None
    compiler = found(instructions)
    if compiler is None:
        return None
    return {"command": " ".join(compiler.command), "version": compiler.version.split("\n")[0]}


def _manifest() -> Data:
    """What was emitted; empty where that cannot be read."""
    try:
        folder = Path(str(import_module(_EMITTED).__file__)).parent
        return tomllib.loads((folder / "MANIFEST.toml").read_text("utf-8")) | {"folder": str(folder)}
    except (ImportError, OSError, ValueError):
        return {}


def _generated() -> Data:
    """Whether the generated kernels are those of the declarations, by the hashes of these; no file is compared."""
    found: Data = {"folder": None, "fresh": False, "stale": [], "missing": [], "superfluous": [], "error": None}
    manifest = _manifest()
    found["folder"] = manifest.get("folder")
    if not manifest:
        found["error"] = "there is no generated/MANIFEST.toml that can be read; `chasles emit` writes it"
        return found
    try:
        declared = _declared()
    except Exception as error:
        found["error"] = f"{type(error).__name__}: {error}"
        return found
    emitted = {name: kernel.get("derivation") for name, kernel in manifest.get("kernels", {}).items()}
    found["stale"] = [name for name, derivation in declared.items() if emitted.get(name, derivation) != derivation]
    found["missing"] = [name for name in declared if name not in emitted]
    found["superfluous"] = [name for name in emitted if name not in declared]
    found["fresh"] = not (found["stale"] or found["missing"] or found["superfluous"])
    return found


def _declared() -> dict[str, str]:
    """The hash of its declaration for each kernel that the book asks for."""
    from chasles.statements import load
    from chasles.statements.fingerprint import Fingerprints

    fingerprints = Fingerprints()
    return {kernel.name: fingerprints.of(entry.statement) for entry in load() for kernel in entry.kernels}


def _cache() -> Data:
    """The folder of verdicts and compiled expressions, and what lies there."""
    folder = cache.folder()
    if folder is None:
        return {"folder": None, "files": 0, "bytes": 0}
    sizes = []
    for file in folder.rglob("*"):
        with suppress(OSError):
            if file.is_file():
                sizes.append(file.stat().st_size)
    return {"folder": str(folder), "files": len(sizes), "bytes": sum(sizes)}
