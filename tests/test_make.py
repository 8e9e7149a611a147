"""What `make` says where it cannot go on: the reason, and what to do."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
NOBODY = 65534

pytestmark = [
    pytest.mark.skipif(not (ROOT / "Makefile").exists(), reason="needs the checkout"),
    pytest.mark.skipif(shutil.which("make") is None, reason="no make on this machine"),
]


@pytest.fixture
def checkout() -> Iterator[Path]:
    """A folder with the Makefile, which every user may read."""
    with tempfile.TemporaryDirectory(prefix="größer & ") as name:
        folder = Path(name)
        shutil.copy(ROOT / "Makefile", folder)
        (folder / "pyproject.toml").write_text("", "utf-8")
        folder.chmod(0o755)
        yield folder


def made(checkout: Path, python: str, **options: int) -> str:
    """What `make` says on standard error where it fails."""
    command = ["make", f"PYTHON={python}", ".venv/pyvenv.cfg"]
    done = subprocess.run(command, cwd=checkout, capture_output=True, text=True, check=False, **options)
    assert done.returncode == 2
    assert not (checkout / ".venv").exists()
    return done.stderr


def imitation(checkout: Path, *lines: str) -> str:
    """A Python in the checkout that does as the lines say."""
    program = checkout / "python"
    program.write_text("\n".join(("#!/bin/sh", *lines, "exit 0", "")), "utf-8")
    program.chmod(0o755)
    return "./python"


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="a POSIX matter")
def test_a_folder_that_cannot_be_written_is_named(checkout: Path) -> None:
    checkout.chmod(0o555)
    # Root may write everywhere.
    said = made(checkout, sys.executable, **({"user": NOBODY, "group": NOBODY} if os.geteuid() == 0 else {}))
    checkout.chmod(0o755)
    assert "This folder cannot be written" in said
    assert str(checkout) in said
    assert "python3-venv" not in said


def test_a_python_without_ensurepip_needs_a_package(checkout: Path) -> None:
    said = made(checkout, imitation(checkout, 'case "$2" in *ensurepip*) exit 1;; esac'))
    assert "install the Debian package python3-venv" in said


def test_a_python_that_is_too_old_is_named(checkout: Path) -> None:
    said = made(checkout, imitation(checkout, 'case "$2" in *version_info*) exit 1;; esac'))
    assert "needs Python 3.11 or newer" in said


def test_why_there_is_no_environment_is_passed_on(checkout: Path) -> None:
    lines = 'if test "$2" = venv; then mkdir .venv; echo "Error: the disk is full" >&2; exit 1; fi'
    said = made(checkout, imitation(checkout, lines))
    assert "Error: the disk is full" in said
    assert "what it says stands above" in said
    assert "python3-venv" not in said


def test_the_quick_tests_are_there() -> None:
    said = subprocess.run(["make", "--dry-run", "quick"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    files = re.findall(r"tests/test_[a-z_/]+\.py", said)
    assert len(files) > 30
    assert [file for file in files if not (ROOT / file).is_file()] == []
