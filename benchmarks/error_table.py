"""The page of errors: what is proved of each result beside the largest error found."""

from __future__ import annotations

from typing import Any

from chasles.bounds.bound import AGAINST

__all__ = ["page"]

HEAD = """# Errors

`python -m benchmarks.errors` measures and rewrites this page and `evidence/errors.json`, which holds the input of each
largest error, and errors over the angle of the formulas as printed and of the kernels.

Units are roundoffs, 2^-53 and 2^-24. A proved bound is for every input, and says of what it is in parts; "normwise" is
in parts of the largest of the entries of one dimension, which the condition of the input alone can make large.
{inputs} inputs of each kernel in each precision, half of them towards a singular set. {where}

"""
TITLES = ("kernel", "result", "proved", "of", "float64", "float32", "normwise, float64", "normwise, float32")


def page(evidence: dict[str, Any]) -> str:
    """The page for what was measured."""
    machine = evidence["machine"]
    where = f"{machine['date']}; {machine['processor']}; loops: {machine['instructions'] or machine['backend']}."
    lines = [f"| {' | '.join(TITLES)} |", "|" + "---|" * len(TITLES)]
    for name, found in evidence["kernels"].items():
        for result in found["proved"]:
            lines.append(f"| {' | '.join(_row(name, result, found))} |")
    return HEAD.format(inputs=evidence["inputs"], where=where) + "\n".join(lines) + "\n"


def _row(name: str, result: str, found: dict[str, Any]) -> list[str]:
    proved = found["proved"][result]
    measured = [
        _number(found[dtype].get(result, {}).get(measure))
        for measure in ("proved", "normwise")
        for dtype in ("float64", "float32")
    ]
    against = AGAINST[proved["against"]].removeprefix("of ") if proved else ""
    return [name, result, proved["units"] if proved else "not proved", against, *measured]


def _number(finding: dict[str, Any] | None) -> str:
    return f"{finding['units']:g}" if finding else ""
