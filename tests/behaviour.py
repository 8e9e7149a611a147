"""What can be seen from outside, recorded, so that two states of the project can be compared byte for byte.

    python -m tests.behaviour record before.json
    python -m tests.behaviour compare before.json after.json

Everything is found anew, in an empty cache: the kernels and answers of the chapter and of the planar example, verdicts,
derivations, exercises, pages, help, signatures, and the answers to questions that are drawn by number.
"""

from __future__ import annotations

import inspect
import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from difflib import unified_diff
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).resolve().parents[1]
CHASLES = [sys.executable, "-m", "chasles"]
PLANAR = ["--chapter", str(ROOT / "examples" / "planar")]
COMMANDS = ("decide", "derive", "list", "practice", "repair", "report", "show", "solve", "summary", "verify", "emit")
PUBLIC = ("chasles", "chasles.vocabulary", "chasles.statements", "chasles.kernels", "chasles.checked")
QUESTIONS = 60
DRAWN = """
import sys
from tests.fuzzing.asking import ask, ask_statement
from tests.fuzzing.languages import LANGUAGES, draw_for
for name in sorted(LANGUAGES):
    for number in range(int(sys.argv[1])):
        asked = LANGUAGES[name].question(draw_for(name, 71, number))
        answer = ask_statement(asked.statement) if name == "declared" else ask(asked)
        print(name, number, answer.name, answer.words or repr(answer.verdict))
"""
TIMES = re.compile(r"\b[0-9.]+ m?s\b|\"(milli)?seconds\": [0-9.e-]+|0x[0-9a-f]{6,}")
"""Times and addresses in memory, which differ from run to run."""


def seen() -> Iterator[tuple[str, str]]:
    """The name of each thing that can be seen, and what it says; times are left out."""
    with TemporaryDirectory() as folder:
        for name, chapter in (("book", []), ("planar", PLANAR)):
            out = Path(folder) / name
            _printed(*CHASLES, *chapter, "emit", "--anew", "--out", str(out), cache=folder)
            yield from _files(f"emit {name}", out)
            for asked in (["decide", "--json"], ["decide"], ["derive", "--json"], ["derive"], ["list"]):
                yield f"{' '.join(asked)} {name}", _printed(*CHASLES, *chapter, *asked, cache=folder)
        out = Path(folder) / "report"
        _printed(*CHASLES, "report", "--out", str(out), cache=folder)
        yield from _files("report", out)
        yield "repair", _printed(*CHASLES, "repair", cache=folder)
        for number in _exercises():
            for command in ("solve", "practice"):
                for form in ([], ["--json"]):
                    asked = [command, number, *form]
                    yield " ".join(asked), _printed(*CHASLES, *asked, cache=folder)
        yield "drawn", _printed(sys.executable, "-c", DRAWN, str(QUESTIONS), cache=folder)
    for command in COMMANDS:
        yield f"{command} --help", _printed(*CHASLES, command, "--help", cache="")
    yield from _signatures()


def _printed(*command: str, cache: str) -> str:
    """The status, what is printed, and what is said of errors."""
    environment = {**os.environ, "CHASLES_CACHE": cache and str(Path(cache) / "cache"), "COLUMNS": "100"}
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
    text = f"{done.returncode}\n{done.stdout}\n{done.stderr}"
    return text.replace(cache, "FOLDER") if cache else text


def _files(name: str, folder: Path) -> Iterator[tuple[str, str]]:
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.suffix not in (".png", ".pdf"):
            yield f"{name}: {path.relative_to(folder)}", path.read_text("utf-8")


def _exercises() -> list[str]:
    from chasles.statements.exercises import exercise_numbers

    return list(exercise_numbers())


def _signatures() -> Iterator[tuple[str, str]]:
    for package in PUBLIC:
        module = import_module(package)
        for name in sorted(getattr(module, "__all__", dir(module))):
            found = getattr(module, name)
            try:
                said = str(inspect.signature(found))
            except (TypeError, ValueError):
                said = type(found).__name__
            yield f"{package}.{name}", said


def differences(before: dict[str, str], after: dict[str, str]) -> Iterator[str]:
    """What differs, one after the other, the first lines of each."""
    for name in sorted({*before, *after}):
        old, new = (TIMES.sub("TIME", each.get(name, "")).splitlines() for each in (before, after))
        if old != new:
            lines = [line[:160] for line in unified_diff(old, new, lineterm="", n=0)][2:]
            yield "\n".join([f"{name}: {len(lines)} lines", *lines[:6]])


def main(arguments: list[str]) -> int:
    match arguments:
        case ["record", file]:
            Path(file).write_text(json.dumps(dict(seen()), indent=0), "utf-8")
            return 0
        case ["compare", one, other]:
            found = list(differences(*(json.loads(Path(file).read_text("utf-8")) for file in (one, other))))
            print("\n".join(found) or "no byte differs")  # noqa: T201
            return 1 if found else 0
    print(__doc__, file=sys.stderr)  # noqa: T201
    return 2


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
