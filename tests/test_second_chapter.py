"""A chapter outside the book: `examples/planar` is loaded, decided and emitted by what serves the book, unchanged."""

from __future__ import annotations

import cmath
import json
import math
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from fractions import Fraction
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner, Result

from chasles.cli import main
from chasles.statements import DeclarationError, load

ROOT = Path(__file__).resolve().parents[1]
PLANAR = ROOT / "examples" / "planar"
pytestmark = pytest.mark.skipif(not PLANAR.exists(), reason="needs the checkout")

VERDICTS = {
    "turn_is_orthogonal": "holds",
    "pole": "holds-under",
    "velocity_of_point": "holds",
    "instant_center": "holds-under",
    "velocity_from_center": "holds-under",
    "acceleration_of_point": "fails",
    "three_centers": "holds-under",
    "slider_velocity": "holds-under",
    "freudenstein": "holds-under",
}


@pytest.fixture(autouse=True)
def _as_before(monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Chapters that a test imports are forgotten, and so is where it looked for them."""
    monkeypatch.setattr(sys, "path", list(sys.path))
    yield
    elsewhere = (PLANAR, tmp_path_factory.getbasetemp())
    for name, module in list(sys.modules.items()):
        place = getattr(module, "__file__", None)
        if place and any(Path(place).is_relative_to(folder) for folder in elsewhere):
            del sys.modules[name]


def run(*words: str, chapter: str | Path = f"{PLANAR}") -> Result:
    return CliRunner(env={"COLUMNS": None}).invoke(main, ["--chapter", str(chapter), *words], prog_name="chasles")


def decided(*words: str, chapter: str | Path = PLANAR) -> dict[str, dict[str, Any]]:
    done = run("decide", "--json", *words, chapter=chapter)
    assert done.exit_code == 0, done.stderr
    return {record["name"]: record for record in json.loads(done.stdout)["statements"]}


def refused(*words: str, chapter: str | Path) -> str:
    """The one line that is said of bad input."""
    done = run(*words, chapter=chapter)
    assert done.exit_code == 2
    assert done.stdout == ""
    assert done.stderr.count("\n") == 1
    return done.stderr


# The sample.


def test_the_verdicts_on_the_sample() -> None:
    records = decided()
    assert {name: r["verdict"] for name, r in records.items() if r["role"] == "claim"} == VERDICTS
    assert {r["verdict"] for r in records.values() if r["role"] != "claim"} == {"defined", "posed"}
    assert records["pole"]["needs"] == ["phi != 0"]
    assert records["instant_center"]["needs"] == ["omega != 0"]
    assert records["three_centers"]["needs"] == ["omega_1 != omega_2", "omega_1 != omega_3", "omega_2 != omega_3"]


def test_the_engine_knows_nothing_of_the_sample() -> None:
    sources = [path for path in (ROOT / "src").rglob("*.py") if "planar" in path.read_text("utf-8").split()]
    assert not sources


def test_the_misprint_is_refuted_by_a_point_that_can_be_evaluated_by_hand() -> None:
    at = {
        name: Fraction(value) for name, value in decided("2.6")["acceleration_of_point"]["counterexample"]["at"].items()
    }
    c, s, w, alpha = at["cos(phi)"], at["sin(phi)"], at["phi_dot"], at["phi_ddot"]
    assert c * c + s * s == 1
    x, y = c * at["r_1"] - s * at["r_2"], s * at["r_1"] + c * at["r_2"]
    true = (at["a_ddot_1"] - alpha * y - w * w * x, at["a_ddot_2"] + alpha * x - w * w * y)
    printed = (at["a_ddot_1"] - alpha * y + w * w * x, at["a_ddot_2"] + alpha * x + w * w * y)
    found = decided("2.6")["acceleration_of_point"]["counterexample"]
    row = found["entry"][0] - 1
    assert (Fraction(found["lhs"]), Fraction(found["rhs"])) == (true[row], printed[row])
    assert true != printed


def test_the_misprint_is_repaired_and_the_road_comes_to_the_repaired_form() -> None:
    record = decided("2.6")["acceleration_of_point"]
    assert record["corrected"]["text"] == "p_ddot = a_ddot + omega_dot E (p - a) - omega^2 (p - a)"
    assert (record["corrected"]["found"], record["corrected"]["verdict"]) == ("repair", "holds")
    assert "the sign of omega^2 (p - a) is turned" in run("repair").stdout
    walked = run("derive", "2.6")
    assert walked.exit_code == 0
    assert "equal to the printed equation as repaired" in walked.stdout


def test_the_verdict_is_on_what_is_declared(tmp_path: Path) -> None:
    copy = shutil.copytree(PLANAR, tmp_path / "planar_corrected", ignore=shutil.ignore_patterns("__pycache__"))
    section = copy / "s02_velocity.py"
    right = section.read_text("utf-8").replace("+ omega**2 * paren(p - a)", "- omega**2 * paren(p - a)")
    wrong = right.replace("a + over(1, omega) * E", "a - over(1, omega) * E")
    section.write_text(wrong, "utf-8")
    records = decided(chapter=copy)
    assert records["acceleration_of_point"]["verdict"] == "holds"
    assert records["instant_center"]["verdict"] == "fails"


def test_commands_show_the_chapter_and_nothing_of_the_book(tmp_path: Path) -> None:
    numbers = set(load(PLANAR).numbers)
    listed = json.loads(run("list", "--json").stdout)["statements"]
    assert {record["number"] for record in listed} == numbers
    assert "Aronhold" in run("show", "three_centers").stdout
    assert "the book has no equation '1.6'; near it: 2.6, 1.5" in refused("show", "1.6", chapter=PLANAR)
    done = run("report", "--out", str(tmp_path))
    assert done.exit_code == 0, done.stderr
    assert "1 of 1 derivations complete" in done.stdout
    page = (tmp_path / "index.html").read_text("utf-8")
    assert "Motion in a Plane" in page
    assert "Chasles" not in page
    assert 'id="n-2-6"' in page
    assert "n-3-18" not in page


def test_exercises_of_the_book_are_not_those_of_another_chapter() -> None:
    said = "there is no exercise '3.7'; planar.exercises would hold it, in a module x3_7"
    assert said in refused("solve", "3.7", chapter=PLANAR)
    assert said in refused("practice", "3.7", chapter=PLANAR)


# Its kernels.


@pytest.fixture(scope="module")
def emitted(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the sample with its kernels in it."""
    copy = tmp_path_factory.mktemp("elsewhere") / "planar_emitted"
    shutil.copytree(PLANAR, copy, ignore=shutil.ignore_patterns("__pycache__", "generated"))
    assert "there is no planar_emitted.generated" in run("verify", chapter=copy).stderr
    done = run("emit", chapter=copy)
    assert done.exit_code == 0, done.stderr
    return copy


@pytest.fixture
def kernels(emitted: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(emitted.parent)
    return import_module("planar_emitted.generated.numpy.kernels")


def as_complex(v: Any) -> complex:
    return complex(v[0], v[1])


def test_kernels_agree_with_complex_numbers(kernels: ModuleType) -> None:
    phi, a, a_, p = 0.7, np.array([1.0, 2.0]), np.array([-0.5, 4.0]), np.array([3.0, -1.0])
    moved = as_complex(a_) + cmath.exp(1j * phi) * as_complex(p - a)
    assert as_complex(kernels.displaced_point(phi, a, a_, p)) == pytest.approx(moved)
    c = kernels.pole(phi, a, a_)
    assert kernels.displaced_point(phi, a, a_, c) == pytest.approx(c)
    omega, v = 1.5, np.array([0.3, -2.0])
    center = kernels.instant_center(omega, v, a)
    assert kernels.velocity_of_point(omega, v, a, center) == pytest.approx(np.zeros(2), abs=1e-14)
    alpha, acceleration, z = -0.4, np.array([2.0, 5.0]), as_complex(p - a)
    expected = as_complex(acceleration) + (1j * alpha - omega**2) * z
    found = as_complex(kernels.acceleration_of_point(omega, alpha, acceleration, a, p))
    assert found == pytest.approx(expected), "the kernel is made of the repaired form"


def test_the_slider_moves_as_its_position_changes(kernels: ModuleType) -> None:
    crank, rod, theta, speed, step = 0.3, 1.1, 0.9, 2.0, 1e-6

    def rod_angle(theta: float) -> float:
        return -math.asin(crank * math.sin(theta) / rod)

    def position(theta: float) -> float:
        return crank * math.cos(theta) + rod * math.cos(rod_angle(theta))

    slope = (position(theta + step) - position(theta - step)) / (2 * step) * speed
    assert kernels.slider_velocity(crank, theta, speed, rod_angle(theta)) == pytest.approx(slope, rel=1e-8)


def test_the_kernels_are_compared_with_their_statements(emitted: Path) -> None:
    done = run("verify", "--json", "--samples", "10", chapter=emitted)
    assert done.exit_code == 0, done.stderr
    found = json.loads(done.stdout)
    assert (found["backend"], found["wrong"]) == ("numpy", [])
    assert {"pole", "slider_velocity"} <= {evidence["kernel"] for evidence in found["evidence"]}
    assert run("emit", "--check", chapter=emitted).exit_code == 0
    assert run("summary", "--samples", "5", chapter=emitted).exit_code == 0


@pytest.mark.skipif(shutil.which("cc") is None, reason="no C compiler on this machine")
def test_its_c_library_passes_its_self_test(emitted: Path, tmp_path: Path) -> None:
    c = emitted / "generated" / "c"
    sources = [str(path) for path in sorted((c / "src").glob("*.c"))]
    program = tmp_path / "self_test"
    flags = ["-std=c99", "-O1", f"-I{c / 'include'}"]
    subprocess.run(["cc", *flags, *sources, str(c / "test" / "self_test.c"), "-lm", "-o", str(program)], check=True)
    subprocess.run([str(program)], check=True)


# Where a chapter is looked for.


SMALL = """
from chasles.statements import Claim, Definition, Section, Theorem
from chasles.vocabulary import scalar, vector
section = Section("1", "One")
x = scalar("x", "x", "a number")
claim = Claim("1.1", x + x, 2 * x, says="Twice.")
"""


@pytest.fixture
def write(tmp_path: Path) -> Callable[..., Path]:
    """Writes a package of declarations and returns its folder."""

    def package(name: str, **modules: str) -> Path:
        (tmp_path / name).mkdir()
        for module, text in modules.items():
            (tmp_path / name / f"{module}.py").write_text(text, "utf-8")
        return tmp_path / name

    return package


def test_by_name_from_the_current_folder_and_from_where_python_looks(
    write: Callable[..., Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write("a_small_chapter", __init__='SECTIONS = ("one",)\n', one=SMALL)
    assert "there is no chapter 'a_small_chapter'" in refused("decide", chapter="a_small_chapter")
    monkeypatch.chdir(tmp_path)
    assert list(decided(chapter="a_small_chapter")) == ["claim"]
    assert list(decided(chapter="./a_small_chapter")) == ["claim"]
    assert load("a_small_chapter").package == "a_small_chapter"


def test_a_chapter_without_kernels_is_summed_up(write: Callable[..., Path]) -> None:
    folder = write("without_kernels", __init__="SECTIONS = ('one',)", one=SMALL)
    done = run("summary", chapter=folder)
    assert done.exit_code == 0, done.stderr
    assert "1 statement: 1 hold" in done.stdout
    assert "0 kernels" in run("verify", chapter=folder).stdout


def test_what_is_installed_comes_before_the_current_folder(
    write: Callable[..., Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert "wsgiref" not in sys.modules, "it would be found there, wherever Python looks"
    write("wsgiref", __init__='SECTIONS = ("one",)\n', one=SMALL)
    monkeypatch.chdir(tmp_path)
    assert "rename the folder" in refused("list", chapter="./wsgiref")
    assert "wsgiref has no SECTIONS" in refused("list", chapter="wsgiref")
    del sys.modules["wsgiref"]


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("modules", "said"),
    [
        ({}, "there is no __init__.py in it"),
        ({"__init__": ""}, "has no SECTIONS"),
        ({"__init__": "SECTIONS = ()"}, "has no statements"),
        ({"__init__": "SECTIONS = ('one')", "one": SMALL}, "are a text, 'one'"),
        ({"__init__": "SECTIONS = ('two',)", "one": SMALL}, "lists 'two' among its SECTIONS, and there is no such"),
        ({"__init__": "SECTIONS = ('one',)", "one": SMALL.split("claim")[0]}, "has no statements"),
        (
            {"__init__": "SECTIONS = ('one',)", "one": f"{SMALL}again = Claim('1.1', x, x)\n"},
            "claim and again are both declared as (1.1), part 1: give the second another `part`",
        ),
        ({"__init__": "SECTIONS = ('one',)\nUNIT = False", "one": SMALL}, "line 2: nothing reads UNIT: write UNITS"),
        ({"__init__": "SECTIONS = ('one',)\nTITLE = 3", "one": SMALL}, "line 2: TITLE is 3: make it a text"),
        (
            {"__init__": "SECTIONS = ('one',)\nCONVENTIONS = 'one'", "one": SMALL},
            "CONVENTIONS is 'one': make it a tuple of texts",
        ),
        *(
            ({"__init__": "SECTIONS = ('one',)", "one": SMALL + said}, f"one.py, line 7: {told}")
            for said, told in (
                ("twice = Definition('1.2', 2 * x, x)\n", "twice (1.2) defines 2 x, which is no symbol"),
                ("empty = Theorem('1.2', 'it holds', ())\n", "empty (1.2) has no forms: they are what it says"),
                ("by = Claim('1.2', x, x, by=2)\n", "by (1.2) is said to be multiplied by 2, and not what"),
                (
                    "other = Claim('1.2', x, x, reading=vector('v', 'v', ''))\n",
                    "other (1.2) has another form",
                ),
                ("void = Claim(' ', x, x)\n", "void ( ) has no number"),
                ("c = Claim('1.2', x, scalar('l', ' ', ''))\n", "c (1.2) is about 'l': declare it with a name and a"),
            )
        ),
        ({"__init__": "SECTIONS = ('one',)", "one": "import none_such\n"}, "one.py, line 1: ModuleNotFoundError"),
        ({"__init__": "SECTIONS = ('one',)", "one": SMALL.replace("2 * x", "2 * y")}, "one.py, line 6: NameError"),
    ],
)
def test_a_chapter_that_does_not_stand_is_refused(
    write: Callable[..., Path], modules: dict[str, str], said: str
) -> None:
    assert said in refused("decide", chapter=write("a_broken_chapter", **modules))


def test_a_folder_that_cannot_be_a_package_is_named(write: Callable[..., Path], tmp_path: Path) -> None:
    folder = write("my-chapter", __init__="SECTIONS = ('one',)", one=SMALL)
    assert "'my-chapter' is no name of a Python package; rename the folder" in refused("decide", chapter=folder)
    assert "there is no __init__.py in it" in refused("decide", chapter=tmp_path / "nowhere")
    with pytest.raises(DeclarationError, match="rename the folder"):
        load(folder)
    with pytest.raises(ModuleNotFoundError):
        load("no_such.chapter")
    assert "there is no chapter 'no_such.chapter'" in refused("decide", chapter="no_such.chapter")


def test_two_folders_of_one_name_are_not_confused(write: Callable[..., Path], tmp_path: Path) -> None:
    first = write("one_name", __init__="SECTIONS = ('one',)", one=SMALL)
    second = shutil.copytree(first, tmp_path / "below" / "one_name")
    assert load(first).package == load(first).package == "one_name"
    with pytest.raises(DeclarationError, match=r"one_name is .* already; rename the folder"):
        load(second)
