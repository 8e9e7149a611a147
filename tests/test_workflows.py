"""The workflows of the code host: what they run exists, and what they build is what is promised."""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / ".github" / "workflows"
FILES = ("ci.yml", "wheels.yml")
RUNNERS = {"ubuntu-24.04", "ubuntu-24.04-arm", "macos-15", "macos-15-intel", "windows-2022"}
GIVEN = re.compile(r"\$\{\{ *([a-z.]+) *\}\}")

pytestmark = pytest.mark.skipif(not FOLDER.exists(), reason="needs the checkout")


def read(name: str) -> dict[Any, Any]:
    return yaml.safe_load((FOLDER / name).read_text("utf-8"))


def jobs() -> Iterator[tuple[str, dict[str, Any]]]:
    for name in FILES:
        yield from ((f"{name}: {job}", found) for job, found in read(name)["jobs"].items())


def rows(job: dict[str, Any]) -> list[dict[str, str]]:
    """The values of each run of a job."""
    matrix = job.get("strategy", {}).get("matrix", {})
    return matrix.get("include") or [{"os": system} for system in matrix.get("os", [])] or [{}]


def filled(text: str, row: dict[str, str]) -> str:
    return GIVEN.sub(lambda match: row.get(match[1].removeprefix("matrix."), match[0]), text)


@pytest.mark.parametrize("name", FILES)
def test_a_workflow_says_when_it_runs_and_may_only_read(name: str) -> None:
    workflow = read(name)
    # YAML reads the key `on` as the truth value.
    assert "workflow_dispatch" in workflow[True]
    assert workflow["permissions"] == {"contents": "read"}
    for job_name, job in workflow["jobs"].items():
        assert job.get("permissions") == ({"id-token": "write"} if job_name == "publish" else None)
        assert set(job) >= {"name", "runs-on", "timeout-minutes", "steps"}
        assert set(job.get("needs", [])) <= set(workflow["jobs"])
        assert all(("uses" in step) != ("run" in step) for step in job["steps"])


def test_every_run_is_on_a_system_that_there_is_and_every_variable_is_given() -> None:
    for name, job in jobs():
        for row in rows(job):
            assert filled(job["runs-on"], row) in RUNNERS, name
            for text in [job["name"], *(step.get("run", "") for step in job["steps"])]:
                assert "matrix." not in filled(text, row), name


def test_actions_are_of_a_fixed_version() -> None:
    used = [step["uses"] for _, job in jobs() for step in job["steps"] if "uses" in step]
    assert used
    assert [action for action in used if not re.fullmatch(r"[a-z-]+/[a-z-]+@v\d+(\.\d+)*", action)] == []


def test_scripts_are_shell_and_name_files_and_targets_that_there_are() -> None:
    targets = set(re.findall(r"^([a-z]+):", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE))
    lines = [line for _, job in jobs() for step in job["steps"] for line in step.get("run", "").splitlines()]
    for _, job in jobs():
        for step in job["steps"]:
            script = filled(step.get("run", ""), rows(job)[0])
            subprocess.run(["sh", "-n"], input=script, text=True, check=True)
    named = {word for line in lines for word in re.findall(r"(?<![\w.])(tests/[\w/.]+|\.ci/\w+)", line)}
    assert {".ci/run", ".ci/oldest", ".ci/bare"} <= named
    assert "tests/test_portability.py" in named
    assert [path for path in named if not (ROOT / path).exists()] == []
    made = {word for line in lines for word in re.findall(r"\bmake ([a-z]+)", line)}
    assert "test" in made
    assert made <= targets


def test_each_system_and_compiler_is_there() -> None:
    text = (FOLDER / "ci.yml").read_text("utf-8")
    for word in ("gcc", "clang", "MSVC", "ClangCL", "macos", "windows", "-arm", "3.14t", "qemu-user", "mingw"):
        assert word in text, word


def test_the_wheels_are_for_the_first_interpreter_and_the_free_threaded_one() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    wheels, scripts = project["tool"]["cibuildwheel"], project["tool"]["scikit-build"]["wheel"]
    first = scripts["py-api"]
    assert project["project"]["requires-python"] == f">=3.{first.removeprefix('cp3')}"
    assert wheels["build"][0] == f"{first}-*"
    assert "cp314t-*" in wheels["build"]
    assert wheels["environment"] == {"CHASLES_REQUIRE_C": "1"}
    assert [command.split()[:2] for command in wheels["test-command"]] == [
        ["chasles", "decide"], ["chasles", "solve"], ["chasles", "doctor"], ["python", "-c"],
    ]  # fmt: skip


def test_as_many_wheels_are_counted_as_there_are_systems() -> None:
    wheels = read("wheels.yml")["jobs"]
    systems = wheels["compiled"]["strategy"]["matrix"]["os"]
    counted = wheels["all"]["steps"][-1]["run"]
    assert re.findall(r"-eq (\d+)", counted) == [str(len(systems)), str(len(systems)), "2"]


@pytest.mark.parametrize(
    "form", sorted((ROOT / ".github" / "ISSUE_TEMPLATE").glob("*.yml")), ids=lambda path: path.stem
)
def test_an_issue_form_asks_for_what_it_takes(form: Path) -> None:
    said = yaml.safe_load(form.read_text("utf-8"))
    assert said["name"]
    assert said["description"]
    asked = {field["id"]: field for field in said["body"]}
    assert len(asked) == len(said["body"]) >= 2
    assert all(field["attributes"]["label"] for field in asked.values())
    assert any(field.get("validations", {}).get("required") for field in asked.values())


def test_only_a_tag_is_published_and_only_once_all_was_looked_at() -> None:
    jobs = read("wheels.yml")["jobs"]
    publish = jobs["publish"]
    assert publish["needs"] == ["all", "tested"]
    assert jobs["tested"]["env"]["CHASLES_TEST_WHOLE"] == "1"
    assert jobs["tested"]["steps"][-1] == {"run": "make test"}
    assert publish["if"] == "startsWith(github.ref, 'refs/tags/v')"
    assert publish["environment"] == "pypi"


def test_the_oldest_versions_are_those_that_are_allowed() -> None:
    said = subprocess.run([sys.executable, ROOT / ".ci" / "oldest"], capture_output=True, text=True, check=True).stdout
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert len(said.splitlines()) >= len(project["dependencies"])
    for line in said.splitlines():
        name, least = line.removesuffix(".*").split("==")
        wanted = [*project["dependencies"], *project["optional-dependencies"]["fast"]]
        wanted += project["optional-dependencies"]["plots"]
        assert any(each.startswith(f"{name}>={least}") for each in wanted), line


def test_what_is_published_says_where_the_source_is(tmp_path: Path) -> None:
    """The address is put into copies; the links of the README then work where the files beside it are not."""
    for name in ("pyproject.toml", "README.md", ".ci/published"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes((ROOT / name).read_bytes())
    for _ in range(2):
        subprocess.run([sys.executable, tmp_path / ".ci/published", "https://example.org/us/chasles/"], check=True)
        text = (tmp_path / "pyproject.toml").read_text("utf-8")
        assert tomllib.loads(text)["project"]["urls"]["Source"] == "https://example.org/us/chasles"
        places = re.findall(r"\]\(([^)]*)\)", (tmp_path / "README.md").read_text("utf-8"))
        kept = [re.fullmatch(r"https://example\.org/us/chasles/(?:blob|raw)/main/(.+)", place) for place in places]
        assert len(kept) > 10
        assert all(found and (ROOT / found[1]).exists() for found in kept)
    builds = re.compile("cibuildwheel|build --sdist")
    built = [job for _, job in jobs() if builds.search(str(job["steps"]))]
    assert len(built) == 2
    assert all(any(".ci/published" in step.get("run", "") for step in job["steps"]) for job in built)
