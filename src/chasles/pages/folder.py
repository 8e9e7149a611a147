"""What is written of a page: a chapter, its findings, what is asked of a person, and what could not be read."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from typing import Any

from chasles.pages.findings_told import told
from chasles.pages.kept_declarations import merged
from chasles.pages.package import package_of
from chasles.pages.page import ReadPage
from chasles.pages.page_chapter import chapter_of
from chasles.pages.page_equation import PageEquation

QUESTIONS = "questions.toml"
ASKED = """\
# What only a person knows of the equations: fill in a role, "claim", "condition", "law" or "definition", or a reading
# in LaTeX. What is filled in is used when the page is read again.
"""


def answers(text: str) -> dict[str, dict[str, str]]:
    """What a person has filled in, by the equation's name. Raises ValueError for what has another form."""
    tables = tomllib.loads(text)
    if not all(isinstance(said, dict) for said in tables.values()):
        raise ValueError("expected a table for each equation, such as ['3.8'] with role = 'law'")
    filled = {name: {key: value for key, value in said.items() if value} for name, said in tables.items()}
    return {name: said for name, said in filled.items() if said}


def files_of(page: ReadPage, given: Mapping[str, Mapping[str, Any]], found: Mapping[str, str]) -> dict[str, str]:
    """The text of each file by its name; answers that are `given` stay where they are asked for.

    Of the files that are `found` in the folder, declarations that a person has changed are kept. Raises SyntaxError for
    a module that is no Python, and `BadRecord` for a record of another form.
    """
    chapter, read = chapter_of(page.file or "page", page.equations)
    said = {name: f"{each.printed.file or page.file}:{each.line}" for name, each in read.items()}
    return {
        **merged(package_of(chapter, said), found),
        "README.md": _table(page),
        QUESTIONS: _questions(page, given),
        "unread.md": _unread(page),
    }


def _table(page: ReadPage) -> str:
    rows = [f"| {each.line} | {each.number} | {_cell(told(each))} |" for each in page.equations]
    return "\n".join(
        [f"# {page.file}", "", page.summary, "", "| line | number | finding |", "| --- | --- | --- |", *rows, ""]
    )


def _cell(text: str) -> str:
    return " ".join(text.replace("|", r"\|").split())


def _questions(page: ReadPage, given: Mapping[str, Mapping[str, Any]]) -> str:
    asked: dict[str, list[PageEquation]] = {name: [] for name in given}
    for each in page.equations:
        if each.number in given or each.verdict in ("open", "ambiguous", "undecided", "contradictory"):
            asked.setdefault(each.number, []).append(each)
    lines = [ASKED]
    for name, equations in asked.items():
        for each in equations:
            lines += [f"# line {each.line}: {' '.join(each.printed.latex.split())}", f"# {_cell(told(each))}"]
        key = "reading" if any(each.others for each in equations) else "role"
        said = given.get(name) or {key: ""}
        lines += [f"[{json.dumps(name)}]", *(f"{each} = {json.dumps(value)}" for each, value in said.items()), ""]
    return "\n".join(lines)


def _unread(page: ReadPage) -> str:
    lines = ["# What could not be read", ""]
    for each in page.equations:
        if each.verdict == "unread":
            lines += [f"- line {each.line}: {told(each)}", "", f"      {' '.join(each.printed.latex.split())}", ""]
    return "\n".join(lines)
