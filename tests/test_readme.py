"""Every block of the README is executed, or found where it says it stands."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(\w+)\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)


def blocks(language: str) -> list[str]:
    return [text for kind, text in BLOCKS if kind == language]


def normal(text: str) -> list[str]:
    """The lines without what differs from run to run: times, and blanks at the end."""
    return [re.sub(r"\d+(\.\d+)? m?s\b", "TIME", line).rstrip() for line in text.strip().splitlines()]


def is_declaration(text: str) -> bool:
    return text.startswith("screw_axis_point = Claim(")


def test_every_block_is_of_a_kind_that_is_tested():
    assert {kind for kind, _ in BLOCKS} == {"python", "console", "c"}


@pytest.mark.parametrize("text", [b for b in blocks("python") if not is_declaration(b)])
def test_python_runs(text: str):
    exec(compile(text, "README.md", "exec"), {})


def test_the_declaration_is_the_books():
    [declaration] = [b for b in blocks("python") if is_declaration(b)]
    assert declaration in (ROOT / "derivations" / "s02_screw.py").read_text(encoding="utf-8")


@pytest.mark.parametrize("text", blocks("console"))
def test_console_prints_what_is_shown(text: str):
    command, expected = text.removeprefix("$ chasles ").split("\n", 1)
    environment = os.environ | {"NO_COLOR": "1", "COLUMNS": "120", "PYTHONIOENCODING": "utf-8"}
    program = [sys.executable, "-c", "from chasles.cli import main; main()", *command.split()]
    done = subprocess.run(program, capture_output=True, text=True, env=environment, cwd=ROOT, check=True)
    assert normal(done.stdout) == normal(expected)


@pytest.mark.parametrize("text", blocks("c"))
def test_c_is_as_generated(text: str):
    sources = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "generated" / "c" / "src").glob("*.c"))
    assert text.strip() in sources
