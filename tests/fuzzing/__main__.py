"""Ask questions until the time is over, print every alarm with a small question that raises it, and count."""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from random import Random
from time import monotonic
from typing import Any

from .judging import Alarm
from .languages import LANGUAGES, draw_for
from .shrinking import shrunk

SHRUNK = 5
"""So many alarms of a kind are shrunk; the rest is printed as it was drawn."""


def main(arguments: list[str] | None = None) -> int:
    """1 if an answer is wrong, else 0."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzzing", description=__doc__)
    parser.add_argument("--seconds", type=float, default=60.0, help="how long to go on")
    parser.add_argument("--questions", type=int, default=10**9, help="how many questions at most")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="the number of the first question")
    parser.add_argument("--language", choices=sorted(LANGUAGES), action="append")
    parser.add_argument("--whole", action="store_true", help="print what raises an alarm as it was drawn")
    told = parser.parse_args(arguments)
    languages = told.language or sorted(LANGUAGES)
    counts: Counter[tuple[str, str]] = Counter()
    alarms = 0
    end = monotonic() + told.seconds
    number = told.first
    while number < told.first + told.questions and monotonic() < end:
        name = languages[number % len(languages)]
        answer, alarm, question = examined(name, told.seed, number)
        counts[name, answer] += 1
        if alarm is not None:
            alarms += 1
            counts[name, f"alarm: {alarm.kind}"] += 1
            whole = told.whole or counts[name, f"alarm: {alarm.kind}"] > SHRUNK
            say(report(name, told.seed, number, question, alarm, whole))
        number += 1
    say(shares(counts, number - told.first, told.seed))
    return 1 if alarms else 0


def examined(name: str, seed: int, number: int) -> tuple[str, Alarm | None, Any]:
    """The answer to a question by its number, the alarm if it is wrong, and the question."""
    language = LANGUAGES[name]
    draw = draw_for(name, seed, number)
    question = language.question(draw)
    try:
        judged = language.judge(question, draw)
    except (ArithmeticError, AttributeError, LookupError, NotImplementedError, TypeError, ValueError) as error:
        return "not judged", Alarm("oracle", f"the oracle itself failed: {type(error).__name__}: {error}"), question
    return judged.answer.name, judged.alarm, question


def report(name: str, seed: int, number: int, question: Any, alarm: Alarm, whole: bool) -> str:
    """The alarm with the smallest question found that raises it."""
    language = LANGUAGES[name]

    def persists(other: Any) -> bool:
        try:
            found = language.judge(other, Random(0)).alarm
        except (ArithmeticError, NotImplementedError, TypeError, ValueError, AttributeError, LookupError):
            return False
        return found is not None and found.kind == alarm.kind

    detail = alarm.detail
    if not whole:
        question, _ = shrunk(question, language.smaller, persists)
        again = language.judge(question, Random(0)).alarm
        detail = again.detail if again is not None and again.kind == alarm.kind else detail
    head = f"ALARM {alarm.kind} [{name}, --seed {seed}, question {number}, {getattr(question, 'kind', '')}]"
    return f"{head}\n  {detail}\n" + "".join(f"  {line}\n" for line in language.source(question).splitlines())


def shares(counts: Counter[tuple[str, str]], asked: int, seed: int) -> str:
    """How often each answer came, by language."""
    lines = [f"{asked} questions with seed {seed}"]
    for name in sorted({name for name, _ in counts}):
        own = {answer: count for (language, answer), count in counts.items() if language == name}
        total = sum(count for answer, count in own.items() if not answer.startswith("alarm"))
        parts = [f"{answer} {count} ({100 * count / total:.0f} %)" for answer, count in sorted(own.items())]
        lines.append(f"  {name}: {total}: {', '.join(parts)}")
    return "\n".join(lines) + "\n"


def say(text: str) -> None:
    sys.stdout.write(text)
    sys.stdout.flush()


if __name__ == "__main__":
    raise SystemExit(main())
