"""The first phase of a certificate of a run as a Coq source: the scene, its claim, and the steps as integers.

The polynomials are those of the file. The bases are rounded to few bits, and the bounds of the errors in them are
found here anew, as RunChecker.v will judge them: so its numbers are small. Nothing here is believed: other numbers
prove nothing, or the same claim. Imports nothing beyond the standard library.
"""

from __future__ import annotations

import json
import math
from fractions import Fraction
from typing import Any

HEADER = """(** * The first phase of the run of {name}.cert

    Written by proofs/coq/check_in_coq.py: the scene with the bracket of its first event, and the steps up to it. *)

From Coq Require Import ZArith QArith List.
From GSpot Require Import CompliantMotion RunScene RunChecker.
Import ListNotations.
Open Scope Z_scope.
"""
COORDINATES = ("b", "Y", "V", "Z")
"""The states in the order of the Coq vectors."""
FINEST, ERRORS, SCALE, DEPTH, TRIES = 24, 200, 40, 12, 1000
"""Bits of the bases, of the bounds of errors, of what Coq rounds of matrices; how often it halves to find a sign, and
how often the bounds are enlarged here."""
SLACK = 24
"""The bounds are larger than needed by 2^-SLACK of themselves: Coq rounds."""
FOUR = range(4)
Matrix = list[list[int]]


def exact(pair: list[int]) -> Fraction:
    """[m, e] as the number m 2^e."""
    mantissa, exponent = pair
    return Fraction(mantissa) * Fraction(2) ** exponent


def up(a: int, d: int) -> int:
    """a/d, rounded up."""
    return -(-a // d)


def root(square: int) -> int:
    """The square root, rounded up."""
    return math.isqrt(square - 1) + 1 if square else 0


def integer(value: int | Fraction) -> str:
    """An integer as a Coq term; a long one in hexadecimal digits, which Coq reads faster.

    :raises ValueError: it is none.
    """
    whole = Fraction(value)
    if whole.denominator != 1:
        raise ValueError("A number of a run is finer than its unit.")
    text = hex(abs(whole.numerator)) if abs(whole) > 2**60 else str(abs(whole.numerator))
    return f"(-{text})" if whole < 0 else text


def number(value: Fraction) -> str:
    """A rational as a Coq term."""
    top = f"({value.numerator})" if value < 0 else value.numerator
    return f"({top} # {value.denominator})"


def row(values: list[Any]) -> str:
    """A vector as a Coq term."""
    return f"(row {' '.join(values)})"


def inverse(S: Matrix) -> tuple[Matrix, int]:
    """A multiple of the inverse of a matrix of integers, in integers, and the positive factor.

    :raises ValueError: there is none.
    """
    rows = [[*map(Fraction, line), *(Fraction(i == k) for k in FOUR)] for i, line in enumerate(S)]
    for i in FOUR:
        pivot = next((k for k in range(i, 4) if rows[k][i]), None)
        if pivot is None:
            raise ValueError("A basis is not regular.")
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [value / rows[i][i] for value in rows[i]]
        for k in FOUR:
            if k != i:
                rows[k] = [a - rows[k][i] * b for a, b in zip(rows[k], rows[i], strict=True)]
    found = [line[4:] for line in rows]
    factor = math.lcm(*(value.denominator for line in found for value in line))
    return [[int(value * factor) for value in line] for line in found], factor


def without_clock(piece: dict[str, Any], names: list[str]) -> tuple[Matrix, list[int]]:
    """The basis of a piece, rounded, without the clock T, whose error is 0; and the first column of each one's block.

    :raises ValueError: the column that moves T most has others in its block.
    """
    n, blocks = len(names), list(piece["blocks"])
    S = [[exact(piece["basis"][i * n + k]) for k in range(n)] for i in range(n)]
    moves = [abs(value) for value in S[names.index("T")]]
    moved = moves.index(max(moves))
    block = next((j for j in range(len(blocks)) if sum(blocks[:j]) == moved), None)
    if block is None or blocks[block] != 1:
        raise ValueError("The checker of runs in Coq does not know a basis in which the clock is no block by itself.")
    kept = [k for k in range(n) if k != moved]
    sizes = blocks[:block] + blocks[block + 1 :]
    first = [sum(sizes[:j]) for j, size in enumerate(sizes) for _ in range(size)]
    states = [names.index(name) for name in COORDINATES]
    return [[round(S[i][k] * 2**FINEST) for k in kept] for i in states], first


def plus(p: list[int], q: list[int], factor: int = 1) -> list[int]:
    """p + factor q."""
    n = max(len(p), len(q))
    return [a + factor * c for a, c in zip(p + [0] * (n - len(p)), q + [0] * (n - len(q)), strict=True)]


class Errors:
    """The bounds of the errors, from piece to piece, as RunChecker.v computes them."""

    def __init__(self, rates: list[int], clock: int, grain: int, start: list[Fraction], middle: list[int]) -> None:
        """[first_errors]: how far ``start`` is from ``middle``; ``rates``: below, rate1, rate2, rate3, first_p."""
        self.rates, self.clock, self.grain = rates, clock, grain
        self.fine = 2 ** (ERRORS + FINEST) // grain
        self.basis, self.blocks = [[int(i == k) for k in FOUR] for i in FOUR], [*FOUR]
        self.radii = [math.ceil(abs(a * grain - m) * self.fine) for a, m in zip(start, middle, strict=True)]
        self.middle = middle
        self.begin = 0

    def defects(self, h: int, x: list[list[int]]) -> list[int]:
        """Bounds of the defect of a step."""
        below, rate1, rate2, rate3, p = self.rates
        b, y, v, z = x
        force, units = plus(z, y, -1), below * self.clock
        p_value, p_slope = p * self.clock + rate1 * self.begin, rate1 * h
        pressed = plus([p_value * c for c in force], [0, *(p_slope * c for c in force)])
        turned = [
            (plus([rate2 * self.grain], force, -rate3), b, units),
            (v, y, self.clock),
            (plus([units * c for c in b], pressed), v, self.clock * units),
            (plus(y, z, -2), z, self.clock),
        ]
        return [
            up(sum(map(abs, plus([h * c for c in f], [k * c for k, c in enumerate(p)][1:], -u))) * self.fine, u)
            for f, p, u in turned
        ]

    def matrix(self, S: Matrix, inv: Matrix, det: int, bl: list[int], h: int, ends: tuple[int, int]) -> Matrix:
        """[growth]: M of Theorem N1', for a piece."""
        below, rate1, _, rate3, p = self.rates
        clock, (left, right) = self.clock, ends
        p_value, p_slope = p * clock + rate1 * self.begin, rate1 * h
        units, middle = 2 * below * clock * clock, 2 * p_value * clock + p_slope * (left + right)
        radius = abs(p_slope) * (right - left)
        field = [
            [
                2 * clock * clock * rate3 * (S[1][k] - S[3][k]),
                units * S[2][k],
                middle * (S[3][k] - S[1][k]) + units * S[0][k],
                units * (S[1][k] - 2 * S[3][k]),
            ]
            for k in FOUR
        ]
        B = [[sum(inv[i][m] * field[k][m] for m in FOUR) for k in FOUR] for i in FOUR]
        E = [[abs(inv[i][2]) * abs(S[3][k] - S[1][k]) * radius for k in FOUR] for i in FOUR]
        scale, whole = 2**SCALE, det * units
        sizes = [[up((abs(B[i][k]) + E[i][k]) * scale, whole) for k in FOUR] for i in FOUR]

        def disc(j: int, i: int) -> int:
            beside = [
                up((abs(B[i][k] + B[k][i]) + E[i][k] + E[k][i]) * scale, whole) for k in FOUR if bl[k] == j and k != i
            ]
            return up((B[i][i] + E[i][i]) * scale, whole) + up(sum(beside), 2)

        return [
            [
                max([disc(j, i) for i in FOUR if bl[i] == j] or [disc(j, j)])
                if j == k
                else root(sum(sizes[i][m] ** 2 for i in FOUR if bl[i] == j for m in FOUR if bl[m] == k))
                for k in FOUR
            ]
            for j in FOUR
        ]

    def piece(self, S: Matrix, bl: list[int], h: int, ends: tuple[int, int], parts: int, given: list[list[int]]) -> str:
        """The Coq term of a piece, and the errors at its end. ``given``: the defect and the jump."""
        inv, det = inverse(S)
        scale, (defect, jump) = 2**SCALE, given

        def lengths(v: list[int]) -> list[int]:
            return [root(sum(v[i] ** 2 for i in FOUR if bl[i] == j)) for j in FOUR]

        d = lengths([up(sum(abs(inv[i][k]) * defect[k] for k in FOUR), det) for i in FOUR])
        leap = lengths([up(abs(sum(inv[i][k] * jump[k] for k in FOUR)), det) for i in FOUR])
        G = [[sum(inv[i][m] * self.basis[m][k] for m in FOUR) for k in FOUR] for i in FOUR]

        def gram(j: int, k: int, a: int) -> int:
            return sum(abs(sum(G[i][a] * G[i][c] for i in FOUR if bl[i] == j)) for c in FOUR if self.blocks[c] == k)

        def norm(j: int, k: int) -> int:
            most = max([gram(j, k, a) for a in FOUR if self.blocks[a] == k], default=0)
            return root(up(scale * scale * most, det * det))

        entered = [up(sum(norm(j, k) * self.radii[k] for k in FOUR) + leap[j] * scale, scale) for j in FOUR]
        M = self.matrix(S, inv, det, bl, h, ends)
        nodes = [[w + (w >> SLACK) + 1 for w in entered]]
        length = ends[1] - ends[0]
        most = parts * scale * self.clock**2
        own = [length * h * M[j][j] for j in FOUR]
        if max(own) >= most:
            raise ValueError("The parts of a piece of a run are too long to bound the errors.")

        def others(j: int, w: list[int]) -> int:
            return length * (h * sum(M[j][k] * w[k] for k in FOUR if k != j) + d[j] * scale * self.clock)

        for _ in range(parts):
            u = nodes[-1]
            least = [max(1, up((most + own[j]) * u[j] + others(j, u), most)) for j in FOUR]
            v = least
            for _ in range(TRIES):
                needed = [max(least[j], up(most * u[j] + others(j, v), most - own[j])) for j in FOUR]
                if all(a <= c for a, c in zip(needed, v, strict=True)):
                    break
                v = [w + (w >> SLACK) // parts + 1 for w in needed]
            else:
                raise ValueError("No bounds of the errors are found on a piece of a run.")
            nodes.append(v)
        self.basis, self.blocks, self.radii = S, bl, nodes[-1]
        matrices = [row([row([integer(value) for value in line]) for line in A]) for A in (S, inv)]
        names = row([f"of_{COORDINATES[k].lower()}" for k in bl])
        bounds = "; ".join(row([integer(value) for value in w]) for w in nodes)
        return f"Piece {ends[1]}\n    {matrices[0]}\n    {matrices[1]} {integer(det)}\n    {names}\n    [{bounds}]"


def read(text: str) -> tuple[dict[str, Any], int, dict[str, Any], list[dict[str, Any]]]:
    """The statement, the bits, the first phase and its steps.

    :raises ValueError: it is not a run of the model system that RunChecker.v knows.
    """
    header, bits, *lines = (json.loads(line) for line in text.split("\n")[:-2])
    statement, phase = header["statement"], lines[0]
    steps = lines[1 : 1 + phase["steps"]]
    known = (
        statement["effects"] == ["compliant_contact", "lift_off"]
        and all(statement["parameters"][name] == "1" for name in ("k_1", "k_2", "damping"))
        and (phase["phase"], phase["event"]) == ("slip", "lift-off")
        and [event[0] for event in statement["events"][:1]] == ["lift-off"]
        and all(sorted(step["x"]) == sorted([*COORDINATES, "T"]) for step in steps)
    )
    if not known:
        raise ValueError("The checker of runs in Coq knows a first lift-off of the model with k_1 = k_2 = damping = 1.")
    return statement, bits["bits"], phase, steps


def scene(statement: dict[str, Any]) -> str:
    """The scene with the bracket of its first event as a Coq term."""
    of = statement["parameters"] | statement["start"]
    words = [statement["epsilon"], *(of[name] for name in ("alpha_1", "alpha_2", "beta", *"bpvyz"))]
    return f"Scene {' '.join(number(Fraction(word)) for word in (*words, *statement['events'][0][1:]))}"


def run(text: str) -> str:
    """The run up to the first event as a Coq term.

    :raises ValueError: it is not a run that is known; a basis or a number is not of the form that is known.
    """
    statement, bits, phase, steps = read(text)
    names = sorted(steps[0]["x"])
    lengths = [exact(step["h"]) for step in steps]
    stops = [exact(piece["end"]) for step in steps for piece in step["pieces"]]
    clock = max(value.denominator for value in (*lengths, *stops))
    digits, unit = max(step["unit"] for step in steps), 2**bits
    of = {name: Fraction(text) for name, text in (statement["parameters"] | statement["start"]).items()}
    eps = Fraction(statement["epsilon"])
    rates = [eps * of["alpha_1"], eps * of["alpha_2"], eps * of["alpha_1"] * of["beta"], of["p"]]
    below = math.lcm(*(rate.denominator for rate in rates))
    left, right = map(exact, phase["bracket"])
    halvings = next((m for m in range(bits, 0, -1) if right * 2**m <= 1), 0)
    start = [of["b"], of["y"] / eps**2, of["v"] / eps, of["z"] / eps**2]
    first = [steps[0]["x"][name][0] * 2 ** (digits - steps[0]["unit"]) for name in COORDINATES]
    errors = Errors([below, *(int(rate * below) for rate in rates)], clock, 2**digits, start, first)
    given = []
    for step, length in zip(steps, lengths, strict=True):
        h, more = int(length * clock), 2 ** (digits - step["unit"])
        x = [[c * more for c in step["x"][name]] for name in COORDINATES]
        defect, at, lines = errors.defects(h, x), 0, []
        jump = [(errors.middle[i] - x[i][0]) * errors.fine for i in FOUR]
        for piece in step["pieces"]:
            end = int(exact(piece["end"]) * clock)
            parts = 2 * (len(piece["nodes"]) - 1)
            lines.append(errors.piece(*without_clock(piece, names), h, (at, end), parts, [defect, jump]))
            at, jump = end, [0] * 4
        errors.middle = [sum(p) for p in x]
        errors.begin += h
        curve = row([f"[{'; '.join(integer(c) for c in p)}]" for p in x])
        given.append(f"Step {h}\n   {curve}\n   [{(';' + chr(10) + '   ').join(lines)}]")
    head = [integer(value) for value in (below, *(rate * below for rate in rates))]
    units = [clock, f"(2 ^ {digits})", integer(errors.fine), f"(2 ^ {SCALE})", integer(unit)]
    ends = [integer(left * unit), integer(right * unit), f"{halvings}%nat", f"{DEPTH}%nat"]
    between = ";\n  "
    return f"Run (Rates {' '.join(head)}) {' '.join(map(str, units))}\n  [{between.join(given)}]\n  {' '.join(ends)}"


def source(name: str, text: str) -> str:
    """A file of the development that holds the scene with the bracket of its first event, and the run up to it.

    :raises ValueError: as of [run].
    """
    given = read(text)[0]
    return HEADER.format(name=name) + (
        f"\nDefinition {name}_scene : scene := ({scene(given)})%Q.\n\nDefinition {name} : run := {run(text)}.\n"
    )


def data(text: str) -> str:
    """The first line of the file, the same as a term, and the run up to the first event, for check_in_coq.py.

    :raises ValueError: as of [run].
    """
    statement, line = read(text)[0], text.partition("\n")[0]
    later = [
        f'("{name}"%string, ({number(Fraction(low))}, {number(Fraction(high))}))'
        for name, low, high in statement["events"][1:]
    ]
    end = "true" if statement["end"] == "for ever" else "false"
    doubled = line.replace('"', '""')
    return (
        f'\nDefinition given_line : string := "{doubled}"%string.\n\nDefinition given_header : header :='
        f" Header\n  ({scene(statement)})%Q\n  [{'; '.join(later)}]%Q {number(Fraction(statement['until']))} {end}.\n"
        f"\nDefinition given : run := {run(text)}.\n"
    )
