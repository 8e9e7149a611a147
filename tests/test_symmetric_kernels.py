"""Symmetric matrices in six numbers: a second kernel from the same statement, proved like the first."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from chasles import kernels
from chasles.decisions.session import Session
from chasles.lowering.declaration import requested
from chasles.lowering.equivalence.requests import differences
from chasles.lowering.lower import program_of
from chasles.lowering.program import Op
from chasles.numerics.sampling import draw, moves
from chasles.numerics.specification import specification_of
from chasles.statements import Definition, Entry, Kernel, Packed, Section, Stack, load
from chasles.statements.arrays import SIX
from chasles.targets.commission import kernel_of
from chasles.targets.kernel import EmissionError
from chasles.vocabulary import CPM, scalar, square, vector

UPPER = np.triu_indices(3)
S, T = square("S", "S", "a matrix"), square("T", "T", "another matrix")
x, y, z = (scalar(name, name, "a number") for name in "xyz")
v = vector("v", "v", "a vector")
CONTRACT = {
    "inertia_about_point": ((), (3,), (3,)),
    "inertia_dyad": ((), (3,), (3,)),
    "kinetic_energy": ((), (6,)),
    "momentum_screw": ((), (6,)),
    "newton_euler_twist_rate": ((), (6,), (6,)),
    "newton_euler_wrench": ((), (6,), (6,)),
}


def entry(right, kernel: Kernel) -> Entry:
    return Entry("made", Section("9", "Tests"), Definition("9.1", T, right, says="Made.", kernel=kernel))


def made(right, kernel: Kernel):
    asked = entry(right, kernel)
    return [kernel_of(asked, Session().decide, variant) for variant in asked.kernels]


@pytest.mark.parametrize("name", CONTRACT)
def test_six_numbers_give_what_nine_do(name: str) -> None:
    generator = np.random.default_rng(11)
    root, *rest = (generator.standard_normal((50, *shape)) for shape in ((3, 3), *CONTRACT[name]))
    I_C = root @ np.swapaxes(root, -1, -2) + np.eye(3)
    whole = getattr(kernels, name)(I_C, *rest)
    six = getattr(kernels, f"{name}{SIX}")(I_C[:, *UPPER], *rest)
    expected = whole[:, *UPPER] if name == "inertia_about_point" else whole
    np.testing.assert_allclose(six, expected, rtol=1e-12, atol=1e-12)


def test_there_are_six() -> None:
    assert [name.removesuffix(SIX) for name in dir(kernels) if name.endswith(SIX)] == [*CONTRACT]


def test_the_order_is_that_of_the_upper_triangle() -> None:
    found = kernels.momentum_screw_sym6(np.arange(1.0, 7.0), 1.0, [1.0, 10.0, 100.0, 0.0, 0.0, 0.0])
    assert found[:3].tolist() == [321.0, 542.0, 653.0]


def test_nine_numbers_are_all_read() -> None:
    """The plain kernels do not assume symmetry: each of the nine numbers has its effect."""
    twist = np.arange(1.0, 7.0)
    for place in np.ndindex(3, 3):
        other = np.eye(3)
        other[place] += 1
        for kernel in (kernels.momentum_screw, kernels.kinetic_energy):
            assert np.any(kernel(np.eye(3), 1.0, twist) != kernel(other, 1.0, twist))


def test_what_is_symmetric_by_proof_is_packed() -> None:
    plain, packed = made(S @ S, Kernel(of=(S,), symmetric=(S, T)))
    assert [plain.name, packed.name] == ["made", "made_sym6"]
    assert [item.shape for item in plain.program.parameters] == [(3, 3), (3, 3)]
    assert [item.shape for item in packed.program.parameters] == [(6,), (6,)]
    assert packed.program.operations[Op.MULTIPLY] < plain.program.operations[Op.MULTIPLY]
    assert "symmetric, as (xx, xy, xz, yy, yz, zz)" in packed.program.arguments[0].meaning


def test_what_is_not_symmetric_is_refused() -> None:
    with pytest.raises(EmissionError, match="T is not symmetric in 1, 2: six numbers cannot stand for it"):
        made(S @ CPM(v), Kernel(of=(S, v), symmetric=(S, T)))


def test_a_program_that_reads_the_wrong_number_is_not_equal() -> None:
    asked = entry(S @ S, Kernel(of=(S,), symmetric=(S, T)))
    request = requested(asked, Session().decide, asked.kernels[1])
    program = program_of(request)
    assert differences(request, program) == ()
    swap = {1: 3, 3: 1}
    steps = tuple(replace(s, entry=swap.get(s.entry, s.entry)) if s.op is Op.INPUT else s for s in program.steps)
    assert differences(request, replace(program, steps=steps))


def test_scalars_are_stacked_in_their_order() -> None:
    (kernel,) = made(x * S - y * S, Kernel(of=(Stack("two", (x, y), "two numbers"), S)))
    assert [(item.name, item.shape) for item in kernel.program.arguments] == [("two", (2,)), ("S", (3, 3))]
    assert kernel.program.arguments[0].meaning == "two numbers"


def test_what_cannot_be_packed_or_stacked_is_refused() -> None:
    with pytest.raises(TypeError, match="six numbers stand for a 3 x 3 matrix, and x is no such"):
        Packed(x)
    with pytest.raises(TypeError, match="two stacks scalars, and S is 3 x 3"):
        Stack("two", (x, S))


def test_an_argument_of_which_nothing_is_used_is_refused() -> None:
    with pytest.raises(EmissionError, match="no result depends on the argument more"):
        made(x * S, Kernel(of=(x, S, Stack("more", (y, z)))))


def test_a_family_of_statements_is_declared_by_name() -> None:
    names = [e.name for e in load() if e.number == "Ex 3.10"]
    assert names[:2] == ["rates_of_the_angles", "elementary_rotation_x"]
    assert "euler_rates_zyz" in names
    assert len(names) == len(set(names)) == 148


def test_inputs_are_drawn_and_moved_symmetrically() -> None:
    asked = entry(S @ S, Kernel(of=(S,), symmetric=(S, T)))
    request = specification_of("made_sym6", asked.statement, asked.kernels[1])
    assert [(item.shape, item.nodes) for item in request.inputs] == [((6,), (S,))]
    assert [output.shape for output in request.outputs] == [(6,)]
    sample = next(draw(request, "generic", np.random.default_rng(5)))
    matrix = sample.arrays[S]
    assert (matrix == matrix.T).all()
    assert request.inputs[0].gathered(sample.arrays).tolist() == matrix[UPPER].tolist()
    neighbours = [(np.asarray(one), np.asarray(other)) for one, other in moves(request, S, matrix, sample.exact[S])]
    assert len(neighbours) == 6
    for one, other in neighbours:
        for moved in (one, other):
            assert (moved == moved.T).all()
            assert np.count_nonzero(moved != matrix) in (1, 2)
    ((value,),) = (request.reference(sample.arrays, 30),)
    np.testing.assert_allclose([float(row[0]) for row in value], (matrix @ matrix)[UPPER], rtol=1e-13)
