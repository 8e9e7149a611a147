"""`chasles solve`: worked solutions, JSON and pages; what is malformed is refused in one line."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

import chasles
from chasles.statements.exercises import UnknownExercise, exercise_numbers


@pytest.mark.parametrize("number", exercise_numbers())
def test_every_exercise_with_the_defaults(run, number: str) -> None:
    done = run("solve", number, "--json")
    assert done.exit_code == 0, done.stderr
    found = json.loads(done.stdout)
    assert list(found) == ["exercise", "status", "answers", "assumptions", "steps"]
    assert (found["exercise"], found["steps"] > 0) == (number, True)


def test_the_sheet(run) -> None:
    done = run("solve", "3.7")
    assert done.exit_code == 0
    assert re.search(r"^  3 \(a\) Linear equations for e\.  \(3\.27\); Ex 3\.7$", done.stdout, re.MULTILINE)
    assert "e = (1, 0, 0)" in done.stdout
    assert re.search(r"^Answer: compatible$", done.stdout, re.MULTILINE)
    assert "Substituted back" in done.stdout
    assert not [line for line in done.stdout.splitlines() if line != line.rstrip()]


def test_decimals_stand_beside_what_is_not_rational(run) -> None:
    assert "d = |n| = sqrt(2)  ≈ 1.41421" in run("solve", "3.5").stdout


def test_decimals_stand_below_what_is_long(run) -> None:
    lines = run("solve", "3.6").stdout.splitlines()
    below = [line.strip() for line in lines if line.lstrip().startswith("≈")]
    assert "≈ (-0.268675, -0.47189, 0.256573)" in below


def test_lists_have_decimals(run) -> None:
    found = run("solve", "3.15").stdout
    assert re.search(r"moments_P .*≈ \(3\.38197, 5\.61803, 7\)", found)


def test_data_from_a_file_and_from_standard_input(run, tmp_path: Path) -> None:
    file = tmp_path / "my.json"
    file.write_text('{"nB": [0, 1, "3"]}', "utf-8")
    done = run("solve", "3.7", "--data", str(file), "--json")
    assert (done.exit_code, json.loads(done.stdout)["status"]) == (0, "incompatible")
    code = "import sys; from chasles.cli import main; main()"
    command = (sys.executable, "-c", code, "solve", "3.7", "--data", "-", "--json")
    piped = subprocess.run(command, input=file.read_text("utf-8"), capture_output=True, text=True, check=True)
    assert json.loads(piped.stdout)["status"] == "incompatible"


@pytest.mark.parametrize(
    ("text", "match"),
    [
        ('{"a": [1, 0, "__import__(1)"]}', "'_' has no meaning in a number, at character 1"),
        ('{"a": [1, 0]}', "a: expected a list of 3 numbers, and got 2 of them"),
        ('{"A": [1, 0, 0]}', "exercise 3.7 has no datum 'A'"),
        ("[", "the data are not JSON"),
        ('{"a": [1, 0, Infinity]}', "Infinity is not a number here"),
        ("\udcff", "cannot read .*: it is not UTF-8 text"),
    ],
)
def test_malformed_data_exit_2_with_one_line(run, tmp_path: Path, text: str, match: str) -> None:
    file = tmp_path / "my.json"
    file.write_bytes(text.encode("utf-8", "surrogateescape"))
    done = run("solve", "3.7", "--data", str(file))
    assert done.exit_code == 2
    assert done.stdout == ""
    assert done.stderr.count("\n") == 1
    assert re.search(match, done.stderr)


@pytest.mark.parametrize(
    ("words", "match"),
    [
        (["solve", "3.99"], "there is no exercise '3.99'; there are 3.1, 3.2"),
        (["solve", "../../etc"], "there is no exercise"),
        (["solve", "3.7", "--data", "/no/such/file"], "cannot read /no/such/file: No such file"),
        (["solve", "3.7", "--html", "/no/such/folder/page.html"], "cannot write /no/such/folder/page.html"),
        (["solve"], "Missing argument 'EX'"),
    ],
)
def test_bad_usage_exits_2(run, words: list[str], match: str) -> None:
    done = run(*words)
    assert (done.exit_code, done.stderr.count("\n")) == (2, 1)
    assert match in done.stderr


def test_a_page_is_whole_and_the_same_each_time(run, tmp_path: Path) -> None:
    pages = [tmp_path / name for name in ("one.html", "two.html")]
    for page in pages:
        assert run("solve", "3.1", "--html", str(page)).exit_code == 0
    one, two = (page.read_text("utf-8") for page in pages)
    assert one == two
    assert sorted(path.name for path in tmp_path.iterdir()) == ["one.html", "two.html"]
    assert "<script" not in one
    assert "http://" not in re.sub(r'xmlns(:\w+)?="[^"]*"|"http://www\.w3\.org[^"]*"|http://purl\.org[^"]*', "", one)
    assert "merror" not in one
    for formula in re.findall(r"<math.*?</math>", one, re.DOTALL):
        ElementTree.fromstring(formula)


def test_without_matplotlib_the_page_says_how_to_get_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in [name for name in sys.modules if name.split(".")[0] == "matplotlib"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    solution = chasles.solve("3.7")
    with pytest.raises(ImportError, match=r"pip install 'chasles\[plots\]'"):
        solution.figure()
    assert "pip install" in solution._repr_html_()


def test_from_python() -> None:
    solution = chasles.solve("3.7", a=[1, 0, 0])
    assert solution.status == "compatible"
    assert [str(x) for x in solution.answers["e"]] == ["1", "0", "0"]
    assert solution.steps[1].cites[0].number == "3.32"
    assert "<math" in solution._repr_html_()
    assert r"\mathbf{n}_B" in solution._repr_latex_()
    with pytest.raises(UnknownExercise, match=r"there is no exercise '4\.1'"):
        chasles.solve("4.1")
    with pytest.raises(LookupError, match="has no picture"):
        chasles.solve("3.8").figure()


@pytest.mark.parametrize("number", exercise_numbers())
def test_every_claim_that_is_cited_holds(number: str) -> None:
    solution = chasles.solve(number)
    cited = [citation for step in (*solution.steps, *solution.checks) for citation in step.cites]
    assert all(c.verdict in ("holds", "holds-under", "defined", "posed", "assumed", "fails") for c in cited)


@pytest.mark.sampled(5)
@pytest.mark.parametrize("number", exercise_numbers())
def test_pictures_are_drawn(number: str) -> None:
    pytest.importorskip("matplotlib")
    solution = chasles.solve(number)
    if solution.picture is not None:
        (axes,) = solution.figure().axes
        assert axes.get_title()
        assert axes.get_xlabel()
