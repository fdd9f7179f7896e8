"""Ledger of Section 2: coefficients of restitution of the compliant contact, in the limits that the paper names.

Transcribes the steps of proofs/restitution.md. An impact: forces other than λ_N left out, p > 0 constant. The
coefficient depends on ρ = k_1/k_2 and ζ = c sqrt(p/k_2) alone.
"""

from __future__ import annotations

from functools import lru_cache

from flint import arb, fmpq, fmpq_mpoly

from gspot_verified.numbers.balls import ball_text, certainly_less, working_bits
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra
from gspot_verified.paper.checks.page import Page
from gspot_verified.paper.numerics.restitution import elastic_loss, inelastic_bound, restitution

SECTION = Section("Section 2")
ALGEBRA = Algebra("y v z rho zeta")
_SYMBOLS = ALGEBRA.symbols
MOTION = {"y": "zeta*v", "v": "zeta*(z - y)", "z": "-rho*z - (z - y)"}
"""ζ times the rates of y, v, z."""
FORCE = "z - y"
ELASTIC: dict[str, dict[str, fmpq]] = {
    "c → 0": {"c": fmpq(-1)},
    "c → ∞": {"c": fmpq(1)},
    "k_2 → 0": {"k_2": fmpq(-2)},
    "k_1 → ∞": {"k_1": fmpq(2)},
}
"""k_1, k_2 and c as powers of n → ∞, the others fixed."""
AT = {"c → 0": (8, 16), "c → ∞": (16, 256), "k_2 → 0": (3, 9), "k_1 → ∞": (3, 9)}
"""n at which the coefficient is enclosed."""
LARGEST_LOSS = fmpq(1, 6)
"""1 - e² at the larger n is below this, and below that at the smaller one."""
INELASTIC: dict[str, int] = {"k_1": -1, "k_2": 1}
"""The signs of the powers of n in k_1 → 0, k_2 → ∞."""
LOSSY = (fmpq(1, 16), fmpq(1, 64))
"""k_1 = 1/k_2 at which the coefficient is enclosed, with c = p = 1: ρ = k_1², ζ² = k_1."""
CHOICE = {"k_1": fmpq(-2), "k_2": fmpq(-2), "c": fmpq(-1)}
"""k_1, k_2 and c as powers of ε (compliant3)."""
SCALES = Algebra("y v z lam rho zeta k1 k2 c p q n r")
"""n = 1/ε, r = sqrt(p), q the length that the speed at the start makes with them."""
SPRINGS = {"y": "v", "v": "p*lam", "z": "-k1*z - lam", "lam": "k2*(z - y)"}
"""The rates of y and v, c times that of z, and λ_N in contact (compliant1, compliant2), λ_N the only force."""
UNITS = {"y": "q", "z": "q", "v": "q*n*r", "lam": "q*n^2"}
"""Lengths, speeds and forces grow with the speed at the start, q n r."""
PER_TIME = "n*r"
STIFFNESS = fmpq(1, 400)
ONE_CONTACT = (fmpq(1, 25), fmpq(10**4))
"""Two values of p, with k_1 = STIFFNESS, k_2 = c = 1: ρ = k_1, ζ² = p."""
HEIGHT = fmpq(3, 4)
"""Between 8/11 and -sin 4 (Theorem Q2)."""
APART = (fmpq(1, 2), fmpq(9, 10))
"""e is below the first one and above the second one there."""


@lru_cache(maxsize=32)
def coefficient(rho: fmpq, zeta: fmpq) -> arb:
    """An enclosure of e."""
    return restitution(rho, zeta)


def rate(value: fmpq_mpoly) -> fmpq_mpoly:
    """ζ times the derivative along the motion."""
    return ALGEBRA.derivative(value, {name: ALGEBRA.read(text) for name, text in MOTION.items()})


def energy_falls() -> bool:
    """ζE' = -(ζz')² for E = (v² + Λ² + ρz²)/2."""
    force = ALGEBRA.read(FORCE)
    energy = (_SYMBOLS["v"] ** 2 + force**2 + _SYMBOLS["rho"] * _SYMBOLS["z"] ** 2) / 2
    return (rate(energy) + rate(_SYMBOLS["z"]) ** 2).is_zero()


def loss_is_work() -> bool:
    """H' = Λz' for H = (v² + Λ²)/2."""
    force = ALGEBRA.read(FORCE)
    return (rate((_SYMBOLS["v"] ** 2 + force**2) / 2) - force * rate(_SYMBOLS["z"])).is_zero()


def one_turn() -> bool:
    """ζ²z'' = -(1 + ρ)ζz' + ζv: at a zero of z' the sign of z'' is that of v."""
    speed = rate(_SYMBOLS["z"])
    return (rate(speed) + (1 + _SYMBOLS["rho"]) * speed - _SYMBOLS["zeta"] * _SYMBOLS["v"]).is_zero()


def lag() -> bool:
    """x = ρz + Λ: ζx' = -(1 + ρ)x - ζv, and (1 + ρ)Λ = x - ρy."""
    rho, force = _SYMBOLS["rho"], ALGEBRA.read(FORCE)
    x = rho * _SYMBOLS["z"] + force
    relaxes = rate(x) + (1 + rho) * x + _SYMBOLS["zeta"] * _SYMBOLS["v"]
    return relaxes.is_zero() and ((1 + rho) * force - x + rho * _SYMBOLS["y"]).is_zero()


def creeps() -> bool:
    """(1 + ρ)g = (1 + ρ)x + ζv: ζg' = -(1 + ρ)g + ζ²Λ/(1 + ρ)."""
    rho, zeta, force = _SYMBOLS["rho"], _SYMBOLS["zeta"], ALGEBRA.read(FORCE)
    g = (1 + rho) * (rho * _SYMBOLS["z"] + force) + zeta * _SYMBOLS["v"]
    return (rate(g) + (1 + rho) * g - zeta**2 * force).is_zero()


def numbers() -> bool | None:
    """sin 4 < -HEIGHT and 8/11 < HEIGHT: the contact has ended by then."""
    with working_bits(64):
        return all_of([certainly_less(arb(4).sin(), arb(-HEIGHT)), fmpq(8, 11) < HEIGHT])


COMMON = (energy_falls, one_turn)
Q2 = Page("restitution", (*COMMON, loss_is_work, lag, numbers))
BOTH = Page("restitution", (*Q2.steps, creeps))


def loss_vanishes(powers: dict[str, fmpq]) -> bool | None:
    """Whether one of the bounds of Theorem Q2 on 1 - e² tends to 0 when k_1, k_2, c are these powers of n.

    False where e stays below a number below 1 for some constants: ρ and ζ are fixed, and e < 1 (Theorem Q1); or ρ and
    sqrt(ρ)/ζ tend to 0 and ζ to 0 or to a number, such as 1/2, that e is at most in the limit (Theorem Q3).
    """
    k_1, k_2, c = (powers.get(name, fmpq(0)) for name in ("k_1", "k_2", "c"))
    rho, zeta = k_1 - k_2, c - k_2 / 2
    if rho > 0 or zeta > 0 or (rho == 0 and zeta < 0):
        return True
    return False if rho == zeta == 0 or rho < 2 * zeta else None  # rho <= 0 and zeta <= 0 here


def at(powers: dict[str, fmpq], n: int) -> tuple[fmpq, fmpq]:
    """ρ and ζ for p = 1."""
    k_1, k_2, c = (powers.get(name, fmpq(0)) for name in ("k_1", "k_2", "c"))
    return fmpq(n) ** int(k_1 - k_2), fmpq(n) ** int(c - k_2 / 2)


def losses(limit: str) -> list[arb]:
    """1 - e² at the two n."""
    with working_bits(64):
        return [1 - coefficient(*at(ELASTIC[limit], n)) ** 2 for n in AT[limit]]


def approaches(limit: str) -> bool | None:
    """Whether 1 - e² falls from the first n to the second, is small there, and obeys the bounds of Theorem Q2."""
    first, second = losses(limit)
    bounds = [elastic_loss(*at(ELASTIC[limit], n)) for n in AT[limit]]
    with working_bits(64):
        small = [certainly_less(second, first), certainly_less(second, arb(LARGEST_LOSS))]
        return all_of([*small, certainly_less(first, bounds[0]), certainly_less(second, bounds[1])])


def _elastic() -> Entry:
    found = (f"{limit}: {', '.join(ball_text(loss, 3) for loss in losses(limit))}" for limit in ELASTIC)
    return SECTION.settled(
        "2-restitution-elastic",
        "lines 560 to 566",
        r"e\to1:\quad c\to0,\ c\to\infty,\ k_2\to0,\ k_1\to\infty",
        "The energetic coefficient of restitution e of an impact (constant p > 0, λ_N the only force, y = z = 0 at its "
        "start) tends to 1 as c → 0, c → ∞, k_2 → 0 or k_1 → ∞, the other constants fixed",
        BOTH.carries(
            Rung.EXACT.check(
                "Theorem Q2: bounds on 1 - e², one of which tends to 0 in each limit",
                all_of(loss_vanishes(powers) for powers in ELASTIC.values()),
            )
        ),
        Rung.POINTS.check(
            "certified values at two places on the way to each limit: 1 - e² falls, and obeys the bounds",
            all_of(approaches(limit) for limit in ELASTIC),
            "; ".join(found),
        ),
    )


def in_units() -> bool | None:
    """Whether the springs and the damper, with the powers of ε of compliant3, are the motion with ρ = 1, ζ = sqrt(p).

    In the units of the impact, of which ρ and ζ are all that is left: no ε, and no speed at the start.
    """
    images = {name: SCALES.read(unit) * SCALES.symbols[name] for name, unit in UNITS.items()}
    powers = {"k1": CHOICE["k_1"], "k2": CHOICE["k_2"], "c": CHOICE["c"]}
    images |= {name: SCALES.symbols["n"] ** int(-power) for name, power in powers.items()}
    images["p"] = SCALES.read("r^2")
    left = {name: SCALES.substitute(SCALES.read(text), images) for name, text in SPRINGS.items()}
    plain = {"rho": SCALES.constant(1), "zeta": SCALES.symbols["r"], "lam": SCALES.read(FORCE)}
    answers = [left["lam"] - SCALES.read(UNITS["lam"]) * SCALES.read(FORCE)]
    for name, text in MOTION.items():
        factor = images["c"] if name == "z" else SCALES.constant(1)
        moved = factor * SCALES.read(UNITS[name]) * SCALES.read(PER_TIME) * SCALES.substitute(SCALES.read(text), plain)
        answers.append(SCALES.symbols["r"] * SCALES.substitute(left[name], plain) - moved)
    return all(answer.is_zero() for answer in answers)


def has_no_epsilon() -> bool | None:
    """Whether ρ = k_1/k_2 and ζ = c sqrt(p/k_2) have the power 0 of ε, and sqrt(k_2 p) the power -1."""
    k_1, k_2, c = (CHOICE[name] for name in ("k_1", "k_2", "c"))
    return k_1 == k_2 == -2 and c - k_2 / 2 == 0


def _consistent() -> Entry:
    return SECTION.settled(
        "2-restitution-consistent",
        "lines 560 to 562",
        r"\epsilon\to0:\ \text{consistent with models of coefficients of restitution}",
        "With k_1 = k_2 = 1/ε² and c = 1/ε an impact (constant p > 0, λ_N the only force, y = z = 0 at its start) has "
        "one coefficient of restitution, between 0 and 1, for every ε > 0 and every v < 0 at its start, and lasts ε "
        "times a number that does not depend on ε: as ε → 0 it is a jump of v",
        Page("restitution", COMMON).carries(
            Rung.EXACT.check(
                "eqs. compliant1 to compliant3 in units of the impact are eq. (1) of the page: no ε is left, no speed",
                in_units(),
            )
        ),
        Page("restitution", COMMON).carries(
            Rung.EXACT.check(
                "Theorem Q1: the impact ends, with 0 < e < 1; ρ, ζ and ε sqrt(k_2 p) have no ε in them",
                has_no_epsilon(),
            )
        ),
        note="The coefficient depends on p: it is below 1 at every p, and tends to 1 as p → 0 and as p → ∞ (Theorems "
        "Q1 and Q2 of the page with ρ = 1, ζ = sqrt(p)).",
    )


def bound_vanishes() -> bool | None:
    """Whether ζ, sqrt(ρ)/ζ and ρ tend to 0 for k_1 = n^a, k_2 = n^b of the signs of the limit, c and p fixed.

    False where e tends to 1 (Theorem Q2).
    """
    a, b = INELASTIC["k_1"], INELASTIC["k_2"]
    exponents = (fmpq(-b, 2), fmpq(a, 2), fmpq(a - b))
    if all(exponent < 0 for exponent in exponents):
        return True
    return False if loss_vanishes({"k_1": fmpq(a), "k_2": fmpq(b)}) else None


def root(p: fmpq) -> fmpq:
    """The rational square root.

    :raises DomainError: there is none.
    """
    return fmpq(p.p.sqrt(), p.q.sqrt())


def is_lossy() -> bool | None:
    """Whether e falls along LOSSY and obeys the bound of Theorem Q3."""
    places = [(k**2, root(k)) for k in LOSSY]
    first, second = (coefficient(*place) for place in places)
    bounds = [inelastic_bound(*place) for place in places]
    below = [certainly_less(first, bounds[0]), certainly_less(second, bounds[1])]
    return all_of([certainly_less(second, first), *below])


def _inelastic() -> Entry:
    return SECTION.settled(
        "2-restitution-inelastic",
        "lines 566 to 568",
        r"e\to0:\quad k_1\to0,\ k_2\to\infty",
        "The coefficient of restitution of an impact (constant p > 0, λ_N the only force, y = z = 0 at its start) "
        "tends to 0 as k_1 → 0 and k_2 → ∞, however the two are related, with c fixed",
        BOTH.carries(
            Rung.EXACT.check(
                "Theorem Q3: e is at most ζ + (1 + ρ) sqrt(ρ)/ζ, with ζ = c sqrt(p/k_2), sqrt(ρ)/ζ = sqrt(k_1/p)/c",
                bound_vanishes(),
            )
        ),
        Rung.POINTS.check(
            f"certified values for c = p = 1, k_1 = 1/k_2 = {' and '.join(map(str, LOSSY))}: e falls, and obeys the "
            "bound",
            is_lossy(),
            ", ".join(ball_text(coefficient(k**2, root(k)), 4) for k in LOSSY),
        ),
    )


def coefficients() -> tuple[arb, arb]:
    """e of the contact for the two p."""
    first, second = (coefficient(STIFFNESS, root(p)) for p in ONE_CONTACT)
    return first, second


def they_differ() -> bool | None:
    """Whether the two coefficients lie on different sides of the gap."""
    first, second = coefficients()
    with working_bits(64):
        return all_of([certainly_less(first, arb(APART[0])), certainly_less(arb(APART[1]), second)])


def the_bounds_differ() -> bool | None:
    """Whether Theorem Q3 puts the first one below the gap, and Theorem Q2 the second one above it."""
    low, high = (root(p) for p in ONE_CONTACT)
    with working_bits(64):
        below = certainly_less(inelastic_bound(STIFFNESS, low), arb(APART[0]))
        above = certainly_less(elastic_loss(STIFFNESS, high), arb(1 - APART[1] ** 2))
    return True if below and above else None


def _not_fixed() -> Entry:
    first, second = coefficients()
    return SECTION.settled(
        "2-restitution-not-fixed",
        "lines 568 to 570",
        r"k_1,\ k_2,\ c\ \text{fixed}\ \not\Rightarrow\ e\ \text{fixed}",
        f"With k_1 = {STIFFNESS}, k_2 = c = 1 the coefficient of restitution of an impact (constant p > 0, λ_N the "
        f"only force, y = z = 0 at its start) is below {APART[0]} for p = {ONE_CONTACT[0]} and above {APART[1]} for "
        f"p = {ONE_CONTACT[1]}: it depends on p",
        Rung.BALLS.check(
            "e for both p, by the exact motion", they_differ(), f"{ball_text(first, 4)}, {ball_text(second, 4)}"
        ),
        BOTH.carries(
            Rung.EXACT.check("Theorem Q3 for the smaller p, Theorem Q2 for the larger one", the_bounds_differ())
        ),
        note="p is C - μB in positive slip and C + μB in negative slip, and depends on the mechanism and its "
        "configuration.",
    )


ENTRIES: Builders = {
    "2-restitution-consistent": _consistent,
    "2-restitution-elastic": _elastic,
    "2-restitution-inelastic": _inelastic,
    "2-restitution-not-fixed": _not_fixed,
}
"""The coefficient of restitution."""
