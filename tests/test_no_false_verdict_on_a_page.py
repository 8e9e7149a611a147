"""Signs and brackets that are no factors and no columns: nothing holds, fails or is ill-formed for their sake."""

from __future__ import annotations

import pytest

import chasles
from chasles.pages.findings_told import told
from chasles.reading.notation_file import load_notation
from chasles.reading.pages import displayed
from chasles.reading.proposal import proposed

LETTERS = dict.fromkeys((r"\Delta", r"\delta", "d", r"\partial", "x", "y", "z", "f", "F", "S", "T", "t"), "scalar")
DECIDED = {"holds", "holds-under", "fails", "ill-formed"}


def verdicts(*equations: str) -> list[str]:
    """The verdicts on a page of these equations, with the letters above."""
    page = "\n\n".join(rf"\[ {each} \]" for each in equations)
    return [each.verdict for each in chasles.read(page, {"symbols": LETTERS}, "tex").equations]


def verdicts_as_proposed(*equations: str) -> list[str]:
    """The same with what is proposed for their letters."""
    page = "\n\n".join(rf"\[ {each} \]" for each in equations)
    notation = proposed(displayed(page, "tex"))
    assert load_notation(notation).proposed
    return [each.verdict for each in chasles.read(page, notation, "tex").equations]


@pytest.mark.sampled(4)
@pytest.mark.parametrize("sign", [r"\Delta", r"\delta", "d", r"\mathrm{d}", r"\partial"])
@pytest.mark.parametrize(
    "claim",
    [
        "S (x y) = x S y",
        "S (x y) = x S y + y S x",
        r"S x \, y = x S y",
        r"S [x y] = x S y",
        r"S \frac{x}{y} = \frac{S x}{y}",
        r"S \sqrt{x} = \sqrt{x} \, S y",
        "S^2 (x y) = x S^2 y",
    ],
)
def test_a_sign_of_a_difference_is_no_factor(sign: str, claim: str) -> None:
    equation = claim.replace("S", sign + " ")
    assert not {*verdicts(equation)} & DECIDED
    assert not {*verdicts_as_proposed(equation)} & DECIDED


def test_differences_of_sums_with_a_subscript_and_by_the_time_are_none_of_products() -> None:
    products = (
        r"\Delta_h (x y) = x \Delta_h y + y \Delta_h x",
        r"\frac{D (x y)}{D t} = x \frac{D y}{D t} + y \frac{D x}{D t}",
    )
    assert not {*verdicts_as_proposed(*products)} & DECIDED


def test_a_sign_of_a_difference_is_a_letter_where_the_page_has_it_alone() -> None:
    assert verdicts(r"\Delta = x y - z", r"\Delta x = x^2 y - z x", r"F = x d", r"d (x + y) = F + d y") == [
        "defined",
        "holds",
        "defined",
        "holds",
    ]
    assert verdicts(r"\delta x + y = y + \delta x", r"\delta (x y) = \delta (x y)") == ["holds", "holds"]


def test_the_letter_with_its_difference_is_one() -> None:
    said = r"\Delta x = y - z", r"T = \frac{\Delta x}{\Delta t}", r"\Delta t = F", r"T F = y - z", r"T F = z - y"
    assert verdicts_as_proposed(*said) == ["defined", "defined", "defined", "holds-under", "fails"]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    "claim",
    [
        "f(x) = y, f^{-1}(x) = 1/f(x)",
        "[x, y] = x y - y x",
        "[x, y] = -[y, x]",
        "[x z, y z] = z [x, y]",
        r"\log_2 x = \log x",
        r"\max_x f = f",
        r"2 \frac{1}{2} = \frac{5}{2}",
        r"2 \frac{1}{2} x = x",
        r"\pi = 3.14, \quad 2 \pi = 6.28",
    ],
)
def test_inverse_functions_brackets_of_two_and_mixed_numbers_are_not_read_as_what_they_look_like(claim: str) -> None:
    assert not {*verdicts(claim)} & DECIDED
    assert not {*verdicts_as_proposed(claim)} & DECIDED


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        (r"\prod_{i=1}^{2} 2 i = 8", "holds"),
        (r"\prod_{i=1}^{3} (x + i) = (x + 1)(x + 2)(x + 3)", "holds"),
        (r"\sum_{k=1}^{2} \sum_{i=1}^{2} i k = 9", "holds"),
        (r"\sum_{i=1}^{2} 2 i x = 6 x", "holds"),
        (r"\sum_{i=1}^{3} 2 i x = 6 x", "fails"),
        (r"\sum_{i=1}^{2} (-1)^i i x = x", "holds"),
        (r"\prod_{i=1}^{2} -i x = 2 x^2", "holds"),
    ],
)
def test_the_numbers_that_an_index_runs_through_are_factors(claim: str, verdict: str) -> None:
    assert verdicts(claim) == [verdict]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("nabla", [r"\nabla", r"\boldsymbol{\nabla}", r"\vec{\nabla}", r"\bm\nabla"])
@pytest.mark.parametrize(
    "claim",
    [
        r"N \cdot (f \mathbf{a}) = f N \cdot \mathbf{a}",
        r"N (f g) = f N g",
        r"N \cdot (\mathbf{a} \times \mathbf{b}) = \mathbf{a} \cdot (N \times \mathbf{b})",
        r"(\mathbf{a} \cdot N) (f \mathbf{b}) = f (\mathbf{a} \cdot N) \mathbf{b}",
        r"\frac{1}{2} N f^2 = f^2 N",
    ],
)
def test_a_nabla_is_no_vector(nabla: str, claim: str) -> None:
    assert not {*verdicts_as_proposed(claim.replace("N", nabla + " "))} & DECIDED


@pytest.mark.parametrize(
    "sign", ["D_t", r"\mathrm{D}_x", r"\partial_t", r"\mathcal{L}", r"\operatorname{Re}", r"\mathbb{E}"]
)
def test_what_is_put_before_brackets_and_letters_may_be_no_factor(sign: str) -> None:
    assert not {*verdicts_as_proposed(f"{sign} (u v) = u {sign} v", f"{sign} (2 u v) = v {sign} (2 u)")} & DECIDED


@pytest.mark.parametrize("function", [r"\sin", r"\cos", r"\cosh", r"\ln", r"\sqrt"])
def test_functions_of_numbers_may_be_of_matrices(function: str) -> None:
    letters = {"symbols": {"M": {"is": "matrix", "shape": [2, 2]}, "t": "scalar"}}
    page = rf"\[ {function}{{(M t)}} = t {function}{{(M)}} \]"
    assert not {each.verdict for each in chasles.read(page, letters, "tex").equations} & DECIDED


@pytest.mark.parametrize(
    "claims",
    [
        (r"\mathbf{P} \mathbf{P} = \mathbf{P}",),
        ("q q = q",),
        ("p = (s - 1) r", r"\rho = \frac{p}{R T}", r"\rho = \frac{p_o}{R T}"),
        (r"\begin{aligned} \text{top: } & F = x \\ \text{bottom: } & F = -x \end{aligned}",),
        (r"F = x \quad (z > 0), \qquad F = -x \quad (z < 0)",),
        (r"x = y \quad \text{if } y > 0, \quad x = -y \quad \text{otherwise}",),
    ],
)
def test_conditions_new_letters_and_cases_are_no_slips(claims: tuple[str, ...]) -> None:
    assert not {*verdicts_as_proposed(*claims)} & DECIDED


def test_rows_that_say_several_things_of_one_letter_are_cases_but_other_displays_are_not() -> None:
    rows = r"\begin{align} \text{top} &: & F &= x \\ \text{bottom} &: & F &= -x \end{align}"
    found = chasles.read(rows, {"symbols": LETTERS}, "tex").equations
    assert [each.verdict for each in found] == ["defined", "open"]
    assert verdicts("F = x", "F = -x") == ["defined", "fails"]


def test_what_print_has_a_sign_for_but_no_word_is_read_and_nothing_is_claimed_of_it() -> None:
    read = (r"\langle x y \rangle = x \langle y \rangle", r"F = \binom{x}{y} z!", r"F = \{x, y, z\}", "x^{f} = x y")
    vdots = r"F = \begin{bmatrix} x \\ \vdots \\ y \end{bmatrix}"
    assert not {*verdicts(*read, vdots)} & {*DECIDED, "unread"}
    assert verdicts(r"x^{1/2} x^{1/2} = x", r"y^{\frac{1}{2}} = z") == ["holds", "defined"]


def test_the_square_of_a_root_of_a_quotient_may_be_written_with_its_divisor() -> None:
    share = r"B = \frac{n^2 - s^2}{f^2 - s^2}"
    said = verdicts_as_proposed(share, r"\tan p = \sqrt{\frac{B}{1-B}}", r"\tan p = \sqrt{\frac{n^2 - s^2}{f^2 - n^2}}")
    assert said[0] == "defined"
    assert "fails" not in said


def test_what_fits_to_neither_neighbour_in_a_chain_is_told_once() -> None:
    letters = r"""
[symbols]
'\mathbf{a}' = { is = "vector" }
'\mathbf{b}' = { is = "vector" }
"""
    page = chasles.read(
        r"\mathbf{a}\times\mathbf{b} = \mathbf{a}\cdot\mathbf{b} = -\mathbf{b}\times\mathbf{a}", letters
    )
    assert [each.verdict for each in page.equations] == ["ill-formed", "holds"]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    "claim",
    [
        "(f * F)(t) = f(t) F(t)",
        "x(t) * y(t) = x(t) y(t)",
        "x[n+1] y = x[n] y + x y",
        "f[k - 1] = f k - f",
        r"A^\dagger A - A A^\dagger = 0",
        "p(x | y) p(y) = p(x) p(y | x)",
        r"(x y)_{S} = x y",
        r"x^2 \Big|_0^1 = 1",
    ],
)
def test_convolutions_sequences_adjoints_and_places_are_no_products(claim: str) -> None:
    assert not {*verdicts(claim)} & DECIDED
    assert not {*verdicts_as_proposed(claim)} & DECIDED


def test_what_is_said_of_a_place_or_of_letters_with_numbers_is_read() -> None:
    page = (
        r"\[ x = y \quad \text{on } \partial\Omega \times (0, T], \]",
        r"\begin{align} \pi_1 &= x y \\ \pi_2 &= y(x, z) \end{align}",
        r"\[ \vector{a} \cross \vector{b} = -\vector{b} \cross \vector{a} \]",
    )
    text = "\n\n".join(page)
    read = chasles.read(text, proposed(displayed(text, "tex")), "tex").equations
    assert [each.verdict for each in read] == ["defined", "defined", "defined", "holds"]


def test_the_inverse_of_a_quaternion_is_no_inverse_of_a_column() -> None:
    (one,) = chasles.read(r"\[ q^{-1} q = 1 \]", {"symbols": {"q": "quaternion"}}, "tex").equations
    assert one.verdict == "unread"


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    "claims",
    [
        ("A B = B A", "(A + B)^2 = A^2 + 2 A B + B^2", "e^{A + B} = e^A e^B"),
        (r"\hat{x} \hat{p} - \hat{p} \hat{x} = i \hbar", r"\hat{x} \hat{p} = \hat{p} \hat{x}"),
        ("L = D^2 + p D", "L D = D L", "D (u v) = u D v"),
        (r"\sigma_x \sigma_y = - \sigma_y \sigma_x", r"\sigma_x \sigma_y \sigma_x = \sigma_x^2 \sigma_y"),
        ("E X Y = X E Y",),
        ("j i = i j",),
        ("H = X (X^T X)^{-1} X^T", "H = I"),
        (r"\mathbf{J}^+ = \mathbf{J}^T (\mathbf{J} \mathbf{J}^T)^{-1}", r"\mathbf{J}^+ \mathbf{J} = \mathbf{I}"),
        (r"\mathbf{1}^T \mathbf{1} = n", r"\mathbf{1} \mathbf{1}^T = I"),
        (r"I(2 \theta) = 2 I(\theta)", "I(0) = 0"),
        (r"x^{k+1} = x^k - g^k", "x^1 = x^0 + h", "x^1 x^2 = x^3"),
        ("v^1 = u^1 + w^1", "v^1 v^1 = v^2"),
        ("T(2 x) = (2/3) T(3 x)",),
        (r"\dot{x} + x = 0", r"x(0) = 1, \quad \dot{x}(0) = 0"),
        ("s = a_i b_i", "r = a_j b_j", "s^2 = a_i^2 b_i^2", "s a_i = a_i^2 b_i"),
        ("C = 1/2 \\pi f", r"C = \frac{1}{2} \pi f"),
        (r"a / b c = \frac{a c}{b}",),
        (r"\lfloor 2 x \rfloor = 2 \lfloor x \rfloor",),
        ("V = (1 + r)^T", "(a b)^T = b a"),
    ],
)
def test_what_holds_of_numbers_alone_or_of_another_reading_is_not_said_to_hold(claims: tuple[str, ...]) -> None:
    assert not {*verdicts_as_proposed(*claims)} & {"holds", "holds-under", "fails", "ill-formed"}


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    "claims",
    [
        (r"A = l \times w", r"A = w \times l"),
        (r"F = m \times a", r"F = a \times m"),
        ("i j = k", "j i = -k"),
        ("A + A = A",),
        ("O(n) + O(n) = O(n)",),
        ("n = n / 2",),
        ("u(t)^2 = u(t)",),
        (r"\Theta(n^2) = \Theta(2 n^2)",),
        (r"x = \frac{-b + \sqrt{b^2 - 4 a c}}{2 a}", r"x = \frac{-b - \sqrt{b^2 - 4 a c}}{2 a}"),
        (r"S = I - \frac{1}{n} \mathbf{1} \mathbf{1}^T", "S^2 = S", r"S \mathbf{1} = 0"),
    ],
)
def test_what_fails_of_one_kind_of_letters_alone_is_not_said_to_fail(claims: tuple[str, ...]) -> None:
    assert not {*verdicts_as_proposed(*claims)} & {"fails", "ill-formed"}


def test_what_holds_of_letters_of_either_kind_holds() -> None:
    true = "A B - B A = C", "(A + B)^2 = A^2 + A B + B A + B^2", r"V = I R, \quad P = V I, \quad P = V^2 / R"
    assert [each for each in verdicts_as_proposed(*true) if each != "defined"] == ["holds", "holds-under"]
    notation = {"symbols": {"A": {"is": "scalar", "or": "matrix"}, "B": {"is": "scalar", "or": "matrix"}}}
    (said,) = chasles.read("A B = B A", {**notation, "page": {"proposed": True}}).equations
    assert "if A, B are scalars" in told(said)
    (known,) = chasles.read("A B = B A", notation).equations
    assert known.verdict == "holds"


def test_what_is_said_of_events_is_one_quantity() -> None:
    page = r"P(X = 1) = p, \quad P(X = 0) = 1 - p, \quad P(X = 1) + P(X = 0) = 1", r"P(A \mid B) P(B) = P(B | A) P(A)"
    assert verdicts_as_proposed(*page) == ["defined", "defined", "holds", "open"]
    assert verdicts_as_proposed(r"P(X \in (a, b]) = P(X \leq b) - P(X \leq a)") == ["defined"]


@pytest.mark.parametrize(
    ("said", "claim"),
    [
        (r"Z = R + j\omega L", "|Z|^2 = Z^2"),
        (r"v = V e^{j\omega t}", r"|e^{j\theta}| = e^{j\theta}"),
        (r"v = V e^{j\omega t}", r"e^{j\theta} = \cos\theta + j \sin\theta"),
        ("z = a + ib", r"\sqrt{z^2} = |z|"),
        ("z = a + ib", "z^2 = a^2 - b^2 - 2iab"),
        (r"i = \sqrt{-1}", "P = |X|^2, P = X^2"),
        ("i^2 = j^2 = k^2 = -1", "ij = k, ji = -k"),
        (r"H = \exp(-\mathrm{i} k r)", r"H \bar{H} = H^2"),
        (r"\sigma = \begin{pmatrix} 0 & -i \\ i & 0 \end{pmatrix}", r"\det\sigma = -1"),
    ],
)
def test_nothing_is_found_of_real_numbers_where_the_page_has_an_imaginary_unit(said: str, claim: str) -> None:
    assert not {*verdicts_as_proposed(said, claim)[-1:]} & DECIDED


def test_what_holds_of_all_numbers_holds_of_complex_ones_and_an_i_that_numbers_things_is_a_number() -> None:
    assert verdicts_as_proposed("z = a + ib", "z^2 = a^2 + 2iab + i^2 b^2") == ["defined", "holds"]
    grid = "x_i = x_0 + i h", "|x_i - x_0|^2 = i^2 h^2"
    assert verdicts_as_proposed(*grid)[-1] in ("holds", "holds-under")


def test_a_letter_with_a_mark_above_is_another_than_with_the_mark_below() -> None:
    claims = "v^k = a + b, v_k = a - b", "v^k - v_k = 2 b", "v^k + v_k = 2 b"
    assert verdicts_as_proposed(*claims) == ["defined", "defined", "holds", "fails"]


def test_a_letter_has_another_shape_in_a_section_of_its_own_and_its_marked_ones_are_those_of_the_page() -> None:
    page = r"""
\section{Numbers} \[ K = \frac{P C}{C P C + R} \] \[ K (C^2 P + R) = P C \]
\section{Matrices} \[ S = C P C^T + R \] \[ K = P C^T S^{-1} \] \[ K S = P C^T \] \[ P_1 = (K S)^T \] \[ A B = B A \]
\section{Numbers again} \[ P = \frac{P_1}{C} \] \[ A B = B A \]"""
    notation = proposed(displayed(page, "tex"))
    found = [each.verdict for each in chasles.read(page, notation, "tex").equations]
    assert found[:6] == ["defined", "holds-under", "defined", "defined", "holds-under", "defined"]
    assert "unread" not in found
    assert found[6:] == ["open", "defined", "ambiguous"]


def test_logarithms_to_a_base_are_quotients_of_natural_ones() -> None:
    claims = (r"\log_2 (x y) = \log_2 x + \log_2 y", r"\log_{10} x = \frac{\ln x}{\ln 10}", r"\log_2 8 = 3")
    assert [each.split()[0].rstrip(":") for each in verdicts(*claims)] == ["holds-under", "holds-under", "holds"]
    assert not DECIDED & {*verdicts(r"\log_2 (x y) = \log_2 x \log_2 y")} - {"fails"}


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (r"e^{x^{2 y}}", r"e^{x^2 y}"),
        (r"e^{\frac{a b}{c}}", r"e^{\frac{a}{b c}}"),
        (r"\sqrt{x} y", r"\sqrt{x y}"),
        (r"\overline{x} y", r"\overline{x y}"),
        (r"x_{i_{j k}}", "x_{i_j k}"),
        (r"{}^A v", r"{}^B v"),
        (r"\mathbf{x} y", r"\mathbf{x y}"),
        ("|x| y", "|x y|"),
        (r"\begin{matrix} a & b \end{matrix}", r"\begin{matrix} a b \end{matrix}"),
    ],
)
def test_what_is_grouped_otherwise_is_another_quantity(one: str, other: str) -> None:
    assert verdicts_as_proposed(rf"\int_0^1 {one} dt = \int_0^1 {other} dt") != ["holds"]
    assert verdicts_as_proposed(rf"\int_0^1 {one} dt = \int_0^1 {one} dt") == ["holds"]


def test_what_one_section_says_another_may_say_otherwise() -> None:
    said = "$$r q = p$$\n\n$$r q q^{-1} = p q^{-1}$$\n\n$$r = p q^{-1}$$\n\n{}$$q r = p$$\n\n$$r = q^{-1} p$$"
    letters = {letter: {"is": "matrix"} for letter in "pqr"}
    same, other = (chasles.read(said.replace("{}", between), {"symbols": letters}) for between in ("", "# Other\n"))
    assert [each.verdict for each in same.equations][-2:] == ["fails", "fails"]
    assert not any(each.verdict == "fails" for each in other.equations)


def test_blocks_of_a_matrix_that_another_section_wrote_out_are_no_slip() -> None:
    blocks = r"\begin{bmatrix} M_{11} & M_{12} \\ M_{21} & M_{22} \end{bmatrix}"
    said = r"$$M(q) = \begin{bmatrix} a + b & b \\ b & b \end{bmatrix}$$"
    page = f"{said}\n\n# Other\n$$M(q) = {blocks}$$"
    letters = {"M": {"is": "matrix", "size": 2}, "M(q)": {"is": "matrix", "size": 2}, "a": "scalar", "b": "scalar"}
    assert [each.verdict for each in chasles.read(page, {"symbols": letters}).equations] == ["defined", "defined"]


@pytest.mark.parametrize(
    ("claims", "expected"),
    [
        ([r"\int_0^1 x + y z \,dt = s", r"\int_0^1 x + y z dt = s + 0"], ["defined", "holds"]),
        ([r"\int_0^1 (x + y) z dt = s", r"\int_0^1 x + y z dt = s"], ["defined", "defined"]),
        ([r"s = \int \frac{dx}{x} + \int_0^1 a dx", r"s - \int_0^1 a dx = \int \frac{dx}{x}"], ["defined", "holds"]),
        ([r"\dot x = a d", r"s = \int_0^1 x dt"], ["defined", "defined"]),
        ([r"v = \min_u a + u", r"v + b = b + \min_u a + u"], ["defined", "holds"]),
        ([r"u^* = \argmin_u J(u)", r"u^* = \underset{u}{\operatorname{argmin}} J(u)"], ["defined", "holds"]),
        ([r"\min_v \quad |v| \quad \text{subject to} \quad b v = c"], ["defined"]),
        ([r"S = \{ x \in R : x > 0 \}", r"a \not= b"], ["defined", "open"]),
        ([r"f : A \to B; \quad a \mapsto f(a) = b"], ["defined"]),
        ([r"\theta = \arctan(y, x)", r"\theta = \operatorname{atan2}(y, x)"], ["defined", "holds-under"]),
        ([r"\cos(\pi/3) = 1/2", r"\sin(\pi/6) = 1"], ["holds", "fails"]),
        ([r"\dot x = \begin{bmatrix} 0 & 1\\ 2 & 3\end{bmatrix} x + \begin{bmatrix} 0\\ u\end{bmatrix}"], ["defined"]),
        ([r"x' = \mathbf{q} \otimes x \otimes \mathbf{q}^*", r"\mathbf{q} \otimes \mathbf{q}_2 = \mathbf{q}_3"],
         ["defined", "defined"]),
    ],
)  # fmt: skip
def test_signs_that_reach_far_and_what_is_put_under_them(claims: list[str], expected: list[str]) -> None:
    assert verdicts_as_proposed(*claims) == expected


def test_scripts_behind_braces_are_put_on_once_and_blocks_need_not_stand_below_each_other() -> None:
    letters = {"Q": "rotation", "p": "vector", "a": "scalar", "T": {"is": "matrix", "shape": [4, 4]}}
    page = r"$$a = {[Q^T]_{12}}^2$$ $$a = Q_{21}^2$$ $$T = \begin{bmatrix} Q & p \\ 1 & \mathbf{0} \end{bmatrix}$$"
    found = chasles.read(page, {"symbols": letters, "operators": {"transpose": ["#^T"]}}).equations
    assert [each.verdict for each in found] == ["defined", "holds", "defined"]


@pytest.mark.parametrize(("first", "expected"), [("V", "ambiguous"), ("V^T", "fails")])
def test_what_the_page_never_transposes_may_be_symmetric(first: str, expected: str) -> None:
    riccati = rf"\dot{{V}} = {first} A - V B R^{{-1}} B^T V"
    claim = r"x^T V A x = \frac{1}{2} x^T V A x + \frac{1}{2} x^T A^T V x"
    assert verdicts_as_proposed(riccati, claim)[-1] == expected


def test_upright_names_of_functions_are_no_factors() -> None:
    snell = r"k_1 \text{sin} \theta_1 = k_2 \text{sin} \theta_2"
    assert verdicts_as_proposed(snell, r"\text{sin}^2 \theta_2 = (k_1 / k_2) \text{sin}^2 \theta_1")[-1] == "open"


def test_what_would_only_say_that_zero_is_zero_was_not_meant() -> None:
    letters = {"H": "matrix", "v": "vector", "h": "vector", r"\alpha": "scalar"}
    page = r"$$\dot h = H v = 0$$ $$\ddot h = H \dot v + \dot H v = 0$$"
    page += r"$$\ddot h = H \dot v + \dot H v = - 2 \alpha \dot h - \alpha^2 h$$"
    assert chasles.read(page, {"symbols": letters}, "md").equations[-1].verdict == "open"


def test_nothing_holds_since_an_open_equation_makes_both_sides_vanish() -> None:
    letters = {"symbols": dict.fromkeys(("x", "y", "V", "A"), "scalar")}
    page = "$$x = 2 V - 20 V = 0 A$$\n\n$$y = 3 V = 4 V$$"
    found = [each.verdict for each in chasles.read(page, letters, "md").equations]
    assert found == ["defined", "open", "defined", "open"]


def test_nothing_holds_since_letters_are_constant_that_make_both_sides_vanish() -> None:
    letters = {"symbols": {"P": "scalar", "R": "scalar", r"\phi": "scalar"}}
    page = r"$$P = \sin\phi$$ $$R = \cos\phi$$ $$\dot P = \dot R$$"
    assert chasles.read(page, letters, "md").equations[-1].verdict == "open"


CASE = r"""$$s = \sqrt{2 J T - L^2} \, u, \quad L = \sqrt{I^2 u^2 + J^2 w^2}$$

$$u = 2 k w$$

In particular, $$u = 0, \quad w = 1$$ This is a rotation.

$$k = 1$$

{}"""


@pytest.mark.parametrize("claim", ["s = n u", "s + 1 = w"])
def test_what_is_open_and_says_what_a_letter_is_in_one_case_is_no_premise_of_others(claim: str) -> None:
    letters = {"symbols": dict.fromkeys(("s", "u", "w", "L", "I", "J", "T", "k", "n"), "scalar")}
    assert chasles.read(CASE.replace("{}", f"$${claim}$$"), letters, "md").equations[-1].verdict == "open"


def test_nothing_fails_at_values_that_the_page_takes_for_an_example_behind_it() -> None:
    letters = {"symbols": dict.fromkeys("xy", "scalar")}
    page = "$$x + y = 0$$\n\nFor example, $$x = 0, \\quad y = 1$$"
    assert chasles.read(page, letters, "md").equations[0].verdict == "open"


def test_values_behind_an_equation_are_defined_there() -> None:
    letters = {"symbols": dict.fromkeys("xmkEn", "scalar")}
    page = r"$$m \ddot x = - k x, \quad m = 2, \quad k = 8$$ $$E = m \dot x^2 / 2$$ $$E = \dot x^2$$"
    assert [each.verdict for each in chasles.read(page, letters, "md").equations[1:]] == ["defined"] * 3 + ["holds"]


@pytest.mark.parametrize(
    ("lead", "verdict"), [("or, in other units:", "open"), ("Hence", "fails"), ("or equivalently", "fails")]
)
def test_what_may_be_said_instead_is_not_wrong(lead: str, verdict: str) -> None:
    page = f"$$F = 2 x + y$$\n\n{lead} $$F = 3 x + y$$"
    assert chasles.read(page, {"symbols": LETTERS}, "md").equations[-1].verdict == verdict


def test_what_is_open_in_one_of_several_readings_is_no_premise() -> None:
    letters = {rf"\mathbf{{{letter}}}": "vector" for letter in "abc"}
    triple = r"\mathbf a \times \mathbf b \times (\mathbf b \times \mathbf a)"
    page = rf"""$$\mathbf c = \mathbf a + \mathbf b$$

$${triple} = \mathbf a \times ((\mathbf b \cdot \mathbf a) \mathbf b - (\mathbf b \cdot \mathbf b) \mathbf a)$$

$$(\mathbf a \cdot \mathbf b) \mathbf a \times \mathbf b = 2 (\mathbf a \cdot \mathbf b) \mathbf a \times \mathbf c$$"""
    found = [each.verdict for each in chasles.read(page, {"symbols": letters}, "md").equations]
    assert found == ["defined", "ambiguous", "fails"]
