"""Ledger of Section 5, last part: the perturbation of the distinguished trajectory on the inner scale, and matching.

w is delta = epsilon^(1/3), and T = epsilon^(2 (β - 1)/3) = w^(2 (β - 1)) with β > 0 stands in front of the hatted
variables. g0, g1, ... are the hatted b and its derivatives in s; h0, h1, ... are theta's in tau.
"""

from __future__ import annotations

from flint import fmpq, fmpq_mpoly

from gspot_verified.paper.appendix_a.theta_pages import NEGATIVE
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts
from gspot_verified.paper.checks.leading_order import leading
from gspot_verified.paper.section_2.extended_system import extended_terms
from gspot_verified.paper.section_4.section_4_inner import PRINTED as SECTION_4
from gspot_verified.paper.section_5.section_5_recursion import PRINTED as RECURSION

SECTION = Section("Section 5, outer system and matching")
ALGEBRA = Algebra(
    "alpha1 alpha2 alpha3 beta delta kappa s tau w T chi x1 b0 b1 y0 y1 v0 v1 z0 z1 lam p a2 a3 y v g0 g1 g2 g3 "
    "h0 h1 h2 h3 hy1 hv1 hz hz1 hl hx hp hp1 bar bar1 barx barl p1 a1 q1 q2 c1 c2 d1 d2 e1 e2"
)
_SYMBOLS = ALGEBRA.symbols
_ZERO, _ONE = ALGEBRA.constant(0), ALGEBRA.constant(1)
HATTED = {
    "b0": "g0", "b1": "g1", "y0": "y", "y1": "hy1", "v0": "v", "v1": "hv1", "z0": "hz", "z1": "hz1", "lam": "hl",
}  # fmt: skip
"""Lines 2049 to 2058: the deviations behind the factor T."""
DISTINGUISHED_P = "alpha1*s + w*q1 + w^2*q2"
DEVIATION_OF_P = {"p": "w^2*hp", "p1": "w^2*hp1"}
"""Behind the factor T: line 2052 leaves it out, as it is smaller by δ² than the others."""
RATE_OF_P = "e1*hx"
"""hp1, by specialPP."""
TAYLOR = {
    "a1": "alpha1 + e1*w^2*hx + e2*w^4*hx^2", "a2": "alpha2 + c1*w^2*hx + c2*w^4*hx^2",
    "a3": "alpha3 + d1*w^2*hx + d2*w^4*hx^2",
}  # fmt: skip
"""alpha_1, alpha_2, alpha_3 at ξ* + δ² hx; a term of degree j >= 3 has the factor w^(2 j) T^j, of higher order too."""
PRINTED: dict[str, dict[str, str]] = {
    "5-bpert-v": {"factor": "delta^4"},
    "5-perturbation": {
        "b'": "alpha3*y/2", "y'": "v", "v'": "g0 - alpha1*s*y/2", "third order": "g3 + alpha1/2*s*g1 - alpha3/2*g0",
    },
    "5-perturbation-theta": {"equation": "h3 - tau*h1 + beta*h0", "kappa cubed": "-alpha1/2"},
    "5-matching": {"power of kappa": "-beta", "power of epsilon": "2*beta/3"},
}  # fmt: skip
CORRECTED: dict[str, dict[str, str]] = {"5-bpert-v": {"factor": "1"}}


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


def put(value: fmpq_mpoly, **texts: str) -> fmpq_mpoly:
    """The value with formulas in place of some symbols."""
    return ALGEBRA.substitute(value, {name: ALGEBRA.read(text) for name, text in texts.items()})


def _bpert_v() -> Entry:
    this = _claim("5-bpert-v")

    def jets(parts: Parts) -> list[fmpq_mpoly]:
        # Without the hatted terms specialY must give y~' = v~; x1 is the derivative of y-bar.
        return [_SYMBOLS["x1"] - parts["factor"] * _SYMBOLS["x1"]]

    def example(parts: Parts) -> list[fmpq_mpoly]:
        terms = extended_terms(6, chi=True)
        s, delta = _SYMBOLS["s"], _SYMBOLS["delta"]

        def series(name: str) -> fmpq_mpoly:
            pieces = (
                ALGEBRA.bring(a) * s**k * delta**n for n, row in enumerate(terms[name]) for k, a in enumerate(row)
            )
            return sum(pieces, start=_ZERO)

        difference = series("y").derivative("s") - parts["factor"] * series("v")
        return [ALGEBRA.coefficient_of(difference, "delta", n) for n in range(6)]

    return SECTION.settled(
        "5-bpert-v",
        "line 2056",
        r"\tilde v=\epsilon^{4/3}\tilde{\bar v}(s,\epsilon^{1/3})+\epsilon^{2(\beta-1)/3}\hat v(s)",
        "The distinguished trajectory enters the scaled v with the factor ε^(4/3)",
        this.check(
            "specialY without the hatted terms: the rate of the distinguished y must be the distinguished part of v",
            jets,
            fault="the rate of y is the v of the distinguished trajectory itself, without the factor ε^(4/3) = δ⁴",
        ),
        this.check(
            "the extended example through δ⁵",
            example,
            fault="its v begins with {left} δ², and the printed factor makes that a term of order δ⁶",
        ),
        corrected="v is that of the distinguished trajectory plus ε^(2(β-1)/3) v\u0302: no ε^(4/3) = δ⁴, which belongs "
        "to the unscaled v",
        note="The lines of b and y are consistent. That of p leaves out a deviation that is smaller by ε^(2/3) than "
        "the others, with s = 0 where p = 0 (eq. pbc). A bracket without a partner in two of them: 5-brackets.",
    )


def leading_equations() -> tuple[dict[str, fmpq_mpoly], list[fmpq_mpoly]]:
    """SpecialPP to specialL for the deviations, left minus right, at leading order; and what is not of higher order."""
    state = {"before": _SYMBOLS["barx"], "after": ALGEBRA.read("barx + T*hx")}
    values: dict[str, dict[str, fmpq_mpoly]] = {}
    for time in state:
        images = {name: ALGEBRA.read("bar1" if name.endswith("1") else "bar") for name in HATTED}
        images |= {"lam": _SYMBOLS["barl"], "p": ALGEBRA.read(DISTINGUISHED_P), "p1": _SYMBOLS["bar1"]}
        if time == "after":
            hats = HATTED | DEVIATION_OF_P
            images = {name: images[name] + _SYMBOLS["T"] * ALGEBRA.read(hat) for name, hat in hats.items()}
        taylor = {name: ALGEBRA.substitute(ALGEBRA.read(text), {"hx": state[time]}) for name, text in TAYLOR.items()}
        images |= taylor | {"delta": _SYMBOLS["w"]}
        lines = {name: ALGEBRA.read(RECURSION["5-inner-system"][f"special{name}"]) for name in ("PP", *"BYVZL")}
        values[time] = {name: ALGEBRA.substitute(line, images) for name, line in lines.items()}
    found, rest = {}, []
    for name, after in values["after"].items():
        found[name], others = leading(ALGEBRA, after - values["before"][name], 2 if name == "PP" else 0, unit=2)
        rest += others
    return found, rest


def _perturbation() -> Entry:
    this = _claim("5-perturbation")

    def derive(parts: Parts) -> list[fmpq_mpoly]:
        equations, rest = leading_equations()
        # specialZ and specialL: z = -lambda, lambda = z - y, so lambda = -y/2, as in line 2045.
        force = {"hl": ALGEBRA.read("-y/2"), "hz": ALGEBRA.read("y/2")}
        # hp stands in no line.
        slopes = {"g1": parts["b'"], "hy1": parts["y'"], "hv1": parts["v'"], "hp1": ALGEBRA.read(RATE_OF_P)}
        lines = [ALGEBRA.substitute(equation, force | slopes) for equation in equations.values()]
        field = {"s": _ONE, "g0": parts["b'"], "y": parts["y'"], "v": parts["v'"]}
        powers = [ALGEBRA.derivative(_SYMBOLS["g0"], field, k) for k in range(4)]
        return [*lines, *rest, ALGEBRA.replaced(parts["third order"], "g", powers, _ONE)]

    def section_4(parts: Parts) -> list[fmpq_mpoly]:
        # -2 times the equation is eqn:de_inner; and the three lines give it with alpha3 y = 2 b'.
        inner = ALGEBRA.read(SECTION_4["4-inner-slow"]["equation"])
        force = put(parts["v'"], y="2*g1") - _SYMBOLS["g0"]  # times alpha3: g0 enters once
        third = 2 * _SYMBOLS["g3"] - _SYMBOLS["alpha3"] * _SYMBOLS["g0"] - force
        slope = 2 * parts["b'"] - _SYMBOLS["alpha3"] * _SYMBOLS["y"]
        return [inner + 2 * parts["third order"], third - 2 * parts["third order"], slope, parts["y'"] - _SYMBOLS["v"]]

    return SECTION.settled(
        "5-perturbation",
        "lines 2031 to 2045, 2063 to 2071",
        r"\hat b'=\alpha_3^*\hat y/2,\ \hat y'=\hat v,\ \hat v'=\hat b-\alpha_1^*s\hat y/2;\quad "
        r"\hat b'''+\tfrac{\alpha_1^*}2s\hat b'-\tfrac{\alpha_3^*}2\hat b=0",
        "For every β > 0 the perturbation satisfies the three printed equations, at leading order in ε, once z has "
        "come to z = y/2 in the fast time s/δ, with p = 0 at s = 0 (eq. pbc), and the elimination of y and v from "
        "them gives the printed equation of third order",
        this.check(
            "specialPP to specialL with the factor ε^(2(β-1)/3), that of p smaller by δ²: what else there is, the "
            "deviation of p too, has a higher order for every β > 0",
            derive,
        ),
        this.check("-2 times the result is eq. de_inner; elimination with α_3 y = 2 b'", section_4),
    )


def _perturbation_theta() -> Entry:
    this = _claim("5-perturbation-theta")
    printed = ALGEBRA.read(PRINTED["5-perturbation"]["third order"])

    def chain_rule(parts: Parts) -> list[fmpq_mpoly]:
        # b^(k) = kappa^k theta^(k); a term kappa^a s^c is kappa^(a - c) tau^c, and only kappa^0 and kappa^3 may remain.
        powers = [_SYMBOLS["kappa"] ** k * _SYMBOLS[f"h{k}"] for k in range(4)]
        value, found = _ZERO, []
        for a, in_s in ALGEBRA.coefficients(ALGEBRA.replaced(printed, "g", powers, _ONE), "kappa").items():
            for c, coefficient in ALGEBRA.coefficients(in_s, "s").items():
                cubed = {0: _ONE, 3: parts["kappa cubed"]}.get(a - c)
                if cubed is None:
                    found.append(coefficient)
                else:
                    value += coefficient * cubed * _SYMBOLS["tau"] ** c
        return [*found, put(value, alpha3="beta*alpha1") + ALGEBRA.read("alpha1/2") * parts["equation"]]

    def monomials(parts: Parts) -> list[fmpq_mpoly]:
        found, place = [parts["kappa cubed"] + _SYMBOLS["alpha1"] / 2], ALGEBRA.read("kappa*s")
        for j in range(5):
            b = [ALGEBRA.derivative(place**j, {"s": _ONE}, k) for k in range(4)]
            theta = [ALGEBRA.derivative(_SYMBOLS["tau"] ** j, {"tau": _ONE}, k) for k in range(4)]
            right = put(ALGEBRA.replaced(parts["equation"], "h", theta, _ONE), tau="kappa*s")
            difference = ALGEBRA.replaced(printed, "g", b, _ONE) + _SYMBOLS["alpha1"] / 2 * right
            found.append(put(put(difference, alpha3="beta*alpha1"), alpha1="-2*kappa^3"))
        return found

    return SECTION.settled(
        "5-perturbation-theta",
        "lines 2072 to 2078",
        r"\theta'''-\tau\theta'+\beta\theta=0,\quad\tau=\kappa s,\ \kappa=(-\alpha_1^*/2)^{1/3}",
        "In τ = κ s, α_1* < 0, the equation of third order of the perturbation, line 2070, becomes eq. hypergeomeqn",
        this.check("chain rule", chain_rule),
        this.check("both operators on 1, s, ..., s⁴, which determine one of order 3", monomials),
    )


def theta_polynomial(n: int) -> list[fmpq]:
    """The coefficients of Θ(τ, n) = (-1)^n n! [r^n] e^(rτ - r³/3): of τ^n, τ^(n-3), ... (proofs/initial_values.md)."""
    found, value = [], fmpq((-1) ** n)
    for j in range(n // 3 + 1):
        found.append(value)
        left = n - 3 * j
        value *= fmpq(-left * (left - 1) * (left - 2), 3 * (j + 1))
    return found


def _matching() -> Entry:
    this = _claim("5-matching")

    def exponents(parts: Parts) -> list[fmpq_mpoly]:
        # kappa^x epsilon^y (-kappa s)^β against (-t)^β = (epsilon^(2/3) (-s))^β: the powers of kappa and of epsilon.
        beta = _SYMBOLS["beta"]
        return [parts["power of kappa"] + beta, parts["power of epsilon"] - beta * fmpq(2, 3)]

    def integers(parts: Parts) -> list[fmpq_mpoly]:
        # At an integer β, Θ is a polynomial: kappa^x epsilon^y Θ(kappa t epsilon^(-2/3)) is (-t)^β and positive powers
        # of epsilon.
        found = []
        for n in range(2, 8):
            x, y = (ALGEBRA.substitute(value, {"beta": ALGEBRA.constant(n)}) for value in parts.values())
            for j, number in enumerate(theta_polynomial(n)):
                in_kappa, in_epsilon = x + (n - 3 * j), y - fmpq(2, 3) * (n - 3 * j)
                wrong = number - (-1) ** n if j == 0 else 0
                found += [in_kappa + 3 * j, in_epsilon - 2 * j, ALGEBRA.constant(wrong)]
        return found

    return SECTION.settled(
        "5-matching",
        "lines 2079 to 2083",
        r"\hat b(s)=b_0\kappa^{-\beta}\epsilon^{2\beta/3}\Theta(\kappa s,\beta)",
        "The inner solution b_0 κ^(-β) ε^(2β/3) Θ(κ s, β) matches b_0 (-t)^β of the outer solution",
        NEGATIVE.carries(
            this.check("Θ(τ, β) ~ (-τ)^β as τ → −∞; the powers of κ and ε, for every β, given this", exponents)
        ),
        this.check("Θ as a polynomial at β = 2, ..., 7: (-t)^β and positive powers of ε", integers, Rung.POINTS),
        note="This b is the unscaled deviation: ε^(2β/3) times the hatted b of lines 2053 to 2071.",
    )


ENTRIES: Builders = {
    "5-bpert-v": _bpert_v,
    "5-perturbation": _perturbation,
    "5-perturbation-theta": _perturbation_theta,
    "5-matching": _matching,
}
"""The perturbation, in the order of the paper."""
