"""The paper's oscillator with its compliant contact, written by hand, at a tiny epsilon: a second way, no bound.

The state is (phi - phi_ref, phi', Y, V, Z), y = epsilon^2 Y, v = epsilon V; psi follows from y and v. Paper, Sec. 6, in
the units m_1 = l = g = 1, beta = 7/3, kappa = 0; friction against positive slip.
"""

from __future__ import annotations

from flint import arb, arb_mat, fmpq

from tests.witnesses.stiff_contact import State, StiffContact

_STEP = arb("1e-25")  # of differences


class StiffOscillator(StiffContact):
    """At one epsilon."""

    def __init__(self, epsilon: fmpq) -> None:
        super().__init__([], epsilon)

    def acceleration(self, phi: arb, speed: arb, v: arb, force: arb) -> tuple[arb, arb]:
        """phi'' and y''."""
        beta, mu = arb(7) / 3, arb(25) / 12
        offset, damping = arb(49) / 20 - 7 * beta / 12, 25 * (18 - 7 * beta) / 108
        sine = arb(4) / 5 * phi.cos() + arb(3) / 5 * phi.sin()
        cosine = arb(3) / 5 * phi.cos() - arb(4) / 5 * phi.sin()
        slider = v - sine * speed  # psi'
        first = -(phi - offset) - sine + force * (sine - mu * cosine)
        second = -damping * slider - 2 - cosine * speed**2 + force
        # [[1, sin], [sin, 2]] (phi'', psi'') = (first, second)
        whole = 2 - sine**2
        turning, falling = (2 * first - sine * second) / whole, (second - sine * first) / whole
        return turning, falling + sine * turning + cosine * speed**2

    def rates(self, u: State) -> State:
        """The right sides."""
        phi, speed, height, rise, z = u
        e, force = self._epsilon, z - height
        turning, lifting = self.acceleration(phi, speed, e * rise, force)
        return [speed, turning, rise / e, lifting / e, (-z - force) / e]

    def _slopes(self, u: State) -> arb_mat:
        base, columns = self.rates(u), list[State]()
        for i in range(len(u)):
            moved = [value + (_STEP if i == j else 0) for j, value in enumerate(u)]
            columns.append([((a - c) / _STEP).mid() for a, c in zip(self.rates(moved), base, strict=True)])
        return arb_mat(columns).transpose()

    def at_rest(self, phi: arb, speed: arb) -> State:
        """v = 0, and the force of rigid slip: y'' = b + p force = 0."""
        nothing, one = (self.acceleration(phi, speed, arb(0), arb(k))[1] for k in (0, 1))
        force = -nothing / (one - nothing)
        return [phi, speed, -2 * force, arb(0), -force]
