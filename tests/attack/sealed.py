"""Mutants of certificates of ways to a G-spot, sealed anew: what is accepted must be true of the motion that it states.

The statement alone is read, by sympy and by scipy; of the way and the bounds in the file nothing is used.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

import scipy.integrate
import sympy
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.reference_mechanism import Body
from attack.reference_slip import Slip, Unsure
from must_reject.mutate import Lines, checker, text_of

_PROOFS = Path(__file__).resolve().parents[2] / "proofs"
_FILES = ("approach_rod", "passage_3_2")
_NEAR = 1e-7
"""What the references are off at most, with room."""
_LITTLE = 1e-9
"""Where -b is as small as this the way is at its end; b falls like p^beta, so p may be 0 long before."""
_LONGEST = 400.0


def attack(random: Random) -> Attack:
    """One or two changes of a true statement, at times with what the file says elsewhere."""
    name = random.choice(_FILES)
    lines = _lines(name)
    kept = json.dumps(lines[0]["statement"])
    for _ in range(random.choice((1, 1, 1, 2))):
        part = lines[-1] if random.random() < 0.1 and "neighbourhood" not in lines[-1] else lines[0]["statement"]
        holder, key = random.choice(list(_texts(part)))
        holder[key] = _other(str(holder[key]), random)
    text = text_of(lines)
    seed = random.getrandbits(32)
    return Attack(
        f"check_text({text!r}), from {name}", lambda: _judged(text, lines[0]["statement"], kept, Random(seed))
    )


def _lines(name: str) -> Lines:
    return [json.loads(line) for line in (_PROOFS / f"{name}.cert").read_text(encoding="utf-8").splitlines()[:-1]]


def _texts(data: Any) -> Iterator[tuple[Any, Any]]:
    """Where texts stand."""
    for key, child in list(data.items() if isinstance(data, dict) else enumerate(data)):
        if isinstance(child, dict | list):
            yield from _texts(child)
        elif isinstance(child, str):
            yield data, key


def _other(text: str, random: Random) -> str:
    """Another number near or far; another formula; a word."""
    try:
        old = Fraction(text)
    except ValueError:
        more = random.choice((" + 1/100", " + 0", " + 1*X", " + -1*theta_dot", "*X"))
        swapped = text.replace("cos", "sin") if random.random() < 0.5 else text.replace("-1*", "1*")
        return random.choice((text + more, swapped, text.replace("1*", "2*", 1), "positive", "negative"))
    if random.random() < 0.5:
        return str(old * random.choice((2, Fraction(1, 2), Fraction(99, 100), Fraction(101, 100), -1, 10, 0)))
    return str(old + Fraction(random.choice((-1, 1)), random.choice((1, 10, 1000, 10**6, 10**8, 10**9, 10**13))))


def _judged(text: bytes, statement: Mapping[str, Any], kept: str, random: Random) -> Answer:
    check = checker()
    try:
        stated = check.main.check_text(text, check.limits.Limits())
    except check.limits.Rejected as reason:
        return undecided("rejected for its work") if "limit" in str(reason) else AGREED
    if json.dumps(statement) == kept:
        return AGREED
    try:
        trouble = (untrue_approach if statement["kind"] == "approach" else untrue_passage)(statement, random)
    except Unsure as error:
        return undecided(str(error))
    return wrong(f"accepted: {stated}\n  {trouble}") if trouble else AGREED


# ---------------------------------------------------------------------------------------------------------------------
# An approach: rigid slip of a mechanism, by DOP853 in the stretched time.
# ---------------------------------------------------------------------------------------------------------------------


def body_of(mechanism: Mapping[str, Any]) -> tuple[Body, dict[str, float]]:
    """The mechanism M q'' = f of a statement as a body, each angle as itself; and its reference angles."""
    coordinates = [sympy.Symbol(q) for q in mechanism["coordinates"]]
    velocities = [sympy.Symbol(f"{q}_dot") for q in mechanism["coordinates"]]
    sines = {q: [sympy.Rational(x) for x in pair] for q, pair in mechanism["angles"].items()}
    references = {q: sympy.atan2(sine, cosine) for q, (sine, cosine) in sines.items()}
    names: dict[str, sympy.Expr] = {str(each): each for each in (*coordinates, *velocities)}
    for q in coordinates:
        names |= {f"sin({q})": sympy.sin(q), f"cos({q})": sympy.cos(q)}
        names |= {f"({q}-{q}_ref)": q - references[str(q)]} if str(q) in references else {}

    def read(text: str) -> sympy.Expr:
        terms = (term.split("*") for term in text.split(" + "))
        return sum((sympy.Rational(c) * sympy.prod([names[f] for f in factors]) for c, *factors in terms), sympy.S(0))

    q, dq = sympy.Matrix(coordinates), sympy.Matrix(velocities)
    mass = sympy.Matrix([[read(entry) for entry in row] for row in mechanism["mass_matrix"]])
    kinetic = (dq.T * mass * dq)[0] / 2
    # Lagrange's equations have the forces f where these are the generalised ones.
    turning = (mass * dq).jacobian(q) * dq - sympy.Matrix([kinetic.diff(c) for c in q])
    forces = tuple(read(text) + more for text, more in zip(mechanism["forces"], turning, strict=True))
    body = Body(
        tuple(coordinates), tuple(velocities), kinetic, sympy.S(0), forces,
        read(mechanism["x"]), read(mechanism["y"]), sympy.Rational(mechanism["mu"]),
    )  # fmt: skip
    return body, {name: float(value) for name, value in references.items()}


def untrue_approach(statement: Mapping[str, Any], random: Random) -> str:  # noqa: ARG001  all of it is asked
    """What is wrong with a statement on rigid slip; nothing where it agrees with the reference.

    :raises Unsure: the reference cannot tell.
    """
    body, references = body_of(statement["mechanism"])
    exact, given = body.functions(), {}
    for word, value in statement["start"].items():
        q = (re.fullmatch(r"\((\w+)-\w+_ref\)", word) or [word, ""])[1]
        given[q or word] = float(Fraction(value)) + references.get(q, 0.0)
    left = [each for each in (*body.coordinates, *body.velocities) if str(each) not in given]
    known = {sympy.Symbol(word): value for word, value in given.items()}
    solved = sympy.solve([body.y.subs(known), exact["v"].subs(known)], left, dict=True)
    given |= {str(each): float(value) for each, value in solved[0].items()}
    surface = float(Fraction(statement["surface"][0])) if statement["surface"] else None
    start = [given[str(each)] for each in (*body.coordinates, *body.velocities)]
    slip = Slip(body)
    way = scipy.integrate.solve_ivp(
        slip.rates, (0.0, _LONGEST), [*start, 0.0], "DOP853", rtol=1e-12, atol=1e-14, max_step=0.25,
        events=_until(lambda _, state: slip.at(state)[2][1] + _LITTLE),
    )  # fmt: skip
    if way.status != 1:
        raise Unsure("b does not fall to 0")
    speeds = [slip.at(state)[2][2] for state in way.y.T]
    if surface is not None and min(speeds) < surface - _NEAR:
        return f"the slip velocity falls to {min(speeds)}"
    return _compared(statement, body, references, slip, way.y[:, -1])


def _until(function: Callable[[float, Sequence[float]], float]) -> Callable[[float, Sequence[float]], float]:
    function.terminal = True  # type: ignore[attr-defined]  as scipy asks for it
    return function


def _compared(
    statement: Mapping[str, Any], body: Body, references: Mapping[str, float], slip: Slip, last: Sequence[float]
) -> str:
    (p, *_, first, second, third), time = slip.at(last)[2], last[-1]
    if p > 1e-4:
        return f"slip ends by lift-off at {time}"
    if time > float(Fraction(statement["time"])) + _NEAR:
        return f"the G-spot is reached at {time}"
    reached = dict(zip(map(str, (*body.coordinates, *body.velocities)), last[:-1], strict=True))
    found = {word: reached[word] for word in reached if word in statement["place"]}
    found |= {f"({q}-{q}_ref)": reached[q] - references[q] for q in references}
    asked = [(word, pair, found[word]) for word, pair in statement["place"].items()]
    alphas = enumerate(zip(statement["alpha"], (first, second, third), strict=True), 1)
    asked += [(f"alpha_{k}", pair, value) for k, (pair, value) in alphas]
    for word, (low, high), value in [*asked, ("beta", statement["beta"], third / first)]:
        room = _NEAR * (1 + 20 * abs(value))
        if not float(Fraction(low)) - room <= value <= float(Fraction(high)) + room:
            return f"{word} = {value}, not in [{low}, {high}]"
    if statement["C_1"] == ["positive"] and third / first < 1:
        return "beta < 1: b < 0 is C_1 (-t)^beta and less"
    return ""


# ---------------------------------------------------------------------------------------------------------------------
# A passage: the model system at one epsilon, by DOP853.
# ---------------------------------------------------------------------------------------------------------------------


def untrue_passage(statement: Mapping[str, Any], random: Random) -> str:
    """The same of a passage, at the largest epsilon, from the ends of the set of starts.

    :raises Unsure: the way is too long for the reference.
    """
    first, second, third = (float(Fraction(value)) for value in statement["alpha"])
    k_1, k_2, damper = (float(Fraction(value)) for value in statement["contact"])
    p, b, epsilon, within, scaled, drift = (
        float(Fraction(statement[name])) for name in ("p", "b", "epsilon", "within", "scaled", "drift")
    )
    kappa, rate, mean, beta = k_1 * k_2 / (k_1 + k_2), (k_1 + k_2) / damper, second / (third - first), third / first
    lag, end = k_2 - kappa, -scaled * first * epsilon ** (2 / 3)
    if not (p - end) / (-first * epsilon) < 2e4:
        raise Unsure("a long way")

    def rates(time: float, states: Sequence[float]) -> list[float]:
        own, y, v, z = states
        force = k_2 * (z - y)
        return [
            epsilon * (second - third * force), v, own + (p + first * epsilon * time) * force,
            -(k_1 * z + force) / damper,
        ]  # fmt: skip

    size = abs(-b / p - mean)
    for signs in [(1, 1, 1), *[[random.choice((-1, 0, 1)) for _ in range(3)] for _ in range(2)]]:
        force = -b / p + signs[0] * within * size
        speed = signs[1] * within * math.sqrt(p / kappa) * size
        phi = signs[2] * within * math.sqrt(p * lag) * size / rate
        y = (phi - force - lag / rate * speed) / kappa
        times = (0.0, (p - end) / (-first * epsilon))
        found = scipy.integrate.solve_ivp(
            rates, times, [b, y, speed, y + force / k_2], "DOP853", rtol=1e-10, atol=1e-12
        )
        if not found.success:
            raise Unsure("the integration fails")
        if min(k_2 * (found.y[3] - found.y[1])) < -_NEAR:
            return f"at epsilon = {epsilon}, from the ends {signs}: contact is lost"
        deviation = (-found.y[0][-1] / end - mean) / (-b / p - mean)
        if deviation <= 0 or abs(math.log(deviation * (end / p) ** (1 - beta))) > drift + 1e-6:
            return f"at epsilon = {epsilon}, from the ends {signs}: L is {deviation} of what it was"
    return ""
