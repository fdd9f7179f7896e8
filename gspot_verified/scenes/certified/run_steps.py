"""The steps of a certified run over all its phases: a budget, a journal that knows some of them, signs of life."""

from __future__ import annotations

import time as clock
from collections.abc import Callable

from flint import arb

from gspot_verified.integrator.norm_steps.chosen_step import ChosenStep, Steps
from gspot_verified.numbers.balls import approximate
from gspot_verified.numbers.counted import counted
from gspot_verified.scenes.certified.step_journal import StepJournal

Progress = Callable[[str], None]
QUIET_SECONDS = 2.0  # between two signs of life


class RunSteps(Steps):
    """``left``: how many more steps the run may make at this precision, ``bits``; ``until``: when it ends.

    Those that the journal holds for this precision and phase are offered first; from the first one on that cannot be
    proved again they are dropped.
    """

    def __init__(
        self, budget: int, bits: int, small: float, until: float, journal: StepJournal | None, progress: Progress
    ) -> None:
        super().__init__(budget)
        self._bits, self._small, self._until = bits, small, until
        self._journal, self._progress = journal, progress
        self._phase, self._name, self._began = -1, "", 0.0
        self._offered: ChosenStep | None = None
        lines = [] if journal is None else journal.lines
        self._next = next((i for i, line in enumerate(lines) if line.get("bits") == bits), len(lines))
        self._count, self._again = 0, 0
        self._said = clock.monotonic()

    def begins(self, name: str, began: arb) -> None:
        """The next phase begins at this time."""
        self._phase, self._name, self._began = self._phase + 1, name, approximate(began)

    def known(self) -> ChosenStep | None:
        """What the journal holds for the next step."""
        self._offered = None
        if self._journal is None or self._next >= len(self._journal.lines):
            return None
        line = self._journal.lines[self._next]
        if (line.get("bits"), line.get("phase")) == (self._bits, self._phase):
            try:
                self._offered = ChosenStep.from_json(line.get("step"))
            except ValueError:
                self._offered = None
        return self._offered

    def proved(self, step: ChosenStep, time: arb) -> None:
        """Count the step; keep it unless it is the one that the journal offered."""
        super().proved(step, time)
        self._count += 1
        if self._journal is not None:
            if self._offered is not None and step.plan is self._offered.plan:
                self._again += 1
            else:
                if self._next < len(self._journal.lines):
                    self._journal.cut(self._next)
                self._journal.add({"bits": self._bits, "phase": self._phase, "step": step.to_json()})
            self._next += 1
        now = clock.monotonic()
        if now - self._said > QUIET_SECONDS:
            self._said = now
            reached = (self._began + approximate(time)) * self._small
            again = f", {self._again} of them from the journal" if self._again else ""
            steps = counted(self._count, "step")
            place = f"t = {reached:.6g} of {self._until:.6g}"
            self._progress(f"{self._bits} bits: {self._name} at {place} after {steps}{again}")
