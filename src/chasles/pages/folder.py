"""What is written of a page: a chapter, its findings, what is asked of a person, and what could not be read.

Where modules are written again, declarations that a person has changed, added or left in another form stay as they are.
"""

from __future__ import annotations

import ast
import json
import tomllib
from collections.abc import Iterator, Mapping
from hashlib import sha256
from typing import Any

from chasles.pages.findings_told import told
from chasles.pages.package import package_of
from chasles.pages.page import ReadPage
from chasles.pages.page_chapter import chapter_of
from chasles.pages.page_equation import PageEquation

QUESTIONS = "questions.toml"
ASKED = """\
# What only a person knows of the equations: fill in a role, "claim", "condition", "law" or "definition", or a reading
# in LaTeX. What is filled in is used when the page is read again.
"""
RECORD = "written.json"
"""Of each declaration in each module a hash of what was written, by which a change is seen."""
Record = dict[str, dict[str, str]]


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


class BadRecord(ValueError):
    """A record of another form than was written: its text says in one line what was expected."""


def merged(new: Mapping[str, str], found: Mapping[str, str]) -> dict[str, str]:
    """The modules as they are to be written, and the record; `found` are files of the folder as they are.

    Raises SyntaxError for a module that is no Python, and `BadRecord` for a record that is none.
    """
    record = _record(found.get(RECORD, "{}"))
    files = {name: _merged(text, found.get(name, ""), record.get(name, {}), name) for name, text in new.items()}
    now = {name: {key: _hash(said) for key, (_, said) in _declarations(text).items()} for name, text in new.items()}
    return {**files, RECORD: json.dumps(now, indent=1) + "\n"}


def _record(text: str) -> Record:
    try:
        record = json.loads(text)
    except ValueError as error:
        raise BadRecord(str(error)) from None
    if not isinstance(record, dict) or not all(isinstance(each, dict) for each in record.values()):
        raise BadRecord("a table of hashes for each module was expected")
    return record


def _merged(new: str, old: str, written: Mapping[str, str], file: str) -> str:
    """The new text with those declarations of the old one that are not as they were written."""
    before, now = _declarations(old, file), _declarations(new)
    kept = {name: held for name, held in before.items() if _hash(held[1]) != written.get(name)}
    kept = {name: held for name, held in kept.items() if name not in now or held[1] != now[name][1]}
    if not kept:
        return new
    for name in kept.keys() & now.keys():
        new = new.replace(now[name][0], kept[name][0])
    new += "".join(f"\n{held[0]}\n" for name, held in kept.items() if name not in now)
    return _with_imports(new, [node for node in ast.parse(old).body if isinstance(node, ast.Import | ast.ImportFrom)])


def _declarations(text: str, file: str = "") -> dict[str, tuple[str, str]]:
    """What is assigned to each variable: the text with the comments above it, and without."""
    lines, found = text.splitlines(), {}
    for node in ast.parse(text, file).body:
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            first = start = node.lineno - 1
            while start and lines[start - 1].startswith("#"):
                start -= 1
            end = node.end_lineno
            found[node.targets[0].id] = "\n".join(lines[start:end]), "\n".join(lines[first:end])
    return found


def _with_imports(text: str, imports: list[ast.Import | ast.ImportFrom]) -> str:
    """The text with what it names and only the old text imports."""
    nodes = list(ast.walk(ast.parse(text)))
    used = {node.id for node in nodes if isinstance(node, ast.Name)}
    bound = {name for node in nodes if isinstance(node, ast.Import | ast.ImportFrom) for name in _names(node)}
    more = [node for node in imports if used & (set(_names(node)) - bound)]
    head, tail = text.split("\n\n", 1)
    return "\n\n".join([head, "\n".join([*map(ast.unparse, more), tail.lstrip("\n")])]) if more else text


def _names(node: ast.Import | ast.ImportFrom) -> Iterator[str]:
    yield from ((each.asname or each.name).partition(".")[0] for each in node.names)


def _hash(text: str) -> str:
    return sha256(text.encode()).hexdigest()[:12]
