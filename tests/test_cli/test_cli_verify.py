"""`chasles verify` and `chasles summary`: right kernels pass, wrong ones do not, missing ones are named."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest
from click.testing import CliRunner, Result

from chasles.cli import chosen_chapter, comparison, main
from chasles.statements import Chapter, load

from ..sampling import sample

NAMES = ["cross_product_matrix", "rotation_from_axis_angle"]


def cross_product_matrix(v):
    x, y, z = np.moveaxis(v, -1, 0)
    o = np.zeros_like(x)
    return np.stack([o, -z, y, z, o, -x, -y, x, o], -1).reshape(*x.shape, 3, 3)


def rotation_from_axis_angle(e, phi):
    c, s = np.cos(phi)[..., None, None], np.sin(phi)[..., None, None]
    dyad = e[..., :, None] * e[..., None, :]
    return dyad + c * (np.eye(3, dtype=e.dtype) - dyad) + s * cross_product_matrix(e)


def backwards(e, phi):
    return rotation_from_axis_angle(e, -phi)


def careless_near_half_turns(e, phi):
    exact = rotation_from_axis_angle(e, phi)
    return np.where(np.abs(np.cos(phi) + 1)[..., None, None] < 0.001, np.nan, exact)


def run(*words: str) -> Result:
    return CliRunner(env={"COLUMNS": None}).invoke(main, list(words), prog_name="chasles")


@pytest.fixture
def installed(monkeypatch: pytest.MonkeyPatch):
    """The beginning of the book, and kernels for it."""
    whole = load()
    end = next(k for k, entry in enumerate(whole.entries) if entry.name == NAMES[-1]) + 1
    monkeypatch.setattr(chosen_chapter, "load", lambda package: Chapter(whole.title, whole.entries[:end]))

    def install(**others: object) -> None:
        kernels = {"cross_product_matrix": cross_product_matrix, "rotation_from_axis_angle": rotation_from_axis_angle}
        module = SimpleNamespace(backend="numpy", **{k: v for k, v in (kernels | others).items() if v is not None})
        monkeypatch.setattr(comparison, "installed_kernels", lambda book: module)

    install()
    return install


def shares_said(printed: str) -> dict[str, float]:
    """The largest error over what was allowed for it, by precision, as the last lines say."""
    (line,) = re.findall(r"^largest errors as a share of what .* explain: (.*)$", printed, re.MULTILINE)
    return {dtype: float(share) for share, dtype in re.findall(r"(\S+) in (\w+) \(\w+\)", line)}


def test_right_kernels_pass(installed) -> None:
    done = run("verify", "--samples", "20", "--points", "generic", "--points", "simple")
    assert (done.exit_code, done.stderr) == (0, "")
    assert all(re.search(rf"^{name} +✓ ", done.stdout, re.MULTILINE) for name in NAMES)
    assert "2 kernels (numpy) compared with 50 digits at 160 points" in done.stdout
    shares = shares_said(done.stdout)
    assert list(shares) == ["float64", "float32"]
    assert all(0 < share <= 1 for share in shares.values())


def test_a_wrong_kernel_fails(installed) -> None:
    installed(rotation_from_axis_angle=backwards)
    for words in (["verify", "--samples", "10"], ["summary", "--samples", "10"]):
        done = run(*words)
        assert done.exit_code == 1
        assert done.stderr == "chasles: not what the statements say: rotation_from_axis_angle\n"
    wrong = run("verify", "--samples", "10").stdout
    assert re.search(r"rotation_from_axis_angle +✗", wrong)
    assert all(share > 1 for share in shares_said(wrong).values())
    assert run("verify", "--samples", "10", "cross_product_matrix").exit_code == 0


def test_a_kernel_that_loses_digits_here_and_there_is_a_finding(installed) -> None:
    installed(rotation_from_axis_angle=careless_near_half_turns)
    words = ("verify", "--samples", "60")
    done = run(*words)
    assert (done.exit_code, done.stderr) == (0, "")
    assert re.search(r"rotation_from_axis_angle +≈", done.stdout)
    assert re.search(r"rotation_from_axis_angle  float64, generic points: \d+ of 60 lose digits", done.stdout)
    assert "at phi" in done.stdout
    assert "digits are lost near singular points by rotation_from_axis_angle" in done.stdout
    strict = run(*words, "--strict")
    assert strict.exit_code == 1
    assert strict.stderr == "chasles: these kernels lose digits: rotation_from_axis_angle\n"


def test_what_is_proved_stands_beside_what_is_measured(installed) -> None:
    installed()
    said = run("verify", "--samples", "2", "rotation_from_axis_angle").stdout
    assert re.search(r"rotation_from_axis_angle, proved: [\d.]+ u of the largest entry, for every unit e", said)
    assert "proved" not in run("verify", "--samples", "2").stdout


def test_as_data(installed) -> None:
    found = json.loads(run("verify", "--json", "--samples", "5", "cross_product_matrix").stdout)
    assert list(found) == ["backend", "seconds", "wrong", "lossy", "evidence", "proved"]
    assert [(each["kernel"], each["dtype"], each["samples"], each["passed"]) for each in found["evidence"]] == [
        ("cross_product_matrix", "float64", 5, True),
        ("cross_product_matrix", "float32", 5, True),
    ]


@pytest.mark.parametrize(
    ("other", "said"),
    [
        (None, "the kernels installed here (numpy) lack cross_product_matrix: run `chasles emit`, then `make compile`"),
        (lambda v: v, "cross_product_matrix cannot be compared with (2.38): "),
        (lambda v: cross_product_matrix(v).astype("float64"), "float32 of shape"),
    ],
)
def test_what_cannot_be_compared_is_named(installed, other, said: str) -> None:
    installed(cross_product_matrix=other)
    done = run("verify", "--samples", "2")
    assert done.exit_code == 1
    assert said in done.stderr
    assert done.stderr.count("\n") == 1


def test_no_kernels_is_one_line() -> None:
    command = (sys.executable, "-c", "from chasles.cli import main; main()", "verify")
    environment = {**os.environ, "CHASLES_BACKEND": "fortran"}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == "chasles: CHASLES_BACKEND is 'fortran'; expected 'c', 'numpy' or nothing\n"


def test_the_summary_adds_up(installed) -> None:
    done = run("summary", "--samples", "5")
    assert (done.exit_code, done.stderr) == (0, "")
    assert "General Rigid-Body Motion and Its Associated Screw" in done.stdout
    assert "2 kernels (numpy) compared with 50 digits at 20 points" in done.stdout
    data = json.loads(run("summary", "--samples", "5", "--json").stdout)
    assert list(data) == ["sections", "decided", "rechecked", "kernels"]
    (section,) = data["sections"]
    assert (section["section"], section["defined"], section["holds"], section["kernels"]) == ("3.2", 2, 0, 2)
    assert data["decided"]["statements"] == 2
    assert data["rechecked"]["rejected"] == []


def test_the_summary_has_a_row_for_each_section_and_a_total(monkeypatch: pytest.MonkeyPatch) -> None:
    from chasles.decisions.session import Session
    from chasles.report.decisions import summary_table, tallies
    from chasles.report.screen import Screen

    whole = load()
    entries = sample(whole.entries, 3)
    found = tallies(list(Session(book=whole).decide_all(entries)))
    assert [tally.number for tally in found] == list(dict.fromkeys(entry.section.number for entry in whole.entries))
    assert sum(sum(tally.verdicts.values()) for tally in found) == len(entries)
    (table,) = summary_table(Screen(), found)
    assert table.row_count == len(found) + 2
