"""Methods of `sympy.physics.mechanics` as kernels: matrices as SymPy has them, accelerations that solve M a = f."""

from __future__ import annotations

import random
import sys
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp
from sympy.physics.mechanics import (
    Force,
    KanesMethod,
    LagrangesMethod,
    Lagrangian,
    Particle,
    PinJoint,
    Point,
    PrismaticJoint,
    ReferenceFrame,
    RigidBody,
    System,
    dynamicsymbols,
    inertia,
)
from sympy.physics.mechanics.models import multi_mass_spring_damper, n_link_pendulum_on_cart

import chasles
from chasles.compiling import LoweringError
from chasles.compiling.elimination import solved, solved_definite
from chasles.lowering.arithmetic import Operators, decimals, run
from chasles.lowering.builder import Builder
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Argument, Op, Program, Result

t = dynamicsymbols._t
m, g, l, k, c, r = sp.symbols("m g l k c r", positive=True)


@pytest.fixture(autouse=True)
def written(monkeypatch):
    monkeypatch.setenv("CC", "no-such-compiler")


class Exact(Operators):
    """Fractions; a sine, a cosine or a root is any number, the same for the same operand."""

    def __init__(self, seed):
        self.seed = seed

    @staticmethod
    def constant(value):
        return value

    @staticmethod
    def not_a_number():
        raise AssertionError("no model has one")

    def sine(self, a):
        return self._any("sine", a)

    def cosine(self, a):
        return self._any("cosine", a)

    def square_root(self, a):
        return self._any("root", a)

    def _any(self, *what):
        return Fraction(random.Random(f"{self.seed}{what}").randint(1, 10**6), 10**6)


def exactly(program, seed):
    """The results of a program at a random rational point."""
    draw = random.Random(seed)
    point = [[Fraction(draw.randint(1, 999), 100) for _ in range(int(np.prod(a.shape)))] for a in program.arguments]
    return dict(zip((each.name for each in program.results), run(program, point, Exact(seed)), strict=True))


def pendulum(constraints=False):
    """Of Lagrange, in the angle or in the plane with a rod of constant length."""
    N, O, P = ReferenceFrame("N"), Point("O"), Point("P")
    O.set_vel(N, 0)
    if constraints:
        q = list(dynamicsymbols("x y"))
        P.set_pos(O, q[0] * N.x + q[1] * N.y)
    else:
        q = [dynamicsymbols("theta")]
        P.set_pos(O, l * sp.sin(q[0]) * N.x - l * sp.cos(q[0]) * N.y)
    P.set_vel(N, P.pos_from(O).dt(N))
    bob = Particle("bob", P, m)
    bob.potential_energy = m * g * P.pos_from(O).dot(N.y)
    loads = [(P, -c * P.vel(N))]
    rod = {"hol_coneqs": [q[0] ** 2 + q[1] ** 2 - l**2]} if constraints else {}
    return LagrangesMethod(Lagrangian(N, bob), q, forcelist=loads, frame=N, **rod)


def rolling_disc():
    """Of Kane, with dependent speeds where it touches the ground."""
    q1, q2, q3, q4, q5 = q = dynamicsymbols("q1:6")
    u = dynamicsymbols("u1:6")
    N = ReferenceFrame("N")
    Y = N.orientnew("Y", "Axis", [q1, N.z])
    L = Y.orientnew("L", "Axis", [q2, Y.x])
    R = L.orientnew("R", "Axis", [q3, L.y])
    R.set_ang_vel(N, u[0] * L.x + u[1] * L.y + u[2] * L.z)
    O, C = Point("O"), Point("C")
    O.set_vel(N, 0)
    C.set_pos(O, q4 * N.x + q5 * N.y + r * L.z)
    C.set_vel(N, u[3] * N.x + u[4] * N.y)
    turn = Y.ang_vel_in(N) + L.ang_vel_in(Y) + R.ang_vel_in(L)
    rates = [(turn - R.ang_vel_in(N)).dot(each) for each in (L.x, L.y, L.z)]
    kinematic = [*rates, q4.diff(t) - u[3], q5.diff(t) - u[4]]
    contact = C.vel(N) + R.ang_vel_in(N).cross(-r * L.z)
    constraints = [contact.dot(N.x), contact.dot(N.y)]
    body = RigidBody("disc", C, R, m, (inertia(L, m * r**2 / 4, m * r**2 / 2, m * r**2 / 4), C))
    method = KanesMethod(
        N, list(q), list(u[:3]), kd_eqs=kinematic, u_dependent=list(u[3:]), velocity_constraints=constraints
    )
    method.kanes_equations([body], [(C, -m * g * N.z)])
    return method


def arm_of_joints(links=2, formed=True):
    """A `System` of bodies with pin joints, and a slide at the end."""
    ground = RigidBody("ground")
    system = System.from_newtonian(ground)
    parent = ground
    for number in range(links):
        link = RigidBody(f"link{number}")
        joint = PinJoint(
            f"pin{number}", parent, link, joint_axis=parent.z, child_point=-l * link.x, parent_point=l * parent.x
        )
        system.add_joints(joint)
        parent = link
    slide = RigidBody("slide")
    system.add_joints(PrismaticJoint("slider", parent, slide, joint_axis=parent.x))
    system.apply_uniform_gravity(-g * ground.y)
    system.add_loads(Force(slide.masscenter, sp.Function("F")(t) * parent.y))
    if formed:
        system.form_eoms()
    return system


def speeds_that_are_no_rates():
    """Of Kane, with kinematic equations that are to be solved."""
    x, y = dynamicsymbols("x y")
    u, v = dynamicsymbols("u v")
    N, P, O = ReferenceFrame("N"), Point("P"), Point("O")
    O.set_vel(N, 0)
    P.set_vel(N, u * N.x + (u * sp.cos(x) + v) * N.y)
    method = KanesMethod(N, [x, y], [u, v], kd_eqs=[2 * x.diff(t) - u, y.diff(t) - u * sp.cos(x) - v])
    method.kanes_equations([Particle("p", P, m)], [(P, (-k * x - c * x.diff(t) + sp.sin(t)) * N.x - k * y * N.y)])
    return method


def lagrange_of_two():
    method = pendulum()
    method.form_lagranges_equations()
    return method


def lagrange_with_a_rod():
    method = pendulum(constraints=True)
    method.form_lagranges_equations()
    return method


MODELS = {
    "pendulum on a cart": lambda: n_link_pendulum_on_cart(1),
    "two on a cart": lambda: n_link_pendulum_on_cart(2, joint_torques=True),
    "three on a cart": lambda: n_link_pendulum_on_cart(3),
    "spring": lambda: multi_mass_spring_damper(1, True, True),
    "springs": lambda: multi_mass_spring_damper(4, True, True),
    "pendulum": lagrange_of_two,
    "rod": lagrange_with_a_rod,
    "disc": rolling_disc,
    "arm": arm_of_joints,
    "kinematics": speeds_that_are_no_rates,
}
CONSTRAINED = {"rod", "disc"}


@pytest.fixture(scope="module", params=MODELS)
def model(request):
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CC", "no-such-compiler")
        method = MODELS[request.param]()
        outputs = ["mass_matrix", "forcing", "accelerations", "state_rates"]
        outputs += ["multipliers"] if request.param == "rod" else []
        return request.param, method, chasles.compile(method, outputs=outputs, name="model")


@pytest.mark.sampled(7)
@pytest.mark.parametrize("seed", range(3))
def test_accelerations_solve_the_equations_exactly(model, seed):
    name, _, kernel = model
    found = exactly(kernel.program, seed)
    a, f = [*found["accelerations"], *(-each for each in found.get("multipliers", ()))], found["forcing"]
    rows = np.array(found["mass_matrix"]).reshape(len(f), len(a))
    if name in ("two on a cart", "three on a cart", "arm", "kinematics"):
        # The matrix is symmetric as far as sines are sines: what is below the diagonal is what is factorised.
        rows = np.tril(rows) + np.tril(rows, -1).T
    assert [sum(x * y for x, y in zip(row, a, strict=True)) for row in rows] == list(f)


def test_matrices_are_those_of_sympy(model):
    _, method, kernel = model
    formed = getattr(method, "eom_method", None) or method
    draw = np.random.default_rng(3).uniform
    point = [draw(0.4, 1.4, argument.shape) for argument in kernel.program.arguments]
    found = dict(zip((each.name for each in kernel.program.results), kernel(*point), strict=True))
    values = {}
    for argument, numbers in zip(kernel.program.arguments, point, strict=True):
        said = argument.meaning.partition(": ")[2] or argument.name
        for text, number in zip(split(said), np.ravel(numbers), strict=True):
            values[text] = mpmath.mpf(float(number))
    kinematic = formed.kindiffdict() if isinstance(formed, KanesMethod) else {}

    def at(expression):
        expression = expression.subs(kinematic)
        variables = sorted(expression.atoms(sp.Derivative), key=str)
        variables += sorted(expression.subs(dict.fromkeys(variables, 0)).atoms(sp.core.function.AppliedUndef), key=str)
        standing = {variable: sp.Dummy() for variable in variables}
        plain = expression.xreplace(standing)
        numbers = {dummy: values[str(variable)] for variable, dummy in standing.items()}
        numbers |= {symbol: values[str(symbol)] for symbol in plain.free_symbols - set(standing.values())}
        return float(plain.subs(numbers).evalf(30))

    scale = max(np.abs(found["mass_matrix"]).max(), np.abs(found["forcing"]).max())
    for which, matrix in (("mass_matrix", formed.mass_matrix), ("forcing", formed.forcing)):
        right = np.array([at(sp.sympify(entry)) for entry in matrix])
        np.testing.assert_allclose(np.ravel(found[which]), right, rtol=1e-13, atol=1e-14 * scale)
    right = np.linalg.lstsq(
        *(np.array([at(each) for each in matrix]).reshape(matrix.shape) for matrix in whole(formed)), rcond=None
    )[0].ravel()
    count = len(formed.q) + len(formed.u)
    np.testing.assert_allclose(np.ravel(found["state_rates"]), right[:count], rtol=1e-9, atol=1e-9)
    np.testing.assert_array_equal(np.ravel(found["state_rates"])[len(formed.q) :], np.ravel(found["accelerations"]))
    if "multipliers" in found:
        np.testing.assert_allclose(np.ravel(found["multipliers"]), -right[count:], rtol=1e-9)


def whole(method):
    return method.mass_matrix_full, method.forcing_full


def split(said):
    """Texts between commas that stand in no brackets."""
    parts, depth = [""], 0
    for letter in said:
        depth += (letter in "([") - (letter in ")]")
        if letter == "," and not depth:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def test_a_zero_of_structure_costs_nothing():
    springs = chasles.compile(multi_mass_spring_damper(6), outputs="accelerations")
    assert springs.operations["divide"] == 6
    # Coordinates are relative: the matrix is full.
    chain = chasles.compile(n_link_pendulum_on_cart(4), outputs=["accelerations"])
    assert chain.operations["divide"] == 5
    assert sum(chain.operations.values()) < 300


def test_what_a_tridiagonal_system_costs_grows_with_its_size():
    def count(size, solve):
        build = Builder()
        entries = iter(build.input(0, entry) for entry in range(4 * size))
        rows = [[build.zero] * size for _ in range(size)]
        for i in range(size):
            rows[i][i] = next(entries)
            if i:
                rows[i][i - 1] = rows[i - 1][i] = next(entries)
        found = solve(build, rows, [next(entries) for _ in range(size)])
        result = Result("x", (size,), "the solution", tuple(found))
        return pruned(Program("x", (Argument("a", (4 * size,), ""),), build.steps, (result,))).operations.total()

    assert count(10, solved_definite) - count(9, solved_definite) == count(9, solved_definite) - count(
        8, solved_definite
    )
    assert count(10, solved_definite) < 100


@pytest.mark.parametrize("size", range(1, 7))
def test_rows_are_exchanged_where_the_pivot_is_small(size):
    draw = np.random.default_rng(size)
    build = Builder()
    rows = [[build.input(0, i * size + j) for j in range(size)] for i in range(size)]
    found = [entry for [entry] in solved(build, rows, [[build.input(1, i)] for i in range(size)])]
    arguments = (Argument("a", (size * size,), "rows"), Argument("b", (size,), "right"))
    program = pruned(Program("x", arguments, build.steps, (Result("x", (size,), "solution", tuple(found)),)))

    class Floats(Operators):
        constant = staticmethod(float)

    for _ in range(20):
        matrix, right = draw.normal(size=(size, size)), draw.normal(size=size)
        matrix[0, 0] *= 1e-17
        if size > 2:
            matrix[1, :2] = 0
        [values] = run(program, [matrix.ravel().tolist(), right.tolist()], Floats())
        wanted = np.linalg.solve(matrix, right)
        assert np.abs(np.array(values) - wanted).max() <= 1e-13 * np.linalg.cond(matrix) * np.abs(wanted).max()


def test_inputs_may_be_said():
    method = n_link_pendulum_on_cart(1)
    g_, l0, m0, m1 = sp.symbols("g l0 m0 m1")
    inputs = {"state": [*method.q, *method.u], "F": dynamicsymbols("F"), "g": g_, "p": [l0, m0, m1]}
    kernel = chasles.compile(method, inputs, outputs="state_rates")
    assert kernel.signature == "(4),(),(),(3)->(4)"
    usual = chasles.compile(method, outputs="state_rates")
    assert usual.inputs["parameters"] == "4 numbers: g, l0, m0, m1"
    np.testing.assert_allclose(
        kernel(state=[1, 2, 3, 4], F=5, g=9, p=[1, 2, 3]), usual([1, 2], [3, 4], 5, [9, 1, 2, 3]), rtol=1e-13
    )
    with pytest.raises(LoweringError, match="F\\(t\\), g, l0, m0, m1 are not among"):
        chasles.compile(method, {"state": [*method.q, *method.u]})


def test_what_has_no_equations_yet_says_so():
    N, q, u = ReferenceFrame("N"), dynamicsymbols("q"), dynamicsymbols("u")
    for method, said in [
        (KanesMethod(N, [q], [u], kd_eqs=[q.diff(t) - u]), r"KanesMethod .* kanes_equations"),
        (pendulum(), r"LagrangesMethod .* form_lagranges_equations\(\)"),
        (arm_of_joints(formed=False), r"System .* form_eoms\(\)"),
        (Particle("P"), r"Particle has no equations of motion to compile"),
        (q * N.x, r"q\(t\)\*N.x has components in a frame: give them, as .to_matrix\(frame\)"),
        (inertia(N, 1, 2, q), r"has components in a frame"),
        (m * g, "inputs is missing"),
    ]:
        with pytest.raises(LoweringError, match=said):
            chasles.compile(method, [q] if hasattr(method, "to_matrix") else None)


@pytest.mark.parametrize("outputs", ["inverse", [], ["forcing", "forcing"], ["multipliers"]])
def test_what_is_not_offered_is_named(outputs):
    with pytest.raises(LoweringError, match="are some of mass_matrix, forcing, accelerations, state_rates; not"):
        chasles.compile(n_link_pendulum_on_cart(1), outputs=outputs)


def test_a_matrix_that_is_not_symmetric_is_not_taken_for_one():
    N, P, O = ReferenceFrame("N"), Point("P"), Point("O")
    q, u = dynamicsymbols("q1:4"), dynamicsymbols("u1:4")
    B = N.orientnew("B", "Axis", [0, N.x])
    B.set_ang_vel(N, u[0] * N.x + u[1] * N.y + u[2] * N.z)
    O.set_vel(N, 0)
    P.set_vel(N, 0)
    skew = inertia(N, *sp.symbols("Ix Iy Iz")) + k * (N.x | N.y)
    method = KanesMethod(N, list(q), list(u), kd_eqs=[a.diff(t) - b for a, b in zip(q, u, strict=True)])
    method.kanes_equations([RigidBody("b", P, B, m, (skew, P))], [(B, c * N.x + g * N.y)])
    kernel = chasles.compile(method)
    matrix, right, rates = (
        np.array(each)
        for each in kernel(*(np.full(a.shape, 0.3) + np.arange(a.shape[0]) for a in kernel.program.arguments))
    )
    assert (matrix != matrix.T).any()
    np.testing.assert_allclose(matrix @ rates, right, atol=1e-14)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", ["two on a cart", "rod", "disc", "kinematics"])
def test_accelerations_are_differentiated_by_all_that_goes_in(name):
    program = chasles.compile(MODELS[name](), outputs="accelerations", jacobian=True).program
    assert [result.name for result in program.results] == ["accelerations", "accelerations_jacobian"]
    numbers = decimals(60)
    sizes = [int(np.prod(argument.shape)) for argument in program.arguments]
    flat = [numbers.sine(numbers.constant(Fraction(k**2))) + 2 for k in range(1, sum(sizes) + 1)]

    def at(place, step):
        moved = iter(value + step * (k == place) for k, value in enumerate(flat))
        return run(program, [[next(moved) for _ in range(size)] for size in sizes], numbers)

    step = numbers.constant(Fraction(1, 10**20))
    _, slopes = at(0, 0 * step)
    for place in range(len(flat)):
        (up, _), (down, _) = at(place, step), at(place, -step)
        for k, (above, below) in enumerate(zip(up, down, strict=True)):
            found = slopes[k * len(flat) + place]
            assert abs(found - (above - below) / (2 * step)) <= numbers.constant(Fraction(1, 10**25)) * (1 + abs(found))


def test_a_matrix_that_is_singular_as_it_stands_is_refused():
    build = Builder()
    x = build.input(0, 0)
    with pytest.raises(LoweringError, match="singular whatever its entries are: for a method ask for outputs="):
        solved(build, [[x, build.zero], [x, build.zero]], [[x], [x]])
    with pytest.raises(LoweringError, match="singular whatever its entries are: for a method ask for outputs="):
        solved_definite(build, [[x, build.zero], [build.zero, build.zero]], [x, x])


def test_operations_are_shared_between_results():
    one = chasles.compile(n_link_pendulum_on_cart(2), outputs="accelerations").program
    more = chasles.compile(n_link_pendulum_on_cart(2)).program
    assert more.operations[Op.DIVIDE] == one.operations[Op.DIVIDE]
    assert more.operations.total() == one.operations.total()


def test_what_was_made_of_a_method_is_not_made_again(tmp_path, monkeypatch):
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path))
    asked = [{}, {"outputs": "state_rates"}, {"outputs": "accelerations", "jacobian": True, "wrt": "q"}]
    asked.append(asked[-1] | {"wrt": "u"})
    pendulum = n_link_pendulum_on_cart(1)
    made = [chasles.compile(pendulum, **options) for options in asked]
    monkeypatch.delattr(sys.modules["chasles.compiling.mechanics"], "program_of")
    again = [chasles.compile(n_link_pendulum_on_cart(1), **options) for options in asked]
    assert [kernel.program for kernel in again] == [kernel.program for kernel in made]
    assert len({repr(kernel.program) for kernel in made}) == len(asked)
    with pytest.raises(NameError):
        chasles.compile(pendulum, outputs="state_rates", name="other")
