"""Ledger of Section 5: the spaces of the lemma, of Theorem 1 and of the corollary, for every order at once.

A shift (e, o) says: the term of order n = 2 nu is in P_(nu + e), that of order n = 2 nu + 1 in P_(nu + o). Shifts do
not depend on nu, so a statement on shifts holds for every n. P_a with a < 0 is {0}, which lies in every space. The
second route is in t and epsilon (``powers_of_epsilon``). Page: proofs/expansion.md.
"""

from __future__ import annotations

from collections.abc import Iterable

from flint import fmpq, fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts
from gspot_verified.paper.checks.page import Page
from gspot_verified.paper.section_2.extended_system import extended_terms
from gspot_verified.paper.section_4.powers_of_epsilon import exponents, later, progressions, sums
from gspot_verified.paper.section_5 import explicit_expansions as explicit
from gspot_verified.paper.section_5.double_series import POWER_OF_DELTA, example_series
from gspot_verified.paper.section_5.explicit_expansions import LEMMA, SPACES, Shift

SECTION = Section("Section 5, Theorem 1")
UNSCALED = {"xi": 2, "p": 2, "b": 2, "y": 6, "v": 4, "z": 6, "lambda_n": 0}
"""The powers of delta in front of the scaled variables, lines 1385 to 1390."""
INDICES = Algebra("n k nu sigma rho")
LOWEST = {"highest k": "n - 2", "order of xi_k": "k + 2"}
"""Lemma 2, first part: f_n depends on xi_k up to this k, where xi_k delta^(k + 2) stands in xi - xi*."""
STEP_4 = {"order": "n + 2", "highest k": "n", "p": "n", "b": "n", "y": "n - 4", "v": "n - 2"}
"""Lines 1727 to 1740: the order of the conditions that ξ_n(0) is found from, and the terms that stand in them."""
PROOF = {"even": "nu - 9*k", "odd": "nu - 4 - 9*k"}
"""Lines 1566 to 1588: the space P of a product with 2k, or 2k + 1, factors ξ of odd order."""
COROLLARY = {
    "even": {
        "delta": "2*nu + 2", "rho": "nu + 1 - 3*sigma", "delta by rho": "2*nu - 2*rho + 2", "delta by sigma": "6*sigma",
        "last sigma": "1/3*nu + 1/3", "epsilon": "2*sigma", "t": "nu + 1 - 3*sigma",
    },
    "odd": {
        "delta": "2*nu + 3", "rho": "nu - 3 - 3*sigma", "delta by rho": "2*nu - 2*rho + 3",
        "delta by sigma": "9 + 6*sigma", "last sigma": "1/3*nu - 1", "epsilon": "3 + 2*sigma", "t": "nu - 3 - 3*sigma",
    },
}  # fmt: skip
"""Lines 1803 to 1840, for p: the power of delta in front of s^rho, the exponents rho, those of delta in front of t^rho,
the number that sigma does not exceed, and the exponents of epsilon and t."""


def times(left: Shift, right: Shift) -> list[tuple[int, int]]:
    """The cases (parity of the order, index minus nu) of the terms of a product."""
    # (2 a) + (2 b) = 2 (a + b); (2 a) + (2 b + 1) = 2 (a + b) + 1; (2 a + 1) + (2 b + 1) = 2 (a + b + 1).
    return [(0, left[0] + right[0]), (1, left[0] + right[1]), (1, left[1] + right[0]), (0, left[1] + right[1] - 1)]


def lies_in(cases: Iterable[tuple[int, int]], target: Shift) -> bool:
    """Whether each P_(nu + index) is a part of the target's space: not higher, and congruent modulo 3."""
    return all(index <= target[parity] and (target[parity] - index) % 3 == 0 for parity, index in cases)


def moved(shift: Shift, by: int, later_orders: int = 0) -> list[tuple[int, int]]:
    """The cases after ``by`` more powers of s, taken from ``later_orders`` orders before (order n - later)."""
    cases = []
    for parity in (0, 1):
        other = (parity - later_orders) % 2
        nu_before = (parity - later_orders - other) // 2  # relative to nu
        cases.append((parity, shift[other] + nu_before + by))
    return cases


def by_derivatives(parts: Parts) -> list[fmpq_mpoly]:
    """The order n - (k + 2) of df/dxi_k in f_n: 0 at the highest k and negative beyond, for every n."""
    k, left = INDICES.symbols["k"], INDICES.symbols["n"] - parts["order of xi_k"]
    beyond = INDICES.substitute(left, {"k": parts["highest k"] + k})
    return [INDICES.substitute(left, {"k": parts["highest k"]}), beyond + k]


def by_products(parts: Parts) -> list[fmpq_mpoly]:
    """A product of m factors ξ_k has the order n = Σ (k + 2): k = n - 2 for m = 1, and less for m > 1.

    rho >= 0 is the sum of the other k, nu + 1 the number of the other factors, for m > 1: n - 2 - k = rho + 2 nu + 2.
    """
    order, highest = parts["order of xi_k"], parts["highest k"]
    others = INDICES.substitute(order, {"k": INDICES.symbols["rho"]}) + 2 * INDICES.symbols["nu"]
    alone, below = (
        INDICES.substitute(highest, {"n": total}) - INDICES.symbols["k"] for total in (order, order + others)
    )
    return [alone, below - INDICES.read("rho + 2*nu + 2")]


def wrong_in_a_quartic(orders: int = 8) -> list[int]:
    """The n at which f_n of a quartic has another highest ξ_k than stated, or another factor of it than f_ξ."""
    found, stated = explicit.highest_in_a_quartic(orders), INDICES.read(LOWEST["highest k"])
    wrong = []
    for n in range(orders):
        left = INDICES.substitute(stated, {"n": INDICES.constant(n)})
        if n in found:
            right = (left - found[n]).is_zero()
        else:
            right = left.is_constant() and not left.is_zero() and left.leading_coefficient() < 0
        wrong += [] if right else [n]
    return wrong


def by_parities(parts: Parts) -> list[fmpq_mpoly]:
    """The index of a product of factors ξ, by the lemma's proof: sigma is the sum of κ + 1 over the even orders 2κ.

    rho is the sum of κ over the odd orders 2κ + 1, of which there are 2k, or 2k + 1; ν is that of the product's order.
    The space without such pairs, k = 0, is the lemma's.
    """
    sigma, rho, k = (INDICES.symbols[name] for name in ("sigma", "rho", "k"))
    even, odd = SPACES["xi"]
    found = []
    for parity, name in enumerate(PROOF):
        number = 2 * k + parity
        # κ + even for each of the even orders is sigma and a number times even - 1; that number must not count.
        order = 2 * sigma + 2 * rho + number * (1 + UNSCALED["xi"])
        nu = (order - parity) / 2
        alone = INDICES.substitute(parts[name], {"k": INDICES.constant(0)}) - INDICES.symbols["nu"]
        found += [sigma + rho + number * odd - INDICES.substitute(parts[name], {"nu": nu}), alone - LEMMA["f"][parity]]
    return [*found, INDICES.constant(2 * even - UNSCALED["xi"])]


def by_the_conditions(parts: Parts) -> list[fmpq_mpoly]:
    """The orders in the conditions at s = 0: of p_n, b_n, ... by their powers of δ, and of ∂f/∂ξ_k in f_(n+2).

    That of ∂f/∂ξ_k is 0 at the highest k, so that it is f_ξ(ξ*), and negative beyond: what is left has ξ_k below it.
    """
    order, highest, k = parts["order"], parts["highest k"], INDICES.symbols["k"]
    others = [order - UNSCALED[name] - parts[name] for name in "pbyv"]
    slope = order - INDICES.read(LOWEST["order of xi_k"])
    beyond = INDICES.substitute(slope, {"k": highest + k}) + k
    return [*others, INDICES.substitute(slope, {"k": highest}), beyond, highest - INDICES.symbols["n"]]


def step_4_in_systems(orders: int = 8) -> bool | None:
    """The same: the highest ξ_k of a quartic alone and linear, and the conditions P = p, ... in nonlinear systems."""

    def number(name: str, n: int) -> fmpq:
        value = INDICES.substitute(INDICES.read(STEP_4[name]), {"n": INDICES.constant(n)})
        return fmpq(0) if value.is_zero() else value.leading_coefficient()

    found = explicit.highest_in_a_quartic(orders)
    highest = all(
        found.get(int(number("order", n).p)) == number("highest k", n) and number("order", n).q == 1
        for n in range(orders - UNSCALED["xi"])
    )
    answers = []
    for recursion in explicit.recursions():
        for i, name in enumerate("pbyv"):
            terms = [explicit.plain(term)[0] for term in getattr(recursion, name)]
            for n in range(len(terms)):
                wanted = [terms[k] for k in range(len(terms)) if k == number(name, n)]
                below = not wanted and number(name, n) < 0
                answers.append([explicit.plain(recursion.xi[n][i])[0]] == ([fmpq(0)] if below else wanted))
    return highest and all(answers)


def dependence() -> bool:
    """Whether f_n depends on ξ_k as stated."""
    return all(value.is_zero() for value in by_derivatives({k: INDICES.read(text) for k, text in LOWEST.items()}))


def scaling_is_that_of_xi() -> bool:
    """ξ_k has the order k + 2, by line 1385."""
    return bool(INDICES.read(LOWEST["order of xi_k"]) == INDICES.symbols["k"] + UNSCALED["xi"])


def lemma_by_induction() -> bool:
    """One more factor xi_k, of weight k + 2, leads from the lemma's space to itself; a factor and a constant too."""
    function = LEMMA["f"]
    factor = moved(SPACES["xi"], 0, 2)  # xi_k counted at the order k + 2
    as_shift = (factor[0][1], factor[1][1])
    return lies_in(factor, function) and lies_in(times(as_shift, function), function) and lies_in([(0, 0)], function)


def outside_by_induction() -> bool | None:
    """Whether a constant, a component of ξ or a product of two leaves the lemma's spaces: a counterexample."""
    function, factor = LEMMA["f"], moved(SPACES["xi"], 0, 2)
    as_shift = (factor[0][1], factor[1][1])
    return not (lies_in([(0, 0), *factor], function) and lies_in(times(as_shift, as_shift), function))


def lemma_by_powers_of_epsilon() -> bool:
    """xi - xi* has no powers of epsilon that f may not have, and those of f are closed under addition and hold 0."""
    state, function = exponents(SPACES["xi"], UNSCALED["xi"]), exponents(LEMMA["f"], 0)
    if state is None or function is None:
        return False
    # The lemma states exactly the powers that occur: sums of those of xi, and 0.
    return 0 in function and state <= function and sums(function, function) <= function and function <= state | {0}


def outside_by_powers_of_epsilon() -> bool | None:
    """The same in powers of epsilon; ``None`` where the spaces are not sets of such powers."""
    state, function = exponents(SPACES["xi"], UNSCALED["xi"]), exponents(LEMMA["f"], 0)
    if state is None or function is None:
        return None
    return not {0, *state, *sums(state, state)} <= function


def unless(outside: bool | None, holds: bool) -> bool | None:
    """The lemma's answer: False where a function is outside; a route that fails without one leaves it open."""
    return None if outside is None else False if outside else holds or None


def steps() -> dict[str, bool]:
    """Each step of the induction, for every nu at once (proofs/expansion.md, section 4)."""
    function, force, target = LEMMA["f"], SPACES["lambda_n"], SPACES["b"]
    deformation = [lies_in(moved(SPACES["z"], -1, 1), SPACES[name]) for name in ("y", "z")]
    return {
        "p_n": lies_in(moved(function, 1), SPACES["p"]),
        "r_b and r_xi": lies_in(times(function, force), function),
        "r_v": lies_in(times(SPACES["p"], force), target),
        "r_n": lies_in(moved(function, -2), target)
        and lies_in(moved(SPACES["z"], -3, 1), target)
        and lies_in(moved(function, 1), target),
        # b_n is where r_n is: L is a bijection of every P_a (section 3).
        "lambda_n": lies_in(moved(SPACES["b"], -1), force) and lies_in(moved(function, 0), force),
        "y_n, z_n": all(deformation) and all(lies_in(moved(force, 0), SPACES[name]) for name in ("y", "z")),
        "v_n": lies_in(moved(SPACES["y"], -1), SPACES["v"]),
        "xi_n": lies_in(moved(function, 1), SPACES["xi"]),
        # At s = 0: the terms of order n + 2 of functions, p_n, b_n, y_(n-4), v_(n-2) are in the space of xi_n.
        "xi_n(0)": lies_in(moved(function, 0, -2), SPACES["xi"])
        and lies_in(moved(SPACES["y"], 0, 4), SPACES["xi"])
        and lies_in(moved(SPACES["v"], 0, 2), SPACES["xi"])
        and all(lies_in(moved(SPACES[name], 0), SPACES["xi"]) for name in ("p", "b")),
    }


def steps_in_powers_of_epsilon() -> bool:
    """The same steps for the unscaled variables in t and epsilon; derivatives in t do not change powers of epsilon."""
    found = {name: exponents(SPACES[name], UNSCALED[name]) for name in SPACES}
    function = exponents(LEMMA["f"], 0)
    e = {name: value for name, value in found.items() if value is not None}
    if function is None or len(e) != len(found):
        return False
    deformation = later(e["lambda_n"], 2) | later(e["z"], 1)  # z = -epsilon^2 lambda - epsilon z'
    return (
        function == e["p"] == e["b"] == e["xi"] == e["lambda_n"]
        and sums(function, e["lambda_n"]) | sums(e["p"], e["lambda_n"]) | later(e["b"], 2) <= e["b"]
        and later(e["z"], 1) <= e["b"]
        and deformation == e["z"] == e["y"] == e["v"]
        and e["y"] | e["v"] <= e["xi"]
    )


def _lemma_orders() -> Entry:
    this = Claim(INDICES, LOWEST)
    return SECTION.settled(
        "5-lemma-orders",
        "thm:expansion, first part",
        r"f_n=f_n(\xi_0,\ldots,\xi_{n-2}),\quad \partial f_n/\partial\xi_{n-2}=f_\xi(\xi^*)",
        "For a function f in C^n, f_n depends on ξ_k with k <= n - 2 only, and for n >= 2 linearly on ξ_(n-2) with "
        "the coefficient f_ξ(ξ*)",
        Page("expansion", (scaling_is_that_of_xi,)).carries(
            this.check(
                "section 1: ∂f_n/∂ξ_k = (f_ξ)_(n-2-k), and n - 2 - k is 0 at k = n - 2, negative beyond, for every n",
                by_derivatives,
            )
        ),
        this.check(
            "Taylor's formula: a product of m factors ξ_k δ^(k+2) of the order n, for every n and m: its highest k is "
            "n - 2 for m = 1 and lower for m > 1",
            by_products,
        ),
        Rung.POINTS.check(
            "a quartic with symbols as coefficients, all orders below 8, ξ_k as symbols", not wrong_in_a_quartic()
        ),
        note="With f in C^n and n = 0 the error O(δ^(n+1)) of eq. f_kdef needs C^1.",
    )


def _step_4() -> Entry:
    this = Claim(INDICES, STEP_4)
    return SECTION.settled(
        "5-initial-values",
        "lines 1727 to 1740",
        r"[\mathcal P_\xi,\ldots,\mathcal J_\xi]\,\xi_n(0)=r_{\xi_0,n}",
        "For P, B, Y, V and J in C^(n+2): in the terms of order δ^(n+2) of the conditions at s = 0, for every n, "
        "ξ_n(0) stands once, linearly, with the Jacobian; all others are (i) constants times products of ξ_k(0) with "
        "k < n, or (ii) p_n(0), b_n(0), y_(n-4)(0), v_(n-2)(0)",
        Page("expansion", (dependence, scaling_is_that_of_xi)).carries(
            this.check(
                "sections 1 and 2: ∂f_(n+2)/∂ξ_k = (f_ξ)_(n-k), which is f_ξ(ξ*) at k = n and 0 beyond; the powers of "
                "δ in front of p, b, y, v",
                by_the_conditions,
            )
        ),
        Rung.POINTS.check(
            "a quartic with symbols as coefficients and ξ_k as symbols; the conditions in three nonlinear systems",
            step_4_in_systems(),
        ),
        note="f_n is a polynomial in ξ_0, ..., ξ_(n-2): 5-lemma-orders. p_n(0) = 0 for every n: that p_n(0) stands "
        "there, and not p_k(0) of another k, is shown by the powers of δ alone, which the systems cannot tell.",
    )


def _lemma() -> Entry:
    return SECTION.settled(
        "5-lemma",
        "thm:expansion, second part",
        r"f_{2\nu}\in P_\nu,\quad f_{2\nu+1}\in P_{\nu-4}",
        "For f as in the first part: if ξ_2k is in P_(k+1) and ξ_(2k+1) in P_(k-3), then f_2ν is in P_ν and f_(2ν+1) "
        "in P_(ν-4)",
        Rung.EXACT.check(
            "one more factor at a time, for every ν and both parities",
            unless(outside_by_induction(), lemma_by_induction()),
        ),
        Rung.EXACT.check(
            "in t and ε: the spaces are the series without ε¹, and 0, 2, 3, 4, ... are closed under addition",
            unless(outside_by_powers_of_epsilon(), lemma_by_powers_of_epsilon()),
        ),
        Claim(INDICES, PROOF).check(
            "the printed proof: with 2k or 2k + 1 factors of odd order a product is in P_(ν - 9k) or P_(ν - 4 - 9k)",
            by_parities,
        ),
        Rung.POINTS.check(
            "five nonlinear functions of two components, all orders below 10", explicit.lemma_on_functions()
        ),
    )


def outside_in_the_example(orders: int = 12) -> list[str]:
    """The terms of the extended example that are not in their stated space; ξ holds p and b."""
    terms = extended_terms(orders, chi=True)
    return explicit.outside_their_spaces([*terms.items(), ("xi", terms["p"]), ("xi", terms["b"])])


def _theorem() -> Entry:
    proved = steps()
    found = explicit.recursions()
    outside = [place for recursion in found for place in explicit.outside_their_spaces(explicit.rows_of(recursion))]
    others = outside_in_the_example()
    return SECTION.settled(
        "5-theorem-1-spaces",
        "th:1, the spaces",
        r"p_{2\nu},b_{2\nu},\xi_{2\nu}\in P_{\nu+1},\ \ldots,\ \lambda_{2\nu+1}\in P_{\nu-4}",
        "The terms of Theorem 1 are in the stated spaces, for every order",
        Page("expansion", (dependence, lemma_by_induction, lemma_by_powers_of_epsilon)).carries(
            Rung.EXACT.check(
                "section 4, the steps of the induction, each for every ν at once: " + ", ".join(proved),
                all(proved.values()) or None,
            )
        ),
        Rung.EXACT.check(
            "in t and ε: ξ, p, b, λ_N without ε¹; y, z, v without ε⁰ and ε¹; each step stays there",
            steps_in_powers_of_epsilon() or None,
        ),
        Rung.POINTS.check(
            f"{len(found)} nonlinear systems, all orders below {len(found[0].p)}",
            not outside,
            f"not in their spaces: {', '.join(outside)}" if outside else "",
        ),
        Rung.POINTS.check(
            "the extended example with a symbol χ, all orders below 12",
            not others,
            f"not in their spaces: {', '.join(others)}" if others else "",
        ),
        note="Line 1744 prints P_ν-3 for P_(ν-3).",
    )


def corollary_exponents(name: str) -> bool | None:
    """Whether each s^rho delta^n of the unscaled variable is t^rho times an integer power >= 0 of epsilon = delta^3."""
    rows = progressions(SPACES[name], UNSCALED[name])
    return rows is not None and all(first >= 0 and step >= 0 for first, step in rows)


def corollary_powers(name: str) -> bool | None:
    """The same: the powers of epsilon that the space allows are a set of integers >= 0, all of them from one on."""
    return exponents(SPACES[name], UNSCALED[name]) is not None


def printed_sums(parity: int) -> dict[str, fmpq_mpoly]:
    """The exponents that the proof prints for p."""
    return {name: INDICES.read(text) for name, text in tuple(COROLLARY.values())[parity].items()}


def printed_powers(parity: int) -> bool | None:
    """The exponents of p from its powers of epsilon: n + 2 is twice the power of t and three times that of epsilon."""
    rows, printed, total = progressions(SPACES["p"], UNSCALED["p"]), printed_sums(parity), UNSCALED["p"] + parity
    if rows is None:
        return False
    first, step = rows[parity]
    epsilon = INDICES.read(f"{first} + {step}*sigma")
    time = (INDICES.read(f"2*nu + {total}") - 3 * epsilon) / 2
    same = printed["epsilon"] == epsilon and printed["rho"] == printed["t"] == time
    whole = INDICES.read(f"2*nu + {total} - 2*rho")
    left = printed["delta by rho"] == whole and printed["delta by sigma"] == 3 * epsilon
    last = INDICES.substitute(time, {"sigma": printed["last sigma"]})
    return bool(same and left and last.is_zero() and printed["delta"] == 2 * time + 3 * epsilon)


def printed_exponents(parity: int) -> bool | None:
    """The exponents that the proof prints for p, as identities in nu and sigma."""
    printed = printed_sums(parity)
    n_and_front = INDICES.read(f"2*nu + {parity + UNSCALED['p']}")
    rho = INDICES.read(f"nu + {SPACES['p'][parity]} - 3*sigma")
    by_rho = printed["delta by rho"]
    return bool(
        printed["delta"] == n_and_front
        and by_rho == n_and_front - 2 * INDICES.symbols["rho"]
        and printed["delta by sigma"] == INDICES.substitute(by_rho, {"rho": rho})
        and INDICES.substitute(rho, {"sigma": printed["last sigma"]}).is_zero()
        and printed["rho"] == printed["t"] == rho
        and 3 * printed["epsilon"] == n_and_front - 2 * rho
    )


def example_in_t_and_epsilon() -> bool | None:
    """Every term of the extended example, by the recursion, is the term t^i epsilon^j of its series in (t, epsilon)."""
    terms, tables = extended_terms(7, chi=True), example_series(9)
    for name in "pbyvz":
        for n, row in enumerate(terms[name]):
            for k, value in enumerate(row):
                power, rest = divmod(n + UNSCALED[name] - 2 * k, 3)
                if value != 0 and (rest or power < 0 or (k, power) not in tables[name]):
                    return False
    return {name: POWER_OF_DELTA[name] for name in "pbyvz"} == {name: UNSCALED[name] for name in "pbyvz"}


def _corollary() -> Entry:
    return SECTION.settled(
        "5-corollary",
        "corollary of th:1, lines 1777 to 1842",
        r"\sum K\epsilon^{2\sigma}t^{\nu+1-3\sigma},\quad\sum K\epsilon^{3+2\sigma}t^{\nu-3-3\sigma}",
        "By the spaces of Theorem 1 each unscaled variable, truncated at any order, is a polynomial in t and ε; p has "
        "the two printed sums",
        Rung.EXACT.check(
            "power of ε of every term of ξ, p, b, y, v, z, λ_N: an integer, not negative, for every ν and σ; the two "
            "sums as identities in ν and σ",
            all_of([*map(corollary_exponents, SPACES), *map(printed_exponents, (0, 1))]),
        ),
        Rung.EXACT.check(
            "the powers of ε of each space as a set; the sums from those of p, by n + 2 = 2k + 3j for t^k ε^j",
            all_of([*map(corollary_powers, SPACES), *map(printed_powers, (0, 1))]),
        ),
        Rung.POINTS.check(
            "the extended example, orders below 7: its terms are those of its series in (t, ε)",
            example_in_t_and_epsilon(),
        ),
    )


ENTRIES: Builders = {
    "5-lemma-orders": _lemma_orders,
    "5-lemma": _lemma,
    "5-initial-values": _step_4,
    "5-theorem-1-spaces": _theorem,
    "5-corollary": _corollary,
}
"""The spaces, in the order of the paper."""
