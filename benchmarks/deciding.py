"""How long does it take to decide the book? Wall time of whole processes, beside an empty Python process.

Run it as `python benchmarks/deciding.py [ROUNDS]` in the environment in which chasles is installed. It prints the least
of the rounds: what the machine can do when nothing else runs.
"""

from __future__ import annotations

import subprocess
import sys
import time

COMMANDS = {
    "python -c pass": ["-c", "pass"],
    "decide 3.18": ["-m", "chasles", "decide", "3.18"],
    "decide 3.2 to 3.4": ["-m", "chasles", "decide", "--section", "3.2", "--section", "3.3", "--section", "3.4"],
    "decide everything": ["-m", "chasles", "decide"],
    "decide everything, not checked again": ["-m", "chasles", "decide", "--no-recheck"],
}


def seconds(words: list[str]) -> float:
    """The wall time of one process."""
    started = time.perf_counter()
    subprocess.run([sys.executable, *words], stdout=subprocess.DEVNULL, check=True)
    return time.perf_counter() - started


def main() -> None:
    """Print a line for each command."""
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    least = {name: min(seconds(words) for _ in range(rounds)) for name, words in COMMANDS.items()}
    for name, value in least.items():
        print(f"{name:40} {value:6.2f} s")


if __name__ == "__main__":
    main()
