"""What is installed, compiled, dispatched and fresh, and what is wrong where it is not."""

from __future__ import annotations

import json
import os
import platform
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import chasles
from chasles import kernels
from chasles.cli import diagnosis
from chasles.cli.diagnosis import problems

TOPICS = ["chasles", "python", "libraries", "extras", "kernels", "compiler", "generated", "checker", "cache"]


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    return diagnosis.examined()


def test_all_is_well_here(run) -> None:
    done = run("doctor")
    assert (done.exit_code, done.stderr) == (0, "")
    for word in (chasles.__version__, platform.python_version(), f"numpy {np.__version__}", "python-flint"):
        assert word in done.stdout
    assert "as the declarations ask for" in done.stdout


def test_as_data(run, found: dict[str, Any]) -> None:
    printed = json.loads(run("doctor", "--json").stdout)
    assert list(printed) == [*TOPICS, "problems"]
    assert printed == json.loads(json.dumps(found)) | {"problems": []}
    assert printed["chasles"]["folder"] == str(Path(str(chasles.__file__)).parent)
    assert printed["kernels"]["backend"] == kernels.backend
    assert printed["kernels"]["count"] == len(set(dir(kernels)) - {"array_api", "backend", "instructions", "one"})
    assert printed["kernels"]["instructions"] == (kernels.instructions or None)
    assert printed["libraries"]["numpy"] == np.__version__
    assert set(printed["libraries"]) >= {"sympy", "click", "rich", "jinja2", "platformdirs"}
    assert printed["generated"]["fresh"] is True


@pytest.mark.parametrize(
    ("topic", "change", "said"),
    [
        ("chasles", {"installed_version": "0.0.9"}, "what is installed says 0.0.9"),
        ("libraries", {"sympy": None}, "required and not installed: sympy; pip install sympy"),
        ("kernels", {"error": "none to be had"}, "the kernels do not load as asked: none to be had"),
        ("kernels", {"outdated": ["power"]}, "differ from the generated ones: power; install again"),
        ("generated", {"stale": list("abcdef")}, "that are stale: a, b, c, d and 2 more; run `chasles emit`"),
        ("generated", {"missing": ["power"]}, "that are missing: power"),
        ("generated", {"superfluous": ["power"]}, "for no statement: power"),
        ("generated", {"error": "unreadable"}, "cannot be told: unreadable"),
    ],
)
def test_what_is_wrong_is_said_with_what_to_do(
    run, monkeypatch: pytest.MonkeyPatch, found: dict[str, Any], topic: str, change: dict[str, Any], said: str
) -> None:
    assert list(problems(found)) == []
    broken = found | {topic: found[topic] | change}
    monkeypatch.setattr(diagnosis, "examined", lambda: broken)
    done = run("doctor")
    assert done.exit_code == 1
    assert said in done.stderr
    assert done.stderr.count("\n") == 1


def test_a_declaration_that_has_changed_makes_its_kernels_stale(monkeypatch: pytest.MonkeyPatch) -> None:
    declared = diagnosis._declared()
    assert diagnosis._generated()["fresh"]
    changed = {
        name: "0" * 64 if name == "power" else value for name, value in declared.items() if name != "inertia_dyad"
    }
    monkeypatch.setattr(diagnosis, "_declared", lambda: changed | {"newcomer": "1" * 64})
    state = diagnosis._generated()
    assert (state["fresh"], state["stale"], state["missing"], state["superfluous"]) == (
        False,
        ["power"],
        ["newcomer"],
        ["inertia_dyad"],
    )


def test_declarations_that_do_not_stand_are_a_finding(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail() -> dict[str, str]:
        raise ValueError("no")

    monkeypatch.setattr(diagnosis, "_declared", fail)
    assert diagnosis._generated()["error"] == "ValueError: no"


def test_kernels_of_another_emission_are_outdated(monkeypatch: pytest.MonkeyPatch) -> None:
    manifest = diagnosis._manifest()
    power = manifest["kernels"]["power"] | {"derivation": "0" * 64}
    changed = manifest | {"kernels": manifest["kernels"] | {"power": power}}
    monkeypatch.setattr(diagnosis, "_manifest", lambda: changed)
    assert diagnosis._kernels()["outdated"] == ["power"]


@pytest.mark.skipif(kernels.backend != "c", reason="needs compiled kernels")
def test_what_is_asked_for_is_told_from_what_could_be_had(process) -> None:
    data = json.loads(process("doctor", "--json", CHASLES_INSTRUCTIONS="baseline").stdout)["kernels"]
    assert data["instructions"] == "baseline"
    if "CHASLES_INSTRUCTIONS" not in os.environ:
        assert data["best_instructions"] == kernels.instructions


def test_kernels_that_do_not_load_are_said(process) -> None:
    done = process("doctor", "--json", CHASLES_BACKEND="fortran")
    assert done.returncode == 1
    assert "CHASLES_BACKEND is 'fortran'" in done.stderr
    assert json.loads(done.stdout)["kernels"]["backend"] is None


def test_the_cache_is_measured(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (tmp_path / "compiled").mkdir()
    (tmp_path / "compiled" / "a.so").write_bytes(b"12345")
    (tmp_path / "verdicts.json").write_bytes(b"123")
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path))
    assert diagnosis._cache() == {"folder": str(tmp_path), "files": 2, "bytes": 8}
    monkeypatch.setenv("CHASLES_CACHE", "")
    assert diagnosis._cache()["folder"] is None


def test_no_compiler_is_no_fault(monkeypatch: pytest.MonkeyPatch, found: dict[str, Any]) -> None:
    monkeypatch.setenv("CC", "no-such-compiler")
    assert diagnosis._compiler("") is None
    assert list(problems(found | {"compiler": None})) == []


def test_free_threading_is_read_from_the_interpreter(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "_is_gil_enabled", lambda: False, raising=False)
    monkeypatch.setattr(diagnosis.sysconfig, "get_config_var", lambda name: 1)
    assert (diagnosis._python()["free_threaded"], diagnosis._python()["gil_enabled"]) == (True, False)
