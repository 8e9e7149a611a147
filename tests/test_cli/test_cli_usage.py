"""Help, and what is said of bad input: one clear line, and the right exit status."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

import chasles
from chasles.cli import COMMANDS, chosen_chapter
from chasles.statements import Chapter, Definition
from chasles.vocabulary import scalar, vector

a, b = vector("a", "a", "a vector"), vector("b", "b", "another")
x, y, z = (scalar(name, name, "a number") for name in "xyz")


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_help_with_an_example_and_json(run, name: str) -> None:
    done = run(name, "--help")
    assert done.exit_code == 0
    assert f"Example: chasles {name}" in done.stdout
    assert "--json" in done.stdout


def test_help_names_every_command(run) -> None:
    done = run("--help")
    assert all(re.search(rf"^  {name} +\w", done.stdout, re.MULTILINE) for name in COMMANDS)


def test_without_a_command_the_help_is_shown_as_it_is_laid_out(run) -> None:
    done = run()
    assert (done.exit_code, done.stderr) == (0, "")
    assert done.stdout == run("--help").stdout


def test_no_help_shows_its_marks(run) -> None:
    assert not [name for name in COMMANDS if "\\b" in run(name, "--help").stdout]


def test_version(run) -> None:
    assert run("--version").stdout == f"chasles, version {chasles.__version__}\n"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["show", "3.199"], "the book has no equation '3.199'; near it: 3.99, 3.19"),
        (["show", "3.76"], "near it: 3.76a, 3.76b, 3.76c, 3.76d"),
        (["show", "thm", "3.2.9"], "the book has no equation 'thm'"),
        (["show", "screw_axis_pont"], "near it: screw_axis_point"),
        (["show", " "], "the book has no equation ' '"),
        (["show"], "Missing argument 'NUMBER...'; see `chasles show --help`"),
        (["decide", "3.16", "nonsense"], "no equation 'nonsense'; `chasles list` shows all"),
        (["decide", "--section", "4.1"], "the book has no section '4.1'"),
        (["decide", "--section"], "requires an argument"),
        (["list", "--section", "3.2.9"], "near it: 3.2"),
        (["decied"], "there is no command 'decied'; near it: decide, derive; see `chasles --help`"),
        (["read", "no_such_page.md"], "cannot read no_such_page.md: No such file or directory"),
        (["solve", "3.5", "--html", ""], "cannot write a file without a name"),
        (["report", "--address", "https://a.org"], "--address says where a site will lie: give --site too"),
        (["emit", "--what"], "No such option '--what'; see `chasles emit --help`"),
        (["emit", "--out", __file__], "is a file"),
        (["verify", "screw_axis"], "there is no kernel 'screw_axis'; near it: screw_axis_point"),
        (["verify", "--samples", "0"], "'--samples'"),
        (["verify", "--points", "somewhere"], "'--points'"),
    ],
)
def test_bad_input_is_one_clear_line(run, words: list[str], said: str) -> None:
    done = run(*words)
    assert done.exit_code == 2
    assert done.stdout == ""
    assert done.stderr.startswith("chasles: ")
    assert said in done.stderr
    assert done.stderr.count("\n") == 1


def test_a_declaration_that_does_not_fit_is_named_with_its_place(
    run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    package = tmp_path / "a_broken_book"
    package.mkdir()
    (package / "__init__.py").write_text('SECTIONS = ("s01",)\n', "utf-8")
    broken = package / "s01.py"
    words = "from chasles.vocabulary import scalar, vector\n\nwrong = vector('a', 'a', '') + scalar('x', 'x', '')\n"
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(chosen_chapter, "BOOK", "a_broken_book")
    for text, line, said in [
        (words, 3, "cannot add"),
        ("x = = 1\n", 1, "invalid syntax"),
        ("import none_such\n", 1, "none"),
    ]:
        broken.write_text(text, "utf-8")
        done = run("decide")
        assert done.exit_code == 2
        assert done.stderr.startswith(f"chasles: {broken}, line {line}: ")
        assert said in done.stderr
        assert done.stderr.count("\n") == 1


def test_contradictory_declarations_are_bad_input(run, chapter_is) -> None:
    twice = Definition("9.1", x, y)
    again = Definition("9.1", y, z)
    chapter_is(twice=twice, again=again)
    done = run("list")
    assert done.exit_code == 2
    assert "twice and again are both declared as (9.1), part 1" in done.stderr


def test_what_nobody_expected_is_one_line_and_a_traceback_on_request(run, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(package: str) -> Chapter:
        raise RuntimeError("a\nsurprise")

    monkeypatch.setattr(chosen_chapter, "load", fail)
    done = run("decide")
    assert done.exit_code == 1
    assert done.stderr.startswith("chasles: this is a defect of chasles: RuntimeError: a surprise. Please report it")
    assert done.stderr.count("\n") == 1
    assert "Traceback" in run("decide", CHASLES_DEBUG="1").stderr


def test_interruption_is_not_a_traceback(run, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(package: str) -> Chapter:
        raise KeyboardInterrupt

    monkeypatch.setattr(chosen_chapter, "load", interrupt)
    done = run("decide")
    assert (done.exit_code, done.stderr.strip()) == (130, "chasles: stopped")


def test_a_reader_may_leave_early() -> None:
    command = (sys.executable, "-c", "from chasles.cli import main; main()", "list")
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as writer:
        assert writer.stdout is not None
        assert writer.stderr is not None
        writer.stdout.close()
        assert writer.stderr.read() == b""
