"""How much `chasles.prove` decides of the identities that are kept here, how fast, and whether anything is wrong.

    python -m benchmarks.identities.measure [textbook] [sympy] [--verbose] [--every N]

Of each set a line: true ones proved, false ones refuted (both right), wrong, undecided and refused, with the median and
the 90th percentile of processor time. Of SymPy's, those count that are real and without special functions.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from time import process_time
from typing import Any

import sympy
from benchmarks.identities.numbers import changed
from benchmarks.identities.pairs import built, load
from benchmarks.identities.textbook import identities

from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Fails, Holds, HoldsUnder

HERE = Path(__file__).parent
BUDGET = 10.0
Question = tuple[str, bool, partial[Any]]


def textbook() -> Iterator[Question]:
    """Each textbook identity; of every second one that has no given equations also a false variant."""
    for number, item in enumerate(identities()):
        inexact = {"exact": True} if item.left.has(sympy.Float) else {}
        yield item.text, True, partial(prove, item.left, item.right, item.given, budget=BUDGET, **inexact)
        wrong = changed(item.left, item.right, number) if number % 2 and not item.given else None
        if wrong is not None:
            text = f"{item.text.split(' == ')[0]} != {wrong}"
            yield text, False, partial(prove, item.left, wrong, budget=BUDGET, **inexact)


def of_sympy(kind: str) -> Iterator[Question]:
    """Each pair of SymPy's test suite of a kind, and its false variant."""
    for pair in load(HERE / "from_sympy.txt"):
        if pair.kind == kind:
            left = built(pair.left)
            for text, true in ((pair.right, True), (pair.wrong, False)):
                if text:
                    right = built(text)
                    said = f"{pair.left} {'==' if true else '!='} {text}"
                    yield said, true, partial(prove, left, right, budget=BUDGET)


def outcome(true: bool, ask: partial[Any]) -> tuple[str, float, str]:
    """What came out, after how long, and what was said; a proof or point that the checker rejects is none."""
    start, said = process_time(), ""
    try:
        verdict = ask()
    except Untreatable as error:
        return "refused", process_time() - start, str(error)
    except Exception as error:
        return "broken", process_time() - start, f"{type(error).__name__}: {error}"
    took = process_time() - start
    if isinstance(verdict, Holds | HoldsUnder | Fails):
        try:
            recheck(verdict, *ask.args, **{key: said for key, said in ask.keywords.items() if key != "budget"})
        except Rejected as reason:
            return "REJECTED", took, str(reason)
    if isinstance(verdict, Holds | HoldsUnder):
        return ("right" if true else "WRONG"), took, " ".join(verdict.needs)
    if isinstance(verdict, Fails):
        return ("WRONG" if true else "right"), took, str(verdict.counterexample)
    return verdict.name, took, getattr(verdict, "reason", said)


def measure(title: str, questions: Iterator[Question], every: int, verbose: bool) -> Counter[str]:
    """Asks all, prints the sum, and what was not right if `verbose`."""
    found: dict[bool, Counter[str]] = {True: Counter(), False: Counter()}
    times = []
    for number, (text, true, ask) in enumerate(questions):
        if number % every:
            continue
        came, took, said = outcome(true, ask)
        found[true][came] += 1
        times.append(took)
        if came in ("WRONG", "REJECTED", "broken") or (verbose and came != "right"):
            print(f"  {came:9} {1000 * took:6.0f} ms  {text[:150]}\n      {said[:200]}", flush=True)
    times.sort()
    both = found[True] + found[False]
    count = sum(both.values())
    print(f"{title}: {count} questions, {100 * both['right'] / max(count, 1):.1f} % right")
    for true, counter in found.items():
        print(f"  {'true ' if true else 'false'} {dict(sorted(counter.items()))}")
    if times:
        print(
            f"  median {1000 * times[len(times) // 2]:.0f} ms, 90 % within {1000 * times[len(times) * 9 // 10]:.0f} ms"
        )
    return both


def main() -> None:
    """Measures the sets that are named."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("sets", nargs="*", default=["textbook", "sympy"])
    parser.add_argument("--verbose", action="store_true")
    parser.add_argument("--every", type=int, default=1)
    options = parser.parse_args()
    sets = {"textbook": textbook, "sympy": lambda: of_sympy("real"), "complex": lambda: of_sympy("complex")}
    for name in options.sets:
        measure(name, sets[name](), options.every, options.verbose)


if __name__ == "__main__":
    main()
