"""Ledger of Section 2: sentences on the constraint, the contact and the extended example, held against its formulas.

lp, lm: the forward and the backward force, lp = c λ_N, lm = (1 - c) λ_N; q is p⁻; x5 is p; d is positive; D = AC - B².
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.formulas import mended
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts, rising_signs
from gspot_verified.paper.section_2 import lagrangian

SECTION = Section("Section 2")
ALGEBRA = Algebra("x u p b y v z alpha1 alpha2 alpha3 chi a c lam lp lm kplus kminus q x5 k2 d A B C D mu lamT")
_SYMBOLS = ALGEBRA.symbols
ALLOWED: dict[str, Callable[[int, int], bool]] = {"printed": operator.gt, "corrected": operator.ge}
"""y > 0, and y >= 0."""
G_SPOT, SURFACE = {"y": 0, "v": 0}, {"y": 0}
"""Line 502; line 508."""
SHARES = {"lp": "c*lam", "lm": "(1 - c)*lam"}
"""lambda+."""
EDGES = {"lp": "-mu", "lm": "mu"}
"""λ_T over the normal part in forward and in backward slip (Coulomb): the edges of the cone of friction."""
PART = {"part": "alpha3*lp"}
PART_CORRECTED = {"part": "-alpha3*lp"}
EXTENDED = {
    "x": "u", "u": "a + kplus*lp + kminus*lm",
    "p": "alpha1 + chi*b", "b": "alpha2 - c*alpha3*lam", "y": "v", "v": "b + p*c*lam + q*(1 - c)*lam",
    "z": "-z - (z - y)",
}  # fmt: skip
"""xdot, udot, newex1 to newex5: the rates, that of z times ε; ε² λ_N = z - y."""
MOTIVATING = {"p": "alpha1", "b": "alpha2 - alpha3*lam", "y": "v", "v": "b + p*lam", "z": "-z - (z - y)"}
"""modelsys1 to modelsys5, as EXTENDED."""
REPLACED = {"b": ("alpha3*lam", "alpha3*lp"), "v": ("p*lam", "p*lp + q*lm")}
"""Lines 640 to 646: the term of modelsys2 and of modelsys4, and what takes its place."""
FIRST = "alpha1 + chi*b"
"""Line 663: what takes the place of α_1*."""
NORMAL = "pbyvz"
TANGENTIAL = "xu"
FORCE = "k2*(z - y)"
"""compliant2 for y < z."""
OTHER = {"p^-": "C + mu*B", "k^+": "B - mu*A", "k^-": "B + mu*A"}
"""dv/dt and du/dt for each unit of λ_N: in negative slip, in positive, in negative slip."""


def holds_at_the_g_spot(form: str) -> bool | None:
    """Whether the constraint allows the G-spot."""
    return ALLOWED[form](G_SPOT["y"], 0)


def holds_in_contact(form: str) -> bool | None:
    """Whether it allows the rigid contact."""
    return ALLOWED[form](SURFACE["y"], 0)


def _unilateral() -> Entry:
    forms = ("printed", "corrected")
    return SECTION.settled(
        "2-unilateral",
        "lines 431 to 435",
        "y>0",
        "The unilateral constraint is y > 0",
        Rung.EXACT.check(
            "line 502: y = 0 at a G-spot", mended(*map(holds_at_the_g_spot, forms)), "y > 0 leaves out every G-spot"
        ),
        Rung.EXACT.check(
            "line 508: contact is y = 0", mended(*map(holds_in_contact, forms)), "y > 0 leaves out every contact"
        ),
        corrected="y >= 0",
    )


def shares_make_the_force() -> bool | None:
    """Whether the shares have the sum λ_N, and λ_T falls with c from that of backward slip to that of forward slip."""
    shares, edges = ({name: ALGEBRA.read(text) for name, text in texts.items()} for texts in (SHARES, EDGES))
    tangential = sum((edges[name] * shares[name] for name in shares), start=ALGEBRA.constant(0))
    ends = [
        ALGEBRA.substitute(tangential, {"c": ALGEBRA.constant(share)}) - edges[name] * _SYMBOLS["lam"]
        for name, share in (("lp", 1), ("lm", 0))
    ]
    whole = sum(shares.values(), start=-_SYMBOLS["lam"])
    slope = tangential.derivative("c")
    steady = slope.derivative("c").is_zero() and rising_signs(-slope)
    return whole.is_zero() and all(end.is_zero() for end in ends) and steady


def cone_is_spanned() -> bool | None:
    """Whether λ⁺ + λ⁻ = λ_N with λ_T from the edges has one solution, by Cramer's rule, positive within the cone.

    2 μ λ⁺ is d for λ_T = μ λ_N - d and 2 μ λ⁻ is d for λ_T = d - μ λ_N: 0 at the edge of the other force.
    """
    edges = {name: ALGEBRA.read(text) for name, text in EDGES.items()}
    one, bound = ALGEBRA.constant(1), ALGEBRA.read("mu*lam")
    force = {"1": _SYMBOLS["lam"], "edge": _SYMBOLS["lamT"]}
    determinant = ALGEBRA.determinant([[one, one], [edges["lp"], edges["lm"]]])
    numerators = {
        "lp": ALGEBRA.determinant([[force["1"], one], [force["edge"], edges["lm"]]]),
        "lm": ALGEBRA.determinant([[one, force["1"]], [edges["lp"], force["edge"]]]),
    }
    within = {"lp": bound - _SYMBOLS["d"], "lm": _SYMBOLS["d"] - bound}
    found = [ALGEBRA.substitute(numerators[name], {"lamT": within[name]}) - _SYMBOLS["d"] for name in EDGES]
    return rising_signs(determinant) and all(value.is_zero() for value in found)


def _two_forces() -> Entry:
    return SECTION.settled(
        "2-two-forces",
        "lines 626 to 637",
        r"\lambda^+=c\lambda_N,\ \lambda^-=(1-c)\lambda_N:\quad\lambda_T=-\mu\lambda^++\mu\lambda^-",
        "A contact force of the cone of friction, |λ_T| <= μ λ_N with μ > 0 and λ_N > 0, is in exactly one way the sum "
        "of a force of positive slip, with the normal part c λ_N, and one of negative slip, with (1 - c) λ_N: c is 1 "
        "in positive slip, 0 in negative slip, and between them where |λ_T| < μ λ_N",
        Rung.EXACT.check(
            "eq. lambda+: the normal parts have the sum λ_N, and λ_T falls with c from μ λ_N at 0 to -μ λ_N at 1",
            shares_make_the_force(),
        ),
        Rung.EXACT.check(
            "Cramer's rule for the two normal parts: 2 μ λ⁺ = μ λ_N - λ_T and 2 μ λ⁻ = μ λ_N + λ_T", cone_is_spanned()
        ),
        note="The value of c in stick: 2-stick.",
    )


def _contact_part() -> Entry:
    this = Claim(ALGEBRA, PART, PART_CORRECTED)

    def by_the_equation(parts: Parts) -> list[fmpq_mpoly]:
        rate = ALGEBRA.read(EXTENDED["b"])
        free = ALGEBRA.substitute(rate, {"lam": ALGEBRA.constant(0)})
        forward = {"lp": _SYMBOLS["c"] * _SYMBOLS["lam"]}
        return [rate - free - ALGEBRA.substitute(parts["part"], forward)]

    def by_the_fields(parts: Parts) -> list[fmpq_mpoly]:
        # λ_N = lp + lm, λ_T = -μ (lp - lm); G_T is H/(2 μ).
        fields = lagrangian.PRINTED["2-extended"]
        forces = ALGEBRA.read(fields["N6"]) * ALGEBRA.read("lp + lm") - ALGEBRA.read(f"({fields['H6']})*(lp - lm)/2")
        same = ALGEBRA.read(fields["mu"]) - ALGEBRA.read("1 - x5")
        return [forces - parts["part"], same]

    return SECTION.settled(
        "2-contact-part",
        "lines 643 to 646",
        r"\text{the contact-dependent part of }\dot b\text{ is }\alpha_3^*\lambda^+",
        "The part of db/dt that depends on contact is α_3* λ⁺ in the extended example",
        this.check(
            "eq. newex2 less its value without contact, λ⁺ = c λ_N",
            by_the_equation,
            fault="the part is -α_3* λ⁺: the printed sign is the other one",
        ),
        this.check(
            "the sixth components of the printed G_T and G_N, in forward and backward slip",
            by_the_fields,
            fault="their contribution to db/dt is -α_3* λ⁺",
        ),
        corrected="The part is -α_3* λ⁺",
    )


def by_replacing(parts: Parts) -> list[fmpq_mpoly]:
    """modelsys1 to modelsys5 with the printed terms replaced."""
    shares = {name: ALGEBRA.read(text) for name, text in SHARES.items()}
    found = []
    for name in NORMAL:
        rate = ALGEBRA.substitute(ALGEBRA.read(MOTIVATING[name]), {"alpha1": ALGEBRA.read(FIRST)})
        if name in REPLACED:
            old, new = (ALGEBRA.read(term) for term in REPLACED[name])
            free = ALGEBRA.substitute(rate, {"lam": ALGEBRA.constant(0)})
            sign = 1 if rate - free == old else -1
            found.append(rate - free - sign * old)
            rate = free + sign * ALGEBRA.substitute(new, shares)
        found.append(rate - parts[name])
    return found


def by_the_two_slips(parts: Parts) -> list[fmpq_mpoly]:
    """All are affine in c; at c = 1 those of the first example, with χ b in the rate of p.

    At c = 0 they are the same but for the forces: none in the rate of b, and p⁻ λ_N in that of v.
    """
    first = {name: ALGEBRA.read(MOTIVATING[name]) for name in NORMAL}
    first["p"] += _SYMBOLS["chi"] * _SYMBOLS["b"]
    backwards = {**first, "b": _SYMBOLS["alpha2"], "v": ALGEBRA.read("b + q*lam")}
    found = [parts[name].derivative("c").derivative("c") for name in NORMAL]
    for share, wanted in ((1, first), (0, backwards)):
        at_share = {"c": ALGEBRA.constant(share)}
        found += [ALGEBRA.substitute(parts[name], at_share) - value for name, value in wanted.items()]
    return found


def _extended_equations() -> Entry:
    this = Claim(ALGEBRA, EXTENDED)
    return SECTION.settled(
        "2-extended-equations",
        "eqs. newex1 to newex5, lines 639 to 678",
        r"\dot p=\alpha_1^*+\chi b,\ \dot b=\alpha_2^*-c\alpha_3^*\lambda_N,\ \dot y=v,\ "
        r"\dot v=b+pc\lambda_N+p^-(1-c)\lambda_N,\ \epsilon\dot z=-z-\epsilon^2\lambda_N",
        "With α_1* + χ b for α_1*, α_3* λ⁺ for α_3* λ_N and p λ⁺ + p⁻ λ⁻ for p λ_N, where λ⁺ = c λ_N and "
        "λ⁻ = (1 - c) λ_N, eqs. modelsys1 to modelsys5 are eqs. newex1 to newex5; so the part of dv/dt that depends on "
        "contact is p λ⁺ + p⁻ λ⁻",
        this.check("the terms of modelsys1 to modelsys5 replaced, for every c", by_replacing),
        this.check("affine in c, with the values of positive slip at c = 1, of negative slip at 0", by_the_two_slips),
        note="The part of db/dt that depends on contact is -α_3* λ⁺: 2-contact-part. That these equations are those of "
        "the printed fields: 2-extended.",
    )


def enters(name: str, rates: str) -> bool | None:
    """Whether the variable enters one of these rates, for every χ and every share c; λ_N is a function of y and z."""
    found = [ALGEBRA.read(EXTENDED[rate]).derivative(name) for rate in rates]
    return not all(value.is_zero() for value in found)


def one_of(answers: Iterable[bool | None]) -> bool | None:
    """Whether one is True; open when one is open."""
    found = list(answers)
    return None if None in found or not found else any(found)


def denied(answer: bool | None) -> bool | None:
    """The contrary; open when the answer is."""
    return None if answer is None else not answer


def chi_brings(name: str) -> bool | None:
    """Whether the terms with χ have the variable."""
    parts = [ALGEBRA.read(text).derivative("chi") for text in EXTENDED.values()]
    if all(value.is_zero() for value in parts):
        return None
    return not all(value.derivative(name).is_zero() for value in parts)


def chi_couples_b_to_p() -> bool | None:
    """Whether the terms with χ are χ b in the rate of p."""
    parts = {name: ALGEBRA.read(text).derivative("chi") * _SYMBOLS["chi"] for name, text in EXTENDED.items()}
    others = all(value.is_zero() for name, value in parts.items() if name != "p")
    return others and (parts["p"] - _SYMBOLS["chi"] * _SYMBOLS["b"]).is_zero()


def _coupling() -> Entry:
    slip = one_of(enters(name, NORMAL) for name in TANGENTIAL)
    terms = one_of(chi_brings(name) for name in TANGENTIAL)
    right = chi_couples_b_to_p()
    return SECTION.settled(
        "2-coupling",
        "lines 661 to 664",
        r"\alpha_1=\alpha_1^*+\chi b\ \text{allows two-way coupling between normal and tangential dynamics}",
        "The term χ b of α_1 couples the tangential dynamics (x, u) back to the normal dynamics",
        Rung.EXACT.check(
            "newex1 to newex5, the share c kept: the rates of p, b, y, v, z, derived by x and by u",
            mended(slip, right),
            "neither x nor u enters, for any χ",
        ),
        Rung.EXACT.check(
            "all terms with χ, in slip and in stick",
            mended(terms, right),
            "the one term with χ is χ b in the rate of p",
        ),
        corrected="χ couples b back to p. The tangential motion acts on the normal one by the sign of u alone (slip, "
        "stick, slip backwards), for χ = 0 too",
        note="With p in the place of x and u the sentence is right: the rate of p has no variable for χ = 0, and b for "
        "χ other than 0, and p stands in the rate of v for every χ where the share c is positive.",
    )


def fields_have(state: str) -> bool | None:
    """Whether a component of F, G_T, G_N or μ has the state."""
    fields = lagrangian.PRINTED["2-extended"]
    names = [name for name in fields if name[0] in "FHN" or name == "mu"]
    return not all(lagrangian.ALGEBRA.read(fields[name]).derivative(state).is_zero() for name in names)


def slip_is_the_motivating_example() -> bool | None:
    """Whether the rates of p, b, y, v, z with c = 1 and χ = 0 are those of modelsys, ε² λ_N apart."""
    slip = {"c": ALGEBRA.constant(1), "chi": ALGEBRA.constant(0)}
    return all(
        (ALGEBRA.substitute(ALGEBRA.read(EXTENDED[name]), slip) - ALGEBRA.read(MOTIVATING[name])).is_zero()
        for name in NORMAL
    )


def _tangential() -> Entry:
    normal = [*(enters(name, NORMAL) for name in TANGENTIAL), enters("x", NORMAL + TANGENTIAL)]
    return SECTION.settled(
        "2-tangential",
        "lines 612 to 617, 621 to 623 and 929 to 931, eq. udot",
        r"x\ \text{is a cyclic coordinate; no transition to stick without }u",
        "x enters no right-hand side of the extended example; in slip the equations for p, b, y, v, z, which for χ = "
        "0 and positive slip are those of the motivating example, have no u either: they say nothing of a stop",
        Rung.EXACT.check(
            "eqs. xdot, udot, newex1 to newex5, derived by x and by u; with c = 1, χ = 0 eqs. modelsys1 to modelsys5",
            all_of([denied(one_of(normal)), slip_is_the_motivating_example()]),
        ),
        Rung.EXACT.check(
            "the components of the printed F, G_T, G_N and μ, derived by ξ_1; by ξ_2 there is ξ_1' = ξ_2 alone",
            all_of([denied(fields_have("x1")), only_place_has_the_velocity()]),
        ),
    )


def rate_of_p_is_constant() -> bool | None:
    """Whether the rate of p is α_1 for χ = 0, and so has no variable in it."""
    rate = ALGEBRA.substitute(ALGEBRA.read(EXTENDED["p"]), {"chi": ALGEBRA.constant(0)})
    return (rate - _SYMBOLS["alpha1"]).is_zero()


def fields_move_p_alike() -> bool | None:
    """Whether ξ_5 has the rate α_1 in F for χ = 0, and none in G_T and G_N."""
    fields, algebra = lagrangian.PRINTED["2-extended"], lagrangian.ALGEBRA
    rates = {letter: algebra.read(fields[f"{letter}5"]) for letter in "FHN"}
    free = algebra.substitute(rates["F"], {"chi": algebra.constant(0)}) - algebra.symbols["alpha1"]
    return all(value.is_zero() for value in (free, rates["H"], rates["N"]))


def _linear() -> Entry:
    return SECTION.settled(
        "2-p-linear",
        "lines 794 to 795 and 972 to 973",
        r"p(t)=\alpha_1^*t",
        "In the motivating example p is p(0) + α_1 t along every motion, in contact or not",
        Rung.EXACT.check("eq. newex1 with χ = 0: the rate of p is α_1, without a variable", rate_of_p_is_constant()),
        Rung.EXACT.check(
            "the fifth components of the printed F, G_T and G_N with χ = 0: α_1, 0 and 0", fields_move_p_alike()
        ),
    )


def only_place_has_the_velocity() -> bool | None:
    """Whether ξ_2 enters F_1 = ξ_2 and nothing else."""
    fields = lagrangian.PRINTED["2-extended"]
    names = [name for name in fields if (name[0] in "FHN" or name == "mu") and name != "F1"]
    read = lagrangian.ALGEBRA.read
    return all(read(fields[name]).derivative("x2").is_zero() for name in names) and read(fields["F1"]) == read("x2")


def force_is_positive_below() -> bool | None:
    """Whether λ_N > 0 for y = z - d: contact."""
    below = ALGEBRA.substitute(ALGEBRA.read(FORCE), {"y": _SYMBOLS["z"] - _SYMBOLS["d"]})
    return rising_signs(below)


def force_vanishes_at_the_surface_alone() -> bool | None:
    """Whether the force of contact is 0 at y = z and falls with y: no other y has the force 0 of flight."""
    force = ALGEBRA.read(FORCE)
    return ALGEBRA.substitute(force, {"y": _SYMBOLS["z"]}).is_zero() and rising_signs(-force.derivative("y"))


def _contact_condition() -> Entry:
    return SECTION.settled(
        "2-contact-condition",
        "lines 551 to 555",
        r"\text{lift-off and touch-down are given by the same condition } y=z",
        "With λ_N of eq. compliant2 contact ends and begins at y = z, and λ_N is continuous there: for every z and "
        "every k_2 > 0 the force is positive exactly for y < z",
        Rung.EXACT.check("the force at y = z - d, for every d > 0, is positive", force_is_positive_below()),
        Rung.EXACT.check(
            "the force of contact falls with y and is that of flight, 0, at y = z alone",
            force_vanishes_at_the_surface_alone(),
        ),
    )


def sums_to_twice_c() -> bool | None:
    """Whether p + p⁻ = 2C."""
    return (ALGEBRA.read(OTHER["p^-"]) + ALGEBRA.read("C - mu*B - 2*C")).is_zero()


def forward_force_slows() -> bool | None:
    """Whether B k⁺ = -(AC - B²) + A p and k⁻ = k⁺ + 2μA: with p = 0, B = C/μ > 0 and AC - B² > 0 the signs follow."""
    parts = {name: ALGEBRA.read(text) for name, text in OTHER.items()}
    first = _SYMBOLS["B"] * parts["k^+"] - ALGEBRA.read("-(A*C - B^2) + A*(C - mu*B)")
    second = parts["k^-"] - parts["k^+"] - ALGEBRA.read("2*mu*A")
    return first.is_zero() and second.is_zero()


def signs_at_p_0() -> bool | None:
    """B C times p⁻, -k⁺, k⁻ at C = μB, A = (B² + D)/C, by positive symbols: all are positive."""
    images = {"C": ALGEBRA.read("mu*B")}
    answers = []
    for name, sign in (("p^-", 1), ("k^+", -1), ("k^-", 1)):
        value = ALGEBRA.read(OTHER[name])
        slope = value.derivative("A")
        rest = value - slope * _SYMBOLS["A"]
        whole = (rest * _SYMBOLS["C"] + slope * ALGEBRA.read("B^2 + D")) * _SYMBOLS["B"]
        answers.append(rising_signs(sign * ALGEBRA.substitute(whole, images)))
    return all(answers)


def _signs() -> Entry:
    return SECTION.settled(
        "2-signs-at-p-0",
        "lines 680 to 687",
        r"p\approx0:\quad p^->0,\quad k^+<0,\quad k^->0",
        "Where p = 0, C > 0, μ > 0 and AC - B² > 0, and so near it: the Painlevé parameter of negative slip is "
        "positive, p⁻ = 2C - p, and the contact force of positive (negative) slip accelerates the contact point "
        "backwards (forwards), k⁺ < 0 < k⁻",
        Rung.EXACT.check(
            "p + p⁻ = 2C; B k⁺ = -(AC - B²) + A p; k⁻ = k⁺ + 2μA = B + μA with B = C/μ > 0",
            all_of([sums_to_twice_c(), forward_force_slows()]),
        ),
        Rung.EXACT.check("C = μB and A = (B² + D)/C put in, D = AC - B², all symbols positive", signs_at_p_0()),
        note="A, C and AC - B² are positive for independent gradients of the two contact coordinates "
        "(1-mass-matrix); where they are dependent, that of y not 0, k⁺ is 0 at p = 0. The paper says of p⁻ that it "
        "must be positive, and of the accelerations that they typically have these signs.",
    )


ENTRIES: Builders = {
    "2-unilateral": _unilateral,
    "2-contact-condition": _contact_condition,
    "2-tangential": _tangential,
    "2-p-linear": _linear,
    "2-two-forces": _two_forces,
    "2-contact-part": _contact_part,
    "2-coupling": _coupling,
    "2-extended-equations": _extended_equations,
    "2-signs-at-p-0": _signs,
}
"""Sentences of Sec. 2."""
