"""A rod with a PD wrist on its compliant contact, written by hand, at a tiny epsilon: a second way, no bound.

Mass and length 1, moment of inertia 1/3; the wrist turns it with -kp (theta - theta_d) - kd theta', a push of 5 and
gravity press it down; friction against positive slip. The state is (theta, theta', Y, V, Z).
"""

from __future__ import annotations

from flint import arb, fmpq

from tests.witnesses.stiff_oscillator import StiffOscillator

MECHANISM = """
format = 1
name = "rod with PD wrist"
[parameters]
kd = 1
[lagrangian]
coordinates = ["X", "Y", "th"]
mass_matrix = [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]]
forces = [0, "-9.81 - 5", "-5*(th - 0.9) - kd*th_dot"]
[contact]
x = "X + cos(th)"
y = "Y - sin(th)"
mu = "3/2"
[g_spot]
search = true
fixed = ["X", "X_dot"]
[g_spot.point]
X = 0
Y = 1
th = "0.9"
X_dot = 5
Y_dot = 1
th_dot = 3
"""


class StiffRod(StiffOscillator):
    """At one epsilon."""

    def __init__(self, epsilon: fmpq, damping: fmpq) -> None:
        super().__init__(epsilon)
        self._damping = arb(damping)

    def acceleration(self, phi: arb, speed: arb, v: arb, force: arb) -> tuple[arb, arb]:  # noqa: ARG002
        """theta'' and y''."""
        sine, cosine = phi.sin(), phi.cos()
        torque = -5 * (phi - arb(9) / 10) - self._damping * speed
        turning = 3 * (torque + force * (arb(3) / 2 * sine - cosine))
        return turning, -arb(981) / 100 - 5 + force - cosine * turning + sine * speed**2
