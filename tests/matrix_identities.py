"""Identities of matrices of any size, as handbooks have them, in our own words; and how each may be got wrong."""

from __future__ import annotations

from collections.abc import Iterator

from chasles.statements import Claim, Hypothesis, definite, nonzero, symmetric, unit
from chasles.statements.matrices import (
    commuting,
    idempotent,
    invertible,
    orthogonal,
    orthonormal_columns,
    skew_symmetric,
)
from chasles.vocabulary import (
    Contract,
    Identity,
    Inverse,
    Negative,
    Node,
    Number,
    Sum,
    Transpose,
    Zero,
    column,
    dot,
    inverse,
    matrix,
    norm,
    number,
    paren,
    rebuilt,
    row,
    scalar,
    square,
    tr,
    vector,
)
from chasles.vocabulary.sizes import Size, rectangular

n, m, k = Size("n"), Size("m"), Size("k")
A, B, C, P, Q, R, S, X = (square(name, name, "a matrix", size=n) for name in "ABCPQRSX")
D, W, L = (square(name, name, "a matrix", size=m) for name in "DWL")
U, V, F, G = (
    rectangular("U", "U", "a matrix", n, m),
    rectangular("V", "V", "a matrix", m, n),
    rectangular("F", "F", "a matrix", n, m),
    rectangular("G", "G", "a matrix", m, k),
)
a, b, u, v, x, y = (vector(name, name, "a column", size=n) for name in "abuvxy")
z, w = (vector(name, name, "a column", size=m) for name in "zw")
s, t, rho = (scalar(name, name, "a number") for name in ("s", "t", "rho"))
I, J = Identity(n), Identity(m)
Equality = tuple[str, Node, Node, tuple[Hypothesis, ...]]


def commutator(one: Node, other: Node) -> Node:
    return paren(one @ other - other @ one)


gain = S @ V.T @ inverse(V @ S @ V.T + W)
schur = A - U @ inverse(D) @ V
normal = inverse(V.T @ V)
whole = matrix([A, U], [V, D])
block_inverse = matrix(
    [inverse(schur), -inverse(schur) @ U @ inverse(D)],
    [-inverse(D) @ V @ inverse(schur), inverse(D) + inverse(D) @ V @ inverse(schur) @ U @ inverse(D)],
)

IDENTITIES: tuple[Equality, ...] = (
    ("transpose of a product", (A @ U @ G).T, G.T @ U.T @ A.T, ()),
    ("transpose of a sum", (A + B.T).T, B + A.T, ()),
    ("distributive", (A + B) @ (A - B), A @ A - A @ B + B @ A - B @ B, ()),
    ("square of a sum", (A + B) ** 2, A @ A + A @ B + B @ A + B @ B, ()),
    ("binomial where they commute", (A + B) ** 2, A**2 + 2 * A @ B + B**2, (commuting(A, B),)),
    ("difference of cubes", (A - B) @ (A**2 + A @ B + B**2), A**3 - B**3, (commuting(A, B),)),
    ("symmetric and skew parts", A, (A + A.T) / 2 + (A - A.T) / 2, ()),
    ("Jacobi", commutator(A, commutator(B, C)) + commutator(B, commutator(C, A)), -commutator(C, commutator(A, B)), ()),
    ("commutator of a product", commutator(A, B @ C), commutator(A, B) @ C + B @ commutator(A, C), ()),
    ("trace of a commutator", tr(commutator(A, B)), number(0), ()),
    ("trace goes round", tr(A @ B @ C), tr(C @ A @ B), ()),
    ("trace of rectangular ones", tr(U @ V), tr(V @ U), ()),
    ("trace of a transpose", tr(A @ B.T), tr(B @ A.T), ()),
    ("trace of a dyad", tr(A @ x @ y.T), y.T @ A @ x, ()),
    ("trace of the identity", tr(I + x @ x.T), tr(I) + dot(x, x), ()),
    ("trace of symmetric and skew", tr(A @ B), number(0), (symmetric(A), skew_symmetric(B))),
    ("Frobenius", tr((A + B).T @ (A + B)), tr(A.T @ A) + 2 * tr(A.T @ B) + tr(B.T @ B), ()),
    ("scalar product moved over", dot(A @ x, y), dot(x, A.T @ y), ()),
    ("a scalar is its transpose", x.T @ U @ z, z.T @ U.T @ x, ()),
    ("skew form vanishes", x.T @ A @ x, number(0), (skew_symmetric(A),)),
    ("only the symmetric part counts", x.T @ A @ x, x.T @ ((A + A.T) / 2) @ x, ()),
    ("polarisation", 4 * dot(x, y), dot(x + y, x + y) - dot(x - y, x - y), ()),
    ("parallelogram", norm(x + y) ** 2 + norm(x - y) ** 2, 2 * norm(x) ** 2 + 2 * norm(y) ** 2, ()),
    ("dyads multiplied", (a @ b.T) @ (u @ v.T), dot(b, u) * (a @ v.T), ()),
    ("inverse of a product", inverse(A @ B), inverse(B) @ inverse(A), ()),
    ("inverse of a transpose", inverse(A.T), inverse(A).T, ()),
    ("inverse of an inverse", inverse(inverse(A)), A, ()),
    ("inverse of a multiple", inverse(s * A), inverse(A) / s, (nonzero(s),)),
    ("inverse of three", inverse(A @ B @ C), inverse(C) @ inverse(B) @ inverse(A), ()),
    ("difference of inverses", inverse(A) - inverse(B), inverse(A) @ (B - A) @ inverse(B), ()),
    ("sum of inverses", inverse(A) + inverse(B), inverse(A) @ (A + B) @ inverse(B), ()),
    ("parallel sum", inverse(inverse(A) + inverse(B)), A @ inverse(A + B) @ B, ()),
    ("parallel sum the other way", A @ inverse(A + B) @ B, B @ inverse(A + B) @ A, ()),
    ("parallel sum by a difference", A - A @ inverse(A + B) @ A, B - B @ inverse(A + B) @ B, ()),
    ("resolvent", inverse(I + A), I - A @ inverse(I + A), ()),
    ("push-through", inverse(I + A @ B) @ A, A @ inverse(I + B @ A), ()),
    ("push-through, rectangular", inverse(I + U @ V) @ U, U @ inverse(J + V @ U), ()),
    ("push-through, two ways", inverse(I + U @ V), I - U @ inverse(J + V @ U) @ V, ()),
    (
        "Woodbury",
        inverse(A + U @ D @ V),
        inverse(A) - inverse(A) @ U @ inverse(inverse(D) + V @ inverse(A) @ U) @ V @ inverse(A),
        (),
    ),
    (
        "Woodbury for a difference",
        inverse(A - U @ inverse(D) @ V),
        inverse(A) + inverse(A) @ U @ inverse(D - V @ inverse(A) @ U) @ V @ inverse(A),
        (),
    ),
    (
        "Woodbury without the inverse in it",
        inverse(A + U @ D @ V),
        inverse(A) - inverse(A) @ U @ inverse(J + D @ V @ inverse(A) @ U) @ D @ V @ inverse(A),
        (),
    ),
    (
        "information form of a gain",
        S @ V.T @ inverse(V @ S @ V.T + W),
        inverse(inverse(S) + V.T @ inverse(W) @ V) @ V.T @ inverse(W),
        (),
    ),
    (
        "Sherman and Morrison",
        inverse(A + u @ v.T),
        inverse(A) - inverse(A) @ u @ v.T @ inverse(A) / (1 + v.T @ inverse(A) @ u),
        (nonzero(1 + v.T @ inverse(A) @ u),),
    ),
    ("rank one added to the identity", inverse(I + u @ v.T), I - u @ v.T / (1 + dot(u, v)), (nonzero(1 + dot(u, v)),)),
    (
        "a solution by Sherman and Morrison",
        inverse(A + u @ v.T) @ u,
        inverse(A) @ u / (1 + v.T @ inverse(A) @ u),
        (nonzero(1 + v.T @ inverse(A) @ u),),
    ),
    ("inverse of blocks by a Schur complement", inverse(whole), block_inverse, ()),
    (
        "inverse of a triangular one",
        inverse(matrix([A, U], [0, D])),
        matrix([inverse(A), -inverse(A) @ U @ inverse(D)], [0, inverse(D)]),
        (),
    ),
    ("inverse of a unit triangular one", inverse(matrix([I, U], [0, J])), matrix([I, -U], [0, J]), ()),
    (
        "Schur factors",
        whole,
        matrix([I, U @ inverse(D)], [0, J]) @ matrix([schur, 0], [0, D]) @ matrix([I, 0], [inverse(D) @ V, J]),
        (),
    ),
    (
        "block elimination",
        matrix([I, 0], [-V @ inverse(A), J]) @ whole,
        matrix([A, U], [0, D - V @ inverse(A) @ U]),
        (),
    ),
    ("blocks multiplied", row(A, U) @ column(B, V), A @ B + U @ V, ()),
    ("transpose of blocks", whole.T, matrix([A.T, V.T], [U.T, D.T]), ()),
    ("trace of blocks", tr(whole), tr(A) + tr(D), ()),
    (
        "quadratic form of blocks",
        column(x, z).T @ whole @ column(x, z),
        x.T @ A @ x + x.T @ U @ z + z.T @ V @ x + z.T @ D @ z,
        (),
    ),
    (
        "completing the square",
        (x + inverse(A) @ b).T @ A @ (x + inverse(A) @ b),
        x.T @ A @ x + 2 * b.T @ x + b.T @ inverse(A) @ b,
        (symmetric(A),),
    ),
    ("orthogonal projection is idempotent", (U @ inverse(U.T @ U) @ U.T) ** 2, U @ inverse(U.T @ U) @ U.T, ()),
    ("orthogonal projection is symmetric", (U @ inverse(U.T @ U) @ U.T).T, U @ inverse(U.T @ U) @ U.T, ()),
    ("complement of a projection", (I - P) ** 2, I - P, (idempotent(P),)),
    ("projection and complement", P @ (I - P), Zero(n, n), (idempotent(P),)),
    ("reflection by a projection", (2 * P - I) ** 2, I, (idempotent(P),)),
    ("residual is normal", U.T @ (I - U @ inverse(U.T @ U) @ U.T) @ b, Zero(m, 1), ()),
    ("normal equations", (U.T @ U) @ (inverse(U.T @ U) @ U.T @ b), U.T @ b, ()),
    ("left inverse", (inverse(U.T @ U) @ U.T) @ U, J, ()),
    (
        "resolvents",
        inverse(s * I - A) - inverse(s * I - B),
        inverse(s * I - A) @ (A - B) @ inverse(s * I - B),
        (invertible(s * I - A), invertible(s * I - B)),
    ),
    ("right inverse", V @ (V.T @ inverse(V @ V.T)), J, ()),
    ("Penrose 1", U @ (inverse(U.T @ U) @ U.T) @ U, U, ()),
    ("Penrose 2", (inverse(U.T @ U) @ U.T) @ U @ (inverse(U.T @ U) @ U.T), inverse(U.T @ U) @ U.T, ()),
    ("weighted projection", U @ inverse(U.T @ A @ U) @ U.T @ A @ U, U, ()),
    ("ridge, two ways", inverse(U.T @ U + s * J) @ U.T, U.T @ inverse(U @ U.T + s * I), (nonzero(s),)),
    (
        "Joseph form",
        (I - gain @ V) @ S @ (I - gain @ V).T + gain @ W @ gain.T,
        (I - gain @ V) @ S,
        (symmetric(S), symmetric(W)),
    ),
    ("covariance in information form", S - gain @ V @ S, inverse(inverse(S) + V.T @ inverse(W) @ V), ()),
    ("Householder is orthogonal", (I - 2 * u @ u.T).T @ (I - 2 * u @ u.T), I, (unit(u),)),
    (
        "Householder is its inverse",
        inverse(I - 2 * u @ u.T / dot(u, u)),
        I - 2 * u @ u.T / dot(u, u),
        (nonzero(dot(u, u)),),
    ),
    ("product of orthogonal ones", (Q @ R).T @ (Q @ R), I, (orthogonal(Q), orthogonal(R))),
    ("inverse of an orthogonal one", inverse(Q), Q.T, (orthogonal(Q),)),
    ("length is kept", norm(Q @ x) ** 2, norm(x) ** 2, (orthogonal(Q),)),
    ("trace is kept", tr(Q.T @ A @ Q), tr(A), (orthogonal(Q),)),
    ("similar ones multiply alike", (inverse(S) @ A @ S) @ (inverse(S) @ B @ S), inverse(S) @ A @ B @ S, ()),
    ("powers of similar ones", (inverse(S) @ A @ S) ** 3, inverse(S) @ A**3 @ S, ()),
    ("trace of similar ones", tr(inverse(S) @ A @ S), tr(A), ()),
    (
        "Cayley transform is orthogonal",
        (inverse(I + A) @ (I - A)).T @ (inverse(I + A) @ (I - A)),
        I,
        (skew_symmetric(A),),
    ),
    ("Cayley factors commute", inverse(I + A) @ (I - A), (I - A) @ inverse(I + A), ()),
    ("congruence keeps symmetry", (U.T @ A @ U).T, U.T @ A @ U, (symmetric(A),)),
    ("product of symmetric ones that commute", (A @ B).T, A @ B, (symmetric(A), symmetric(B), commuting(A, B))),
    ("inverse of a symmetric one", inverse(A).T, inverse(A), (symmetric(A), invertible(A))),
    ("inverse commutes where they do", inverse(A) @ B, B @ inverse(A), (commuting(A, B),)),
    ("orthonormal columns project", (U @ U.T) ** 2, U @ U.T, (orthonormal_columns(U),)),
    ("coordinates in an orthonormal frame", U.T @ (U @ z), z, (orthonormal_columns(U),)),
    ("operational space inertia", V @ inverse(A) @ (V.T @ inverse(V @ inverse(A) @ V.T)), J, (definite(A),)),
    (
        "null space of a weighted inverse",
        V @ (I - inverse(A) @ V.T @ inverse(V @ inverse(A) @ V.T) @ V),
        Zero(m, n),
        (definite(A),),
    ),
    (
        "constrained motion",
        V @ (inverse(A) @ (b - V.T @ (inverse(V @ inverse(A) @ V.T) @ (V @ inverse(A) @ b - z)))),
        z,
        (definite(A),),
    ),
    ("normalised", dot(x / norm(x), x / norm(x)), number(1), (nonzero(norm(x)),)),
    ("projection on a line", (x @ x.T / dot(x, x)) @ (x @ x.T / dot(x, x)), x @ x.T / dot(x, x), (nonzero(dot(x, x)),)),
)


def claims() -> Iterator[tuple[str, Claim]]:
    """Each identity as a claim, with its name."""
    for name, left, right, assuming in IDENTITIES:
        yield name, Claim("1", left, right, assuming=assuming)


def slips(node: Node) -> Iterator[tuple[str, Node]]:
    """The expression with one slip: a sign, an order, a transpose or an inverse lost, another factor."""
    match node:
        case Sum(terms):
            for place in range(1, len(terms)):
                term = terms[place]
                other = term.term if isinstance(term, Negative) else Negative(term)
                yield "sign", Sum((*terms[:place], other, *terms[place + 1 :]))
        case Contract(factors):
            for place in range(len(factors) - 1):
                if factors[place].shape == factors[place + 1].shape:
                    turned = (*factors[:place], factors[place + 1], factors[place], *factors[place + 2 :])
                    yield "order", Contract(turned)
        case Transpose(of) if of.shape == of.T.shape:
            yield "transpose", of
        case Inverse(of):
            yield "inverse", of
        case Number(value) if value > 1:
            yield "number", Number(value + 1)
    for place, part in enumerate(node.below):
        for kind, changed in slips(part):
            try:
                yield kind, rebuilt(node, (*node.below[:place], changed, *node.below[place + 1 :]))
            except ValueError:
                continue
