"""How the variables of an expansion are called and scaled in its text, its JSON and its LaTeX.

Paper, Sec. 5.1 (the scaling) and Sec. 4.5 (C_1). Components of the state have the mechanism's own names; p, b, y, v, z,
lambda_n are the paper's. Each left side says what it is: ``(theta - theta*)/delta^2``, ``p/delta^2``.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Generic, NamedTuple, TypeVar

Value = TypeVar("Value")

DELTA_FACTORS = {"xi": 2, "p": 2, "b": 2, "y": 6, "v": 4, "z": 6, "lambda_n": 0}
"""xi - xi* = delta^2 xi~, y = delta^6 y~, ...; with t = delta^2 s and epsilon = delta^3 the coefficient of
t^k epsilon^m belongs to the order 2 k + 3 m minus this number."""

CONTACT = tuple(name for name in DELTA_FACTORS if name != "xi")
_GREEK = (
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu", "nu", "xi", "rho",
    "sigma", "tau", "phi", "varphi", "chi", "psi", "omega", "Gamma", "Delta", "Theta", "Phi", "Psi", "Omega",
)  # fmt: skip

SCALES = (
    "s = t/epsilon^(2/3), delta = epsilon^(1/3); t is the time, in the mechanism's unit, and 0 where p = 0",
    "epsilon scales the contact: stiffnesses k_1/epsilon^2 and k_2/epsilon^2, damper c/epsilon (the paper's: "
    "k_1 = k_2 = c = 1), in the mechanism's units; a star marks values at the G-spot",
    "p, b, y, v, z, lambda_n without a star are the paper's: y'' = b + p lambda_n, y and v gap and gap rate, "
    "z the damper's place",
    "C_1 = 0 here: other slow trajectories have b - (this b) ~ C_1 (-t)^beta as t -> -infinity, "
    "C_1 in the unit of b over that of t^beta",
)
"""What the left sides, s, delta and C_1 mean."""

VALUES_OF = "values of the truncated polynomials; how far the mechanism's own trajectory is from them is not proved"


def state_names(names: Sequence[str], dimension: int) -> tuple[str, ...]:
    """The names of the components: the mechanism's own, or xi_1, xi_2, ..."""
    return tuple(names) or tuple(f"xi_{i + 1}" for i in range(dimension))


class InTwo(NamedTuple, Generic[Value]):
    """What belongs to the components of the state, by their names, and to p, b, y, v, z, lambda_n."""

    state: dict[str, Value]
    contact: dict[str, Value]


def in_two(values: Mapping[str, Value], names: Sequence[str]) -> InTwo[Value]:
    """What stands under xi_1, xi_2, ..., p, b, ... by the names, and by p, b, ...

    In two tables, since a component may be called p or y too.

    >>> in_two({"xi_1": 1, "p": 2}, ["p"])
    InTwo(state={'p': 1}, contact={'p': 2})
    """
    state = {name: values[f"xi_{i + 1}"] for i, name in enumerate(names)}
    return InTwo(state, {name: value for name, value in values.items() if name in CONTACT})


def left_side(key: str, names: Sequence[str], scaled: bool) -> str:
    """The left side of the line for xi_1, ..., p, b, ...

    >>> left_side("xi_2", ["X", "theta"], True), left_side("y", [], True), left_side("lambda_n", [], True)
    ('(theta - theta*)/delta^2', 'y/delta^6', 'lambda_n')
    """
    component = _component(key, names)
    power = DELTA_FACTORS["xi" if component else key] if scaled else 0
    base = f"{component} - {component}*" if component else key
    return base if not power else f"({base})/delta^{power}" if component else f"{base}/delta^{power}"


def latex_left_side(key: str, names: Sequence[str]) -> str:
    r"""The same in LaTeX.

    >>> print(latex_left_side("xi_1", ["theta_dot"]), latex_left_side("p", []))
    \delta^{-2}(\dot{\theta} - \dot{\theta}^*) \delta^{-2} p
    """
    component = _component(key, names)
    power = DELTA_FACTORS["xi" if component else key]
    shown = latex_symbol(component or key)
    scale = rf"\delta^{{-{power}}}" if power else ""
    return f"{scale}({shown} - {shown}^*)" if component else f"{scale} {shown}".strip()


def latex_symbol(name: str) -> str:
    r"""A name as mathematics: Greek letters, a dot for a velocity, indices; other words upright.

    >>> print(latex_symbol("lambda_n"), latex_symbol("x_2"), latex_symbol("angle"))
    \lambda_{n} x_{2} \mathrm{angle}
    """
    if name.endswith("_dot"):
        return rf"\dot{{{latex_symbol(name.removesuffix('_dot'))}}}"
    base, *indices = name.split("_")
    known = base in _GREEK
    shown = rf"\{base}" if known else base if len(base) == 1 else rf"\mathrm{{{base}}}"
    index = ",".join(part if re.fullmatch(r"\d+|\w", part) else rf"\mathrm{{{part}}}" for part in indices if part)
    return shown + (f"_{{{index}}}" if index else "")


def _component(key: str, names: Sequence[str]) -> str | None:
    return names[int(key[3:]) - 1] if key.startswith("xi_") else None
