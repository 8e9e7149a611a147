"""Answers that a chapter brings along: what was found when it was emitted, as text that people can read.

Each stands by its question's hash, under what asked first; nothing of it is believed before it was checked.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from importlib.resources import files
from typing import Any

from chasles.statements.packages import generated_package

ANSWERS = "ANSWERS.json"


def shipped(package: str) -> dict[str, Any]:
    """The answers that a chapter's package brings, by question; none where it brings none that can be read."""
    try:
        text = files(generated_package(package)).joinpath(ANSWERS).read_text("utf-8")
        groups = json.loads(text)
        return {key: answer for answers in groups.values() for key, answer in answers.items()}
    except (ModuleNotFoundError, OSError, ValueError, AttributeError):
        return {}


def as_text(groups: Mapping[str, Mapping[str, Any]]) -> str:
    """The text of the file: the answers of each group, one on a line."""
    parts = []
    for asking, answers in groups.items():
        lines = ",\n".join(
            f"  {json.dumps(key)}: {json.dumps(answer, ensure_ascii=False)}" for key, answer in answers.items()
        )
        parts.append(f" {json.dumps(asking, ensure_ascii=False)}: {{\n{lines}\n }}")
    return "{\n" + ",\n".join(parts) + "\n}\n"
