"""The page of the figures: each model, each tool, and the best peer beside chasles."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

__all__ = ["page"]

TITLES = {
    "chasles": "chasles",
    "sympy_lambdify": "lambdify",
    "sympy_cse_c": "SymPy cse, C",
    "numba_jit": "numba",
    "wrenfold_cpp": "wrenfold",
    "symforce_cpp": "SymForce",
    "casadi_c": "CasADi",
}
HEAD = """# Expressions compiled

`python -m benchmarks.compile [MODELS] [--curve] [--methods]` measures and rewrites this page and
`../evidence/compile.json`; the models are in `models.py`. Each peer gets the same expression in its own words; what
it writes is compiled with `-O3 -march=native` and bound as a generalised ufunc. Making is processor time in a new
process that has SymPy and the expression, from there to the kernel: of what the tool imports, and of the C compiler
too, in all threads; chasles' cold with an empty cache and warm with the cache that the first process left. A peer whose
files are kept by hand starts warm in no time.
A batch has 10,000 elements, with `out=`; times of calls are medians of interleaved rounds, in processor time.
Errors are the largest at 12 points, against {digits} digits, in 2^-53 of the largest entry. The best peer is that of
those that compile, lambdify left out. Bold is what is not as it should be: more than twice the making of the best
peer, or slower than it.
"""
BEST = "best peer"


def page(found: dict[str, Any]) -> str:
    """The whole page."""
    said = found["machine"]
    versions = ", ".join(f"{name} {version}" for name, version in said["versions"].items())
    where = (
        f"{said['date']}; {said['processor']}, {said['cores']} cores, load {said['load']}; {said['compiler']}; "
        f"Python {said['python']}; {versions}; {said['instructions']}."
    )
    models = found["models"]
    parts = [HEAD.format(digits=50), where, "## Beside the best peer", beside(models.items())]
    if found.get("methods"):
        how = (
            "Accelerations of methods of `sympy.physics.mechanics`; for the peers NumPy solves M a = f, batch by batch."
        )
        parts += ["## Equations of motion", how, beside(found["methods"].items())]
    if found.get("curve"):
        rows = [(f"{row['masses']} masses", row) for row in found["curve"]]
        parts += ["## Over size", "Forces in a chain of masses and springs in the plane.", beside(rows)]
    parts += ["## Making, seconds", *table(models, "cold", "{:.2f}", warm=True)]
    parts += ["## Batch, ns per element", *table(models, "batch", "{:.1f}")]
    parts += ["## Single call, microseconds", *table(models, "call", "{:.2f}")]
    parts += ["## Largest error", *table(models, "error", "{:.2g}")]
    parts += ["## Operations", *table(models, "operations", "{}")]
    return "\n\n".join(part.rstrip() for part in parts) + "\n"


def beside(rows: Iterable[tuple[str, dict[str, Any]]]) -> str:
    """What chasles takes, by what the best peer takes."""
    lines = []
    for name, row in rows:
        ours = row["tools"]["chasles"]
        cells = [name, cell(ours.get("operations"), "{}")]
        for key, most, form in (("cold", 2.0, "{:.2f} s"), ("batch", 1.0, "{:.0f} ns"), ("call", 1.0, "{:.2f} us")):
            others = {
                tool: each[key]
                for tool, each in row["tools"].items()
                if tool not in ("chasles", "sympy_lambdify") and isinstance(each.get(key), float)
            }
            cells.append(cell(ours.get(key), form))
            if not isinstance(ours.get(key), float) or not others:
                cells.append("")
                continue
            best = min(others, key=lambda tool: others[tool])
            ratio = ours[key] / others[best]
            cells.append(f"{'**' if ratio > most else ''}{ratio:.2f}{'**' if ratio > most else ''} {TITLES[best]}")
            if key == "cold":
                cells.insert(-1, cell(ours.get("warm"), "{:.2f} s"))
        cells += [cell(ours.get("error"), "{:.2g}")]
        lines.append(cells)
    heads = ["", "operations", "making", "warm", f"by {BEST}", "batch", f"by {BEST}", "call", f"by {BEST}", "error"]
    return grid(heads, lines)


def table(models: dict[str, Any], key: str, form: str, warm: bool = False) -> list[str]:
    """A figure of all tools for all models."""
    tools = [tool for tool in TITLES if any(tool in row["tools"] for row in models.values())]
    lines = []
    for name, row in models.items():
        cells = [cell(row["tools"].get(tool, {}).get(key), form) for tool in tools]
        if warm:
            cells.insert(1, cell(row["tools"]["chasles"].get("warm"), form))
        lines.append([name, *cells])
    heads = [TITLES[tool] for tool in tools]
    if warm:
        heads.insert(1, "warm")
    return [grid(["", *heads], lines)]


def cell(value: Any, form: str) -> str:
    """A figure, or a word for why there is none."""
    if value is None:
        return ""
    return form.format(value) if isinstance(value, int | float) else str(value).partition(":")[0]


def grid(heads: Sequence[str], lines: Sequence[Sequence[str]]) -> str:
    """A table of Markdown, padded."""
    widths = [max(len(row[i]) for row in (heads, *lines)) for i in range(len(heads))]
    rows = [heads, ["-" * width for width in widths], *lines]
    return "\n".join("| " + " | ".join(f"{x:<{w}}" for x, w in zip(row, widths, strict=True)) + " |" for row in rows)
