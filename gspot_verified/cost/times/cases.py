"""The cases that run in one process: few digits, far tau, many digits, general beta, an array, the import."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from flint import fmpq

from gspot_verified.cost.times.baseline import Answer, flint_theta, mpmath_theta, right_digits
from gspot_verified.cost.times.measure import (
    Contestant,
    Timing,
    clear_caches,
    import_seconds,
    measure,
    run_child,
    timing,
)
from gspot_verified.cost.times.rows import Row, Target, seconds_text
from gspot_verified.theta_function.theta import theta

HALF = fmpq(1, 2)  # a beta of small height
SEVEN_THIRDS = fmpq(7, 3)  # a tau and a beta without special values
BETAS = (HALF, SEVEN_THIRDS, fmpq(-5, 2))
NEAR = tuple(sign * size for size in (fmpq(1, 10), SEVEN_THIRDS, fmpq(10)) for sign in (1, -1))
FAR = tuple(fmpq(sign * size) for size in (10**6, 10**12) for sign in (1, -1))
FAR_BITS = 1 << 14  # a limit for the baseline far out
MPMATH_DIGITS = 1_000  # beyond them mpmath takes too long
SPEED = {1_000: 8.0, 10_000: 60.0, 100_000: 150.0}  # the target: how many times faster than the baseline, by digits

_AS_FAST = Target("cold / baseline", 1.5)
_CHEAPER = Target("repeated / first", 1.0)
_GENERAL = Target("cold / cold at β=1/2", 2.0)


def asked(tau: fmpq, beta: fmpq, digits: int, derivative: int = 0) -> str:
    """The question in words."""
    name = ("Θ", "Θ'")[derivative] if derivative < 2 else f"Θ^({derivative})"
    return f"{name} τ={_short(tau)} β={beta} {digits} digits"


def _short(tau: fmpq) -> str:
    size = int(abs(tau).p)
    power = len(str(size)) - 1
    return str(tau) if tau.q != 1 or size < 1_000 or size != 10**power else f"{'-' if tau < 0 else ''}10^{power}"


def _times(
    tau: fmpq, beta: fmpq, digits: int, derivative: int = 0, repeats: int = 61, bits: int | None = None
) -> tuple[dict[str, Timing], str]:
    """Our cold and warm calls, the baseline, mpmath (up to 1,000 digits); and what there is to say about answers."""

    def ours() -> object:
        return theta(tau, beta, derivative, digits)

    limit = {} if bits is None else {"max_bits": bits}
    answers: dict[str, object] = {}

    def keep(name: str, value: object) -> None:
        answers[name] = value

    contestants = {
        "cold": Contestant(ours, clear_caches, repeats),
        "baseline": Contestant(
            lambda: keep("baseline", flint_theta(tau, beta, derivative, digits, **limit)),
            clear_caches,  # of no use to it: so that both calls come after the same work
            repeats if bits is None else 1,
        ),
    }
    if digits <= MPMATH_DIGITS:
        contestants["mpmath"] = Contestant(
            lambda: keep("mpmath", mpmath_theta(tau, beta, derivative, digits)), repeats=3
        )
    times = measure(contestants)
    ours()
    times |= measure({"warm": Contestant(ours, repeats=repeats)})
    notes = []
    answer = answers["baseline"]
    if isinstance(answer, Answer) and answer.attempts > 1:
        times["first attempt"] = timing([answer.seconds[0]])
    if answer is None:
        spent = times.pop("baseline").median
        notes.append(f"baseline: no answer within {bits} bits ({seconds_text(spent)} spent)")
    if "mpmath" in answers:
        notes += _mpmath_note(answers["mpmath"], tau, beta, digits, derivative)
    return times, "; ".join(notes)


def _mpmath_note(value: object, tau: fmpq, beta: fmpq, digits: int, derivative: int) -> list[str]:
    if value is None:
        return ["mpmath: no answer"]
    right = right_digits(value, theta(tau, beta, derivative, digits + 5), digits)
    return [] if right >= digits else [f"mpmath: {right} of {digits} digits right, without a warning"]


def _row(case: str, words: str, target: Target, figure: float | None, times: dict[str, Timing], note: str) -> Row:
    shown = {name: times[name].median for name in ("cold", "warm", "baseline", "mpmath") if name in times}
    return Row(case, words, target, figure, note=note, **shown)


def _ratio(times: dict[str, Timing], above: str, below: str) -> float | None:
    return times[above].median / times[below].median if above in times and below in times else None


def few_digits() -> Iterator[Row]:
    """15, 30, 50 digits at moderate tau: the first call against the baseline; a derivative; one beta again."""
    case = "few digits, first call"
    mpmath_theta(SEVEN_THIRDS, HALF)  # its import and its first constants are not measured
    for digits in (15, 30, 50):
        for beta in BETAS:
            for tau in NEAR:
                times, note = _times(tau, beta, digits)
                figure = _ratio(times, "cold", "baseline")
                yield _row(case, asked(tau, beta, digits), _AS_FAST, figure, times, note)
    for beta in BETAS:
        times, note = _times(SEVEN_THIRDS, beta, 15, derivative=1)
        figure = _ratio(times, "cold", "baseline")
        yield _row("a derivative", asked(SEVEN_THIRDS, beta, 15, 1), _AS_FAST, figure, times, note)
    for derivative in (0, 1):
        for digits in (15, 50):
            yield _repeated_beta(digits, derivative)


def _repeated_beta(digits: int, derivative: int) -> Row:
    beta, first, second = SEVEN_THIRDS, SEVEN_THIRDS, fmpq(9, 4)

    def at(tau: fmpq) -> object:
        return theta(tau, beta, derivative, digits)

    def after_another() -> None:
        clear_caches()
        at(first)

    times = measure({
        "cold": Contestant(lambda: at(second), clear_caches, 31),
        "warm": Contestant(lambda: at(second), after_another, 31),
    })  # fmt: skip
    words = asked(second, beta, digits, derivative)
    note = f"warm: right after τ={first}; cold: with nothing before"
    return _row("the same β again", words, _CHEAPER, _ratio(times, "warm", "cold"), times, note)


def far_tau() -> Iterator[Row]:
    """tau = -50, and tau = +-10^6, +-10^12, where 1F2 loses its accuracy or ends its terms."""
    for digits in (16, 50):
        for beta in BETAS:
            times, note = _times(fmpq(-50), beta, digits)
            target = Target("cold", 0.0005, "s")
            yield _row("τ = -50", asked(fmpq(-50), beta, digits), target, times["cold"].median, times, note)
    for tau in FAR:
        for beta in BETAS:
            times, note = _times(tau, beta, 50, bits=FAR_BITS)
            yield _row("huge τ", asked(tau, beta, 50), Target("cold", 0.005, "s"), times["cold"].median, times, note)


def many_digits() -> Iterator[Row]:
    """10^3 and 10^4 digits against the baseline."""
    questions = [(tau, digits, SPEED[digits]) for digits in (1_000, 10_000) for tau in (SEVEN_THIRDS, -SEVEN_THIRDS)]
    first = measure({"mpmath": Contestant(lambda: mpmath_theta(SEVEN_THIRDS, HALF, 0, MPMATH_DIGITS), repeats=1)})
    words = (
        f"mpmath's first call at {MPMATH_DIGITS} digits: {seconds_text(first['mpmath'].median)}, it keeps Γ's constants"
    )
    for tau, digits, limit in [*questions, (fmpq(-50), 10_000, 80.0)]:
        times, note = _times(tau, HALF, digits, repeats=9)
        speed = _ratio(times, "baseline", "cold")
        note = "; ".join(filter(None, [note, _first_attempt(times), words if digits == MPMATH_DIGITS else ""]))
        target = Target("baseline / cold", limit, at_most=False)
        yield _row("many digits", asked(tau, HALF, digits), target, speed, times, note)


def first_attempt_note(seconds: float, ours: float) -> str:
    """How ours compares with the baseline's first precision alone, as if its few missing bits were no loss."""
    return f"the baseline's first attempt alone, a few bits short: {seconds_text(seconds)}, {seconds / ours:.3g} x"


def _first_attempt(times: dict[str, Timing]) -> str:
    return first_attempt_note(times["first attempt"].median, times["cold"].median) if "first attempt" in times else ""


def general_beta() -> Iterator[Row]:
    """beta with no shortcut for its Gamma values, against beta = 1/2; in this process and in fresh ones."""
    betas = (HALF, SEVEN_THIRDS, fmpq(7, 5))

    def call(beta: fmpq, digits: int) -> object:
        return theta(SEVEN_THIRDS, beta, 0, digits)

    for digits in (1_000, 10_000):
        times = measure({
            str(beta): Contestant(partial(call, beta, digits), clear_caches, 9)
            for beta in betas
        })  # fmt: skip
        for beta in betas[1:]:
            cold, half = times[str(beta)].median, times["1/2"].median
            note = f"β=1/2: {seconds_text(half)}"
            yield Row("general β", asked(SEVEN_THIRDS, beta, digits), _GENERAL, cold / half, cold, note=note)
    yield from general_beta_fresh(10_000, 60.0)


def general_beta_fresh(digits: int, time_limit: float) -> Iterator[Row]:
    """The same comparison, each call the first one of its own process: constants are computed inside the time."""
    seconds: dict[fmpq, float | None] = {}
    for beta in (HALF, SEVEN_THIRDS, fmpq(7, 5)):
        request = {"who": "ours", "tau": "7/3", "beta": str(beta), "digits": digits}
        seconds[beta] = run_child(request, time_limit).seconds
    half = seconds.pop(HALF)
    note = f"β=1/2: {seconds_text(half)}; each in a fresh process"
    for beta, cold in seconds.items():
        figure = cold / half if cold and half else None
        yield Row("general β", asked(SEVEN_THIRDS, beta, digits), _GENERAL, figure, cold, note=note)


def array_and_import() -> Iterator[Row]:
    """10^4 values in one array call; the time of the import."""
    import numpy as np

    points = np.linspace(-10.0, 10.0, 10_000)
    for beta in BETAS[:2]:
        times = measure({
            "cold": Contestant(partial(theta, points, beta), clear_caches, 3),
            "warm": Contestant(partial(theta, points, beta), None, 3),
        }, 5.0)  # fmt: skip
        words = f"10^4 τ in [-10, 10] β={beta} 15 digits"
        yield _row("numpy array", words, Target("cold", 1.0, "s"), times["cold"].median, times, "")
    seconds = import_seconds().median
    target = Target("time", 0.2, "s")
    yield Row("import", "import gspot_verified", target, seconds, seconds, note="median of 5 processes")
