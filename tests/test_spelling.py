"""How expressions are written: a table of precedence, in LaTeX and in plain text."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from latex2mathml.converter import convert

from chasles import vocabulary
from chasles.vocabulary import (
    CPM,
    PI,
    Cofactor,
    Entry,
    Family,
    Group,
    Identity,
    Index,
    Kronecker,
    Negative,
    Node,
    Number,
    Scale,
    Sum,
    Zero,
    abbreviation,
    array,
    at,
    bracket,
    column,
    cos,
    cross,
    det,
    dot,
    in_frame,
    integral,
    inverse,
    latex,
    matrix,
    norm,
    over,
    paren,
    plain,
    printed,
    rate,
    row,
    scalar,
    sin,
    square,
    tr,
    uniform,
    vect,
    vector,
    walk,
)
from chasles.vocabulary.definite_integrals import definite_integral
from chasles.vocabulary.expansions import limit, up_to
from chasles.vocabulary.fields import field
from chasles.vocabulary.fitting import word
from chasles.vocabulary.functions import cases, sqrt
from chasles.vocabulary.partial import partial
from chasles.vocabulary.products import kronecker_product, vec
from chasles.vocabulary.shorthand import Shorthand, opened
from chasles.vocabulary.sizes import Size

e, a, a_, p = (vector(name, name, "") for name in ("e", "a", "a'", "p"))
p_0 = vector("p_0", "p_0", "")
p_0_ = vector("p_0'", r"\mathbf{p}'_0", "")
u = vector("u*", "u^*", "")
omega = vector("omega", r"\omega", "")
phi = scalar("phi", r"\phi", "")
theta = scalar("theta_1", r"\theta_1", "")
s, t, q_0 = (scalar(name, name, "") for name in ("s", "t", "q_0"))
Q, R = square("Q", "Q", ""), square("R", "R", "")
E = abbreviation("E", "E", CPM(e), "")
N_tilde = array("N~", r"\tilde{\mathbf{N}}", "", uniform((3, 4)))
rho = scalar("rho", r"\rho", "")
one, O = Identity(3), Zero(3, 3)
K = square("K", "K", "", size=Size("n"))
half = Number(Fraction(1, 2))
i, j = Index("i"), Index("j")
members = tuple(vector(f"e_{k}", f"e_{k}", "") for k in (1, 2, 3))
e_of, e_of_ = Family(r"\mathbf{e}", members), Family(r"\mathbf{e}", members, "'")
omega_of = Family(r"\boldsymbol{\omega}", members)

# fmt: off
TABLE: list[tuple[Node, str, str]] = [
    # sums
    (s + t, r"s + t", "s + t"),
    (s + t + q_0, r"s + t + q_0", "s + t + q_0"),
    (s + (t + q_0), r"s + \left( t + q_0 \right)", "s + (t + q_0)"),
    ((s + t) + q_0, r"s + t + q_0", "s + t + q_0"),
    (s - t, r"s - t", "s - t"),
    (s - (t - q_0), r"s - \left( t - q_0 \right)", "s - (t - q_0)"),
    (s - (-t), r"s - \left( -t \right)", "s - (-t)"),
    (-s + t, r"-s + t", "-s + t"),
    (-(s + t), r"-\left( s + t \right)", "-(s + t)"),
    (-s * t, r"-s t", "-s t"),
    (paren(-s) * t, r"\left( -s \right) t", "(-s) t"),
    (2 * -s, r"2 \left( -s \right)", "2 (-s)"),
    (Negative(-s), r"-\left( -s \right)", "-(-s)"),
    (Sum((Number(Fraction(-2)), s)), r"-2 + s", "-2 + s"),
    (s + Number(Fraction(-2)), r"s + \left( -2 \right)", "s + (-2)"),
    (s - Number(Fraction(-2)), r"s - \left( -2 \right)", "s - (-2)"),
    # products
    (2 * s, r"2 s", "2 s"),
    (2 * (3 * s), r"2 \left( 3 s \right)", "2 (3 s)"),
    (Scale(Number(Fraction(2)), Number(Fraction(3))), r"2 \left( 3 \right)", "2 (3)"),
    (2 * half, r"2 \left( \frac{1}{2} \right)", "2 (1/2)"),
    (half * s, r"\frac{1}{2} s", "(1/2) s"),
    (s * half, r"s \frac{1}{2}", "s (1/2)"),
    (-half * s, r"-\frac{1}{2} s", "-(1/2) s"),
    (2 * (s + t), r"2 \left( s + t \right)", "2 (s + t)"),
    ((s + t) * (s - t), r"\left( s + t \right) \left( s - t \right)", "(s + t) (s - t)"),
    ((s + t) * e, r"\left( s + t \right) \mathbf{e}", "(s + t) e"),
    (e * (s + t), r"\mathbf{e} \left( s + t \right)", "e (s + t)"),
    # products of matrices
    (Q @ R @ e, r"\mathbf{Q} \mathbf{R} \mathbf{e}", "Q R e"),
    (Q @ (R @ e), r"\mathbf{Q} \mathbf{R} \mathbf{e}", "Q R e"),
    ((Q + R) @ e, r"\left( \mathbf{Q} + \mathbf{R} \right) \mathbf{e}", "(Q + R) e"),
    (-Q @ e, r"-\mathbf{Q} \mathbf{e}", "-Q e"),
    (Q @ paren(-R), r"\mathbf{Q} \left( -\mathbf{R} \right)", "Q (-R)"),
    ((Q @ R).T, r"\left( \mathbf{Q} \mathbf{R} \right)^T", "(Q R)^T"),
    (Q.T @ R.T, r"\mathbf{Q}^T \mathbf{R}^T", "Q^T R^T"),
    ((Q - one).T, r"\left( \mathbf{Q} - \mathbf{1} \right)^T", "(Q - 1)^T"),
    (Q.T.T, r"\left( \mathbf{Q}^T \right)^T", "(Q^T)^T"),
    (Q @ (e @ e.T), r"\mathbf{Q} \mathbf{e} \mathbf{e}^T", "Q e e^T"),
    (e.T @ Q @ e, r"\mathbf{e}^T \mathbf{Q} \mathbf{e}", "e^T Q e"),
    ((e.T @ e) * Q, r"\mathbf{e}^T \mathbf{e} \mathbf{Q}", "e^T e Q"),
    (a_.T @ a, r"\mathbf{a}'^T \mathbf{a}", "a'^T a"),
    (p_0.T @ a, r"\mathbf{p}_0^T \mathbf{a}", "p_0^T a"),
    (p_0_.T @ a, r"{\mathbf{p}'_0}^T \mathbf{a}", "p_0'^T a"),
    (u.T @ e, r"{\mathbf{u}^*}^T \mathbf{e}", "u*^T e"),
    (rate(p_0_).T @ a, r"{\dot{\mathbf{p}}'_0}^T \mathbf{a}", "p_0'_dot^T a"),
    # powers
    (s**2, r"s^2", "s^2"),
    ((-s) ** 2, r"\left( -s \right)^2", "(-s)^2"),
    ((2 * s) ** 2, r"\left( 2 s \right)^2", "(2 s)^2"),
    ((s / t) ** 2, r"\left( \frac{s}{t} \right)^2", "(s / t)^2"),
    (half**2, r"\left( \frac{1}{2} \right)^2", "(1/2)^2"),
    (s**12, r"s^{12}", "s^12"),
    (Q**2 @ e, r"\mathbf{Q}^2 \mathbf{e}", "Q^2 e"),
    ((Q @ R) ** 2, r"\left( \mathbf{Q} \mathbf{R} \right)^2", "(Q R)^2"),
    ((Q.T) ** 2, r"\left( \mathbf{Q}^T \right)^2", "(Q^T)^2"),
    (sin(phi) ** 2, r"\sin^2 \phi", "sin(phi)^2"),
    (sin(phi / 2) ** 2, r"\sin^2\left( \frac{\phi}{2} \right)", "sin(phi / 2)^2"),
    (norm(a) ** 2, r"\|\mathbf{a}\|^2", "|a|^2"),
    (inverse(Q), r"\mathbf{Q}^{-1}", "Q^-1"),
    (inverse(Q.T @ R), r"\left( \mathbf{Q}^T \mathbf{R} \right)^{-1}", "(Q^T R)^-1"),
    (inverse(Q).T, r"\left( \mathbf{Q}^{-1} \right)^T", "(Q^-1)^T"),
    # quotients in both styles
    (s / t, r"\frac{s}{t}", "s / t"),
    (over(s, t), r"s/t", "s/t"),
    (s / t / q_0, r"\frac{\frac{s}{t}}{q_0}", "(s / t) / q_0"),
    (over(over(s, t), q_0), r"\left( s/t \right)/q_0", "(s/t)/q_0"),
    (over(s, over(t, q_0)), r"s/\left( t/q_0 \right)", "s/(t/q_0)"),
    (s / (t / q_0), r"\frac{s}{\frac{t}{q_0}}", "s / (t / q_0)"),
    ((s / t) * q_0, r"\frac{s}{t} q_0", "(s / t) q_0"),
    (over(s, t) * q_0, r"\left( s/t \right) q_0", "(s/t) q_0"),
    (s * over(t, q_0), r"s \left( t/q_0 \right)", "s (t/q_0)"),
    (over(s * t, q_0), r"s t/q_0", "s t/q_0"),
    (over(s, t * q_0), r"s/\left( t q_0 \right)", "s/(t q_0)"),
    (over(s, t**2), r"s/t^2", "s/t^2"),
    (over(s + t, s - t), r"\left( s + t \right)/\left( s - t \right)", "(s + t)/(s - t)"),
    ((s + t) / (s - t), r"\frac{s + t}{s - t}", "(s + t) / (s - t)"),
    (-s / t, r"-\frac{s}{t}", "-s / t"),
    (over(-s, t), r"\left( -s \right)/t", "(-s)/t"),
    (s / t + 1, r"\frac{s}{t} + 1", "s / t + 1"),
    (over(1, 2) * E, r"\left( 1/2 \right) \mathbf{E}", "(1/2) E"),
    (
        1 / (2 * (1 - cos(phi))) * one,
        r"\frac{1}{2 \left( 1 - \cos \phi \right)} \mathbf{1}",
        "{1 / [2 (1 - cos(phi))]} 1",
    ),
    (
        over(sin(phi), 2 * (1 - cos(phi))) * (one - e @ e.T),
        r"\left\{ \sin \phi/\left[ 2 \left( 1 - \cos \phi \right) \right] \right\} \left( \mathbf{1} - \mathbf{e} "
        r"\mathbf{e}^T \right)",
        "{sin(phi)/[2 (1 - cos(phi))]} (1 - e e^T)",
    ),
    (
        (Q - one).T @ (Q @ a - a_) / (2 * (1 - cos(phi))),
        r"\frac{\left( \mathbf{Q} - \mathbf{1} \right)^T \left( \mathbf{Q} \mathbf{a} - \mathbf{a}' \right)}{2 "
        r"\left( 1 - \cos \phi \right)}",
        "(Q - 1)^T (Q a - a') / [2 (1 - cos(phi))]",
    ),
    # functions, of an angle and of half of it
    (sin(phi) * e, r"\sin \phi \mathbf{e}", "sin(phi) e"),
    (
        cos(phi / 2) * one - sin(phi / 2) * E,
        r"\cos\left( \frac{\phi}{2} \right) \mathbf{1} - \sin\left( \frac{\phi}{2} \right) \mathbf{E}",
        "cos(phi / 2) 1 - sin(phi / 2) E",
    ),
    (sin(over(phi, 2)), r"\sin\left( \phi/2 \right)", "sin(phi/2)"),
    (sin(-phi), r"\sin\left( -\phi \right)", "sin(-phi)"),
    (sin(phi + theta), r"\sin\left( \phi + \theta_1 \right)", "sin(phi + theta_1)"),
    (sin(2 * phi), r"\sin\left( 2 \phi \right)", "sin(2 phi)"),
    (cos(theta) * sin(phi), r"\cos \theta_1 \sin \phi", "cos(theta_1) sin(phi)"),
    (sin(phi) * cos(phi), r"\sin \phi \cos \phi", "sin(phi) cos(phi)"),
    (bracket(sin(over(phi, 2))) * e, r"\left[ \sin\left( \phi/2 \right) \right] \mathbf{e}", "[sin(phi/2)] e"),
    (cos(Number(Fraction(0))) * s, r"\cos\left( 0 \right) s", "cos(0) s"),
    # nested brackets, and brackets that the author puts
    (2 * (1 - (1 - s) * t), r"2 \left[ 1 - \left( 1 - s \right) t \right]", "2 [1 - (1 - s) t]"),
    (
        2 * (1 - (1 - (1 - s) * t) * t),
        r"2 \left\{ 1 - \left[ 1 - \left( 1 - s \right) t \right] t \right\}",
        "2 {1 - [1 - (1 - s) t] t}",
    ),
    (
        2 * (1 - (1 - (1 - (1 - s) * t) * t) * t),
        r"2 \left\{ 1 - \left\{ 1 - \left[ 1 - \left( 1 - s \right) t \right] t \right\} t \right\}",
        "2 {1 - {1 - [1 - (1 - s) t] t} t}",
    ),
    (2 * (bracket(s) + t), r"2 \left\{ \left[ s \right] + t \right\}", "2 {[s] + t}"),
    (paren(s + t) * e, r"\left( s + t \right) \mathbf{e}", "(s + t) e"),
    (bracket(Q - one) @ e, r"\left[ \mathbf{Q} - \mathbf{1} \right] \mathbf{e}", "[Q - 1] e"),
    (Group(s + t, "{}") * e, r"\left\{ s + t \right\} \mathbf{e}", "{s + t} e"),
    # norms
    (norm(a), r"\|\mathbf{a}\|", "|a|"),
    (norm(a - p) * e, r"\|\mathbf{a} - \mathbf{p}\| \mathbf{e}", "|a - p| e"),
    (norm(a * norm(e) * s), r"\|\left( \mathbf{a} \|\mathbf{e}\| s \right)\|", "|(a |e| s)|"),
    (norm(a) * s * norm(a), r"\|\mathbf{a}\| s \|\mathbf{a}\|", "|a| s |a|"),
    (norm(a / norm(a)), r"\|\left( \frac{\mathbf{a}}{\|\mathbf{a}\|} \right)\|", "|(a / |a|)|"),
    # dots and crosses
    (dot(a, p), r"\mathbf{a} \cdot \mathbf{p}", "a . p"),
    (dot(a, p) + s, r"\mathbf{a} \cdot \mathbf{p} + s", "a . p + s"),
    (s - dot(a, p), r"s - \mathbf{a} \cdot \mathbf{p}", "s - a . p"),
    (-dot(a, p), r"-\mathbf{a} \cdot \mathbf{p}", "-a . p"),
    (dot(a, p) * e, r"\left( \mathbf{a} \cdot \mathbf{p} \right) \mathbf{e}", "(a . p) e"),
    (
        dot(a + p, a - p),
        r"\left( \mathbf{a} + \mathbf{p} \right) \cdot \left( \mathbf{a} - \mathbf{p} \right)",
        "(a + p) . (a - p)",
    ),
    (dot(Q @ a, p), r"\mathbf{Q} \mathbf{a} \cdot \mathbf{p}", "Q a . p"),
    (dot(s * a, p), r"s \mathbf{a} \cdot \mathbf{p}", "s a . p"),
    (dot(-a, p), r"\left( -\mathbf{a} \right) \cdot \mathbf{p}", "(-a) . p"),
    (dot(a, p) / s, r"\frac{\mathbf{a} \cdot \mathbf{p}}{s}", "(a . p) / s"),
    (cross(omega, a), r"\boldsymbol{\omega} \times \mathbf{a}", "omega x a"),
    (
        cross(omega, cross(omega, a)),
        r"\boldsymbol{\omega} \times \left( \boldsymbol{\omega} \times \mathbf{a} \right)",
        "omega x (omega x a)",
    ),
    (
        cross(omega, a - p) + p,
        r"\boldsymbol{\omega} \times \left( \mathbf{a} - \mathbf{p} \right) + \mathbf{p}",
        "omega x (a - p) + p",
    ),
    (
        dot(omega, cross(a, p)),
        r"\boldsymbol{\omega} \cdot \left( \mathbf{a} \times \mathbf{p} \right)",
        "omega . (a x p)",
    ),
    (cross(a / s, p), r"\frac{\mathbf{a}}{s} \times \mathbf{p}", "(a / s) x p"),
    (cross(over(a, s), p), r"\left( \mathbf{a}/s \right) \times \mathbf{p}", "(a/s) x p"),
    (Q @ cross(omega, a), r"\mathbf{Q} \left( \boldsymbol{\omega} \times \mathbf{a} \right)", "Q (omega x a)"),
    # blocks
    (column(Q - one, e.T), r"\begin{bmatrix} \mathbf{Q} - \mathbf{1} \\ \mathbf{e}^T \end{bmatrix}", "[Q - 1; e^T]"),
    (column(e, phi).T, r"\begin{bmatrix} \mathbf{e} \\ \phi \end{bmatrix}^T", "[e; phi]^T"),
    (
        matrix((one, O), (CPM(a - p), one)),
        r"\begin{bmatrix} \mathbf{1} & \mathbf{O} \\ \text{CPM}\left( \mathbf{a} - \mathbf{p} \right) & "
        r"\mathbf{1} \end{bmatrix}",
        "[1, 0; CPM(a - p), 1]",
    ),
    (
        row(Q, e) @ column(e, 1),
        r"\begin{bmatrix} \mathbf{Q} & \mathbf{e} \end{bmatrix} \begin{bmatrix} \mathbf{e} \\ 1 \end{bmatrix}",
        "[Q, e] [e; 1]",
    ),
    (2 * column(s * e, -t), r"2 \begin{bmatrix} s \mathbf{e} \\ -t \end{bmatrix}", "2 [s e; -t]"),
    # rates
    (rate(phi), r"\dot{\phi}", "phi_dot"),
    (rate(a), r"\dot{\mathbf{a}}", "a_dot"),
    (rate(a_), r"\dot{\mathbf{a}}'", "a'_dot"),
    (rate(p_0), r"\dot{\mathbf{p}}_0", "p_0_dot"),
    (rate(p_0_), r"\dot{\mathbf{p}}'_0", "p_0'_dot"),
    (rate(q_0), r"\dot{q}_0", "q_0_dot"),
    (rate(rate(p_0)), r"\ddot{\mathbf{p}}_0", "p_0_ddot"),
    (rate(rate(rate(a))), r"\dddot{\mathbf{a}}", "a_dddot"),
    (rate(N_tilde), r"\dot{\tilde{\mathbf{N}}}", "N~_dot"),
    (rate(Q).T, r"\dot{\mathbf{Q}}^T", "Q_dot^T"),
    (rate(e_of[i]), r"\dot{\mathbf{e}}_i", "e_i_dot"),
    (rate(a - p_0), r"\frac{d}{dt} \left( \mathbf{a} - \mathbf{p}_0 \right)", "d/dt (a - p_0)"),
    (rate(rate(Q @ e)), r"\frac{d^2}{dt^2} \left( \mathbf{Q} \mathbf{e} \right)", "d^2/dt^2 (Q e)"),
    (rate(s * a) * t, r"\left[ \frac{d}{dt} \left( s \mathbf{a} \right) \right] t", "[d/dt (s a)] t"),
    (rate(s) - rate(s * t), r"\dot{s} - \frac{d}{dt} \left( s t \right)", "s_dot - d/dt (s t)"),
    (rate(Q @ e).T, r"\left[ \frac{d}{dt} \left( \mathbf{Q} \mathbf{e} \right) \right]^T", "[d/dt (Q e)]^T"),
    (rate(column(e, phi)), r"\frac{d}{dt} \begin{bmatrix} \mathbf{e} \\ \phi \end{bmatrix}", "d/dt [e; phi]"),
    (at(p), r"\mathbf{p}(t)", "p(t)"),
    (at(rate(p)), r"\dot{\mathbf{p}}(t)", "p_dot(t)"),
    (rate(at(p_0)), r"\dot{\mathbf{p}}_0(t)", "p_0_dot(t)"),
    (rate(rate(at(p_0))), r"\ddot{\mathbf{p}}_0(t)", "p_0_ddot(t)"),
    (at(Q) @ p_0, r"\mathbf{Q}(t) \mathbf{p}_0", "Q(t) p_0"),
    # functions of matrices
    (tr(Q), r"\text{tr}\left( \mathbf{Q} \right)", "tr(Q)"),
    (tr(Q) * one - Q, r"\text{tr}\left( \mathbf{Q} \right) \mathbf{1} - \mathbf{Q}", "tr(Q) 1 - Q"),
    (vect(rate(Q) @ Q.T), r"\text{vect}\left( \dot{\mathbf{Q}} \mathbf{Q}^T \right)", "vect(Q_dot Q^T)"),
    (vect(Q).T, r"\text{vect}\left( \mathbf{Q} \right)^T", "vect(Q)^T"),
    (CPM(omega) ** 2, r"\text{CPM}\left( \boldsymbol{\omega} \right)^2", "CPM(omega)^2"),
    (det(Q @ (Q - one)), r"\det\left[ \mathbf{Q} \left( \mathbf{Q} - \mathbf{1} \right) \right]", "det(Q (Q - 1))"),
    (det(Q) * s, r"\det\left( \mathbf{Q} \right) s", "det(Q) s"),
    (Cofactor(Q), r"\text{cof}\left( \mathbf{Q} \right)", "cof(Q)"),
    # families, entries, the Kronecker delta
    (e_of[i], r"\mathbf{e}_i", "e_i"),
    (dot(e_of[i], e_of[j]), r"\mathbf{e}_i \cdot \mathbf{e}_j", "e_i . e_j"),
    (e_of_[j].T @ e_of[i], r"\mathbf{e}_j'^T \mathbf{e}_i", "e_j'^T e_i"),
    (omega_of[i], r"\boldsymbol{\omega}_i", "omega_i"),
    (Kronecker(i, j), r"\delta_{ij}", "delta_ij"),
    (s * Kronecker(i, j), r"s \delta_{ij}", "s delta_ij"),
    (Entry(Q, i, j, "q"), r"q_{ij}", "q_ij"),
    # integrals over a body, components in a frame
    (integral(rho * p, rho, p), r"\int_{\mathcal{B}} \rho \mathbf{p} \, d\mathcal{B}", "int_B(rho p)"),
    (
        integral(paren(p - a) * rho, rho, p),
        r"\int_{\mathcal{B}} \left( \mathbf{p} - \mathbf{a} \right) \rho \, d\mathcal{B}",
        "int_B((p - a) rho)",
    ),
    (
        integral(rho * p, rho, p) + integral(rho * a, rho),
        r"\int_{\mathcal{B}} \rho \mathbf{p} \, d\mathcal{B} + \int_{\mathcal{B}} \rho \mathbf{a} \, d\mathcal{B}",
        "int_B(rho p) + int_B(rho a)",
    ),
    (
        s * integral(rho * (p + a), rho, p),
        r"s \int_{\mathcal{B}} \rho \left( \mathbf{p} + \mathbf{a} \right) \, d\mathcal{B}",
        "s int_B(rho (p + a))",
    ),
    (
        rate(integral(rho * p, rho, p)),
        r"\frac{d}{dt} \left( \int_{\mathcal{B}} \rho \mathbf{p} \, d\mathcal{B} \right)",
        "d/dt int_B(rho p)",
    ),
    (
        integral(rho * p, rho, p).T,
        r"\left( \int_{\mathcal{B}} \rho \mathbf{p} \, d\mathcal{B} \right)^T",
        "int_B(rho p)^T",
    ),
    (in_frame(p, "F"), r"\left[ \mathbf{p} \right]_{\mathcal{F}}", "[p]_F"),
    (
        in_frame(Q, "M").T @ in_frame(p + a, "F"),
        r"\left[ \mathbf{Q} \right]_{\mathcal{M}}^T \left[ \mathbf{p} + \mathbf{a} \right]_{\mathcal{F}}",
        "[Q]_M^T [p + a]_F",
    ),
    (rate(in_frame(p, "F")), r"\frac{d}{dt} \left[ \mathbf{p} \right]_{\mathcal{F}}", "d/dt [p]_F"),
    (in_frame(rate(p), "F"), r"\left[ \dot{\mathbf{p}} \right]_{\mathcal{F}}", "[p_dot]_F"),
    # entries and blocks
    (Q[1, 2], "Q_{12}", "Q_12"),
    (omega.x, r"\omega_x", "omega_x"),
    (rate(omega).y + rate(omega.y), r"\dot{\omega}_y + \dot{\omega}_y", "omega_dot_y + omega_y_dot"),
    (Q[1:2, 3], r"\mathbf{Q}_{1:2,3}", "Q_1:2,3"),
    (cross(a, e).z, r"\left[ \mathbf{a} \times \mathbf{e} \right]_z", "[a x e]_z"),
    (2 * Q[1, 2] ** 2, "2 Q_{12}^2", "2 Q_12^2"),
    # functions of scalars, cases, derivatives, expansions
    (sqrt(s + phi), r"\sqrt{s + \phi}", "sqrt(s + phi)"),
    (
        cases((s, s > 0), otherwise=phi),
        r"\begin{cases} s & s > 0 \\ \phi & \text{otherwise} \end{cases}",
        "(s if s > 0, phi otherwise)",
    ),
    (partial(s * phi, phi), r"\frac{\partial \left( s \phi \right)}{\partial \phi}", "d(s phi) / dphi"),
    (
        definite_integral(s * phi, phi, 0, s),
        r"\int_{0}^{s} s \phi \, \mathrm{d}\phi",
        "integral from 0 to s of s phi dphi",
    ),
    (field(s, phi).derivative(phi), r"\frac{\partial s}{\partial \phi}", "ds/dphi"),
    (limit(s * phi, phi), r"\lim_{\phi \to 0} s \phi", "lim phi -> 0 s phi"),
    (up_to(s, phi, 3), r"s + O\left( \phi^3 \right)", "s + O(phi^3)"),
    # products of any size
    (opened(kronecker_product(K, K)), r"\text{kron}\left( \mathbf{K}, \mathbf{K} \right)", "kron(K, K)"),
    (opened(vec(K)), r"\text{vec}\left( \mathbf{K} \right)", "vec(K)"),
    # constants
    (O @ e, r"\mathbf{O} \mathbf{e}", "0 e"),
    (PI * s, r"\pi s", "pi s"),
    (2 * one, r"2 \mathbf{1}", "2 (1)"),
    (norm(omega) ** 2 * one, r"\|\boldsymbol{\omega}\|^2 \mathbf{1}", "|omega|^2 1"),
    (printed(lambda: a + 1), r"\mathbf{a} + 1", "a + 1"),
]
# fmt: on


@pytest.mark.parametrize(("node", "in_latex", "in_plain"), TABLE, ids=[row[2] for row in TABLE])
def test_an_expression_is_spelled_as_its_author_wrote_it(node: Node, in_latex: str, in_plain: str) -> None:
    assert latex(node) == in_latex
    assert plain(node) == in_plain == str(node)
    assert "<math" in convert(in_latex)


def test_every_kind_of_node_is_in_the_table() -> None:
    def kinds(cls: type[Any]) -> set[str]:
        own = {cls.__name__} if cls.__module__.startswith("chasles.") and not issubclass(cls, Shorthand) else set()
        return own.union(*map(kinds, cls.__subclasses__()))

    seen = {type(part).__name__ for node, _, _ in TABLE for part in walk(node)}
    in_common = {"Node", "OfOne", "OfAnySize", "CarriedOut"}
    assert kinds(Node) - in_common <= seen, "these four are what kinds of nodes have in common"


def test_a_node_without_a_spelling_is_named() -> None:
    @word
    class Whisper(Node):
        def _measured(self) -> vocabulary.Measure:
            return vocabulary.uniform((1, 1))

    with pytest.raises(TypeError, match="no spelling for the node Whisper"):
        latex(Whisper())
