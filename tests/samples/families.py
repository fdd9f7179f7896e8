"""The paper's model system with p any function of one component q and a parameter k: its spots are known."""

from __future__ import annotations

from gspot_verified.mechanisms.input.given import from_fields
from gspot_verified.mechanisms.input.mechanism import Mechanism


def family(p: str, q: str, k: str = "1", **others: str) -> Mechanism:
    """dq/dt = -1, so α_1 = -∂p/∂q, α_2 = -1, α_3 = -3/2; a spot is sought near ``q`` at the parameter value ``k``."""
    mu = f"1 - ({p})"
    return from_fields(
        f"p = {p}", ["x", "u", "y", "v", "q", "b"],
        ["u", "0", "v", "b", "-1", "-1"],
        ["0", f"3/(2*({mu}))", "0", "1/2", "0", f"-3/(4*({mu}))"],
        ["0", "1/2", "0", f"(1 + ({p}))/2", "0", "3/4"],
        x="x", y="y", mu=mu, parameters={"k": k, **others},
        place={"x": 0, "u": 1, "y": 0, "v": 0, "q": q, "b": 0}, search=True, fixed=["x", "u"],
    )  # fmt: skip


def three_alphas(
    first: str, second: str, third: str, slip: str = "1", inertia: str = "1", k: str = "0", other: str = "0"
) -> Mechanism:
    """The model system with α_1, α_2, α_3 any functions of parameters k, l; the spot is at 0, with u = ``slip``.

    A is 3/2 times ``inertia`` there and A C - B^2 is (3 inertia - 1)/4; no α depends on it. l is ``other``.
    """
    return from_fields(
        "three alphas", ["x", "u", "y", "v", "p", "b"],
        ["u", "0", "v", "b", first, second],
        ["0", f"3*({inertia})/(2*(1 - p))", "0", "1/2", "0", f"({third})/(2*(1 - p))"],
        ["0", "1/2", "0", "(1 + p)/2", "0", f"-({third})/2"],
        x="x", y="y", mu="1 - p", parameters={"k": k, "l": other},
        place={"x": 0, "u": slip, "y": 0, "v": 0, "p": 0, "b": 0}, fixed=["x", "u"],
    )  # fmt: skip
