"""Text for a LaTeX document, escaped."""

from __future__ import annotations

SPECIAL = str.maketrans(
    {
        "\\": r"\textbackslash{}",
        "~": r"\textasciitilde{}",
        "^": r"\textasciicircum{}",
        **{mark: f"\\{mark}" for mark in "{}_#$%&"},
    }
)


def escaped(text: str) -> str:
    """The text as it stands."""
    return text.translate(SPECIAL)
