"""Macros that a configuration of MathJax or KaTeX defines, in JavaScript, Python, YAML or HTML, as LaTeX."""

from __future__ import annotations

import re

TABLE = re.compile(r"^([ \t]*).*?\bmacros[\"']?[ \t]*[:=][ \t]*(\{|$)", re.IGNORECASE | re.MULTILINE)
ENTRY = re.compile(
    r"^[ \t{,]*(?P<quote>[\"']?)\\{0,2}(?P<name>[A-Za-z]+)(?P=quote)[ \t]*:[ \t\n]*(?:\[[ \t\n]*)?(?P<raw>r?)"
    r"(?:\"(?P<double>(?:\\.|[^\"\\\n])*)\"|'(?P<single>(?:\\.|[^'\\\n])*)'|(?P<bare>[^\s\"'\[{#][^\n]*))",
    re.MULTILINE,
)


def configured_macros(text: str) -> str:
    r"""The definitions with \newcommand of what tables of macros in the text define, nothing of it executed."""
    found: list[str] = []
    for table in TABLE.finditer(text):
        end = _closing_brace(text, table.end()) if table[2] else _end_of_block(text, table.end(), len(table[1]))
        inside = text[table.end() : end]
        for entry in ENTRY.finditer(re.sub(r",(?=[ \t]*[\"'A-Za-z\\]+[ \t]*:)", ",\n", inside)):
            body = next(each for each in entry.group("double", "single", "bare") if each is not None)
            body = body if entry["raw"] or entry["bare"] else body.replace("\\\\", "\\")
            count = max(re.findall(r"#(\d)", body), default="0")
            found.append(rf"\newcommand{{\{entry['name']}}}[{count}]{{{body}}}")
    return "\n".join(found)


def _closing_brace(text: str, start: int) -> int:
    """Where the brace that opens before the place is closed, those in strings counted, too."""
    depth = 1
    for brace in re.finditer(r"[{}]", text[start:]):
        depth += 1 if brace[0] == "{" else -1
        if depth == 0:
            return start + brace.start()
    return len(text)


def _end_of_block(text: str, start: int, indent: int) -> int:
    """Where the lines end that stand further to the right, as in YAML."""
    end = re.compile(rf"^[ \t]{{0,{indent}}}[^\s#]", re.MULTILINE).search(text, start)
    return end.start() if end else len(text)
