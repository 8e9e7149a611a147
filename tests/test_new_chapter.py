"""A chapter made by `chasles new`: decided, compiled, imported like the book, with nothing of the book in its files."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from chasles import kernels

PAGE = Path(__file__).resolve().parents[1] / "docs" / "chapter.md"
pytestmark = [
    pytest.mark.skipif(shutil.which("cc") is None, reason="no C compiler on this machine"),
    pytest.mark.skipif(not PAGE.exists(), reason="needs the checkout"),
]
OF_THE_BOOK = ("wist", "rench", "angular part", "Euler", "SI.", "`chasles.", "chasles._kernels", "derivations")


def run(*words: str, cwd: Path, status: int = 0, **environment: str) -> str:
    command = [sys.executable, "-m", "chasles", *words]
    done = subprocess.run(
        command, cwd=cwd, env={**os.environ, **environment}, capture_output=True, text=True, check=False
    )
    assert done.returncode == status, f"{done.stdout}\n{done.stderr}"
    assert "Traceback" not in done.stderr
    return done.stdout if status == 0 else done.stderr


def python(code: str, cwd: Path, **environment: str) -> str:
    command = [sys.executable, "-W", "error", "-c", code]
    done = subprocess.run(
        command, cwd=cwd, env={**os.environ, **environment}, capture_output=True, text=True, check=False
    )
    return done.stdout if done.returncode == 0 else done.stderr


@pytest.fixture(scope="module")
def fresh(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The chapter `mine` as it is written."""
    here = tmp_path_factory.mktemp("fresh")
    run("new", "mine", cwd=here)
    return here / "mine"


@pytest.fixture
def mine(fresh: Path, tmp_path: Path) -> Path:
    """A copy of that chapter, to be changed."""
    return shutil.copytree(fresh, tmp_path / "mine")


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory, hasty_compiler: str) -> tuple[Path, str]:
    """The folder in which the five commands of the manual have made the chapter `mybook`, and what they print."""
    block = PAGE.read_text("utf-8").partition("%%bash\n")[2].partition("```")[0]
    commands = block.strip().splitlines()
    assert (len(commands), commands[0]) == (5, "chasles new mybook")
    here, tools = tmp_path_factory.mktemp("shelf"), tmp_path_factory.mktemp("tools")
    (tools / "chasles").write_text(f'#!/bin/sh\nexec "{sys.executable}" -m chasles "$@"\n', "utf-8")
    (tools / "chasles").chmod(0o755)
    path = f"{tools}{os.pathsep}{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    environment = {**os.environ, "PATH": path, "CC": hasty_compiler, "CHASLES_CACHE": str(here / "cache")}
    done = subprocess.run(
        ["bash", "-e", "-c", block], cwd=here, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return here, done.stdout


@pytest.fixture(scope="module")
def book(made: tuple[Path, str]) -> Path:
    """The folder that holds the chapter `mybook`, built."""
    return made[0]


def test_the_five_commands_of_the_manual_lead_from_nothing_to_an_import(made: tuple[Path, str]) -> None:
    said = made[1]
    assert said.splitlines()[-1] == "[ 3.  4. -5.]"
    assert "5 statements: 3 hold under hypotheses, 2 defined" in said
    assert "2 kernels, proved and compiled" in said
    assert "from mybook import kernels" in said.splitlines()
    assert "q  (-49/9, -40/9, 7/9)" in said


def test_all_of_it_is_true(book: Path) -> None:
    records = json.loads(run("--chapter", "mybook", "decide", "--json", cwd=book))["statements"]
    assert {record["verdict"] for record in records} == {"defined", "holds-under"}


def test_its_kernels_are_imported_like_those_of_the_book(book: Path) -> None:
    code = (
        "import sys; from mybook import kernels as k; n, p = [0, 0, 1], [[3, 4, 5], [1, 1, 1]]\n"
        "print(k.backend, type(k.image_of_point).__name__, k.image_of_point(n, p).tolist(), k.instructions)\n"
        "import numpy as np; print(k.one.image_of_point(np.array(n, float), np.array([3., 4, 5])).tolist())\n"
        "print('sympy' in sys.modules, k.image_of_point.__signature__)\n"
        "k.checked.image_of_point([0, 0, 2], p)"
    )
    said = python(code, book)
    assert "ValueError: image_of_point: n" in said
    printed = python(code.rpartition("\n")[0], book).splitlines()
    expected = "c ufunc [[3.0, 4.0, -5.0], [1.0, 1.0, -1.0]]"
    assert printed[0] == f"{expected} {kernels.instructions}"
    assert printed[1] == "[3.0, 4.0, -5.0]"
    assert printed[2].startswith("False (n, p, /, *,")


def test_the_variables_of_the_book_choose_for_it_too(book: Path) -> None:
    code = (
        "from mybook import kernels as k; print(k.backend, k.instructions, k.point_from_image([0, 0, 1], [1, 2, 3])[2])"
    )
    assert python(code, book, CHASLES_BACKEND="numpy") == "numpy  -3.0\n"
    assert python(code, book, CHASLES_INSTRUCTIONS="baseline") == "c baseline -3.0\n"


def test_the_compiled_functions_are_compared_with_50_digits(book: Path) -> None:
    found = json.loads(run("--chapter", "mybook", "verify", "--json", "--samples", "7", cwd=book))
    assert (found["backend"], found["wrong"], found["lossy"]) == ("c", [], [])
    assert "2 kernels (c) compared" in run("--chapter", "mybook", "summary", "--samples", "3", cwd=book)
    run("--chapter", "mybook", "emit", "--check", cwd=book)


def test_its_test_passes(book: Path) -> None:
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "mybook"]
    done = subprocess.run(command, cwd=book, capture_output=True, text=True, check=False)
    assert " passed" in done.stdout
    assert "skipped" not in done.stdout
    assert done.returncode == 0, done.stdout


def test_its_files_say_its_own_conventions_and_none_of_the_book(book: Path) -> None:
    texts = {
        path: path.read_text("utf-8") for path in (book / "mybook").rglob("*.*") if path.suffix not in (".so", ".pyc")
    }
    generated = {path.relative_to(book).as_posix(): text for path, text in texts.items() if "generated" in path.parts}
    found = [(path, word) for path, text in generated.items() for word in OF_THE_BOOK if word in text]
    assert found == []
    for path in ("README.md", "kernels.py", "c/include/chasles.h"):
        assert "a normal points away from the mirror." in " ".join(generated[f"mybook/generated/{path}"].split())


def test_kernels_that_were_written_elsewhere_are_found(book: Path, hasty_compiler: str, tmp_path: Path) -> None:
    copy = tmp_path / "elsewhere"
    shutil.copytree(book / "mybook", copy / "mirrors", ignore=shutil.ignore_patterns("generated", "__pycache__"))
    assert "there is no mirrors.generated" in run("--chapter", "./mirrors", "verify", cwd=copy, status=1)
    here = {"CC": hasty_compiler, "CHASLES_CACHE": str(book / "cache")}  # what no declaration changes is compiled there
    said = run("--chapter", "./mirrors", "build", "--out", "ours/of-mirrors", cwd=copy, **here)
    assert said.splitlines()[-1] == "from of-mirrors import kernels"
    assert not (copy / "mirrors" / "generated").exists()
    found = json.loads(run("--chapter", "./mirrors", "verify", "--json", "--samples", "2", cwd=copy, **here))
    assert (found["backend"], found["wrong"]) == ("c", [])


def test_what_was_compiled_of_other_declarations_is_not_taken(book: Path, tmp_path: Path) -> None:
    shutil.copytree(book / "mybook", tmp_path / "mybook", ignore=shutil.ignore_patterns("__pycache__"))
    code = "from mybook import kernels as k; print(k.backend)"
    assert python(code, tmp_path) == "c\n"
    section = tmp_path / "mybook" / "s01_reflection.py"
    section.write_text(section.read_text("utf-8").replace("q, H @ p", "q, -H @ p"), "utf-8")
    run("--chapter", "./mybook", "emit", cwd=tmp_path)
    said = python(code, tmp_path)
    assert "RuntimeWarning: NumPy kernels in place of the compiled ones" in said
    assert "what was emitted last is not compiled" in said
    assert "ImportError: CHASLES_BACKEND is 'c'" in python(code, tmp_path, CHASLES_BACKEND="c")


def test_its_c_library_is_built_by_cmake(book: Path, hasty_compiler: str, tmp_path: Path) -> None:
    cmake = shutil.which("cmake", path=f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")
    if cmake is None:
        pytest.skip("no CMake on this machine")
    build = [cmake, "-S", str(book / "mybook" / "generated"), "-B", str(tmp_path / "build")]
    environment = {**os.environ, "CC": hasty_compiler}
    for command in (
        build,
        [cmake, "--build", str(tmp_path / "build")],
        [str(Path(cmake).with_name("ctest")), "--test-dir", str(tmp_path / "build"), "--no-tests=error"],
        [cmake, "--install", str(tmp_path / "build"), "--prefix", str(tmp_path / "prefix")],
    ):
        subprocess.run(command, check=True, capture_output=True, env=environment)
    assert (tmp_path / "prefix" / "include" / "mybook" / "chasles.h").is_file()


# Its exercise.


def test_its_exercise_is_solved_exactly_and_cites_its_statements(made: tuple[Path, str]) -> None:
    book, printed = made
    assert "The point reflected.  (1.2)" in printed
    (book / "data.json").write_text('{"n": [1, 1, 0]}', "utf-8")
    said = run("--chapter", "mybook", "solve", "1", "--json", "--data", "data.json", cwd=book)
    assert json.loads(said)["status"] == "no unit vector"


def test_new_data_are_drawn_and_answers_graded(book: Path) -> None:
    code = (
        "import chasles\n"
        "for seed in range(1, 8):\n"
        "    task = chasles.practice('1', seed, './mybook')\n"
        "    right = task.solution.as_data()['answers']\n"
        "    again = chasles.solve('1', './mybook', **task.drawn).answers == task.solution.answers\n"
        "    wrong = task.grade({'status': 'ok', 'q': [1, 2, 3]})\n"
        "    print(task.grade({'status': 'ok', **right}).passed, again, wrong.wrong, bool(wrong.violated))"
    )
    assert python(code, book).splitlines() == ["True True ('q',) True"] * 7


def test_it_is_on_the_page_of_the_report(book: Path) -> None:
    run("--chapter", "mybook", "report", "--out", "pages", cwd=book)
    page = (book / "pages" / "index.html").read_text("utf-8")
    assert "The image of a point" in page
    assert "Rigid-Body" not in page


MISTAKES_IN_EXERCISES = [
    ('sheet["p"]', 'sheet["w"]', "x1.py, line 11: KeyError: 'w'"),
    ('sheet.compute(reflection, "The reflection.")', "pass", "x1.py, line 15: NoValue: H has no value here"),
    ("sheet.compute(reflection", "sheet.compute(reflektion", "x1.py, line 14: NameError: name 'reflektion'"),
    ("vector_shape(), [3, 4, 5],", "[3, 4, 5],", "x1.py, line 32: Datum: `shape` is a list (3, 4, 5)"),
    ('return "ok"', 'return "fine"', "`solve` of exercise 1 returns 'fine', and must return 'ok', 'no unit vector'"),
    ('    "1",', '    "2",', "declares exercise 2: it must be 1"),
    ("exercise = Exercise(", "exercize = Exercise(", "declares no `exercise`"),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("right", "wrong", "said"), MISTAKES_IN_EXERCISES)
def test_a_mistake_in_an_exercise_is_told_by_file_and_line(mine: Path, right: str, wrong: str, said: str) -> None:
    module = mine / "exercises" / "x1.py"
    text = module.read_text("utf-8")
    assert right in text
    module.write_text(text.replace(right, wrong), "utf-8")
    told = run("--chapter", "./mine", "solve", "1", cwd=mine.parent, status=2)
    assert said in told
    assert told.count("\n") == 1


# What is refused.


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["new", "my-book"], "'my-book' is no name of a Python package"),
        (["new", "class"], "'class' is no name of a Python package"),
        (["new", "json"], "there is a Python package json already"),
        (["new", "mybook"], "there is mybook already: nothing was written"),
        (["build"], "`make compile` compiles the kernels of chasles.derivations"),
    ],
)
def test_what_is_not_written(book: Path, words: list[str], said: str) -> None:
    assert said in run(*words, cwd=book, status=2)


def test_without_a_compiler_the_kernels_are_emitted_and_run_in_numpy(mine: Path) -> None:
    said = run("--chapter", "./mine", "build", cwd=mine.parent, status=1, CC="no-such-compiler")
    assert "are emitted to" in said
    assert "there is no C compiler" in said
    code = "from mine import kernels as k; print(k.backend, k.image_of_point([0, 0, 1], [1, 2, 3])[2])"
    assert python(code, mine.parent) == "numpy -3.0\n"


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", ["checked", "backend", "instructions"])
def test_a_kernel_is_not_called_like_what_stands_beside_it(mine: Path, name: str) -> None:
    section = mine / "s01_reflection.py"
    section.write_text(section.read_text("utf-8").replace("point_from_image =", f"{name} ="), "utf-8")
    shutil.rmtree(mine / "exercises")
    assert f"a kernel may not be called {name}" in run("--chapter", "./mine", "emit", cwd=mine.parent, status=1)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("said", ['"one text"', "[1, 2]", "(1,)", r'("\\hat a",)', '("a\\nb",)'])
def test_conventions_are_lines_of_plain_text(mine: Path, said: str) -> None:
    package = mine / "__init__.py"
    package.write_text(package.read_text("utf-8") + f"CONVENTIONS = {said}\n", "utf-8")
    assert "CONVENTIONS" in run("--chapter", "./mine", "emit", cwd=mine.parent, status=2)


def test_a_kernel_that_is_refused_is_told_and_the_others_are_compared(mine: Path) -> None:
    """Once nothing was compared: the kernels lacked one, and the advice was to build again."""
    section = mine / "s01_reflection.py"
    section.write_text(
        section.read_text("utf-8").replace("kernel=Kernel(of=(n, q))", "kernel=Kernel(of=(q,))"), "utf-8"
    )
    assert "refused: " in run("--chapter", "./mine", "emit", cwd=mine.parent, status=1)
    command = [sys.executable, "-m", "chasles", "--chapter", "./mine", "verify", "--samples", "2"]
    done = subprocess.run(command, cwd=mine.parent, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "1 kernel (numpy) compared" in done.stdout
    assert done.stderr.startswith("chasles: not compared: point_from_image: n is free")
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        (
            "return draw.written(n=draw.unit(), z=draw.vector())",
            "returns data named n, z, and must return draw.written",
        ),
        (
            "return 5",
            "`instance` of exercise 1 returns 5, and must return draw.written(...) of what the exercise takes",
        ),
    ],
)
def test_an_instance_that_draws_other_data_is_told(mine: Path, wrong: str, said: str) -> None:
    """Once called a defect of chasles."""
    module = mine / "exercises" / "x1.py"
    right = "return draw.written(n=draw.unit(), p=draw.vector())"
    module.write_text(module.read_text("utf-8").replace(right, wrong), "utf-8")
    assert said in run("--chapter", "./mine", "practice", "1", cwd=mine.parent, status=2)
