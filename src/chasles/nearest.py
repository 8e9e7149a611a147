"""The known words that an unknown one is near, for messages."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches


def nearest(word: str, words: Sequence[str]) -> str:
    """The end of a message about an unknown word: what it may have been meant to be; empty if nothing is near."""
    longer = [known for known in words if known.startswith(word)]
    near = list(dict.fromkeys([*longer[:4], *get_close_matches(word, words, n=4, cutoff=0.6)]))
    return f"; near it: {', '.join(near[:4])}" if near else ""
