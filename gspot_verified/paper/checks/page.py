"""Proof pages: prose in proofs/, with the steps that a claim rests on as functions.

A check on this rung holds when every step of the page does. No check on it is made in another way, but of such checks.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from gspot_verified.paper.checks.entry import Check, Rung, all_of

Step = Callable[[], bool | None]
"""An exact step of a page: True when it holds."""


@dataclass(frozen=True, slots=True)
class Page:
    """The page proofs/``name``.md with the steps that are tested where it is used.

    A step that does not hold shows that the proof fails, not that the claim does: the check is open then.

    :raises ValueError: there is no step.

    There is no check that says yes because a page is cited: the claim is compared with what the page states.

    >>> Page("negative", (lambda: 1 + 1 == 2,)).carries(Check(Rung.EXACT, "the sum", 3 + 4 == 7)).agrees
    True
    """

    name: str
    steps: tuple[Step, ...]

    def __post_init__(self) -> None:
        if not self.steps:
            raise ValueError(f"{self.path}: a page without a step that is tested shows nothing")

    @property
    def path(self) -> str:
        """The file, as seen from the root of the project."""
        return f"proofs/{self.name}.md"

    def refutation(self, what: str, finding: str) -> Check:
        """That the page proves what contradicts the claim: the finding."""
        return self._on_page(what, False, finding)

    def carries(self, found: Check) -> Check:
        """A comparison of the claim with what the page states, on the page's rung."""
        return self._on_page(found.what, found.agrees, found.finding)

    def _on_page(self, what: str, agrees: bool | None, finding: str) -> Check:
        if all_of(self._answers()) is not True:
            agrees, finding = None, self._open()
        return Rung.PAGE.check(f"{self.path}: {what}", agrees, finding)

    def _answers(self) -> list[bool | None]:
        return [step() for step in self.steps]

    def _open(self) -> str:
        names = [getattr(step, "__name__", str(step)) for step in self.steps if step() is not True]
        return "steps that do not hold: " + ", ".join(name.replace("_", " ") for name in names)


def joined(*checks: Check) -> Check:
    """Checks on pages that carry a formula together: a part that does not read all of it cannot agree by itself.

    :raises ValueError: one of them is on another rung.
    """
    if any(check.rung is not Rung.PAGE for check in checks):
        raise ValueError("checks that are joined are checks on pages")
    finding = next((check.finding for check in checks if check.agrees is False), "")
    return Rung.PAGE.check("; ".join(check.what for check in checks), all_of(c.agrees for c in checks), finding)
