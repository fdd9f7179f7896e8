"""Hand-made entries with each outcome, and the figures, drawn once."""

import pytest

from gspot_verified.hard_cases.catalogue import measure_hard_cases
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.verdict import Reason, Verdict
from gspot_verified.paper.checks.entry import Check, Entry, Rung, conclude
from gspot_verified.report.certificates import CheckedCertificate
from gspot_verified.report.figures.figures import drawings


@pytest.fixture(scope="session")
def pictures():
    return tuple(draw() for draw in drawings().values())


@pytest.fixture(scope="session")
def certificates():
    return [
        CheckedCertificate("iwc_0_1.cert", 64 * "a", True, "VERIFIED dΘ/dτ < 0", b"one"),
        CheckedCertificate("bad.cert", 64 * "b", False, "REJECTED <b>cover</b>", b"two"),
    ]


@pytest.fixture(scope="session")
def hard():
    """Two families of hard cases, one with a row that is undecided."""
    found = measure_hard_cases(["side", "spots-meet"]).to_json()
    assert found["summary"]["decided"] < found["summary"]["rows"]
    return found


@pytest.fixture(scope="session")
def entries():
    good = (
        Check(Rung.PAGE, "proofs/signs.md: as in rate", True, "found <b>it</b>"),
        Check(Rung.POINTS, "40 points", True),
    )
    bad = (Check(Rung.EXACT, "at beta = 3/2", False, "4 > 0"), Check(Rung.BALLS, "on (1, 2)", False, "all > 0"))
    return (
        Entry("t01", "eq:t01", "Appendix A", r"\Theta(0)", "value <at> 0 & 'more'", good, conclude("t", good)),
        Entry(
            "gamma sign", "line 1271", "Section 4.5", r"\Gamma(-\beta)<0", "the sign", bad,
            conclude("g", bad), r"\Gamma(-\beta)>0", "an exchange, as in t01",
            "gspot_verified/paper/section_4_5/section_4_5_signs.py:_gamma_intervals",
        ),
        Entry(
            "rate", "line 1302", "Section 4.5", r"\log(\eps)", "the rate",
            (Check(Rung.POINTS, "ten points", None),),
            Verdict.undecided("r", Reason.BUDGET, "still falling", tuple((Dyadic(k, k + 1),) for k in range(7))),
        ),
        Entry(
            "<script>alert(1)</script>", "<x>", "Section 4.5", "</code><script>", "<img src=x>", (),
            Verdict.undecided("u", Reason.NO_ROUTE, "<i>"), "<c>", "<n>",
        ),
    )  # fmt: skip
