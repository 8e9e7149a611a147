"""Section 2: quaternions as columns and as matrices."""

from chasles.statements import Claim, Definition, Section, unit_column
from chasles.vocabulary import column, matrix, number, rate

from .notation import L, M, e, e0, e1, e2, e3, f, f0, f1, f2, f3, one4

quaternion_section = Section("2", "Quaternions")

half = number(1) / 2
parts = Definition("2.1", e, column(e0, e1, e2, e3))
other_parts = Definition("2.2", f, column(f0, f1, f2, f3))
left_matrix = Definition("2.3", L, matrix((e0, -e1, -e2, -e3), (e1, e0, -e3, e2), (e2, e3, e0, -e1), (e3, -e2, e1, e0)))
right_matrix = Definition(
    "2.4", M, matrix((f0, -f1, -f2, -f3), (f1, f0, f3, -f2), (f2, -f3, f0, f1), (f3, f2, -f1, f0))
)
both = (parts, other_parts, left_matrix, right_matrix)
are_unit = (unit_column(e0, e1, e2, e3),)

product = Claim(
    "2.5",
    L @ f,
    column(
        e0 * f0 - e1 * f1 - e2 * f2 - e3 * f3,
        e0 * f1 + e1 * f0 + e2 * f3 - e3 * f2,
        e0 * f2 - e1 * f3 + e2 * f0 + e3 * f1,
        e0 * f3 + e1 * f2 - e2 * f1 + e3 * f0,
    ),
    given=both,
)
product_from_the_right = Claim("2.6", L @ f, M @ e, given=both)
matrices_commute = Claim("2.7", L @ M, M @ L, given=both)
length_of_product = Claim("2.8", L.T @ L, (e0**2 + e1**2 + e2**2 + e3**2) * one4, given=both)
rotation_by_quaternion = Claim(
    "2.9",
    matrix((-e1, e0, -e3, e2), (-e2, e3, e0, -e1), (-e3, -e2, e1, e0))
    @ matrix((-e1, e0, e3, -e2), (-e2, -e3, e0, e1), (-e3, e2, -e1, e0)).T,
    matrix(
        (e0**2 + e1**2 - e2**2 - e3**2, 2 * (e1 * e2 - e0 * e3), 2 * (e1 * e3 + e0 * e2)),
        (2 * (e1 * e2 + e0 * e3), e0**2 - e1**2 + e2**2 - e3**2, 2 * (e2 * e3 - e0 * e1)),
        (2 * (e1 * e3 - e0 * e2), 2 * (e2 * e3 + e0 * e1), e0**2 - e1**2 - e2**2 + e3**2),
    ),
)
rotation_by_unit_quaternion = Claim(
    "2.10",
    matrix(
        (e0**2 + e1**2 - e2**2 - e3**2, 2 * (e1 * e2 - e0 * e3), 2 * (e1 * e3 + e0 * e2)),
        (2 * (e1 * e2 + e0 * e3), e0**2 - e1**2 + e2**2 - e3**2, 2 * (e2 * e3 - e0 * e1)),
        (2 * (e1 * e3 - e0 * e2), 2 * (e2 * e3 + e0 * e1), e0**2 - e1**2 - e2**2 + e3**2),
    ),
    matrix(
        (1 - 2 * e2**2 - 2 * e3**2, 2 * e1 * e2 - 2 * e0 * e3, 2 * e1 * e3 + 2 * e0 * e2),
        (2 * e1 * e2 + 2 * e0 * e3, 1 - 2 * e1**2 - 2 * e3**2, 2 * e2 * e3 - 2 * e0 * e1),
        (2 * e1 * e3 - 2 * e0 * e2, 2 * e2 * e3 + 2 * e0 * e1, 1 - 2 * e1**2 - 2 * e2**2),
    ),
    assuming=are_unit,
)
rate_of_parts = Claim(
    "2.13",
    rate(L @ e),
    column(
        2 * (e0 * rate(e0) - e1 * rate(e1) - e2 * rate(e2) - e3 * rate(e3)),
        2 * (e0 * rate(e1) + e1 * rate(e0)),
        2 * (e0 * rate(e2) + e2 * rate(e0)),
        2 * (e0 * rate(e3) + e3 * rate(e0)),
    ),
    given=both,
)
conjugate = Claim("2.14", L.T @ e, column(e0**2 + e1**2 + e2**2 + e3**2, 0, 0, 0), given=both)
