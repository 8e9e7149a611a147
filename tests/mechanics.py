"""Some 150 equations of textbook mechanics under their equations of motion, and whether each is true.

SymPy takes seconds to write them: whoever only collects tests need not import this.
"""

from __future__ import annotations

from typing import Any

from sympy import Eq, Function, Matrix, Symbol, cos, diag, diff, expand, eye, sin, sqrt, symbols, zeros

t = symbols("t")
m, M, g, l, k, c, R, I1, b, mu, om, G, q, B, E0 = symbols("m M g l k c R I b mu omega G q B E0", positive=True)
F, x0, v0, a0 = symbols("F x0 v0 a0")


def fn(name: str) -> Any:
    return Function(name)(t)


x, y, z, th, ph, r, psi, u, v, lam = [fn(n) for n in ("x", "y", "z", "th", "ph", "r", "psi", "u", "v", "lam")]
t1, t2 = fn("t1"), fn("t2")
l1, l2, m1, m2 = symbols("l1 l2 m1 m2", positive=True)


def d(expression: Any, times: int = 1) -> Any:
    return diff(expression, t, times)


def vec(name: str) -> Any:
    return Matrix([fn(f"{name}{i}") for i in (1, 2, 3)])


r_, v_, w, L, p_, e, a_, s_ = [vec(n) for n in ("r", "v", "w", "L", "p", "e", "a", "s")]
J = symbols("J1:4")
Jm = Matrix(3, 3, lambda i, j: Symbol(f"J{min(i, j) + 1}{max(i, j) + 1}"))
eul = [
    Eq(J[0] * d(w[0]), (J[1] - J[2]) * w[1] * w[2]),
    Eq(J[1] * d(w[1]), (J[2] - J[0]) * w[2] * w[0]),
    Eq(J[2] * d(w[2]), (J[0] - J[1]) * w[0] * w[1]),
]
D = diag(*J)


def skew(a: Any) -> Any:
    return Matrix([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def lagr(kinetic: Any, potential: Any, coordinates: list[Any]) -> list[Any]:
    """Lagrange's equations."""
    difference = kinetic - potential
    return [Eq(d(diff(difference, d(q))) - diff(difference, q), 0) for q in coordinates]


__all__ = ["CASES"]

CASES: dict[str, tuple[Any, Any, list[Any], bool]] = {}


def add(name: str, lhs: Any, rhs: Any, given: Any = (), truth: bool = True) -> None:
    assert name not in CASES
    CASES[name] = lhs, rhs, list(given), truth


# oscillator
osc = [Eq(m * d(x, 2), -k * x)]
add("osc energy", d(m * d(x) ** 2 / 2 + k * x**2 / 2), 0, osc)
add("osc energy F", d(m * d(x) ** 2 / 2 - k * x**2 / 2), 0, osc, False)
add("osc 4", d(x, 4), k**2 / m**2 * x, osc)
add("osc 3", d(x, 3), -k / m * d(x), osc)
damp = [Eq(m * d(x, 2) + c * d(x) + k * x, 0)]
add("damp", d(m * d(x) ** 2 / 2 + k * x**2 / 2), -c * d(x) ** 2, damp)
add("dampF", d(m * d(x) ** 2 / 2 + k * x**2 / 2), 0, damp, False)
forced = [Eq(m * d(x, 2) + c * d(x) + k * x, E0 * cos(om * t))]
add("forced power", d(m * d(x) ** 2 / 2 + k * x**2 / 2), -c * d(x) ** 2 + E0 * cos(om * t) * d(x), forced)
add("forced diff", m * d(x, 3) + c * d(x, 2) + k * d(x), -E0 * om * sin(om * t), forced)
add("forced diffF", m * d(x, 3) + c * d(x, 2) + k * d(x), E0 * om * sin(om * t), forced, False)
add("sol sin", d(x, 2) + om**2 * x, 0, [Eq(x, a0 * sin(om * t) + v0 * cos(om * t))])
add("sol sinF", d(x, 2) - om**2 * x, 0, [Eq(x, a0 * sin(om * t) + v0 * cos(om * t))], False)
add("fall", d(x), v0 - g * t, [Eq(x, x0 + v0 * t - g * t**2 / 2)])
add("fall v2", d(x) ** 2, v0**2 - 2 * g * (x - x0), [Eq(x, x0 + v0 * t - g * t**2 / 2)])
add("fallE", d(m * d(x) ** 2 / 2 + m * g * x), 0, [Eq(d(x, 2), -g)])
# pendulums
pen = [Eq(m * l**2 * d(th, 2) + m * g * l * sin(th), 0)]
add("pendE", d(m * l**2 * d(th) ** 2 / 2 - m * g * l * cos(th)), 0, pen)
add("pendEF", d(m * l**2 * d(th) ** 2 / 2 + m * g * l * cos(th)), 0, pen, False)
add("pend3", d(th, 3), -g / l * cos(th) * d(th), pen)
add("pend lag", l * d(th, 2) + g * sin(th), 0, lagr(m * l**2 * d(th) ** 2 / 2, -m * g * l * cos(th), [th]))
pc = [Eq(m * d(x, 2), -lam * x), Eq(m * d(y, 2), -lam * y - m * g), Eq(x**2 + y**2, l**2)]
add("pendC ten", lam * l**2, m * (d(x) ** 2 + d(y) ** 2) - m * g * y, pc)
add("pendC E", d(m * (d(x) ** 2 + d(y) ** 2) / 2 + m * g * y), 0, pc)
add("pendC v", x * d(x) + y * d(y), 0, pc)
add("pendC F", lam * l**2, m * (d(x) ** 2 + d(y) ** 2) + m * g * y, pc, False)
add("pendC xy", x * d(y, 2) - y * d(x, 2), -g * x, pc)
add("pend polar", (l * sin(th)).diff(t) ** 2 + (-l * cos(th)).diff(t) ** 2, l**2 * d(th) ** 2)
X1, Y1 = l1 * sin(t1), -l1 * cos(t1)
X2, Y2 = X1 + l2 * sin(t2), Y1 - l2 * cos(t2)
T = m1 * (d(X1) ** 2 + d(Y1) ** 2) / 2 + m2 * (d(X2) ** 2 + d(Y2) ** 2) / 2
V = m1 * g * Y1 + m2 * g * Y2
dp = lagr(T, V, [t1, t2])
add(
    "dp T",
    T,
    (m1 + m2) * l1**2 * d(t1) ** 2 / 2 + m2 * l2**2 * d(t2) ** 2 / 2 + m2 * l1 * l2 * d(t1) * d(t2) * cos(t1 - t2),
)
add("dp E", d(T + V), 0, dp)
add("dp EF", d(T - V), 0, dp, False)
add(
    "dp eq",
    (m1 + m2) * l1 * d(t1, 2)
    + m2 * l2 * d(t2, 2) * cos(t1 - t2)
    + m2 * l2 * d(t2) ** 2 * sin(t1 - t2)
    + (m1 + m2) * g * sin(t1),
    0,
    dp,
)
add("dp eq2", l2 * d(t2, 2) + l1 * d(t1, 2) * cos(t1 - t2) - l1 * d(t1) ** 2 * sin(t1 - t2) + g * sin(t2), 0, dp)
xs = Matrix([l * sin(th) * cos(ph), l * sin(th) * sin(ph), -l * cos(th)])
vs = d(xs)
Ts = m * vs.dot(vs) / 2
Vs = m * g * xs[2]
sph = lagr(Ts, Vs, [th, ph])
add("sp T", Ts, m * l**2 * (d(th) ** 2 + sin(th) ** 2 * d(ph) ** 2) / 2)
add("sp E", d(Ts + Vs), 0, sph)
add("sp L", d(m * l**2 * sin(th) ** 2 * d(ph)), 0, sph)
add("sp LF", d(m * l**2 * sin(th) * d(ph)), 0, sph, False)
add("sp th", d(th, 2), sin(th) * cos(th) * d(ph) ** 2 - g / l * sin(th), sph)
add("sp thF", d(th, 2), sin(th) * cos(th) * d(ph) ** 2 + g / l * sin(th), sph, False)
# cart pendulum
Tc = M * d(x) ** 2 / 2 + m * ((d(x) + l * cos(th) * d(th)) ** 2 + (l * sin(th) * d(th)) ** 2) / 2
Vc = -m * g * l * cos(th)
cart = lagr(Tc, Vc, [x, th])
add("cart E", d(Tc + Vc), 0, cart)
add("cart p", d((M + m) * d(x) + m * l * cos(th) * d(th)), 0, cart)
add("cart eq", l * d(th, 2) + cos(th) * d(x, 2) + g * sin(th), 0, cart)
add("cart eqF", l * d(th, 2) - cos(th) * d(x, 2) + g * sin(th), 0, cart, False)
# Kepler
kep = [Eq(d(r, 2) - r * d(ph) ** 2, -mu / r**2), Eq(r * d(ph, 2) + 2 * d(r) * d(ph), 0)]
add("kep L", d(r**2 * d(ph)), 0, kep)
add("kep E", d(d(r) ** 2 / 2 + r**2 * d(ph) ** 2 / 2 - mu / r), 0, kep)
add("kep EF", d(d(r) ** 2 / 2 + r**2 * d(ph) ** 2 / 2 + mu / r), 0, kep, False)
rr = sqrt(x**2 + y**2)
kc = [Eq(d(x, 2), -mu * x / rr**3), Eq(d(y, 2), -mu * y / rr**3)]
add("kepc L", d(x * d(y) - y * d(x)), 0, kc)
add("kepc E", d((d(x) ** 2 + d(y) ** 2) / 2 - mu / rr), 0, kc)
add("kepc EF", d((d(x) ** 2 + d(y) ** 2) / 2 + mu / rr), 0, kc, False)
ex = d(y) * (x * d(y) - y * d(x)) - mu * x / rr
add("kepc Runge", d(ex), 0, kc)
add("kepc RungeF", d(d(y) * (x * d(y) - y * d(x)) + mu * x / rr), 0, kc, False)
r3 = sqrt(r_.dot(r_))
k3 = [Eq(d(r_, 2), -mu * r_ / r3**3)]
add("kep3 L", d(r_.cross(d(r_))), zeros(3, 1), k3)
add("kep3 E", d(d(r_).dot(d(r_)) / 2 - mu / r3), 0, k3)
add("kep3 A", d(d(r_).cross(r_.cross(d(r_))) - mu * r_ / r3), zeros(3, 1), k3)
add("kep3 plane", r_.dot(r_.cross(d(r_))), 0)
kl = lagr(m * (d(r) ** 2 + r**2 * d(ph) ** 2) / 2, -mu * m / r, [r, ph])
add("kepl L", d(m * r**2 * d(ph)), 0, kl)
add("kepl E", d(m * (d(r) ** 2 + r**2 * d(ph) ** 2) / 2 - mu * m / r), 0, kl)
add("kepl areal", r * d(ph, 2), -2 * d(r) * d(ph), kl)
# euler
add("eul E", d((J[0] * w[0] ** 2 + J[1] * w[1] ** 2 + J[2] * w[2] ** 2) / 2), 0, eul)
add("eul L", d((D * w).dot(D * w)), 0, eul)
add("eul F", d(w.dot(w)), 0, eul, False)
eulv = [Eq(D * d(w), -w.cross(D * w))]
add("eulv E", d(w.dot(D * w) / 2), 0, eulv)
add("eulv L", d((D * w).dot(D * w)), 0, eulv)
eulm = [Jm * d(w) + w.cross(Jm * w)]
add("eulm E", d(w.dot(Jm * w) / 2), 0, eulm)
add("eulm L", d((Jm * w).dot(Jm * w)), 0, eulm)
add("eulm F", d((Jm * w).dot(w)), w[0], eulm, False)
N_ = Matrix(symbols("N1:4"))
eulN = [Jm * d(w) + w.cross(Jm * w) - N_]
add("eulN P", d(w.dot(Jm * w) / 2), w.dot(N_), eulN)
add(
    "sym top w3",
    J[2] * d(w[2]),
    0,
    [
        Eq(J[0] * d(w[0]), (J[0] - J[2]) * w[1] * w[2]),
        Eq(J[0] * d(w[1]), (J[2] - J[0]) * w[2] * w[0]),
        Eq(J[2] * d(w[2]), 0),
    ],
)
add(
    "sym top wt",
    J[0] * d(w[0] ** 2 + w[1] ** 2),
    0,
    [Eq(J[0] * d(w[0]), (J[0] - J[2]) * w[1] * w[2]), Eq(J[0] * d(w[1]), (J[2] - J[0]) * w[2] * w[0])],
)
# rotating frames
add("pois", d(e.dot(e)), 0, [d(e) - w.cross(e)])
add("pois2", e.dot(d(e)), 0, [d(e) - w.cross(e)])
add("pois3", w.dot(d(e)), 0, [d(e) - w.cross(e)])
add("pois4", d(e, 2), d(w).cross(e) + w.cross(w.cross(e)), [d(e) - w.cross(e)])
add("pois4F", d(e, 2), d(w).cross(e) - w.cross(w.cross(e)), [d(e) - w.cross(e)], False)
add("pois dot", d(e.dot(a_)), 0, [d(e) - w.cross(e), d(a_) - w.cross(a_)])
add("pois cross", d(e.cross(a_)), w.cross(e.cross(a_)), [d(e) - w.cross(e), d(a_) - w.cross(a_)])
add("w from e", w, e.cross(d(e)) + e.dot(w) * e, [d(e) - w.cross(e), Eq(e.dot(e), 1)])
Rm = Matrix(3, 3, [fn(f"R{i}{j}") for i in (1, 2, 3) for j in (1, 2, 3)])
rot = [Rm.T * Rm - eye(3), Eq(Rm.det(), 1)]
kin = [d(Rm) - skew(w) * Rm, *rot]
add("R skew", d(Rm) * Rm.T + (d(Rm) * Rm.T).T, zeros(3, 3), rot[:1])
add("RT inv", d(Rm.T * Rm), zeros(3, 3), [d(Rm) - skew(w) * Rm])
cons = Matrix(symbols("b1:4"))
add("R vel", d(Rm * cons), w.cross(Rm * cons), [d(Rm) - skew(w) * Rm])
add("R velF", d(Rm * cons), (Rm * cons).cross(w), [d(Rm) - skew(w) * Rm], False)
add("R acc", d(Rm * cons, 2), d(w).cross(Rm * cons) + w.cross(w.cross(Rm * cons)), [d(Rm) - skew(w) * Rm])
add("R bodyLdot", d(Rm * Jm * Rm.T * w), zeros(3, 1), [d(Rm) - skew(w) * Rm], False)
# angular momentum
nt = [Eq(m * d(r_, 2), vec("f"))]
ff = vec("f")
add("torque", d(m * r_.cross(d(r_))), r_.cross(ff), nt)
add("work", d(m * d(r_).dot(d(r_)) / 2), ff.dot(d(r_)), nt)
add("workF", d(m * d(r_).dot(d(r_)) / 2), ff.dot(r_), nt, False)
two = [Eq(m1 * d(r_, 2), ff), Eq(m2 * d(s_, 2), -ff)]
add("two P", d(m1 * d(r_) + m2 * d(s_)), zeros(3, 1), two)
add("two cm", d((m1 * r_ + m2 * s_) / (m1 + m2), 2), zeros(3, 1), two)
add("two rel", m1 * m2 / (m1 + m2) * d(r_ - s_, 2), ff, two)
add("two relF", m1 * m2 / (m1 + m2) * d(r_ - s_, 2), -ff, two, False)
add("two LF", d(m1 * r_.cross(d(r_)) + m2 * s_.cross(d(s_))), zeros(3, 1), two, False)
add("two L", d(m1 * r_.cross(d(r_)) + m2 * s_.cross(d(s_))), (r_ - s_).cross(ff), two)
# charged particle
Bv = Matrix(symbols("B1:4"))
lor = [m * d(v_) - q * v_.cross(Bv)]
add("lor E", d(m * v_.dot(v_) / 2), 0, lor)
add("lor par", d(v_.dot(Bv)), 0, lor)
add("lor F", d(v_.dot(v_)), v_.dot(Bv), lor, False)
add("lor 2", m**2 * d(v_, 2), q**2 * (v_.dot(Bv) * Bv - Bv.dot(Bv) * v_).applyfunc(expand), lor)
cyc = [Eq(d(x, 2), om * d(y)), Eq(d(y, 2), -om * d(x))]
add("cyc", d(d(x) ** 2 + d(y) ** 2), 0, cyc)
add("cyc3", d(x, 3), -(om**2) * d(x), cyc)
add("cyc inv", d(d(x) - om * y), 0, cyc)
add("cycF", d(x, 3), om**2 * d(x), cyc, False)
# rolling, constraint
rol = [Eq(d(x), R * d(th)), Eq(m * d(x, 2), m * g * sin(c) - F), Eq(I1 * d(th, 2), F * R)]
add("roll a", d(x, 2) * (m + I1 / R**2), m * g * sin(c), rol)
add("roll F", F * (1 + m * R**2 / I1), m * g * sin(c), rol)
add("roll FF", F, m * g * sin(c), rol, False)
atw = [Eq(m1 * d(x, 2), m1 * g - F), Eq(m2 * d(y, 2), m2 * g - F), Eq(x + y, l)]
add("atw a", (m1 + m2) * d(x, 2), (m1 - m2) * g, atw)
add("atw T", F * (m1 + m2), 2 * m1 * m2 * g, atw)
add("atw TF", F * (m1 + m2), m1 * m2 * g, atw, False)
bead = lagr(m * (d(r) ** 2 + r**2 * om**2) / 2, 0, [r])
add("bead", d(r, 2), om**2 * r, bead)
add("beadE", d(d(r) ** 2 - om**2 * r**2), 0, bead)
hoop = lagr(m * R**2 * (d(th) ** 2 + om**2 * sin(th) ** 2) / 2, -m * g * R * cos(th), [th])
add("hoop", d(th, 2), (om**2 * cos(th) - g / R) * sin(th), hoop)
add("hoopJ", d(d(th) ** 2 / 2 - om**2 * sin(th) ** 2 / 2 - g / R * cos(th)), 0, hoop)
add("hoopF", d(th, 2), (om**2 * cos(th) + g / R) * sin(th), hoop, False)
# hamilton
pq, qq = fn("P"), fn("Q")
ham = [Eq(d(qq), pq / m), Eq(d(pq), -k * qq)]
add("ham E", d(pq**2 / (2 * m) + k * qq**2 / 2), 0, ham)
add("ham 2", d(qq, 2), -k / m * qq, ham)
add("hamF", d(pq * qq), 0, ham, False)
add("ham pq", d(pq * qq), pq**2 / m - k * qq**2, ham)
hp = [Eq(d(th), pq / (m * l**2)), Eq(d(pq), -m * g * l * sin(th))]
add("hamp", d(pq**2 / (2 * m * l**2) - m * g * l * cos(th)), 0, hp)
add("hamp2", d(th, 2), -g / l * sin(th), hp)
ht = [Eq(d(r), u / m), Eq(d(u), v**2 / (m * r**3) - m * mu / r**2), Eq(d(ph), v / (m * r**2)), Eq(d(v), 0)]
add("hamkep", d(u**2 / (2 * m) + v**2 / (2 * m * r**2) - m * mu / r), 0, ht)
# top
A, C3 = symbols("A C", positive=True)
Tt = A * (d(th) ** 2 + d(ph) ** 2 * sin(th) ** 2) / 2 + C3 * (d(psi) + d(ph) * cos(th)) ** 2 / 2
Vt = m * g * l * cos(th)
top = lagr(Tt, Vt, [th, ph, psi])
add("top E", d(Tt + Vt), 0, top)
add("top psi", d(C3 * (d(psi) + d(ph) * cos(th))), 0, top)
add("top phi", d(A * d(ph) * sin(th) ** 2 + C3 * (d(psi) + d(ph) * cos(th)) * cos(th)), 0, top)
add("top F", d(d(psi)), 0, top, False)
# coupled
cp = [Eq(m * d(x, 2), -k * x + c * (y - x)), Eq(m * d(y, 2), -k * y - c * (y - x))]
add("coup sum", m * d(x + y, 2), -k * (x + y), cp)
add("coup dif", m * d(x - y, 2), -(k + 2 * c) * (x - y), cp)
add("coup E", d(m * (d(x) ** 2 + d(y) ** 2) / 2 + k * (x**2 + y**2) / 2 + c * (x - y) ** 2 / 2), 0, cp)
add("coupF", m * d(x - y, 2), -k * (x - y), cp, False)
# moving mass/rocket
mm = fn("mm")
ve = symbols("ve")
rock = [Eq(mm * d(v), -ve * d(mm))]
add("rocket", d(mm * v), (v - ve) * d(mm), rock)
add("rocketF", d(mm * v), v * d(mm), rock, False)
# foucault / coriolis
cor = [Eq(d(x, 2), 2 * om * d(y) - k * x), Eq(d(y, 2), -2 * om * d(x) - k * y)]
add("cor E", d((d(x) ** 2 + d(y) ** 2) / 2 + k * (x**2 + y**2) / 2), 0, cor)
add("cor L", d(x * d(y) - y * d(x) + om * (x**2 + y**2)), 0, cor)
add("corF", d(x * d(y) - y * d(x)), 0, cor, False)
# duffing, van der pol, lotka
duf = [Eq(d(x, 2) + k * x + b * x**3, 0)]
add("duf", d(d(x) ** 2 / 2 + k * x**2 / 2 + b * x**4 / 4), 0, duf)
vdp = [Eq(d(x, 2) - mu * (1 - x**2) * d(x) + x, 0)]
add("vdp", d(d(x) ** 2 / 2 + x**2 / 2), mu * (1 - x**2) * d(x) ** 2, vdp)
add("vdpF", d(d(x) ** 2 / 2 + x**2 / 2), 0, vdp, False)
add(
    "lor3",
    d(x**2 + y**2),
    -2 * x**2 + 2 * x * y * (1 + b - z) - 2 * y**2 + 2 * x * y * 0,
    [Eq(d(x), y - x), Eq(d(y), x * (b - z) - y)],
)
# polar accel
er = Matrix([cos(th), sin(th)])
et = Matrix([-sin(th), cos(th)])
add("pol acc", d(r * er, 2), (d(r, 2) - r * d(th) ** 2) * er + (r * d(th, 2) + 2 * d(r) * d(th)) * et)
add("pol er", d(er), d(th) * et)
add("pol F", d(r * er, 2), (d(r, 2) + r * d(th) ** 2) * er, (), False)
add("circ", d(x, 2) ** 2 + d(y, 2) ** 2, R**2 * om**4, [Eq(x, R * cos(om * t)), Eq(y, R * sin(om * t))])
add("circ2", x * d(x) + y * d(y), 0, [Eq(x**2 + y**2, R**2)])
add("circ3", (x * d(y) - y * d(x)) ** 2, R**2 * (d(x) ** 2 + d(y) ** 2), [Eq(x**2 + y**2, R**2)])
add("circ3F", (x * d(y) - y * d(x)), R**2 * (d(x) ** 2 + d(y) ** 2), [Eq(x**2 + y**2, R**2)], False)
add("speed", d(v) * v, v_.dot(d(v_)), [Eq(v, sqrt(v_.dot(v_)))])
add("speed2", v**2, v_.dot(v_), [Eq(v, sqrt(v_.dot(v_)))])
add("speedF", v, v_.dot(v_), [Eq(v, sqrt(v_.dot(v_)))], False)
add("unit tan", e.dot(d(e)), 0, [Eq(v_, v * e), Eq(e.dot(e), 1)])
add("accdec", d(v_), d(v) * e + v * d(e), [Eq(v_, v * e), Eq(e.dot(e), 1)])
add("acc e", d(v_).dot(e), d(v), [Eq(v_, v * e), Eq(e.dot(e), 1)])
add("acc eF", d(v_).dot(e), 0, [Eq(v_, v * e), Eq(e.dot(e), 1)], False)
qv = [fn(f"q{i}") for i in range(4)]
quat = [
    Eq(d(qv[0]), -(qv[1] * w[0] + qv[2] * w[1] + qv[3] * w[2]) / 2),
    Eq(d(qv[1]), (qv[0] * w[0] + qv[2] * w[2] - qv[3] * w[1]) / 2),
    Eq(d(qv[2]), (qv[0] * w[1] + qv[3] * w[0] - qv[1] * w[2]) / 2),
    Eq(d(qv[3]), (qv[0] * w[2] + qv[1] * w[1] - qv[2] * w[0]) / 2),
]
add("quat norm", d(sum(i**2 for i in qv)), 0, quat)
add("quat speed", 4 * sum(d(i) ** 2 for i in qv), w.dot(w), [*quat, Eq(sum(i**2 for i in qv), 1)])
add("quat speedF", sum(d(i) ** 2 for i in qv), w.dot(w), [*quat, Eq(sum(i**2 for i in qv), 1)], False)
