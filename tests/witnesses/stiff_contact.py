"""The equations in contact at a tiny epsilon, by an implicit method in high precision: a second way, no bound.

Radau IIA with three stages (order 5), steps by step doubling. p' = alpha_1, b' = alpha_2 - alpha_3 lambda,
Y' = V/epsilon, V' = (b + p lambda)/epsilon, Z' = (-Z - lambda)/epsilon, lambda = Z - Y (the paper's contact), with
alpha_i = (value, by p, by b).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from flint import arb, arb_mat, fmpq

from gspot_verified.numbers.balls import working_bits

State = list[arb]
_BITS = 200


def _tableau() -> arb_mat:
    root = arb(6).sqrt()
    rows = [
        [(88 - 7 * root) / 360, (296 - 169 * root) / 1800, (-2 + 3 * root) / 225],
        [(296 + 169 * root) / 1800, (88 + 7 * root) / 360, (-2 - 3 * root) / 225],
        [(16 - root) / 36, (16 + root) / 36, arb(1) / 9],
    ]
    return arb_mat(rows).mid()


class StiffContact:
    """One system at one epsilon."""

    def __init__(self, alphas: Sequence[Sequence[fmpq]], epsilon: fmpq) -> None:
        self._alphas = [[arb(value) for value in row] for row in alphas]
        self._epsilon = arb(epsilon)

    def rates(self, u: State) -> State:
        """The right sides."""
        p, b, y, v, z = u
        first, second, third = (row[0] + row[1] * p + row[2] * b for row in self._alphas)
        force, e = z - y, self._epsilon
        return [first, second - third * force, v / e, (b + p * force) / e, (-z - force) / e]

    def _slopes(self, u: State) -> arb_mat:
        p, _, y, _, z = u
        (_, fp, fb), (_, sp, sb), (_, tp, tb) = self._alphas
        third = self._alphas[2][0] + tp * p + tb * u[1]
        force, e = z - y, self._epsilon
        return arb_mat([
            [fp, fb, 0, 0, 0],
            [sp - tp * force, sb - tb * force, third, 0, -third],
            [0, 0, 0, 1 / e, 0],
            [force / e, 1 / e, -p / e, 0, p / e],
            [0, 0, 1 / e, 0, -2 / e],
        ])  # fmt: skip

    def _step(self, u: State, h: arb, tableau: arb_mat) -> State:
        slopes, size, scaled = self._slopes(u), len(u), tableau * h
        places = [(i, row) for i in range(3) for row in range(size)]
        whole = [[arb(at == to) - scaled[at[0], to[0]] * slopes[at[1], to[1]] for to in places] for at in places]
        inverse, stages = arb_mat(whole).mid().inv().mid(), arb_mat(3, size)
        small = [arb("1e-40") * (abs(value) + arb("1e-30")) for value in u] * 3
        for _ in range(12):
            rates = [self.rates([a + stages[i, row] for row, a in enumerate(u)]) for i in range(3)]
            rest = stages - scaled * arb_mat(rates)
            moved = (inverse * arb_mat(3 * size, 1, rest.entries())).mid().entries()
            stages = (stages - arb_mat(3, size, moved)).mid()
            if all(abs(by) < limit for by, limit in zip(moved, small, strict=True)):
                break
        return [(a + stages[2, row]).mid() for row, a in enumerate(u)]

    def run(self, u: State, stop: Callable[[State], bool], tolerance: str = "1e-12") -> State:
        """The state at the end of the first step after which ``stop`` says so."""
        with working_bits(_BITS):
            tableau, h, least = _tableau(), self._epsilon / 10, self._epsilon ** arb("0.6")
            while not stop(u):
                large = self._step(u, h, tableau)
                small = self._step(self._step(u, h / 2, tableau), h / 2, tableau)
                off = [abs(large[i] - small[i]) / (abs(small[i]) + least) for i in (0, 1)]
                off.append(abs(large[4] - large[2] - small[4] + small[2]))
                error = max(float(value.mid()) for value in off) / float(tolerance)
                if error <= 1:
                    u = small
                h = (h * min(4.0, max(0.2, 0.9 * (error + 1e-30) ** (-1 / 6)))).mid()
            return u


def at_rest(p: fmpq, b: fmpq) -> State:
    """v = 0, lambda = -b/p, y at rest: Y = -2 lambda, Z = -lambda."""
    force = arb(-b / p)
    return [arb(p), arb(b), -2 * force, arb(0), -force]


def fate(contact: StiffContact, start: State, force: int) -> tuple[str, State]:
    """How it ends: lambda <= 0, or lambda > ``force``."""
    last = contact.run(start, lambda u: bool(u[4] - u[2] <= 0 or u[4] - u[2] > force))
    return ("lift-off" if last[4] - last[2] <= 0 else "impact"), last
