"""Ledger of Section 4 on its inner scale, t = delta^2 s with delta^3 = epsilon.

g0, g1, ... are b and its derivatives in s; f0, f1, ... in the fast time; h0, h1, ... are theta's in tau.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Check, Entry, Section
from gspot_verified.paper.checks.identities import Claim, Parts, rising_signs
from gspot_verified.paper.section_4.section_4_fast import fast_matrix
from gspot_verified.paper.section_4.section_4_outer import ALGEBRA, along, field
from gspot_verified.paper.section_4.section_4_outer import PRINTED as OUTER

SECTION = Section("Section 4")
_SYMBOLS = ALGEBRA.symbols
_DELTA = _SYMBOLS["delta"]
INNER_SCALE = {"t": ALGEBRA.read("delta^2*s"), "epsilon": ALGEBRA.read("delta^3")}
PRINTED: dict[str, dict[str, str]] = {
    "4-inner": {"equation": "alpha3*g0 - alpha1*s*g1 - 2*g3 + delta*((alpha3-alpha1)*g1 - alpha1*s*g2 - g4)"},
    "4-inner-fast": {"equation": "-2*f3 - f4 + delta^2*alpha1*s*(f1+f2) + delta^3*(alpha3*f0 + (alpha3-alpha1)*f1)"},
    "4-inner-fast-polynomial": {"polynomial": "-lam^3*(lam+2)"},
    "4-inner-slow": {"equation": "alpha3*g0 - alpha1*s*g1 - 2*g3"},
    "4-theta": {"equation": "h3 - tau*h1 + beta*h0", "kappa cubed": "-alpha1/2"},
    "4-inner-scaling": {
        "y": "2*g1", "y factor": "delta^2", "z": "g1", "z factor": "delta^2",
        "lambda": "-g1", "lambda factor": "delta^2",
    },
    "4-inner-scaling-v": {"v": "2*g2", "v factor": "delta^2"},
}  # fmt: skip
CORRECTED: dict[str, dict[str, str]] = {
    "4-inner-fast": {"equation": PRINTED["4-inner-fast"]["equation"].replace("+ delta^2", "- delta^2")},
    "4-inner-scaling-v": {"v factor": "delta"},
}
ALPHA_1 = "-x"
"""All the values of α_1, as x takes all positive ones: the sign of κ depends on α_1 < 0."""


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


def scaled(value: fmpq_mpoly) -> fmpq_mpoly:
    """delta^8 times an outer formula in b0, b1, ... on the inner scale."""
    images = [_DELTA ** (8 - 2 * k) * _SYMBOLS[f"g{k}"] for k in range(5)]
    return ALGEBRA.substitute(ALGEBRA.replaced(value, "b", images, _DELTA**8), INNER_SCALE)


def _fast_powers() -> list[fmpq_mpoly]:
    """b and its derivatives in fast time along the vector field of the deviations, on the inner scale."""
    return [ALGEBRA.substitute(along(_SYMBOLS[f"f{k}"], "f", False), INNER_SCALE) for k in range(5)]


def slow_rates(scales: Mapping[str, fmpq_mpoly]) -> dict[str, fmpq_mpoly]:
    """The derivation δ d/ds of the deviations on the inner scale, on z = y/2, where that of z vanishes."""
    images = {**INNER_SCALE, **scales}
    rates = {name: ALGEBRA.substitute(rate, images) for name, rate in field(False).items()}
    return {name: ALGEBRA.substitute(rate, {"z": ALGEBRA.read("y/2")}) for name, rate in rates.items()}


def _inner() -> Entry:
    this = _claim("4-inner")
    outer = ALGEBRA.read(OUTER["4-deviation"]["equation"])
    images = [_DELTA ** (4 - k) * power for k, power in enumerate(_fast_powers())]
    return SECTION.settled(
        "4-inner",
        "lines 1144 to 1146, eq:modelSysDevInner",
        r"\alpha_3^*\hat b-\alpha_1^*s\hat b'-2\hat b'''+\delta[\ldots]=0",
        "In the inner time s, t = δ² s with δ = ε^(1/3), eq. modelSysDev becomes eq. modelSysDevInner",
        this.check("chain rule in modelSysDev", lambda parts: [scaled(outer) - _DELTA**8 * parts["equation"]]),
        this.check(
            "along the vector field of the deviations, d/ds = δ^(-1) ε d/dt",
            lambda parts: [ALGEBRA.replaced(parts["equation"], "g", images, _DELTA**4)],
        ),
    )


def _inner_fast() -> Entry:
    this = _claim("4-inner-fast")
    images = [_DELTA ** (4 - k) * _SYMBOLS[f"f{k}"] for k in range(5)]
    inner = ALGEBRA.replaced(ALGEBRA.read(PRINTED["4-inner"]["equation"]), "g", images, _DELTA**4)
    return SECTION.settled(
        "4-inner-fast",
        "line 1161",
        r"-2\hat b_f'''-\hat b_f''''+\delta^2\alpha_1^*s(\hat b_f'+\hat b_f'')+\delta^3[\ldots]=0",
        "In the fast time s_f of the inner scale, ds = δ ds_f, the deviation of b satisfies the printed equation, with "
        "the term δ² α_1 s (b_f' + b_f'')",
        this.check(
            "chain rule in modelSysDevInner, times δ³",
            lambda parts: [_DELTA**3 * inner - _DELTA**4 * parts["equation"]],
            fault="the chain rule gives the term with the other sign, -δ² α_1 s (b_f' + b_f'')",
        ),
        this.check(
            "along the vector field of the deviations: s_f = t_f = t/ε",
            lambda parts: [ALGEBRA.replaced(parts["equation"], "f", _fast_powers(), ALGEBRA.constant(1))],
            fault="the motions of the system do not satisfy the printed equation",
        ),
        corrected="the term is -δ² α_1 s (b_f' + b_f'')",
        note="So it is in the fast equation of the outer scale, p = α_1 δ² s. Its limit δ → 0 is not affected.",
    )


def _inner_fast_polynomial() -> Entry:
    this = _claim("4-inner-fast-polynomial")
    p_is_0 = {"p": ALGEBRA.constant(0)}

    def exponential(parts: Parts) -> list[fmpq_mpoly]:
        equation = ALGEBRA.coefficient_of(ALGEBRA.read(CORRECTED["4-inner-fast"]["equation"]), "delta", 0)
        powers = [_SYMBOLS["lam"] ** k for k in range(5)]
        return [ALGEBRA.replaced(equation, "f", powers, ALGEBRA.constant(0)) - parts["polynomial"]]

    return SECTION.settled(
        "4-inner-fast-polynomial",
        "line 1164",
        r"-\lambda^3[\lambda+2]=0",
        "On the inner scale the fast system, in the time s_f with ds = δ ds_f, δ = ε^(1/3), has the roots 0, 0, 0, -2",
        this.check("exponentials in the fast equation at δ = 0", exponential),
        this.check(
            "determinant of λ I minus the matrix of the fast system at p = 0",
            lambda parts: [parts["polynomial"] + ALGEBRA.substitute(ALGEBRA.determinant(fast_matrix()), p_is_0)],
        ),
    )


def _inner_slow() -> Entry:
    this = _claim("4-inner-slow")

    def reduced(parts: Parts) -> list[fmpq_mpoly]:
        # b = delta^2 g0, v = delta v: then every rate has the factor delta of epsilon d/dt = delta d/ds.
        rates = slow_rates({"b0": _DELTA**2 * _SYMBOLS["g0"], "v": _DELTA * _SYMBOLS["v"]})
        images = {"s": ALGEBRA.constant(1), "g0": rates["b0"] / _DELTA**3, "y": rates["y"] / _DELTA,
                  "v": rates["v"] / _DELTA**2}  # fmt: skip
        powers = [ALGEBRA.derivative(_SYMBOLS["g0"], images, k) for k in range(4)]
        return [rates["z"], ALGEBRA.replaced(parts["equation"], "g", powers, ALGEBRA.constant(1))]

    inner = ALGEBRA.read(PRINTED["4-inner"]["equation"])
    return SECTION.settled(
        "4-inner-slow",
        "eqn:de_inner",
        r"\alpha_3^*\hat b-\alpha_1^*s\hat b'-2\hat b'''=0",
        "In the limit δ → 0 of the inner scale, once z has come to z = y/2 in the fast time s/δ, the deviation of b "
        "satisfies α_3 b - α_1 s b' - 2 b''' = 0",
        this.check(
            "eq. modelSysDevInner at δ = 0",
            lambda parts: [ALGEBRA.coefficient_of(inner, "delta", 0) - parts["equation"]],
        ),
        this.check("along the vector field of the deviations at δ = 0, where z = y/2", reduced),
    )


def _reduced(value: fmpq_mpoly, cube: fmpq_mpoly) -> fmpq_mpoly:
    """A polynomial in kappa with ``cube`` for kappa^3, and beta alpha1 for alpha3."""
    total = ALGEBRA.constant(0)
    for power, part in ALGEBRA.coefficients(value, "kappa").items():
        total += part * cube ** (power // 3) * _SYMBOLS["kappa"] ** (power % 3)
    return ALGEBRA.substitute(total, {"alpha3": ALGEBRA.read("beta*alpha1")})


def _theta() -> Entry:
    this = _claim("4-theta")
    inner = ALGEBRA.read(PRINTED["4-inner-slow"]["equation"])
    kappa, s, tau = (_SYMBOLS[name] for name in ("kappa", "s", "tau"))
    in_s = {"tau": kappa * s}
    none = ALGEBRA.constant(0)

    def chain_rule(parts: Parts) -> list[fmpq_mpoly]:
        left = ALGEBRA.replaced(inner, "g", [kappa**k * _SYMBOLS[f"h{k}"] for k in range(4)], none)
        right = ALGEBRA.substitute(parts["equation"], in_s)
        return [_reduced(left - _SYMBOLS["alpha1"] * right, parts["kappa cubed"])]

    def monomials(parts: Parts) -> list[fmpq_mpoly]:
        found = []
        for j in range(5):
            b, theta = (kappa * s) ** j, tau**j
            b_powers = [ALGEBRA.derivative(b, {"s": ALGEBRA.constant(1)}, k) for k in range(4)]
            theta_powers = [ALGEBRA.derivative(theta, {"tau": ALGEBRA.constant(1)}, k) for k in range(4)]
            left = ALGEBRA.replaced(inner, "g", b_powers, ALGEBRA.constant(1))
            right = ALGEBRA.replaced(parts["equation"], "h", theta_powers, ALGEBRA.constant(1))
            difference = left - _SYMBOLS["alpha1"] * ALGEBRA.substitute(right, in_s)
            found.append(_reduced(difference, parts["kappa cubed"]))
        return found

    def with_direction(check: Check) -> Check:
        cube = ALGEBRA.substitute(ALGEBRA.read(PRINTED["4-theta"]["kappa cubed"]), {"alpha1": ALGEBRA.read(ALPHA_1)})
        if check.agrees and not rising_signs(cube):
            return replace(check, agrees=None, finding="the sign of κ is open")
        return check

    return SECTION.settled(
        "4-theta",
        "eq:hypergeomeqn, line 1176",
        r"\theta'''-\tau\theta'+\beta\theta=0,\quad \tau=\kappa s,\ \kappa=(-\alpha_1^*/2)^{1/3}>0",
        "τ = κ s turns eq. de_inner into θ''' - τ θ' + β θ = 0 with β = α_3/α_1, α_1 not 0, and κ > 0 for α_1 < 0",
        with_direction(this.check("chain rule; the quotient of both sides is α_1; sign of κ³", chain_rule)),
        with_direction(
            this.check("both operators on 1, s, ..., s⁴, which determine an operator of order 3; sign of κ³", monomials)
        ),
    )


def _leading(name: str, order: int, factor: fmpq_mpoly, wanted: fmpq_mpoly) -> list[fmpq_mpoly]:
    """factor alpha3 x/epsilon^order = wanted + O(delta), for a recovered variable x."""
    value = factor * scaled(ALGEBRA.read(OUTER["4-deviation-recover"][name]))
    place = 8 + 3 * order
    powers = ALGEBRA.coefficients(value, "delta")
    lower = [powers[k] for k in sorted(powers) if k < place]
    return [*lower, powers.get(place, ALGEBRA.constant(0)) - wanted]


def _on_slow_system(value: fmpq_mpoly, factor: fmpq_mpoly, name: str) -> fmpq_mpoly:
    """delta^2 (value - factor alpha3 x) for a variable x, with db/ds and d²b/ds² along the slow system."""
    rates = slow_rates({})
    first = rates["b0"]
    powers = [_DELTA**2 * _SYMBOLS["g0"], _DELTA * first, ALGEBRA.derivative(first, rates)]
    variable = ALGEBRA.read({"y": "y", "z": "y/2", "lambda": "y/2 - y", "v": "v"}[name])
    return ALGEBRA.replaced(value, "g", powers, _DELTA**2) - _DELTA**2 * factor * _SYMBOLS["alpha3"] * variable


def _scaling() -> Entry:
    this = _claim("4-inner-scaling")

    def recovered(parts: Parts) -> list[fmpq_mpoly]:
        orders = {"y": 2, "z": 2, "lambda": 0}
        return [r for name, n in orders.items() for r in _leading(name, n, parts[f"{name} factor"], parts[name])]

    def reduced(parts: Parts) -> list[fmpq_mpoly]:
        return [_on_slow_system(parts[name], parts[f"{name} factor"], name) for name in ("y", "z", "lambda")]

    return SECTION.settled(
        "4-inner-scaling",
        "eq:inner_scaling (y, z, λ_N)",
        r"\delta^2\alpha_3^*\hat y/\epsilon^2=2\hat b',\ \delta^2\alpha_3^*\hat z/\epsilon^2=\hat b',\ "
        r"\delta^2\alpha_3^*\hat\lambda_N=-\hat b'",
        "On the inner scale, at leading order in δ, the deviations of y, z and λ_N, as in 4-deviation-recover, "
        "follow from that of b: δ² α_3 y/ε² = 2 b', δ² α_3 z/ε² = b' and δ² α_3 λ_N = -b'",
        this.check(
            "modelSysDevRecoverY, modelSysDevRecoverZ, modelSysDevRecoverLN with t = δ² s, ε = δ³: lowest power of δ",
            recovered,
        ),
        this.check("db/ds along the slow system of the deviations, where z = y/2", reduced),
    )


def _scaling_v() -> Entry:
    this = _claim("4-inner-scaling-v")

    return SECTION.settled(
        "4-inner-scaling-v",
        "eq:inner_scaling (v)",
        r"\delta^2\alpha_3^*\hat v/\epsilon=2\hat b''",
        "On the inner scale, at leading order in δ, the deviation of v follows from that of b: δ² α_3 v/ε = 2 b''",
        this.check(
            "modelSysDevRecoverV with t = δ² s, ε = δ³: the term of the stated order in δ",
            lambda parts: _leading("v", 1, parts["v factor"], parts["v"]),
            fault="at leading order 2 b'' is δ α_3 v/ε, and not δ² α_3 v/ε",
        ),
        this.check(
            "d²b/ds² along the slow system of the deviations, where z = y/2",
            lambda parts: [_on_slow_system(parts["v"], parts["v factor"], "v")],
            fault="along it 2 d²b/ds² is δ α_3 v/ε, with one factor δ",
        ),
        corrected="δ α_3 v/ε = 2 b'': the factor is δ, not δ²",
        note="With δ² the size of v would be ε^((2β+1)/3), against the paper's own ε^((2β+2)/3) in line 1237.",
    )


ENTRIES: Builders = {
    "4-inner": _inner,
    "4-inner-fast": _inner_fast,
    "4-inner-fast-polynomial": _inner_fast_polynomial,
    "4-inner-slow": _inner_slow,
    "4-theta": _theta,
    "4-inner-scaling": _scaling,
    "4-inner-scaling-v": _scaling_v,
}
"""The inner scale, in the order of the paper."""
