"""Ledger of Section 2: how the deformation z of the surface relaxes at a fixed position y of the contact point."""

from __future__ import annotations

from gspot_verified.ledger.entry import Builders, Check, Entry, Rung, all_of, settled
from gspot_verified.ledger.identities import Algebra, rising_signs

ALGEBRA = Algebra("z y eps k1 k2 d x")
_SYMBOLS = ALGEBRA.symbols
RATE = {"contact": "-z - (z - y)", "flight": "-z"}
"""ε z' of compl1 with ε² λ_N = z - y, or λ_N = 0."""
REST = {"contact": "1/2*y", "flight": "0*y"}
"""Where z relaxes to."""
DECAY = {"contact": 2, "flight": 1}
"""z minus its rest falls like e^(-decay t/ε)."""
SPRINGS = {"contact": "-k1*z - k2*(z - y)", "flight": "-k1*z"}
"""c z' of compliant1 and compliant2."""


def relaxes(phase: str) -> bool | None:
    """Whether the deviation d = z - rest obeys ε d' = -decay d, and the rest lies on the right side of z = y.

    y = -x in contact (z = y/2 > y), y = x in flight (z = 0 < y), for every x > 0.
    """
    rest = ALGEBRA.read(REST[phase])
    rate = ALGEBRA.substitute(ALGEBRA.read(RATE[phase]), {"z": rest + _SYMBOLS["d"]})
    place = -_SYMBOLS["x"] if phase == "contact" else _SYMBOLS["x"]
    gap = ALGEBRA.substitute(rest - _SYMBOLS["y"], {"y": place})
    apart = gap if phase == "contact" else -gap
    return (rate + DECAY[phase] * _SYMBOLS["d"]).is_zero() and rising_signs(apart)


def of_the_springs(phase: str) -> bool | None:
    """The same from springs and damper: k_1 = k_2 = 1/ε², c = 1/ε, so c z' times ε² is ε z'."""
    force = ALGEBRA.substitute(
        ALGEBRA.read(SPRINGS[phase]), {"k1": ALGEBRA.constant(1), "k2": ALGEBRA.constant(1)}
    )  # times ε²
    at_rest = ALGEBRA.substitute(force, {"z": ALGEBRA.read(REST[phase])})
    return at_rest.is_zero() and (force.derivative("z") + DECAY[phase]).is_zero()


def _relaxation() -> Entry:
    return settled(
        "Section 2",
        "2-relaxation",
        "lines 555 to 557",
        r"z\to y/2\ (y<0),\qquad z\to0\ (y>0)",
        "At a fixed y < 0 the deformation z of the surface relaxes to y/2 like e^(-2t/ε), and at a fixed y > 0 to 0 "
        "like e^(-t/ε)",
        Check(
            Rung.EXACT,
            "eqs. compl1 and compl2: the deviation of z decays at these rates, for every y",
            all_of(relaxes(phase) for phase in RATE),
        ),
        Check(
            Rung.EXACT,
            "eqs. compliant1 to compliant3: the springs balance there, and the slope of the force over c is the rate",
            all_of(of_the_springs(phase) for phase in SPRINGS),
        ),
        note="A start with z < y < 0 is in flight first: z rises to y, and from there to y/2 in contact.",
    )


ENTRIES: Builders = {"2-relaxation": _relaxation}
"""The relaxation of the surface."""
