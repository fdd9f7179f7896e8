"""Ledger of Section 5: the inner scale of a general system and the steps of Theorem 1's recursion.

b, y, v, z, l, r, w, q with a number are b_n, y_n, v_n, z_n, lambda_n, r_{b,n}, r_{v,n}, z_{n-1} and derivatives in s.
S is a sum over products of the terms of two series, which has its own formulas (see ``convolution``).
"""

from __future__ import annotations

from flint import fmpq, fmpq_mpoly

from gspot_verified.paper.checks.convolution import NAMES, all_pairs, product_of_geometric_series
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts
from gspot_verified.paper.section_2.extended_system import extended_terms
from gspot_verified.paper.section_5.double_series import example_series, scaled_series

SECTION = Section("Section 5, Theorem 1")
ALGEBRA = Algebra(
    "alpha1 alpha3 delta epsilon s n k chi u0 u3 b0 b1 b2 b3 r0 r1 r2 w0 q0 q1 q2 q3 l0 l1 l2 y0 y1 y2 y3 v0 v1 z0 z1 "
    "xi1 f g lam a1 a2 a3 p p1 b y v z pd bd yd vd zd xd a1n a2n fn S m0 P B Y V"
)
_SYMBOLS = ALGEBRA.symbols
SCALING = {"xi": 2, "p": 2, "b": 2, "y": 6, "v": 4, "z": 6}
"""Lines 1385 to 1390: the powers of delta in front of the scaled variables."""
GENERAL = {
    "specialX": ("xd - (f + g*lam)", 0), "specialPP": ("pd - a1", 0), "specialB": ("bd - (a2 - a3*lam)", 0),
    "specialY": ("yd - v", 4), "specialV": ("vd - (b + p*lam)", 2), "specialZ": ("epsilon*zd + z + epsilon^2*lam", 6),
    "specialL": ("epsilon^2*lam - (z - y)", 6),
}  # fmt: skip
"""Eqs. genSysXi to genSysLN, and the power of delta that each has more than its scaled form."""
SYNCHRONISED = {"P": "P - p", "B": "B - b", "Y": "Y - y", "V": "V - v"}
"""Eq. genSysSynch: the functions of the state, and the variables, at one time."""
PRINTED: dict[str, dict[str, str]] = {
    "5-inner-system": {
        "specialX": "xi1 - (f + g*lam)", "specialPP": "p1 - a1", "specialB": "b1 - (a2 - a3*lam)",
        "specialY": "y1 - v0", "specialV": "v1 - (b0 + p*lam)",
        "specialZ": "delta*z1 + z0 + lam", "specialL": "lam - (z0 - y0)",
    },
    "5-scaled-start": {"P": "P - delta^2*p", "B": "B - delta^2*b", "Y": "Y - delta^6*y", "V": "V - delta^4*v"},
    "5-orders": {
        "P": "p1", "r_p": "a1n",
        "B": "b1 + alpha3*l0", "r_b": "a2n - S", "Y": "y1 - v0", "V": "v1 - b0 - alpha1*s*l0", "r_v": "S",
        "Z": "-z0 - l0", "r_z": "q1", "L": "l0 - z0 + y0", "p_0": "alpha1*s",
        "b left": "n - k", "b right": "k", "b first": "0*k", "b last": "n - 1",
        "v left": "n - k", "v right": "k", "v first": "0*k", "v last": "n - 1",
    },
    "5-third-order": {
        "specialYnbis": "alpha3*y2 - alpha3*b0 + alpha1*s*b1 - (alpha1*s*r0 + alpha3*w0)",
        "line 1667": "alpha3*y0 - 2*b1 - (-alpha3*q1 - 2*r0)",
        "third-order_b": "2*b3 + alpha1*s*b1 - alpha3*b0 - (2*r2 + alpha3*q3 + alpha1*s*r0 + alpha3*w0)",
    },
    "5-monomial": {"image": "(k*alpha1 - alpha3)*u3 + k*(k-1)*(k-2)*u0"},
    "5-step-3": {
        "y": "2*(b1-r0) - alpha3*q1", "v": "2*(b2-r1) - alpha3*q2", "lambda": "r0 - b1", "z": "b1 - r0 - alpha3*q1",
    },
    "5-xinprime": {"right side": "fn + S", "left": "n - k", "right": "n", "first": "0*k", "last": "n"},
}  # fmt: skip
CORRECTED: dict[str, dict[str, str]] = {
    "5-monomial": {"image": "(k*alpha1 - alpha3)*u3 + 2*k*(k-1)*(k-2)*u0"},
    "5-xinprime": {"right": "k"},
}


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


def _d(value: fmpq_mpoly, times: int = 1) -> fmpq_mpoly:
    return ALGEBRA.derivative(value, ALGEBRA.jets("s", "b", "r", "q", "l", "y", "v", "z"), times)


def _inner_system() -> Entry:
    this = _claim("5-inner-system")
    # d/dt is delta^(-2) d/ds.
    texts = {name: f"delta^{power}*{name}{'' if name == 'p' else 0}" for name, power in SCALING.items() if name != "xi"}
    texts |= {f"{name[0]}d": f"delta^{power - 2}*{name}1" for name, power in SCALING.items()} | {"epsilon": "delta^3"}
    images = {name: ALGEBRA.read(text) for name, text in texts.items()}

    def chain_rule(parts: Parts) -> list[fmpq_mpoly]:
        return [
            ALGEBRA.substitute(ALGEBRA.read(text), images) - _SYMBOLS["delta"] ** power * parts[name]
            for name, (text, power) in GENERAL.items()
        ]

    def example(parts: Parts) -> list[fmpq_mpoly]:
        # alpha = (-1 + chi b, -1, -3/2), b = delta^2 b~; the component of xi~ that is v has F = b, G = p.
        orders = 7
        series = {name: scaled_series(ALGEBRA, name, orders) for name in ("p", "b", "y", "v", "z", "lam")}
        values = {f"{name}{k}": value.derivative("s") if k else value for name, value in series.items() for k in (0, 1)}
        values |= {"p": series["p"], "lam": series["lam"]}
        values |= {"xi1": values["v1"], "f": values["b0"], "g": values["p"]}
        values |= {"a1": ALGEBRA.read("chi*delta^2") * values["b0"] - 1}
        values |= {"a2": ALGEBRA.constant(-1), "a3": ALGEBRA.constant(fmpq(-3, 2))}
        values = {name: value for name, value in values.items() if name in _SYMBOLS}
        rests = [ALGEBRA.coefficients(ALGEBRA.substitute(part, values), "delta") for part in parts.values()]
        return [value for rest in rests for power, value in rest.items() if power < orders - 1] or [ALGEBRA.constant(0)]

    return SECTION.settled(
        "5-inner-system",
        "eqs. genSysXi to genSysLN, lines 1384 to 1391, eqs. specialX to specialL",
        r"\tilde\xi'=F+G\lambda_N,\ldots,\ \delta\tilde z'=-\tilde z-\lambda_N,\ \lambda_N=\tilde z-\tilde y",
        "The scaled variables turn genSysXi to genSysLN into specialX to specialL",
        this.check("the scaled variables put into genSysXi to genSysLN", chain_rule),
        this.check(
            "the extended example through δ⁵, from its series in (t, ε) without the scaling", example, Rung.POINTS
        ),
    )


def at_the_start(name: str, orders: int) -> fmpq_mpoly:
    """A variable of the extended example at t = 0, as a series in δ, ε = δ³, by its series in (t, ε): not scaled."""
    total, delta, chi = ALGEBRA.constant(0), _SYMBOLS["delta"], _SYMBOLS["chi"]
    for (i, j), value in example_series(orders)[name].items():
        if i == 0:
            total += sum((a * chi**k for k, a in enumerate(value.coeffs())), start=ALGEBRA.constant(0)) * delta ** (
                3 * j
            )
    return total


def _scaled_start() -> Entry:
    this = _claim("5-scaled-start")

    def put_in(parts: Parts) -> list[fmpq_mpoly]:
        scaled = {name: ALGEBRA.read(f"delta^{power}*{name}") for name, power in SCALING.items() if name != "xi"}
        return [ALGEBRA.substitute(ALGEBRA.read(SYNCHRONISED[name]), scaled) - part for name, part in parts.items()]

    def example(parts: Parts) -> list[fmpq_mpoly]:
        orders = 9
        terms = extended_terms(orders, chi=True)
        found = []
        for name, part in parts.items():
            rows = enumerate(terms[name.lower()])
            scaled = (ALGEBRA.bring(row[0]) * _SYMBOLS["delta"] ** n for n, row in rows if row)
            images = {name: at_the_start(name.lower(), orders)}
            images[name.lower()] = sum(scaled, start=ALGEBRA.constant(0))
            rests = ALGEBRA.coefficients(ALGEBRA.substitute(part, images), "delta")
            found += [value for power, value in rests.items() if power < orders]
        return found or [ALGEBRA.constant(0)]

    return SECTION.settled(
        "5-scaled-start",
        "eq. genSysSynch, eqs. specialInitialFirst to specialInitialFourth",
        r"\mathcal P(\xi^*+\delta^2\tilde\xi)-\delta^2\tilde p=0,\ \ldots,\ "
        r"\mathcal V(\xi^*+\delta^2\tilde\xi)-\delta^4\tilde v=0",
        "The synchronisation of p, b, y, v at s = 0 becomes, in the scaled variables and for all δ, "
        "specialInitialFirst to specialInitialFourth",
        this.check("the scaled variables put into genSysSynch", put_in),
        this.check(
            "the extended example at s = 0 through δ⁸: its series in (t, ε), and the terms of Theorem 1's recursion",
            example,
            Rung.POINTS,
        ),
        note="At points p(0) is 0, and so 0 = 0 stands for it: that p has δ² is shown by the first check alone.",
    )


def _sum(parts: Parts, prefix: str = "") -> dict[str, fmpq_mpoly]:
    return {name: parts[prefix + name] for name in NAMES}


def terms_of_the_example(orders: int) -> dict[str, list[fmpq_mpoly]]:
    """The terms p_n, b_n, ..., λ_n of the extended example, of its series in (t, ε): not scaled."""
    return {
        name: [ALGEBRA.coefficient_of(scaled_series(ALGEBRA, name, orders), "delta", n) for n in range(orders)]
        for name in ("p", "b", "y", "v", "z", "lam")
    }


def summed(of: Parts, left: list[fmpq_mpoly], right: list[fmpq_mpoly], n: int) -> fmpq_mpoly | None:
    """The sum over the printed indices; ``None`` where they are none."""
    nothing, at = ALGEBRA.constant(0), {"n": ALGEBRA.constant(n)}
    total = nothing
    ends = [_integer(ALGEBRA.substitute(of[end], at)) for end in ("first", "last")]
    if ends[0] is None or ends[1] is None:
        return None
    for k in range(ends[0], ends[1] + 1):
        here = at | {"k": ALGEBRA.constant(k)}
        i, j = (_integer(ALGEBRA.substitute(of[side], here)) for side in ("left", "right"))
        if i is None or j is None or i >= len(left) or j >= len(right):
            return None
        total += left[i] * right[j] if min(i, j) >= 0 else nothing
    return total


def orders_of_the_example(parts: Parts, orders: int = 11) -> list[fmpq_mpoly]:
    """The printed terms of order δ^n, with those of the extended example: of its series in (t, ε), not scaled.

    α_1 = -1 + χ b with b = δ² b~, α_2 = -1 and α_3 = -3/2, so that (α_1)_n is χ b_(n-2) for n > 0.
    """
    nothing = [ALGEBRA.constant(0)] * orders
    terms = terms_of_the_example(orders)
    chi = _SYMBOLS["chi"]
    a1 = [ALGEBRA.constant(-1), nothing[0], *(chi * value for value in terms["b"][: orders - 2])]
    a2, a3 = ([ALGEBRA.constant(value), *nothing[1:]] for value in (fmpq(-1), fmpq(-3, 2)))
    found = [ALGEBRA.substitute(parts["p_0"], {"alpha1": a1[0]}) - terms["p"][0]]
    for n in range(orders):
        images = {"alpha1": a1[0], "alpha3": a3[0], "a1n": a1[n], "a2n": a2[n], "l0": terms["lam"][n]}
        images |= {f"{name}0": terms[name][n] for name in "byvz"}
        images |= {f"{name}1": terms[name][n].derivative("s") for name in "pbyv"}
        images |= {"q1": terms["z"][n - 1].derivative("s") if n else nothing[0], "n": ALGEBRA.constant(n)}
        for left, right, of in (
            ("P", "r_p", None), ("B", "r_b", ("b ", a3)), ("Y", "", None), ("V", "r_v", ("v ", terms["p"])),
            ("Z", "r_z", None), ("L", "", None),
        ):  # fmt: skip
            total = summed(_sum(parts, of[0]), of[1], terms["lam"], n) if of else nothing[0]
            if total is None:
                return [ALGEBRA.constant(1)]
            line = parts[left] - (parts[right] if right else nothing[0])
            found.append(ALGEBRA.substitute(line, images | {"S": total}))
    return found


def rates_of_the_example(parts: Parts, orders: int = 11) -> list[fmpq_mpoly]:
    """Eq. xinprime, with the terms of the extended example: of its series in (t, ε), not scaled.

    The components b and v of its state have F = α_2 = -1, G = -α_3 = 3/2, and F = b, G = p. A component f of the state
    has f_n in δ² f_(n-2)~, as b and p have it: b~ and p~; that of v has δ² v~, two orders later.
    """
    nothing = [ALGEBRA.constant(0)] * orders
    terms = terms_of_the_example(orders)
    later = {name: [*nothing[:2], *terms[name]][:orders] for name in "pbv"}
    drift, push = ([ALGEBRA.constant(value), *nothing[1:]] for value in (fmpq(-1), fmpq(3, 2)))
    found = []
    for component, f, g in ((terms["b"], drift, push), (later["v"], later["b"], later["p"])):
        for n in range(orders):
            total = summed(parts, g, terms["lam"], n)
            if total is None:
                return [ALGEBRA.constant(1)]
            right = ALGEBRA.substitute(parts["right side"], {"fn": f[n], "S": total})
            found.append(component[n].derivative("s") - right)
    return found


def _integer(value: fmpq_mpoly) -> int | None:
    """The integer that the formula is; ``None`` where it is none."""
    if value.is_zero():
        return 0
    if not value.is_constant() or value.leading_coefficient().q != 1:
        return None
    return int(value.leading_coefficient().p)


def _orders() -> Entry:
    this = _claim("5-orders")
    scaled = {name: ALGEBRA.read(text) for name, text in PRINTED["5-inner-system"].items()}

    def at_order_n(name: str, **texts: str) -> fmpq_mpoly:
        """The order n of an equation: each factor that is a sum of products is replaced by what it gives."""
        return ALGEBRA.substitute(scaled[name], {key: ALGEBRA.read(text) for key, text in texts.items()})

    def linear(parts: Parts) -> list[fmpq_mpoly]:
        # Orders n - 1 (q, m) and n (z, l) as coefficients of delta^0 and delta^1. alpha3_0 = alpha3, p_0 = alpha1 s.
        of_z = at_order_n("specialZ", z0="q0 + delta*z0", z1="q1 + delta*z1", lam="m0 + delta*l0")
        of_z = ALGEBRA.coefficient_of(of_z, "delta", 1)
        of_b = at_order_n("specialB", a2="a2n", a3="1+0*s", lam="alpha3*l0 + S")
        of_v = at_order_n("specialV", p="1+0*s", lam="alpha1*s*l0 + S")
        return [
            parts["P"] - parts["r_p"] - at_order_n("specialPP", a1="a1n"),
            parts["B"] - parts["r_b"] - of_b,
            parts["V"] - parts["r_v"] - of_v,
            parts["Z"] - parts["r_z"] + of_z,
            parts["Y"] - scaled["specialY"],
            parts["L"] - at_order_n("specialL", lam="l0"),
            ALGEBRA.substitute(scaled["specialPP"], {"p1": parts["p_0"].derivative("s"), "a1": _SYMBOLS["alpha1"]}),
            ALGEBRA.coefficient_of(parts["p_0"], "s", 0),
        ]

    def pairs(parts: Parts) -> list[fmpq_mpoly]:
        return [*linear(parts), *(v for x in ("b ", "v ") for v in all_pairs(ALGEBRA, _sum(parts, x), 1))]

    def geometric(parts: Parts) -> list[fmpq_mpoly]:
        sums = (product_of_geometric_series(ALGEBRA, _sum(parts, x), 1) for x in ("b ", "v "))
        return [*linear(parts), *(value for found in sums for value in found)]

    return SECTION.settled(
        "5-orders",
        "eqs. p_nprime, specialBn, specialYn, specialVn, specialZn, specialLn; line 1611",
        r"r_{b,n}={\alpha_2}_n-\sum_{k=0}^{n-1}{\alpha_3}_{n-k}\lambda_k,\ r_{v,n}=\sum_{k=0}^{n-1}p_{n-k}\lambda_k",
        "The terms of order δ^n of specialPP to specialL are p_nprime, specialBn, specialYn, specialVn, specialZn and "
        "specialLn, for every n, and p_0 is α_1* s",
        this.check("term by term; the sums have each pair of orders with the sum n once, for every n", pairs),
        this.check("term by term; the sums for geometric series x^i, y^j, with x^n and y^n as symbols", geometric),
        this.check(
            "the extended example, every order below 11: the terms of its series in (t, ε), without the scaling",
            orders_of_the_example,
            Rung.POINTS,
        ),
        note="The term k = n of each product stands on the left: α_3* λ_n and p_0 λ_n = α_1* s λ_n. z_(-1) = 0 "
        "is said in line 1648 alone: line 1534 is about functions of ξ.",
    )


def _equations() -> dict[str, fmpq_mpoly]:
    """SpecialBn to specialLn, left minus right."""
    printed = PRINTED["5-orders"]
    right = {"B": "r0", "V": "w0", "Z": printed["r_z"]}
    return {name: ALGEBRA.read(f"{printed[name]} - ({right.get(name, '0*s')})") for name in "BYVZL"}


def _general_solution(value: fmpq_mpoly) -> fmpq_mpoly:
    """All solutions of specialBn to specialLn: b, lambda and z_(n-1) are free, the rest follows."""
    images = {f"r{k}": ALGEBRA.read(f"b{k + 1}") + ALGEBRA.read(f"alpha3*l{k}") for k in range(3)}
    images |= {f"y{k}": ALGEBRA.read(f"-2*l{k} - q{k + 1}") for k in range(3)}
    images |= {f"v{k}": images[f"y{k + 1}"] for k in range(2)}
    images["z0"] = ALGEBRA.read("-l0 - q1")
    images["w0"] = images["v1"] - ALGEBRA.read("b0 + alpha1*s*l0")
    return ALGEBRA.substitute(value, images)


def _third_order() -> Entry:
    this = _claim("5-third-order")

    def combined(parts: Parts) -> list[fmpq_mpoly]:
        e, a1s, a3 = _equations(), ALGEBRA.read("alpha1*s"), _SYMBOLS["alpha3"]
        second = a3 * (_d(e["Y"]) + e["V"]) + a1s * e["B"]
        first = a3 * (e["L"] - e["Z"]) - 2 * e["B"]
        third = second - _d(first, 2)
        return [parts["specialYnbis"] - second, parts["line 1667"] - first, parts["third-order_b"] - third]

    return SECTION.settled(
        "5-third-order",
        "eqs. specialYnbis, third-order_b, line 1667",
        r"2b_n'''+\alpha_1^*sb_n'-\alpha_3^*b_n=2r_{b,n}''+\alpha_3^*z_{n-1}'''+\alpha_1^*sr_{b,n}+\alpha_3^*r_{v,n}",
        "The elimination of y_n, v_n, z_n and λ_n from specialBn to specialLn gives specialYnbis, the equation of line "
        "1667 and third-order_b",
        this.check("each equation as a combination of specialBn to specialLn and their derivatives", combined),
        this.check(
            "the general solution of specialBn to specialLn (b_n, λ_n, z_(n-1) free) put in",
            lambda parts: [_general_solution(value) for value in parts.values()],
        ),
    )


def _monomial() -> Entry:
    this = _claim("5-monomial")
    s = _SYMBOLS["s"]
    known = {name: ALGEBRA.constant(0) for name in ("r0", "r2", "q3", "w0")}
    operator = ALGEBRA.substitute(ALGEBRA.read(PRINTED["5-third-order"]["third-order_b"]), known)

    def explicit(parts: Parts) -> list[fmpq_mpoly]:
        # Both sides have degree at most 6 in k, so seven values of k determine them (at k = 0 both powers of s are 1).
        powers_of_k = ALGEBRA.coefficients(parts["image"], "k")
        found = [value for power, value in powers_of_k.items() if power > 6]
        for k in range(1, 8):
            powers = [ALGEBRA.derivative(s**k, {"s": ALGEBRA.constant(1)}, j) for j in range(4)]
            images = {"k": ALGEBRA.constant(k), "u3": s**k, "u0": s ** max(k - 3, 0)}
            found.append(ALGEBRA.replaced(operator, "b", powers, s) - ALGEBRA.substitute(parts["image"], images))
        return found

    def symbolic(parts: Parts) -> list[fmpq_mpoly]:
        # u0 = s^(k-3); each derivative lowers the exponent by one and brings it down as a factor.
        power, factor, values = 3, ALGEBRA.constant(1), []
        for j in range(4):
            values.append(factor * s ** (power - j) * _SYMBOLS["u0"])
            factor = factor * (_SYMBOLS["k"] - j)
        image = ALGEBRA.substitute(parts["image"], {"u3": s**3 * _SYMBOLS["u0"]})
        return [ALGEBRA.replaced(operator, "b", values, s) - image]

    return SECTION.settled(
        "5-monomial",
        "line 1691",
        r"(k\alpha_1^*-\alpha_3^*)s^k+k(k-1)(k-2)s^{k-3}",
        "For b_n = s^k the left-hand side of third-order_b is (k α_1 - α_3) s^k + k (k-1) (k-2) s^(k-3)",
        this.check(
            "s^k for k = 1, ..., 7; both sides have degree at most 6 in k",
            explicit,
            fault="the term with s^(k-3) has half its value: for k = 3 it is 12, not 6",
        ),
        this.check("s^k with k as a symbol", symbolic, fault="the term with s^(k-3) is 2 k (k-1) (k-2) s^(k-3)"),
        corrected="(k α_1 - α_3) s^k + 2k(k-1)(k-2) s^(k-3): the factor 2 of 2 b_n''' is missing",
        note="The coefficient of s^k is right, and with it the conclusion: it is not 0 for α_1 not 0 and β not an "
        "integer.",
    )


def _step_3() -> Entry:
    this = _claim("5-step-3")
    names = {"y": "y0", "v": "v0", "lambda": "l0", "z": "z0"}

    def solved(parts: Parts) -> list[fmpq_mpoly]:
        return [_general_solution(ALGEBRA.read(f"alpha3*{symbol}") - parts[name]) for name, symbol in names.items()]

    def equations(parts: Parts) -> list[fmpq_mpoly]:
        y, v, force, z = (parts[name] for name in names)
        a3 = _SYMBOLS["alpha3"]
        slope = _d(v) - a3 * _SYMBOLS["b0"] - ALGEBRA.read("alpha1*s") * force - a3 * _SYMBOLS["w0"]
        return [
            ALGEBRA.read("b1 - r0") + force,
            _d(y) - v,
            slope - ALGEBRA.read(PRINTED["5-third-order"]["third-order_b"]),
            z + force + ALGEBRA.read("alpha3*q1"),
            force - z + y,
        ]

    return SECTION.settled(
        "5-step-3",
        "lines 1704 to 1707",
        r"\alpha_3^*y_n=2(b_n'-r_{b,n})-\alpha_3^*z_{n-1}',\ \ldots,\ \alpha_3^*\lambda_n=r_{b,n}-b_n',\ \ldots",
        "For α_3* not 0 the four formulas recover y_n, v_n, λ_n, z_n from a b_n that satisfies third-order_b",
        this.check("on the general solution of specialBn to specialLn", solved),
        this.check("put into specialBn to specialLn, modulo third-order_b", equations),
    )


def _xinprime() -> Entry:
    this = _claim("5-xinprime")

    def right_side(parts: Parts) -> list[fmpq_mpoly]:
        scaled = ALGEBRA.read(PRINTED["5-inner-system"]["specialX"])
        images = {"f": ALGEBRA.read("fn"), "g": ALGEBRA.constant(1), "lam": _SYMBOLS["S"]}
        return [ALGEBRA.substitute(scaled, images) - (_SYMBOLS["xi1"] - parts["right side"])]

    return SECTION.settled(
        "5-xinprime",
        "eq:xinprime",
        r"\xi_n'=F_n+\sum_{k=0}^nG_{n-k}\lambda_n",
        "The term of order δ^n of specialX is ξ_n' = F_n + Σ G_(n-k) λ_n, the sum over k from 0 to n, for every n",
        this.check(
            "the sum has each pair of orders with the sum n once, for every n",
            lambda parts: [*right_side(parts), *all_pairs(ALGEBRA, _sum(parts), 0)],
            fault="the orders n-k of G and n of λ_N have the sum n only for k = n",
        ),
        this.check(
            "the sum for geometric series x^i, y^j is the coefficient of δ^n in their product, for every n",
            lambda parts: [*right_side(parts), *product_of_geometric_series(ALGEBRA, _sum(parts), 0)],
            fault="with λ_n in place of λ_k it is not",
        ),
        this.check(
            "the components b and v of the extended example, every order below 11: the terms of its series in (t, ε), "
            "without the scaling",
            rates_of_the_example,
            Rung.POINTS,
            fault="with λ_n in place of λ_k it is not satisfied",
        ),
        corrected="ξ_n' = F_n + Σ_{k=0}^n G_(n-k) λ_k: the index of λ is k",
        note="The orders of G and λ_N must have the sum n.",
    )


ENTRIES: Builders = {
    "5-inner-system": _inner_system, "5-scaled-start": _scaled_start, "5-orders": _orders,
    "5-third-order": _third_order,
    "5-monomial": _monomial, "5-step-3": _step_3, "5-xinprime": _xinprime,
}  # fmt: skip
"""The inner scale and the recursion, in the order of the paper."""
