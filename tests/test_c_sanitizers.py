"""Every batched C function under sanitizers and Valgrind: hostile numbers, steps of every kind, storage of exact size.

A sample of the kernels is compiled, one of each section and those that have cases; with CHASLES_ADVERSARIAL set, all.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tomllib
from pathlib import Path
from typing import Any

import pytest

from .sampling import WHOLE

C = Path(__file__).resolve().parents[1] / "generated" / "c"
CC = shutil.which(os.environ.get("CC", "gcc")) or shutil.which("cc")
FULL = bool(os.environ.get("CHASLES_ADVERSARIAL"))
SAMPLE = ("section_3_2_2", "section_3_4_1")

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(CC is None or not C.exists(), reason="needs the checkout and a C compiler"),
]

DRIVER = """\
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "chasles.h"

static const double special[] = {{0.0, -0.0, 1.0, -1.0, 5e-324, -1e-310, 1e-45, -1e-39, 1e-200, 1e-160, 1e154, 1e300,
    -1e300, 3.4e38, 1e22, 1.6e6, -1.6e6, 1e15, 3.141592653589793, INFINITY, -INFINITY, NAN}};
static unsigned long state = 1;

static double drawn(void)
{{
    state = state * 6364136223846793005ul + 1442695040888963407ul;
    const unsigned long high = state >> 33;
    return high % 4 == 0 ? special[high / 4 % (sizeof special / sizeof *special)] : (double)(high % 2001) / 500.0 - 2.0;
}}

/* Storage of exactly the size that is needed; `first` is where item 0 lies. */
#define STORAGE(real) \\
    static real *storage_##real(size_t count, ptrdiff_t size, ptrdiff_t step, real **first) \\
    {{ \\
        const ptrdiff_t apart = step < 0 ? -step : step; \\
        const size_t all = count == 0 ? 0 : (size_t)((ptrdiff_t)(count - 1) * apart + size); \\
        real *numbers = malloc(all * sizeof(real) + (all == 0)); \\
        for (size_t i = 0; i < all; i++) {{ \\
            numbers[i] = (real)drawn(); \\
        }} \\
        *first = count > 0 && step < 0 ? numbers + (ptrdiff_t)(count - 1) * apart : numbers; \\
        return numbers; \\
    }}
STORAGE(double)
STORAGE(float)

{functions}
int main(void)
{{
    const size_t counts[] = {{0, 1, 2, 3, 5, 8, 17, 64, 65, 131}};
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {{
        for (int way = 0; way < 4; way++) {{
{calls}
        }}
    }}
    puts("done");
    return 0;
}}
"""


def manifest() -> dict[str, Any]:
    return tomllib.loads((C.parent / "MANIFEST.toml").read_text("utf-8"))["kernels"]


def sizes(part: str) -> list[int]:
    """How many numbers each operand has."""
    found = []
    for core in re.findall(r"\(([\d,]*)\)", part):
        size = 1
        for extent in re.findall(r"\d+", core):
            size *= int(extent)
        found.append(size)
    return found


def function(name: str, signature: str, real: str) -> str:
    """Calls one kernel's batched function with one count and one kind of steps."""
    inputs, outputs = (sizes(part) for part in signature.split("->"))
    lines, words = [], ["count"]
    for k, size in enumerate([*inputs, *outputs]):
        kind = "in" if k < len(inputs) else "out"
        choices = f"{size}, -{size}, 0, {size + 2}" if kind == "in" else f"{size}, {size + 1}, {size}, -{size}"
        lines.append(f"    const ptrdiff_t steps{k}[] = {{{choices}}};")
        lines.append(f"    {real} *x{k}, *all{k} = storage_{real}(count, {size}, steps{k}[way], &x{k});")
        words += [f"x{k}", f"steps{k}[way]"]
    lines.append(f"    chasles_{name}_batch{'f' if real == 'float' else ''}({', '.join(words)});")
    lines += [f"    free(all{k});" for k in range(len(inputs) + len(outputs))]
    return f"static void {name}_{real}(size_t count, int way)\n{{\n" + "\n".join(lines) + "\n}\n"


@pytest.fixture(scope="module")
def driver(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """Builds the program that calls the functions, with the options given."""

    def built(*options: str) -> Path:
        folder = tmp_path_factory.mktemp("driver")
        listed = {n: k for n, k in manifest().items() if FULL or k["section"] in SAMPLE}
        made = [function(n, k["signature"], real) for n, k in listed.items() for real in ("double", "float")]
        calls = [f"            {n}_{real}(counts[k], way);" for n in listed for real in ("double", "float")]
        source = folder / "driver.c"
        source.write_text(DRIVER.format(functions="\n".join(made), calls="\n".join(calls)), "utf-8")
        wanted = {k["section"] for k in listed.values()}
        files = [
            path
            for path in sorted((C / "src").glob("*.c"))
            if FULL or path.stem in ("trigonometry_blocks", "batches") or path.stem.removesuffix("_blocks") in wanted
        ]
        # What is not compiled is not linked: nothing of a section that is left out is called.
        words = [str(CC), "-std=c99", "-O1", *options, f"-I{C}/include", *map(str, [source, *files]), "-lm"]
        subprocess.run([*words, "-o", str(folder / "driver")], check=True)
        return folder / "driver"

    return built


def run(*command: object) -> tuple[int, str, str]:
    environment = {**os.environ, "ASAN_OPTIONS": "detect_leaks=0"}
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False, env=environment)
    return done.returncode, done.stdout, done.stderr


def test_sanitizers_have_nothing_to_report(driver: Any) -> None:
    program = driver("-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    assert run(program) == (0, "done\n", "")


@pytest.mark.skipif(shutil.which("valgrind") is None, reason="no valgrind")
@pytest.mark.skipif(not WHOLE, reason="sanitizers look at the same: set CHASLES_TEST_WHOLE=1")
def test_valgrind_has_nothing_to_report(driver: Any) -> None:
    program = driver("-g")
    assert run("valgrind", "--quiet", "--error-exitcode=9", "--leak-check=full", program) == (0, "done\n", "")


def test_a_step_too_far_would_be_reported(driver: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(globals(), "SAMPLE", SAMPLE[:1])
    monkeypatch.setitem(
        globals(), "DRIVER", DRIVER.replace("count - 1) * apart + size)", "count - 1) * apart + size - 1)")
    )
    program = driver("-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    code, _, said = run(program)
    assert code != 0
    assert "AddressSanitizer" in said
