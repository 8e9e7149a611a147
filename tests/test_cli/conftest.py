"""The command line as tests call it: in this process, or in one of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest
from click.testing import CliRunner, Result

from chasles.cli import chosen_chapter, main
from chasles.statements import Chapter, Entry, Section


def call(*words: str, **environment: str | None) -> Result:
    return CliRunner(env={"COLUMNS": None, **environment}).invoke(main, list(words), prog_name="chasles")


def call_process(*words: str, **environment: str) -> subprocess.CompletedProcess[str]:
    command = (sys.executable, "-c", "from chasles.cli import main; main()", *words)
    kept = {key: value for key, value in os.environ.items() if key not in ("COLUMNS", "CHASLES_DEBUG")}
    return subprocess.run(command, env={**kept, **environment}, capture_output=True, text=True, check=False)


def decided(*words: str) -> list[dict]:
    done = call("decide", "--json", *words)
    assert done.exit_code == 0, done.stderr
    return json.loads(done.stdout)["statements"]


def toy(**statements: object) -> Chapter:
    """A chapter with one section that declares these."""
    section = Section("9.1", "A Toy")
    return Chapter("Toys", tuple(Entry(name, section, statement) for name, statement in statements.items()))


@pytest.fixture(scope="session")
def run():
    """Calls a command in this process."""
    return call


@pytest.fixture(scope="session")
def process():
    """Calls a command in a process of its own."""
    return call_process


@pytest.fixture(scope="session")
def records():
    """The records of `chasles decide --json`."""
    return decided


@pytest.fixture(scope="session")
def whole() -> list[dict]:
    """The records of the whole book."""
    return decided()


@pytest.fixture
def chapter_is(monkeypatch: pytest.MonkeyPatch):
    """Puts a chapter with the given statements in the book's place."""

    def replace(**statements: object) -> None:
        monkeypatch.setattr(chosen_chapter, "load", lambda package: toy(**statements))

    return replace
