"""Hard cases of certificates: brackets of zeros that nearly meet, checked again in Python integers."""

from __future__ import annotations

import tempfile
from pathlib import Path

from flint import fmpq

from gspot_verified.certificates.checker import check
from gspot_verified.certificates.text import certificate_text
from gspot_verified.hard_cases.hard_case import Case, HardCase, log10, near
from gspot_verified.hard_cases.sign_cases import SPARE
from gspot_verified.hard_cases.timed import timed
from gspot_verified.signs.zeros.brackets import zeros_at


def brackets_certificate(k: int) -> str:
    """The certificate of the zeros of dTheta/dtau at beta = 6 - 10^-k, apart from each other."""
    zeros = zeros_at(near(6, k, -1), k // 2 + SPARE)
    return certificate_text(zeros.statement, [zeros.column])


def checked_brackets(k: int) -> HardCase:
    """What the independent checker says of it: 1 where it verified."""
    text, seconds = timed(lambda: brackets_certificate(k))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "brackets.cert"
        path.write_text(text, encoding="utf-8")
        result = check(path)
    said = "VERIFIED by the checker" if result.verified else result.text.splitlines()[-1][:80]
    return HardCase(
        level=k,
        asked=f"a certificate of all zeros of dΘ/dτ, β = 6 − 10^−{k}",
        condition=log10(6 * fmpq(10) ** k),
        lost=None,
        double=None,
        double_text="",
        certified=1 if result.verified else None,
        text=said,
        work=len(text),
        seconds=seconds,
    )


CASES: dict[str, Case] = {
    "certificate": checked_brackets,
}
