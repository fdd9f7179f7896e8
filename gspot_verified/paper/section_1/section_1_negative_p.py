"""Ledger of Section 1: what contact allows where p < 0. Rigid slip, lift-off, and an impact that begins with v = 0.

Positive symbols: x = -p, l = λ_N, n = |b|, u = u at the start, B, and D = A C - B² (1-mass-matrix). P is the normal
impulse, r the coefficient of restitution.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, rising_signs

SECTION = Section("Section 1")
ALGEBRA = Algebra("p b l x n s u r A B C D mu P T")
_SYMBOLS = ALGEBRA.symbols
ACCELERATION = "b + p*l"
"""dv/dt in positive slip (1-force)."""
PARADOX = {"p": "-x"}
"""Every p < 0."""
FLIGHT = "1/2*b*s^2"
"""y a time s after y = v = 0 with λ_N = 0, to leading order."""
RATES = {"v": "C - mu*B", "u": "B - mu*A"}
"""dv/dP and du/dP in positive slip: vdynamics and udynamics with λ_T = -μ λ_N, other forces left out."""
STICK = {"v": "C*P + B*T", "u": "A*T + B*P"}
"""The changes of v and u by a normal impulse P and a tangential impulse T."""
COMPRESSION = {"P": "B*u", "T": "-C*u"}
"""D times the impulses of the compression that begins at v = 0 and ends in stick."""
SIZES = {"lowest": ("p*u", "mu*A - B"), "Poisson": ("r*B*u", "A"), "energetic": ("-p*r^2*B*u^2", "A*(mu*A - B)")}
"""The lowest v of such an impact, v at its end by Poisson's law, and its square by the energetic law, as quotients."""
LIMIT = "0*p"
"""The limit as p → 0 of the square of v at the end by the energetic law over that by Poisson's."""
LEAST = ("r*C*u", "mu*A")
"""Less than v at the end by Poisson's law, for every p < 0."""


def in_the_paradox(text: str) -> fmpq_mpoly:
    """A formula with p as the hypothesis has it."""
    return ALGEBRA.substitute(ALGEBRA.read(text), {name: ALGEBRA.read(value) for name, value in PARADOX.items()})


def force_needs_positive_b() -> bool | None:
    """Whether dv/dt = 0 with λ_N = l > 0 gives b > 0: b is minus the rest of dv/dt, which has no b."""
    found = in_the_paradox(ACCELERATION)
    rest = found - found.derivative("b") * _SYMBOLS["b"]
    return (found.derivative("b") - 1).is_zero() and rising_signs(-rest)


def positive_b_gives_a_force() -> bool | None:
    """Whether dv/dt = 0 has for every b = n > 0 one solution l, with x l = n: the slope in l is -x."""
    found = ALGEBRA.substitute(in_the_paradox(ACCELERATION), {"b": _SYMBOLS["n"]})
    slope = found.derivative("l")
    at_zero = ALGEBRA.substitute(found, {"l": ALGEBRA.constant(0)})
    return rising_signs(-slope) and slope.derivative("l").is_zero() and rising_signs(at_zero)


def flight_leaves() -> bool | None:
    """Whether λ_N = 0 at y = v = 0 gives y'' = b, and y > 0 for b = n > 0, y < 0 for b = -n.

    λ_T = 0 too, by Coulomb's law. b is continuous along the motion: y = (b/2 + o(1)) s².
    """
    flight = ALGEBRA.read(FLIGHT)
    free = ALGEBRA.substitute(ALGEBRA.read(ACCELERATION), {"l": ALGEBRA.constant(0)})
    starts = all(
        ALGEBRA.substitute(value, {"s": ALGEBRA.constant(0)}).is_zero() for value in (flight, flight.derivative("s"))
    )
    up, down = (ALGEBRA.substitute(flight, {"b": sign * _SYMBOLS["n"]}) for sign in (1, -1))
    obeys = (flight.derivative("s").derivative("s") - free).is_zero()
    return starts and obeys and rising_signs(up) and rising_signs(-down)


def motions(sign: int) -> list[int] | None:
    """The λ_N >= 0 with dv/dt >= 0 and λ_N dv/dt = 0, in units of |b/p|, for b of this sign.

    λ_N = m n/x: dv/dt = n (sign - m). ``None``: the acceleration is not of that form.
    """
    found = in_the_paradox(ACCELERATION)
    if not (found - _SYMBOLS["b"] + _SYMBOLS["x"] * _SYMBOLS["l"]).is_zero():
        return None
    return [m for m in (0, sign) if m >= 0 and sign - m >= 0]


def motions_as_claimed() -> bool | None:
    """Whether b > 0 has flight and contact with force, and b < 0 neither."""
    both, none = motions(1), motions(-1)
    return None if both is None or none is None else both == [0, 1] and none == []


def _negative_p() -> Entry:
    return SECTION.settled(
        "1-negative-p",
        "lines 176 to 181",
        r"p<0:\quad\lambda_N=-b/p>0\iff b>0",
        "For every p < 0 contact in positive slip has a positive force exactly for b > 0; lift-off from y = v = 0 is "
        "possible for b > 0 as well, and is not for b < 0 (b continuous)",
        Rung.EXACT.check(
            "dv/dt = b + p λ_N = 0 solved for b and for λ_N, by positive symbols; free motion from y = v = 0 has "
            "y = (b/2 + o(1)) s² a time s later",
            all_of([force_needs_positive_b(), positive_b_gives_a_force(), flight_leaves()]),
        ),
        Rung.EXACT.check(
            "λ_N >= 0, dv/dt >= 0, λ_N dv/dt = 0: with λ_N in units of |b/p| the solutions are 0 and 1 for b > 0, and "
            "none for b < 0",
            motions_as_claimed(),
        ),
        note="For b < 0 neither motion exists (Painlevé's paradox).",
    )


def with_positive_symbols(value: fmpq_mpoly) -> fmpq_mpoly:
    """B C times the value at p = -x: μ = (C + x)/B and A = (B² + D)/C; 0 for a value not of degree 1 in A and in μ."""
    b, c = _SYMBOLS["B"], _SYMBOLS["C"]
    large_a, large_mu = b**2 + _SYMBOLS["D"], c - in_the_paradox("p")
    zero = {"A": ALGEBRA.constant(0), "mu": ALGEBRA.constant(0)}
    both = value.derivative("A").derivative("mu")
    alone = {name: ALGEBRA.substitute(value.derivative(name), zero) for name in ("A", "mu")}
    rest = ALGEBRA.substitute(value, zero)
    of_degree_1 = rest + alone["A"] * _SYMBOLS["A"] + alone["mu"] * _SYMBOLS["mu"]
    if not (value - of_degree_1 - both * _SYMBOLS["A"] * _SYMBOLS["mu"]).is_zero():
        return ALGEBRA.constant(0)
    return rest * b * c + alone["A"] * large_a * b + alone["mu"] * large_mu * c + both * large_a * large_mu


def compresses_in_slip() -> bool | None:
    """Whether v falls from 0 (dv/dP < 0) and slip slows down (du/dP < 0), for every p < 0 and every u > 0.

    So u = 0 at the impulse u/(μA - B), with v < 0: the contact was compressed.
    """
    return all(rising_signs(-with_positive_symbols(ALGEBRA.read(RATES[name]))) for name in ("v", "u"))


def decompresses_in_stick() -> bool | None:
    """Whether then v rises in stick: T keeps u = 0, |T| < μ P, and A dv/dP = D > 0, so that v = 0 is reached again."""
    a, b = _SYMBOLS["A"], _SYMBOLS["B"]
    # A T = -B P: u is kept; A times the rate of v.
    kept = ALGEBRA.substitute(ALGEBRA.read(STICK["u"]) * a, {"T": -b, "P": a})
    rate = ALGEBRA.substitute(ALGEBRA.read(STICK["v"]), {"T": -b, "P": a})
    in_the_cone = with_positive_symbols(_SYMBOLS["mu"] * a - b)  # μ - B/A > 0, and -B/A < 0
    rises = (rate - a * _SYMBOLS["C"] + b**2).is_zero()
    return kept.is_zero() and rises and rising_signs(in_the_cone)


def impulses_of_the_compression() -> bool | None:
    """Whether P = B u/D and T = -C u/D stop slip and give back v = 0, P > 0 and |T| < μ P: exactly p < 0.

    u here is the tangential velocity at the start; μ P - |T| = -p u/D.
    """
    impulses = {name: ALGEBRA.read(text) for name, text in COMPRESSION.items()}
    gram = ALGEBRA.read("A*C - B^2")
    normal = ALGEBRA.substitute(ALGEBRA.read(STICK["v"]), impulses)
    stops = ALGEBRA.substitute(ALGEBRA.read(STICK["u"]), impulses) + gram * _SYMBOLS["u"]
    margin = with_positive_symbols(_SYMBOLS["mu"] * impulses["P"] + impulses["T"])
    exactly = (margin - ALGEBRA.read("B*C*u") * -in_the_paradox("p")).is_zero()
    signs = exactly and rising_signs(impulses["P"]) and rising_signs(-impulses["T"]) and rising_signs(margin)
    return normal.is_zero() and stops.is_zero() and signs


def the_same_impulse() -> bool | None:
    """Whether the two routes have the same P: D P = D P_1 - (dv/dP) P_1 A, where slip ends at P_1 = u/(μA - B)."""
    rates = {name: ALGEBRA.read(text) for name, text in RATES.items()}
    u = _SYMBOLS["u"]
    along_the_path = u * ALGEBRA.read("A*C - B^2") - rates["v"] * u * _SYMBOLS["A"]
    return bool((along_the_path + rates["u"] * ALGEBRA.read(COMPRESSION["P"])).is_zero())


def _impact_from_rest() -> Entry:
    return SECTION.settled(
        "1-impact-without-collision",
        "lines 231 to 234",
        r"p<0:\quad v^-=0\ \text{can begin an impact}",
        "Rigid impact with Coulomb friction, A, B, C, μ constant, AC - B² > 0 (1-mass-matrix): for every p < 0 and "
        "every u > 0 there is an impact with v = 0 at its start: v < 0 in slip until u = 0, and then v rises in "
        "stick until it is 0 again at the end of compression",
        Rung.EXACT.check(
            "along the normal impulse: dv/dP = p < 0 and du/dP = B - μA < 0 in slip; in stick (|B| < μA) "
            "A dv/dP = AC - B² > 0",
            all_of([compresses_in_slip(), decompresses_in_stick()]),
        ),
        Rung.EXACT.check(
            "the impulses of the whole compression, B u and -C u over AC - B², stop the slip and give back v = 0; "
            "they lie in the cone of friction exactly for p <= 0, since μ P - |T| = -p u/(AC - B²)",
            all_of([impulses_of_the_compression(), the_same_impulse()]),
        ),
        note="p = C - μB < 0 needs B > 0, as C > 0. Restitution follows in stick, with v > 0 at its end for every "
        "positive coefficient of restitution (1-impact-sizes).",
    )


def _quotient(name: str) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    """A size as numerator and denominator in A, B, C and μ."""
    top, bottom = (ALGEBRA.read(text) for text in SIZES[name])
    parameter = {"p": ALGEBRA.read(RATES["v"])}
    return ALGEBRA.substitute(top, parameter), ALGEBRA.substitute(bottom, parameter)


def _equal(name: str, top: fmpq_mpoly, bottom: fmpq_mpoly) -> bool:
    stated = _quotient(name)
    return bool((stated[0] * bottom - top * stated[1]).is_zero())


def sizes_along_the_path() -> bool | None:
    """The sizes from the rates, in slip to u = 0 at the impulse P_1 = u/k, then in stick with the slope D/A.

    v_1 = dv/dP P_1 is the lowest; compression ends at P_1 - v_1 A/D. Restitution has the impulse r times that
    (Poisson), or the work v² A/(2 D) = r² times that of compression, v_1 P_1/2 - v_1² A/(2 D) (energetic).
    """
    slope, k = ALGEBRA.read(RATES["v"]), -ALGEBRA.read(RATES["u"])
    a, u, r, gram = _SYMBOLS["A"], _SYMBOLS["u"], _SYMBOLS["r"], ALGEBRA.read("A*C - B^2")
    # All times k A, or k² A: P_1 = u/k, v_1 = slope u/k.
    poisson = r * (u * gram - slope * u * a)
    energetic = r**2 * (-slope * u**2 * gram + (slope * u) ** 2 * a)
    return (
        _equal("lowest", slope * u, k)
        and _equal("Poisson", poisson, k * a)
        and _equal("energetic", energetic, k**2 * a)
    )


def sizes_by_the_whole_impulse() -> bool | None:
    """The same from the whole compression, P = B u/D: its work is v P/2, that of a triangle, v the lowest one.

    Stick has the share P - u/k of it, in which v rises from the lowest to 0.
    """
    whole, gram, k = ALGEBRA.read(COMPRESSION["P"]), ALGEBRA.read("A*C - B^2"), -ALGEBRA.read(RATES["u"])
    lowest, bottom = _quotient("lowest")
    a, u, r = _SYMBOLS["A"], _SYMBOLS["u"], _SYMBOLS["r"]
    rise = ALGEBRA.substitute(ALGEBRA.read(STICK["v"]), {"T": -_SYMBOLS["B"], "P": a})  # A dv/dP with T = -B P/A
    return (
        _equal("lowest", -rise * (whole * k - u * gram), a * gram * k)
        and _equal("Poisson", rise * r * whole, a * gram)
        and _equal("energetic", -rise * r**2 * lowest * whole, a * gram * bottom)
    )


def sizes_near_the_g_spot() -> bool | None:
    """Whether the lowest v and the end by the energetic law vanish at p = 0, where μA - B > 0, and LEAST is below."""
    zero = ALGEBRA.constant(0)
    tops = [ALGEBRA.read(SIZES[name][0]) for name in ("lowest", "energetic")]
    regular = ALGEBRA.substitute(with_positive_symbols(-ALGEBRA.read(RATES["u"])), {"x": zero})
    (top, bottom), (least, under) = (tuple(map(ALGEBRA.read, texts)) for texts in (SIZES["Poisson"], LEAST))
    above = with_positive_symbols(top * (under / _SYMBOLS["A"]) - least)
    vanish = all(ALGEBRA.substitute(value, {"p": zero}).is_zero() for value in tops)
    return vanish and bottom == _SYMBOLS["A"] and rising_signs(regular) and rising_signs(above)


def _sizes() -> Entry:
    return SECTION.settled(
        "1-impact-sizes",
        "lines 369 to 374",
        r"p<0:\quad u:\ u\to0,\qquad v^+=rBu/A\ \text{or}\ (v^+)^2=-pr^2Bu^2/(A(\mu A-B))",
        "A rigid impact without collision (v = 0, u > 0 and p < 0 at first, A, B, C, μ constant, AC - B² > 0, a "
        "coefficient of restitution r > 0) stops the slip, and v falls to p u/(μA - B), which tends to 0 with p; at "
        "its end v is r B u/A by Poisson's law, more than r C u/(μA) for every p < 0, and by the energetic law v² is "
        "-p r² B u²/(A (μA - B)), which tends to 0 with p; both limits are those of p → 0 where A and C stay bounded "
        "and AC - B² away from 0",
        Rung.EXACT.check(
            "along the normal impulse: the rates of v in slip and in stick, the impulse and the work of restitution",
            all_of([compresses_in_slip(), decompresses_in_stick(), sizes_along_the_path(), sizes_near_the_g_spot()]),
        ),
        Rung.EXACT.check(
            "from the impulse B u/(AC - B²) of the whole compression and its share in stick; its work is that of a "
            "triangle",
            all_of([impulses_of_the_compression(), sizes_by_the_whole_impulse(), sizes_near_the_g_spot()]),
        ),
        note="So the change of u is as large as u, and that of v depends on the law of restitution.",
    )


def quotient_has_the_limit() -> bool | None:
    """Whether the quotient of the squares has it; open where its denominator at p = 0 is not positive, as μA - B is."""
    (top, bottom), (other, under) = (tuple(map(ALGEBRA.read, SIZES[name])) for name in ("energetic", "Poisson"))
    above, below = top * under**2, bottom * other**2
    at_zero = {name: ALGEBRA.constant(0) for name in "px"}
    stops = -ALGEBRA.read(RATES["u"])
    rest, denominator = (ALGEBRA.substitute(value, at_zero) for value in (above - ALGEBRA.read(LIMIT) * below, below))
    factor, more = divmod(denominator, stops)
    regular = ALGEBRA.substitute(with_positive_symbols(stops), at_zero)
    positive = more.is_zero() and rising_signs(factor) and rising_signs(regular)
    return bool(rest.is_zero()) if positive else None


def _laws() -> Entry:
    return SECTION.settled(
        "1-laws-of-impact",
        "lines 209, 369 to 374",
        r"p\to0:\quad(v^+)^2\text{ by the energetic law over }(v^+)^2\text{ by Poisson's law}\to0",
        "For a rigid impact without collision, A, B, C, μ constant, p < 0, the energetic law of restitution and "
        "Poisson's, both with the same coefficient r > 0, differ in the limit p → 0 where A stays bounded and AC - "
        "B² away from 0: the quotient of the two squares of v at the end tends to 0",
        Rung.EXACT.check(
            "along the normal impulse: the rates of v in slip and in stick, the impulse and the work of restitution",
            all_of([compresses_in_slip(), decompresses_in_stick(), sizes_along_the_path(), quotient_has_the_limit()]),
        ),
        Rung.EXACT.check(
            "from the impulse of the whole compression and its share in stick",
            all_of([impulses_of_the_compression(), sizes_by_the_whole_impulse(), quotient_has_the_limit()]),
        ),
        note="Sizes of the impact: 1-impact-sizes. That v changes by O(1), as Sec. 1.4 says, holds by Poisson's law. "
        "Line 209 calls the distinction not important here, which is a judgement.",
    )


ENTRIES: Builders = {
    "1-negative-p": _negative_p,
    "1-impact-without-collision": _impact_from_rest,
    "1-impact-sizes": _sizes,
    "1-laws-of-impact": _laws,
}
"""Contact, lift-off and impact for p < 0."""
