"""What people read: every statement, in every width, with colour and without."""

from __future__ import annotations

import io
import json
import re
import shlex

import pytest
from rich.text import Text

from chasles.report.screen import Screen

from ..sampling import WHOLE, sample

KEYS = [
    "number", "part", "name", "section", "role", "verdict", "needs", "contradictory", "counterexample", "corrected",
    "latex", "certificate", "coq", "milliseconds",
]  # fmt: skip
ESCAPE = "\x1b["
SOME = () if WHOLE else ("--section", "3.4.1")


def test_every_statement_has_a_page(run, whole: list[dict]) -> None:
    numbers = sample(dict.fromkeys(record["number"] for record in whole), 12)
    shown = [record for record in whole if record["number"] in numbers]
    done = run("show", *numbers, "--latex")
    assert done.exit_code == 0
    for record in shown:
        assert record["name"] in done.stdout
        assert record["certificate"] is None or record["certificate"] in done.stdout
    pages = json.loads(run("show", "--json", *numbers).stdout)["statements"]
    assert len(pages) == len(shown)
    assert all(set(page) == {*KEYS, "says", "text", "given", "assuming", "kernel", "kernels"} for page in pages)


def test_a_page_in_full(run) -> None:
    page = run("show", "3.16", "--latex").stdout
    assert page.startswith("(3.16)  ✓ holds under ")
    assert "normal_matrix_inverse, claim in 3.2.1" in page
    assert "printed      (A^T A)^-1 = " in page
    assert r"\left( \mathbf{A}^T \mathbf{A} \right)^{-1} = " in page
    assert "assuming     phi != 0" in page
    assert "kernel       normal_matrix_inverse(e, phi)" in page
    assert re.search(r"error bound  [\d.]+ u of the largest entry, for every unit e and every phi; u = 2\^-53", page)
    assert "with or without FMA" in page
    assert re.search(r"certificate  sha256:[0-9a-f]{64}\n", page)
    assert re.search(r"example      satisfies all that is assumed: .*e = \(", page)


def test_an_offered_form_is_named(run) -> None:
    assert "made of      an offered form, proved equal to the statement" in run("show", "3.18").stdout
    (page,) = json.loads(run("show", "--json", "3.18").stdout)["statements"]
    ((kernel),) = page["kernels"]
    assert (kernel["name"], kernel["form"]) == ("screw_axis_point", "offered")
    assert kernel["bound"]["guarantees"][0]["against"] == "terms"


def test_list_has_a_line_for_each_number(run, whole: list[dict]) -> None:
    lines = run("list").stdout.splitlines()
    numbers = list(dict.fromkeys(record["number"] for record in whole))
    for wanted in numbers:
        assert sum(line.startswith(f"{wanted}  ") for line in lines) == 1, wanted
    listed = json.loads(run("list", "--json").stdout)["statements"]
    assert [(entry["number"], entry["part"]) for entry in listed] == [(r["number"], r["part"]) for r in whole]


def test_the_page_of_decisions_names_each_statement_and_the_totals(run, whole: list[dict]) -> None:
    page = run("decide", *SOME).stdout
    decided = [record for record in whole if WHOLE or record["section"] == SOME[1]]
    for record in decided:
        number = record["number"] + (f"/{record['part']}" if record["part"] > 1 else "")
        assert re.search(rf"^{re.escape(number)}  ", page, re.MULTILINE), number
    assert f"{len(decided)} statements: " in page
    assert re.search(r"decided in \d+.* checked again in \d+", page)
    brief = run("decide", "--brief", *SOME).stdout
    assert len(brief) < len(page) / 2
    assert "(3.57)" in brief


def test_a_pipe_gets_plain_text(run) -> None:
    for words in (["decide", *SOME], ["list"], ["show", "3.57"]):
        page = run(*words).stdout
        assert ESCAPE not in page
        assert not re.search(r"[ \t]$", page, re.MULTILINE)


COMMANDS = [
    "decide --section 3.4.1",
    "list",
    "show 3.57 'Thm 3.2.2' natural_invariants",
    "derive 3.13",
    "repair 3.57",
    "solve 3.7",
    "doctor",
    "summary --section 3.3 --samples 1",
    "verify axial_vector power --samples 1 --points generic --points near",
]
NUMBERS_OF_PAGES = {
    "decide --section 3.4.1": "3.57",
    "list": "3.148",
    "doctor": "numpy",
    "summary --section 3.3 --samples 1": "3.3 ",
}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("width", [30, 40, 80, 200])
def test_pages_keep_to_the_width_and_nothing_is_cut_off(run, width: int) -> None:
    for command in COMMANDS if width != 30 else COMMANDS[:3]:
        done = run(*shlex.split(command), COLUMNS=str(width))
        assert done.exit_code == 0, command
        assert max(map(len, done.stdout.splitlines())) <= width, command
        assert "\N{HORIZONTAL ELLIPSIS}" not in done.stdout, command
        assert NUMBERS_OF_PAGES.get(command, "") in done.stdout, command


@pytest.mark.parametrize("width", [40, 80])
def test_the_summary_says_the_same_in_words_where_a_table_has_no_room(run, width: int) -> None:
    page = run("summary", "--section", "3.3", "--samples", "1", COLUMNS=str(width)).stdout
    data = json.loads(run("summary", "--section", "3.3", "--samples", "1", "--json").stdout)["sections"][0]
    words = " ".join(page.split())
    if width < 64:
        assert data["title"] in words
        assert f"{data['holds']} holds, {data['holds-under']} holds under" in words
    else:
        assert re.search(rf"{data['holds']} +{data['holds-under']} ", page)


@pytest.mark.parametrize(
    ("environment", "coloured"),
    [
        ({}, False),
        ({"FORCE_COLOR": "1"}, True),
        ({"CLICOLOR_FORCE": "1"}, True),
        ({"CLICOLOR_FORCE": "0"}, False),
        ({"CLICOLOR_FORCE": "1", "CLICOLOR": "0"}, True),
        ({"FORCE_COLOR": "1", "CLICOLOR": "0"}, False),
        ({"FORCE_COLOR": "1", "CLICOLOR": "1"}, True),
        ({"FORCE_COLOR": "1", "NO_COLOR": ""}, True),
        ({"CLICOLOR_FORCE": "1", "NO_COLOR": "1"}, False),
    ],
)
def test_colours_are_for_who_wants_them(environment: dict[str, str], coloured: bool) -> None:
    page = io.StringIO()
    with pytest.MonkeyPatch.context() as patch:
        for name in ("NO_COLOR", "FORCE_COLOR", "CLICOLOR", "CLICOLOR_FORCE"):
            patch.delenv(name, raising=False)
        patch.setenv("TERM", "xterm-256color")
        for name, value in environment.items():
            patch.setenv(name, value)
        Screen(page).show(Text("a number", "green"))
    assert (ESCAPE + "32m" in page.getvalue()) == coloured


def test_colour_where_it_is_wanted_and_words_where_it_is_not(process) -> None:
    words = ("decide", "--section", "3.3")
    coloured = process(*words, FORCE_COLOR="1", TERM="xterm", COLUMNS="100").stdout
    assert ESCAPE + "32m" in coloured
    uncoloured = process(*words, FORCE_COLOR="1", NO_COLOR="1", TERM="xterm", COLUMNS="100").stdout
    assert ESCAPE + "32m" not in uncoloured
    assert "✓ holds under" in uncoloured


def test_ascii_terminals_get_ascii_signs(process) -> None:
    done = process("decide", "3.16", "3.57", "3.22", PYTHONIOENCODING="ascii")
    assert done.returncode == 0, done.stderr
    assert done.stdout.isascii()
    assert "+ holds under" in done.stdout
    assert "! ill-formed" in done.stdout
