"""Ledger of Section 5: the lemma, Theorem 1 and the corollary, by index arithmetic and on explicit systems.

A shift (e, o) says: the term of order n = 2 nu is in P_(nu + e), that of order n = 2 nu + 1 in P_(nu + o). Shifts do
not depend on nu, so a statement on shifts holds for every n. P_a with a < 0 is {0}, which lies in every space.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import product

from gspot_verified.ledger.entry import Check, Entry, Rung, all_of, settled
from gspot_verified.ledger.explicit_expansions import (
    FUNCTION,
    SPACES,
    Shift,
    equations_hold,
    in_stated_spaces,
    lemma_on_functions,
    recursions,
    synchronised,
)

SECTION = "Section 5, Theorem 1"
UNSCALED = {"xi": 2, "p": 2, "b": 2, "y": 6, "v": 4, "z": 6, "lambda_n": 0}
"""The powers of delta in front of the scaled variables, lines 1385 to 1390."""
COROLLARY = {"even": (0, 2, 1, -3), "odd": (3, 2, -3, -3)}
"""Lines 1818 to 1840, for p: eps^(a + b sigma) t^(nu + c + d sigma)."""


def entries() -> list[Entry]:
    """The lemma, the theorem and the corollary."""
    return [_lemma(), _theorem(), _corollary()]


def times(left: Shift, right: Shift) -> list[tuple[int, int]]:
    """The cases (parity of the order, index minus nu) of the terms of a product."""
    # (2 a) + (2 b) = 2 (a + b); (2 a) + (2 b + 1) = 2 (a + b) + 1; (2 a + 1) + (2 b + 1) = 2 (a + b + 1).
    return [(0, left[0] + right[0]), (1, left[0] + right[1]), (1, left[1] + right[0]), (0, left[1] + right[1] - 1)]


def lies_in(cases: Iterable[tuple[int, int]], target: Shift) -> bool:
    """Whether each P_(nu + index) is a part of the target's space: not higher, and congruent modulo 3."""
    return all(index <= target[parity] and (target[parity] - index) % 3 == 0 for parity, index in cases)


def moved(shift: Shift, by: int, later: int = 0) -> list[tuple[int, int]]:
    """The cases after ``by`` more powers of s, taken from ``later`` orders before (order n - later)."""
    cases = []
    for parity in (0, 1):
        other = (parity - later) % 2
        nu_before = (parity - later - other) // 2  # relative to nu
        cases.append((parity, shift[other] + nu_before + by))
    return cases


def lemma_by_induction() -> bool:
    """One more factor xi_k, of weight k + 2, leads from FUNCTION to FUNCTION; a single factor and a constant too."""
    factor = moved(SPACES["xi"], 0, 2)  # xi_k counted at the order k + 2
    as_shift = (factor[0][1], factor[1][1])
    return lies_in(factor, FUNCTION) and lies_in(times(as_shift, FUNCTION), FUNCTION) and lies_in([(0, 0)], FUNCTION)


def lemma_by_counting(most: int = 30) -> bool:
    """The paper's own count: k factors of odd order lower the index by 9 for every two, by 4 more if k is odd."""
    for odd in range(most):
        # n is the sum of the k_i + 2: an even factor has 2 (kappa + 1) and index kappa + 1, an odd one 2 kappa + 3 and
        # index kappa - 3. So 2 (sum of indices) + 9 odd = n, and the index is (n - 9 odd)/2.
        parity = odd % 2
        index = (parity - 9 * odd) // 2  # n = 2 nu + parity
        if not lies_in([(parity, index)], FUNCTION):
            return False
    return True


def steps() -> dict[str, bool]:
    """Each step of the proof of Theorem 1, for every nu at once."""
    force, target = SPACES["lambda_n"], SPACES["b"]
    r_b = lies_in(times(FUNCTION, force), FUNCTION) and lies_in([(0, 0), (1, -4)], FUNCTION)
    r_v = lies_in(times(SPACES["p"], force), target)
    deformation = [lies_in(moved(SPACES["z"], -1, 1), SPACES[name]) for name in ("y", "z")]
    return {
        "p_n": lies_in(moved(FUNCTION, 1), SPACES["p"]),
        "r_b and r_xi": r_b,
        "r_v": r_v,
        "r_n": lies_in(moved(FUNCTION, -2), target)
        and lies_in(moved(SPACES["z"], -3, 1), target)
        and lies_in(moved(FUNCTION, 1), target),
        "b_n": lies_in(moved(target, 0), SPACES["b"]) and lies_in(moved(target, -3), target),
        "lambda_n": lies_in(moved(SPACES["b"], -1), force) and lies_in(moved(FUNCTION, 0), force),
        "y_n, z_n": all(deformation) and all(lies_in(moved(force, 0), SPACES[name]) for name in ("y", "z")),
        "v_n": lies_in(moved(SPACES["y"], -1), SPACES["v"]),
        "xi_n": lies_in(moved(FUNCTION, 1), SPACES["xi"]),
        # At s = 0: the terms of order n + 2 of functions, p_n, b_n, y_(n-4), v_(n-2) are in the space of xi_n.
        "xi_n(0)": lies_in(moved(FUNCTION, 0, -2), SPACES["xi"])
        and lies_in(moved(SPACES["y"], 0, 4), SPACES["xi"])
        and lies_in(moved(SPACES["v"], 0, 2), SPACES["xi"])
        and SPACES["p"] == SPACES["b"] == SPACES["xi"],
    }


def _lemma() -> Entry:
    return settled(
        SECTION,
        "5-lemma",
        "thm:expansion",
        r"f_{2\nu}\in P_\nu,\quad f_{2\nu+1}\in P_{\nu-4}",
        "f_n depends on ξ_k with k <= n - 2 only, linearly on ξ_(n-2), and lies in P_ν or P_(ν-4)",
        Check(Rung.EXACT, "one more factor at a time, for every ν and both parities", lemma_by_induction() or None),
        Check(
            Rung.EXACT,
            "the paper's count with 0 to 29 factors of odd order (9 for every two)",
            lemma_by_counting() or None,
        ),
        Check(
            Rung.POINTS, "five nonlinear functions of two components, all orders below 10", lemma_on_functions() or None
        ),
        note="The first part: a product of terms of order k_i of ξ has the order Σ (k_i + 2) in f.",
    )


def _theorem() -> Entry:
    proved = steps()
    found = recursions()
    return settled(
        SECTION,
        "5-theorem-1",
        "th:1",
        r"p_{2\nu},b_{2\nu},\xi_{2\nu}\in P_{\nu+1},\ \ldots,\ \lambda_{2\nu+1}\in P_{\nu-4}",
        "For β not an integer there is exactly one expansion, with its terms in the stated spaces",
        Check(
            Rung.EXACT,
            "the steps of the proof, each for every ν at once (with entries 5-third-order, 5-monomial, 5-step-3): "
            + ", ".join(proved),
            all(proved.values()) or None,
        ),
        Check(
            Rung.POINTS,
            f"{len(found)} nonlinear systems, all orders below {len(found[0].p)}: spaces, eqs. specialX to "
            "specialL and conditions pbc to Jbc, by ordinary polynomials",
            all_of((in_stated_spaces(r) and equations_hold(r) and synchronised(r)) or None for r in found),
        ),
        note="Line 1744 prints P_ν-3 for P_(ν-3).",
    )


def corollary_exponents(name: str) -> bool:
    """Whether each s^rho delta^n of the unscaled variable is t^rho times an integer power >= 0 of eps = delta^3."""
    for parity in (0, 1):
        # rho = nu + shift - 3 sigma; delta^(2 nu + parity + front - 2 rho) has no nu in it.
        constant = parity + UNSCALED[name] - 2 * SPACES[name][parity]
        if constant % 3 or constant < 0:
            return False
    return True


def printed_exponents() -> bool:
    """The exponents that the proof prints for p, at enough values of nu and sigma for identities of degree 1."""
    for parity, (a, b, c, d) in enumerate(COROLLARY.values()):
        for nu, sigma in product(range(2), range(2)):
            rho = nu + SPACES["p"][parity] - 3 * sigma
            if rho != nu + c + d * sigma or 2 * nu + parity + 2 - 2 * rho != 3 * (a + b * sigma):
                return False
    return True


def _corollary() -> Entry:
    return settled(
        SECTION,
        "5-corollary",
        "corollary of th:1, lines 1777 to 1842",
        r"\sum K\epsilon^{2\sigma}t^{\nu+1-3\sigma},\quad\sum K\epsilon^{3+2\sigma}t^{\nu-3-3\sigma}",
        "Truncated at any order, each unscaled variable is a polynomial in t and ε",
        Check(
            Rung.EXACT,
            "exponent of δ of every term of ξ, p, b, y, v, z, λ_N: a multiple of 3, not negative, for every ν",
            all(corollary_exponents(name) for name in SPACES) or None,
        ),
        Check(Rung.EXACT, "the two printed sums for p, as identities in ν and σ", printed_exponents() or None),
    )
