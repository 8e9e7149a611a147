"""A language is a folder: one made in a temporary place emits, and nothing else has to know of it."""

from __future__ import annotations

from fractions import Fraction

import pytest

import chasles
from chasles.lowering.program import Argument, Op, Program, Result, Step
from chasles.targets import EmissionError, Heading, TargetKernel, discover, render, stale, write

LANGUAGE = """
from pathlib import Path

from chasles.lowering.program import Op
from chasles.targets.constants import DOUBLE, literals
from chasles.targets.dialect import ARITHMETIC, Dialect, call
from chasles.targets.spelling import spelled
from chasles.targets.target import Page, Target

JULIA = Dialect(
    spell={**ARITHMETIC, Op.SQUARE_ROOT: call("sqrt"), Op.SINE: call("sin"), Op.COSINE: call("cos"),
           Op.ARCTANGENT2: call("atan", 2), Op.SELECT: call("ifelse", 3)},
    constant=literals(DOUBLE),
    component=lambda name, shape, entry: f"{name}[{entry + 1}]" if shape else name,
    declare=lambda name, text, truth: f"{name} = {text}",
    reserved=frozenset({"end", "function", "pi"}),
    name_entries=False,
)


def pages(kernels):
    functions = [{"name": kernel.name, "number": kernel.heading.number, "text": spelled(kernel.program, JULIA)}
                 for kernel in kernels]
    yield Page("src/Chasles.jl", "Chasles.jl.jinja", {"functions": functions})


TARGET = Target("julia", Path(__file__).parent, pages)
"""
TEMPLATE = """# made by chasles emit
{% for function in functions %}

# ({{ function.number }})
function {{ function.name }}({% for name in function.text.arguments %}{{ name }}, {% endfor %})
{% for line in function.text.lines %}
    {{ line }}
{% endfor %}
    return {% for entries in function.text.entries %}[{% for entry in entries %}{{ entry }}, {% endfor %}],{% endfor %}

end
{% endfor %}
"""
EXPECTED = """# made by chasles emit

# (3.1)
function half_turn(x, end_, )
    sin_end_ = sin(end_)
    return [sin_end_ * x[2], 0.5 * sin_end_, ],
end
"""


@pytest.fixture
def kernel():
    steps = (
        Step(Op.INPUT, argument=0, entry=1),
        Step(Op.INPUT, argument=1),
        Step(Op.SINE, (1,)),
        Step(Op.MULTIPLY, (2, 0)),
        Step(Op.CONSTANT, value=Fraction(1, 2)),
        Step(Op.MULTIPLY, (4, 2)),
    )
    arguments = Argument("x", (3,), "a vector"), Argument("end", (), "an angle")
    program = Program("half_turn", arguments, steps, (Result("y", (2,), "two numbers", (3, 5)),))
    return TargetKernel(program, Heading("3.1", "A toy.", "holds", (), "0" * 64))


@pytest.fixture
def folder(tmp_path):
    folder = tmp_path / "julia"
    folder.mkdir()
    (folder / "__init__.py").write_text(LANGUAGE)
    (folder / "Chasles.jl.jinja").write_text(TEMPLATE)
    return folder


def test_a_folder_is_a_language(folder, kernel, tmp_path):
    plain = render([kernel], discover())
    targets = discover([folder])
    assert [target.name for target in targets] == [*(target.name for target in discover()), "julia"]
    texts = render([kernel], targets)
    assert texts["julia/src/Chasles.jl"] == EXPECTED
    others = {path for path in texts if path not in ("MANIFEST.toml", "README.md", "julia/src/Chasles.jl")}
    assert {path: texts[path] for path in others} == {path: plain[path] for path in others}
    write(tmp_path / "generated", texts)
    assert stale(tmp_path / "generated", texts) == ()
    assert (tmp_path / "generated/julia/src/Chasles.jl").read_text() == EXPECTED


@pytest.mark.parametrize("key", ["values", "items", "keys", "get", "pop", "copy", "update", "clear"])
@pytest.mark.parametrize("asked", ["{{ function.KEY }}", "{% for x in function.KEY %}{{ x }}{% endfor %}"])
@pytest.mark.parametrize("is_given", [True, False])
def test_a_key_that_is_the_name_of_a_method_is_named(folder, kernel, key, asked, is_given):
    if is_given:
        (folder / "__init__.py").write_text(
            LANGUAGE.replace('"name": kernel.name', f'"{key}": "", "name": kernel.name')
        )
    line = asked.replace("KEY", key)
    (folder / "Chasles.jl.jinja").write_text(TEMPLATE.replace("# ({{ function.number }})", line))
    said = f"target julia: template Chasles.jl.jinja: .*the key '{key}' is the name of a method"
    with pytest.raises(EmissionError, match=said):
        render([kernel], discover([folder]))


def test_every_file_of_code_begins_with_its_licence_and_version(kernel):
    for path, text in render([kernel], discover()).items():
        if path.endswith((".c", ".h", ".py")):
            licence, version = text.split("\n")[:2]
            assert licence.strip("/*# ") == "SPDX-License-Identifier: BSD-3-Clause", path
            assert version.strip("/*# ") == f"Emitted by chasles {chasles.__version__}.", path


def test_the_header_has_a_line_for_each_kernel_and_names_the_file_of_its_contract(kernel):
    texts = render([kernel], discover())
    assert "\n/* (3.1) x[3], end -> y[2]; src/kernels.c */\n" in texts["c/include/chasles.h"]
    assert "A toy." in texts["c/src/kernels.c"]
    assert "A toy." not in texts["c/include/chasles.h"]


def test_a_language_alone(folder, kernel):
    (julia,) = (target for target in discover([folder]) if target.name == "julia")
    assert set(render([kernel], [julia])) == {"julia/src/Chasles.jl", "README.md", "__init__.py", "MANIFEST.toml"}


def test_a_language_without_an_operation_says_so(folder, kernel):
    text = LANGUAGE.replace('Op.SINE: call("sin"), ', "")
    (folder / "__init__.py").write_text(text)
    with pytest.raises(EmissionError, match=r"target julia: half_turn: .* does not spell 'sine'"):
        render([kernel], discover([folder]))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "no target: its __init__.py must set TARGET"),
        ("1 / 0\n", "does not load: ZeroDivisionError"),
        (LANGUAGE.replace('Target("julia"', 'Target("fortran"'), "must have the target's name"),
        (None, r"no __init__\.py"),
    ],
)
def test_a_folder_that_is_no_language_says_why(folder, text, message):
    if text is None:
        (folder / "__init__.py").unlink()
    else:
        (folder / "__init__.py").write_text(text)
    with pytest.raises(EmissionError, match=message):
        discover([folder])


def test_two_languages_of_one_name_are_refused(folder):
    with pytest.raises(EmissionError, match="two targets are called 'julia'"):
        discover([folder, folder])
