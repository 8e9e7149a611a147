"""What a shell offers: commands, numbers, kernels and exercises, quickly and in every shell."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys

import pytest

from chasles.cli import COMMANDS, chosen_chapter
from chasles.statements import load
from chasles.statements.exercises import exercise_numbers

BOOK = load()
KERNELS = [kernel.name for entry in BOOK for kernel in entry.kernels]


@pytest.fixture
def offered(run):
    """The words that a shell offers for the last of some words."""

    def words(*typed: str) -> list[str]:
        line = " ".join(("chasles", *typed))
        done = run(COMP_WORDS=line, COMP_CWORD=str(len(typed)), _CHASLES_COMPLETE="bash_complete")
        assert done.exit_code == 0
        return [line.removeprefix("plain,") for line in done.stdout.split()]

    return words


def test_commands_and_options_are_offered(offered) -> None:
    assert offered("de") == ["decide", "derive"]
    assert offered("") == list(COMMANDS)
    assert offered("decide", "--b") == ["--brief"]
    assert offered("completion", "") == ["bash", "zsh", "fish"]


@pytest.mark.parametrize("command", ["show", "decide", "derive", "repair"])
def test_numbers_are_offered(offered, command: str) -> None:
    assert offered(command, "3.1") == [number for number in BOOK.numbers if number.startswith("3.1")]
    assert offered(command, "3.16", "3.14") == [number for number in BOOK.numbers if number.startswith("3.14")]


def test_numbers_of_two_words_are_offered_word_by_word(offered) -> None:
    assert "Thm" in offered("show", "")
    assert offered("show", "th") == ["Thm"]
    theorems = [number.split()[1] for number in BOOK.numbers if number.startswith("Thm ")]
    assert len(theorems) > 3
    assert offered("show", "Thm", "") == theorems
    assert offered("show", "3.16", "Thm", "3.4") == [number for number in theorems if number.startswith("3.4")]
    assert offered("show", "Thm", theorems[0], "3.16") == ["3.16"]


def test_sections_kernels_and_exercises_are_offered(offered) -> None:
    assert offered("list", "--section", "3.2") == [s.number for s in BOOK.sections if s.number.startswith("3.2")]
    assert offered("verify", "screw") == [name for name in KERNELS if name.startswith("screw")]
    assert "power" not in offered("verify", "power", "p")
    for command in ("solve", "practice"):
        assert offered(command, "3.2") == [number for number in exercise_numbers() if number.startswith("3.2")]


def test_declarations_that_do_not_stand_are_no_message_on_the_line(offered, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(package: str) -> None:
        raise RuntimeError

    monkeypatch.setattr(chosen_chapter, "load", fail)
    assert offered("show", "3.1") == []


@pytest.mark.sampled(2)
@pytest.mark.parametrize("words", ["show 3.1", "verify s", "solve 3", "de"])
def test_no_prover_is_imported_for_a_word(words: str) -> None:
    code = (
        "import atexit, os, sys\n"
        "atexit.register(lambda: os._exit(bool({'sympy', 'numpy', 'flint', 'mpmath'} & set(sys.modules))))\n"
        "from chasles.cli import main\n"
        "main(prog_name='chasles')"
    )
    environment = {"COMP_WORDS": f"chasles {words}", "COMP_CWORD": str(len(words.split()))}
    environment["_CHASLES_COMPLETE"] = "bash_complete"
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


@pytest.mark.sampled(2)
@pytest.mark.parametrize("words", ["--help", "--version", "decide --help", "list", "completion fish"])
def test_no_prover_is_imported_to_say_what_there_is(words: str) -> None:
    code = (
        "import atexit, os, sys\n"
        "atexit.register(lambda: os._exit(bool({'sympy', 'numpy', 'flint', 'mpmath'} & set(sys.modules))))\n"
        "from chasles.cli import main\n"
        "main(sys.argv[1:], prog_name='chasles')"
    )
    done = subprocess.run([sys.executable, "-c", code, *words.split()], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_a_shell_reads_what_is_printed_for_it(run, shell: str) -> None:
    if shutil.which("bash") is None:
        pytest.skip("Click asks bash for its version")
    done = run("completion", shell)
    assert done.exit_code == 0
    assert f"_CHASLES_COMPLETE={shell}_complete" in done.stdout
    assert json.loads(run("completion", shell, "--json").stdout) == {"shell": shell, "script": done.stdout[:-1]}
    if shutil.which(shell) is not None:
        subprocess.run([shell, "-n"], input=done.stdout, text=True, check=True)


def test_another_shell_is_refused(run) -> None:
    done = run("completion", "csh")
    assert (done.exit_code, done.stdout) == (2, "")
    assert "'bash', 'zsh', 'fish'" in done.stderr


def test_help_lists_the_exit_statuses(run) -> None:
    said = run("--help").stdout
    for status in ("  0    fine", "  1    something failed", "  2    bad usage", "  130  stopped"):
        assert f"\n  {status}" in said
