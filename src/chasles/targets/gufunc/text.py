"""How is a text written in C source as a string literal?"""

from __future__ import annotations

_ESCAPES = {"\n": "\\n", '"': '\\"', "\\": "\\\\", "?": "\\?"}


def c_string(text: str) -> str:
    """The literal of the text in UTF-8; bytes beyond ASCII are octal escapes, the same for every compiler."""
    parts = []
    for character in text:
        if character in _ESCAPES:
            parts.append(_ESCAPES[character])
        elif character.isascii():
            parts.append(character)
        else:
            parts += [f"\\{byte:03o}" for byte in character.encode()]
    return f'"{"".join(parts)}"'
