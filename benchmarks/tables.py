"""The page of figures: what was aimed at beside what was measured, then every peer."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

NOISE = 0.85
"""A ratio that misses its goal by less than 15 % is noise."""
MILLION = "1000000 out="
LOST = "lost"
LOST_MEANS = f"""`{LOST}`: a result is not finite, or no digit of it is right. Where the right value itself is beyond
the range of float64, as that of dN/dt at 1e-300, only a result that is not finite is right: 0."""


@dataclass(frozen=True)
class Goal:
    """What a kernel should reach: operations at most, times faster at least, largest error at most."""

    operations: int
    at_ten_thousand: float | None
    at_a_million: float
    error: float | None
    by_condition: bool = False


GOALS = {
    "rotation_from_axis_angle": Goal(22, 5, 3.5, 8),
    "natural_rate_matrix": Goal(24, 5, 4, 6),
    "natural_rate_matrix_dot": Goal(69, 5.5, 5, 10),
    "screw_axis_point": Goal(38, 6, 6, 2, by_condition=True),
    "inertia_about_point": Goal(24, 1.0, 1.0, 4),
    "newton_euler_wrench": Goal(45, 1.7, 1.1, 4),
    "inertia_about_point_sym6": Goal(24, None, 1.1, 4),
    "newton_euler_wrench_sym6": Goal(45, None, 1.3, 4),
}
INTRODUCTION = """# Benchmarks

`make bench` measures on your machine and rewrites this page, `evidence/kernels.json` and `evidence/kernels.svg`.

- `kernels.py`: the kernels beside what one would use instead; its figures follow.
- `against_sympy.py`: the same equations, asked of the prover and of SymPy.
- `deciding.py`: how long the whole book takes to decide.
- `threads.py`: how much sooner several threads are done; `evidence/threads.json` has its last figures.
- `cost.py`: what an operation takes here, and what the cost model says; its figures are in `evidence/cost.json`.
- `plain.py`: every kernel beside a plain loop over its own function in C; run by itself.
- `errors.py`: the largest errors found beside what is proved (`ERRORS.md`), and over the angle; run by itself.
- `identities/`: identities of SymPy's test suite and of textbooks, asked of `prove`; run by itself.
- `reading/`: excerpts of pages by others, read with a notation by hand and with the one that is proposed, decided, and
  with slips planted in them; run by itself.
- `adversarial/`: a million inputs that are apt to break a kernel, every result of every build decided; run by itself.

Every peer is given the formula as the book prints it (`formulas.py`; `peers/` says how). Generated C and C++ is
compiled with `-O3 -march=native` and bound as a generalised ufunc, as chasles' own loops are. Times are medians of
{rounds} interleaved rounds in the thread's own processor time; a ratio is the median of the rounds' ratios.
"""


def summary(evidence: dict[str, Any]) -> str:
    """The page of `benchmarks/README.md`: how, where, and what became of the goals."""
    parts = [INTRODUCTION.format(rounds=evidence["rounds"]), where(evidence), "## Goals"]
    parts += [goals(evidence["kernels"], evidence["peers"]), light(evidence), "![ns per element](evidence/kernels.svg)"]
    return joined(parts)


def details(evidence: dict[str, Any]) -> str:
    """Every peer's figures."""
    kernels, peers = evidence["kernels"], evidence["peers"]
    parts = ["## One call, ns", one_call(kernels, peers)]
    for size in next(iter(kernels.values()))["ns"]:
        if size.partition(" ")[0] != "1":
            parts += [f"## ns per element, n = {spelled(size)}", speeds(kernels, peers, size)]
    parts += ["## Operations in the text, sine and cosine apart", facts(kernels, peers, "operations")]
    parts += ["## Seconds to generate (with the compilation: ufuncify, autowrap, numba)"]
    parts += [facts(kernels, peers, "generation_seconds"), emitted(evidence)]
    parts += ["## Largest error near the singular sets, units of 2^-53, normwise", LOST_MEANS]
    for kernel in kernels.values():
        if len(kernel["errors"]) > 1:
            parts += [f"### {kernel['title']}", errors(kernel, peers)]
    return joined(parts)


def joined(parts: Iterable[str]) -> str:
    """The parts with an empty line between them."""
    return "\n\n".join(part.strip() for part in parts) + "\n"


def light(evidence: dict[str, Any]) -> str:
    """The light path against the ufunc, and how long it takes in batches of 100."""
    kernels = evidence["kernels"].values()
    parts = [each["one_by_ufunc"][size] for each in kernels for size in ("1", "1 out=") if size in each["one_by_ufunc"]]
    rotation = evidence["kernels"]["rotation_from_axis_angle"]["ns"].get("100 out=", {})
    lines = []
    if parts:
        said = judged(max(parts), 0.3, most=True)
        lines.append(f"One call of `chasles.kernels.one`, by one of the ufunc: {min(parts):g} to {said}.")
    if "one" in rotation:
        lines.append(f"Q for n = 100 through it: {judged(rotation['one'], 10, most=True)} ns per element.")
    return " ".join(lines)


def where(evidence: dict[str, Any]) -> str:
    """The machine, the date and the versions."""
    machine = evidence["machine"]
    versions = ", ".join(f"{name} {version}" for name, version in machine["versions"].items())
    lines = [
        f"{machine['date']}; {machine['processor']}, {machine['cores']} cores, load {machine['load']} before and "
        f"{machine['load_after']} after; {machine['compiler']}; Python {machine['python']}; {versions}. "
        f"chasles' loops: {machine['instructions'] or machine['backend']}.",
        *evidence["skipped"],
    ]
    return "\n\n".join(lines) + "\n"


def goals(kernels: dict[str, Any], peers: dict[str, str]) -> str:
    """Each goal with what was measured; a miss is said to be one."""
    rows = []
    for name, kernel in kernels.items():
        goal = GOALS[name]
        rows.append(
            [
                kernel["title"],
                judged(kernel["operations"].get("chasles_kernels"), goal.operations, most=True),
                faster(kernel, peers, "10000", goal.at_ten_thousand),
                faster(kernel, peers, MILLION, goal.at_a_million),
                judged(worst(kernel, goal), goal.error, most=True) + (" x condition" if goal.by_condition else ""),
            ]
        )
    head = ["", "operations", "times faster, n = 1e4", "the same, n = 1e6, `out=`", "largest error, 2^-53"]
    return table(head, rows)


def worst(kernel: dict[str, Any], goal: Goal) -> float | None:
    """The largest error of chasles over all regions; infinite where it is lost."""
    key = "chasles by condition" if goal.by_condition else "chasles_kernels"
    found = [region[key] for region in kernel["errors"].values() if key in region]
    return max((float("inf") if error is None else error for error in found), default=None)


def faster(kernel: dict[str, Any], peers: dict[str, str], size: str, goal: float | None) -> str:
    """How many times faster than the best generated peer, and which it was."""
    found = kernel["times_faster"].get(size)
    return "" if found is None else f"{judged(found['ratio'], goal, most=False)}, {peers[found['than']]}"


def judged(value: float | None, goal: float | None, most: bool) -> str:
    """The value beside its goal."""
    if value is None or goal is None:
        return "" if value is None else f"{value:g}"
    sign = "<=" if most else ">="
    if value <= goal if most else value >= goal:
        return f"{value:g} ({sign} {goal:g})"
    verdict = "within noise" if not most and value >= NOISE * goal else "**miss**"
    return f"{value:g} ({sign} {goal:g}: {verdict})"


def one_call(kernels: dict[str, Any], peers: dict[str, str]) -> str:
    """One element from Python: all peers, the light path, and its part of a ufunc's call."""
    rows = []
    for size in ("1", "1 out="):
        for name, title in {"one": "chasles `one`", **peers}.items():
            values = [kernel["ns"].get(size, {}).get(name) for kernel in kernels.values()]
            rows.append([title + size[1:], *(number(value) for value in values)])
        parts = [kernel["one_by_ufunc"].get(size) for kernel in kernels.values()]
        rows.append([f"`one` by ufunc{size[1:]}", *("" if part is None else judged(part, 0.3, True) for part in parts)])
    hundred = [kernel["ns"].get("100 out=", {}).get("one") for kernel in kernels.values()]
    rows.append(["`one`, n = 100, per element", *(number(value) for value in hundred)])
    return table(["", *(kernel["title"] for kernel in kernels.values())], rows)


def speeds(kernels: dict[str, Any], peers: dict[str, str], size: str) -> str:
    """Ns per element of each peer, and the ratio to the best generated one."""
    rows = []
    for name, title in {**peers, "one": "chasles `one`"}.items():
        values = [kernel["ns"].get(size, {}).get(name) for kernel in kernels.values()]
        if any(value is not None for value in values):
            rows.append([title, *(number(value) for value in values)])
    ratios = [kernel["times_faster"].get(size) for kernel in kernels.values()]
    rows.append(["times faster than the best generated", *("" if r is None else f"**{r['ratio']:g}**" for r in ratios)])
    return table(["", *(kernel["title"] for kernel in kernels.values())], rows)


def facts(kernels: dict[str, Any], peers: dict[str, str], key: str) -> str:
    """A table of what does not hang on the size."""
    rows = []
    for name, title in peers.items():
        values = [kernel[key].get(name) for kernel in kernels.values()]
        if any(value is not None for value in values):
            rows.append([title, *(number(value) for value in values)])
    return table(["", *(kernel["title"] for kernel in kernels.values())], rows)


def errors(kernel: dict[str, Any], peers: dict[str, str]) -> str:
    """The largest error of each peer by region of the angle."""
    regions = kernel["errors"]
    rows = []
    for name, title in {**peers, "chasles by condition": "chasles, by condition number"}.items():
        if any(name in region for region in regions.values()):
            rows.append([title, *(lost_or(region, name) for region in regions.values())])
    return table(["phi", *regions], rows)


def lost_or(region: dict[str, Any], name: str) -> str:
    """The error; empty where none was measured."""
    return "" if name not in region else LOST if region[name] is None else number(region[name])


def emitted(evidence: dict[str, Any]) -> str:
    """What the text of all of chasles' kernels takes."""
    return f"chasles: {evidence['emit_seconds']} s of processor time for `chasles emit --check`: all targets.\n"


def spelled(size: str) -> str:
    """`10000 out=` as it stands in a heading."""
    n, _, out = size.partition(" ")
    return f"{int(n):,}".replace(",", " ") + (", `out=` given" if out else ", output allocated")


def number(value: float | None) -> str:
    """Three digits."""
    if value is None:
        return ""
    return f"{value:.0f}" if 1000 <= value < 1e5 else f"{value:.3g}"


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table in Markdown, its columns aligned."""
    lines = [list(head), *(list(row) for row in rows)]
    widths = [max(len(line[i]) for line in lines) for i in range(len(head))]
    spelled_out = [
        "| " + " | ".join(cell.ljust(w) for cell, w in zip(line, widths, strict=True)) + " |" for line in lines
    ]
    rule = "|" + "|".join("-" * (w + 2) for w in widths) + "|"
    return "\n".join([spelled_out[0], rule, *spelled_out[1:]]) + "\n"
