"""For all tests: how to renew the golden files, and where a test says what it found."""

from __future__ import annotations

import gc
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from chasles.coq.checking import compile_theories

from .sampling import WHOLE, kept_and_left_out

# How long an example takes says nothing on a machine that does other things too; a sample is always the same one.
UNTIMED = {"deadline": None, "suppress_health_check": [HealthCheck.too_slow]}
settings.register_profile("untimed", **UNTIMED, max_examples=100 if WHOLE else 40, derandomize=not WHOLE)
settings.load_profile("untimed")

# Some hundred processes are started here: what they import is compiled once for all of them.
sys.dont_write_bytecode = False
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)

# No test sees what another run has decided.
os.environ["CHASLES_CACHE"] = ""

FEWER_ROADS = """
from chasles.cli import main, reporting

roads_of = reporting._roads_of
reporting._roads_of = lambda book: dict(list(roads_of(book).items())[::{every}])
main()
"""
"""A program that is the command, with one derivation in so many on the report."""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--update-golden", action="store_true", help="write the golden files anew instead of comparing")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Of tests that are marked `sampled`, a sample; see CONTRIBUTING.md for how the whole is run."""
    items[:], left_out = kept_and_left_out(items)
    if left_out:
        config.hook.pytest_deselected(items=left_out)


def pytest_collection_finish() -> None:
    """What is loaded by now stays: the garbage collector need not look at it again and again."""
    gc.freeze()
    gc.set_threshold(100_000, 20, 50)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """What tests recorded as their "report", also where they ran in another process."""
    for result in terminalreporter.getreports("passed"):
        for name, text in result.user_properties if result.when == "call" else ():
            if name == "report":
                terminalreporter.section(result.nodeid)
                terminalreporter.write_line(str(text))


@pytest.fixture(scope="session")
def made_once(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str, Callable[[Path], object]], Path]:
    """A folder that is filled once for all processes of a run, by the first that asks: `made_once(name, fill)`."""
    shared = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        shared = shared.parent

    def made(name: str, fill: Callable[[Path], object]) -> Path:
        folder = shared / name
        with only_one(shared / f"{name}.lock"):
            if not folder.exists():
                unfinished = shared / f"{name}.unfinished"
                shutil.rmtree(unfinished, ignore_errors=True)
                fill(unfinished)
                unfinished.rename(folder)
        return folder

    return made


@pytest.fixture(scope="session")
def hasty_compiler(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A C compiler that optimises nothing, for what is built and not timed; the usual one where the whole is tried."""
    compiler = os.environ.get("CC", "cc")
    if WHOLE or os.name != "posix":
        return compiler
    script = tmp_path_factory.mktemp("compiler") / "cc"
    script.write_text(f'#!/bin/sh\nexec {compiler} "$@" -O0\n', "utf-8")
    script.chmod(0o755)
    return str(script)


@pytest.fixture(scope="session")
def report(made_once: Callable[[str, Callable[[Path], object]], Path]) -> dict[str, str]:
    """The files that `chasles report` writes, with one derivation in four unless the whole is tried."""

    def write(folder: Path) -> None:
        command = [sys.executable, "-c", FEWER_ROADS.format(every=1 if WHOLE else 4), "report", "--out", str(folder)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr

    return {path.name: path.read_text("utf-8") for path in made_once("report", write).iterdir()}


@pytest.fixture(scope="session")
def kept(pytestconfig: pytest.Config, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """A folder by its name, kept from one run to the next: for tools that know themselves what is out of date in it."""
    cache = getattr(pytestconfig, "cache", None)
    return cache.mkdir if cache else tmp_path_factory.mktemp


@pytest.fixture(scope="session")
def coq_cache(kept: Callable[[str], Path], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A cache that has nothing but the theories for Coq, compiled; who adds to it makes a copy."""
    folder = kept("coq")
    with pytest.MonkeyPatch.context() as patch, only_one(folder / "lock"):
        patch.setenv("CHASLES_CACHE", str(folder))
        compile_theories(tmp_path_factory.mktemp("theories"))
        return shutil.copytree(folder, tmp_path_factory.mktemp("coq") / "cache")


@contextmanager
def only_one(lock: Path) -> Iterator[None]:
    """No two processes are in here at once, where the system has a lock for that."""
    with lock.open("w") as file:
        try:
            import fcntl
        except ImportError:
            pass
        else:
            fcntl.flock(file, fcntl.LOCK_EX)
        yield
