"""Typed formulas of Sections 5 and 6 and of the appendices: the general system, the oscillator, Θ."""

from __future__ import annotations

from collections.abc import Callable

from paper.typed.row import CONSTANTS, Names, Parts, Row, difference, of_side, order_of, rows

from gspot_verified.paper.appendix_a import hypergeometric as appendix
from gspot_verified.paper.section_5 import (
    example,
    section_5_ansatz,
    section_5_matching,
    section_5_outer,
    section_5_recursion,
    section_5_right_sides,
)
from gspot_verified.paper.section_5.explicit_expansions import SPACES
from gspot_verified.paper.section_5.section_5_spaces import COROLLARY
from gspot_verified.paper.section_6 import oscillator


def _sum(parts: Parts, of: str, with_: str, prefix: str = "") -> str:
    """Σ as it is printed with the typed bounds and indices."""
    first, last, left, right = (parts[prefix + name].replace(" ", "") for name in ("first", "last", "left", "right"))
    return rf"\sum_{{k={first.replace('0*k', '0')}}}^{{{last}}}{of}_{{{left}}}{with_}_{right}"


def _section_5() -> list[Row]:
    recursion = section_5_recursion.PRINTED
    tilde = CONSTANTS | {
        r"\tilde{p}": "p",
        r"\tilde{\xi}^\prime": "xi1",
        r"\tilde{p}^\prime": "p1",
        r"F(\xi)": "f",
        r"G(\xi)": "g",
    }
    tilde |= {rf"\tilde{{{name}}}": f"{name}0" for name in "byvz"} | {
        rf"\tilde{{{name}}}^\prime": f"{name}1" for name in "byvz"
    }
    tilde |= {rf"\alpha_{k}(\xi)": f"a{k}" for k in (1, 2, 3)}
    lines = ("specialX", "specialPP", "specialB", "specialY", "specialV", "specialZ", "specialL")
    found = rows(
        "5-inner-system",
        recursion,
        tilde,
        *((part, 1397 + k, 1397 + k, 0, difference) for k, part in enumerate(lines)),
    )
    without_tilde = tilde | {r"\tilde{F}(\xi)": "f", r"\tilde{G}(\xi)": "g"}
    found += rows(
        "5-inner-slow",
        section_5_right_sides.PRINTED,
        without_tilde,
        *((part, 2039 + k, 2039 + k, 0, difference) for k, part in enumerate(lines[:5])),
    )
    start = CONSTANTS | {rf"\tilde{{{name}}}(0,\delta)": name for name in "pbyv"}
    start |= {rf"\{name}{name.upper()}(\xi^*+\delta^2\tilde{{\xi}}(0,\delta))": name.upper() for name in "pbyv"}
    found += rows(
        "5-scaled-start",
        recursion,
        start,
        *((part, 1415 + 2 * k, 1416 + 2 * k, 0, of_side(0)) for k, part in enumerate("PBYV")),
    )
    orders, last = recursion["5-orders"], recursion["5-xinprime"]
    nth = CONSTANTS | {
        r"\lambda_n": "l0",
        r"p_n^\prime": "p1",
        r"{\alpha_1}_n": "a1n",
        r"{\alpha_2}_n": "a2n",
        "r_{b,n}(s)": "r0",
        "r_{b,n}": "r0",
        "r_{v,n}": "w0",
        "F_n": "fn",
    }
    for k in range(4):
        prime = r"^{" + r"\prime" * k + "}" if k > 1 else r"^\prime" * k
        nth |= {f"{name}_n{prime}": f"{name}{k}" for name in "byvz"} | {
            f"z_{{n-1}}{prime}": f"q{k}",
            f"r_{{b,n}}{prime}": f"r{k}",
        }
    nth |= {
        _sum(orders, r"{\alpha_3}", r"\lambda", "b "): "S",
        _sum(orders, "p", r"\lambda", "v "): "S",
        _sum(last, "G", r"\lambda"): "S",
    }
    found += rows(
        "5-orders",
        recursion,
        nth,
        ("P", 1603, 1606, 0, of_side(0)),
        ("r_p", 1603, 1606, 0, of_side(1)),
        ("B", 1615, 1620, 0, of_side(0)),
        ("r_b", 1615, 1620, 0, of_side(1)),
        ("Y", 1626, 1628, 0, of_side(0)),
        ("V", 1630, 1633, 0, of_side(0)),
        ("r_v", 1630, 1633, 0, of_side(1)),
        ("Z", 1641, 1643, 0, of_side(0)),
        ("r_z", 1641, 1643, 0, of_side(1)),
        ("L", 1645, 1647, 0, of_side(0)),
    )
    found += rows(
        "5-third-order",
        recursion,
        nth,
        ("specialYnbis", 1658, 1661, 0, difference),
        ("line 1667", 1666, 1668, 0, difference),
        ("third-order_b", 1671, 1674, 0, difference),
    )
    found += rows(
        "5-monomial", recursion, CONSTANTS | {"s^k": "u3", "s^{k-3}": "u0"}, ("image", 1690, 1692, 0, of_side(0))
    )
    found += rows(
        "5-step-3",
        recursion,
        nth,
        *((part, 1704 + k, 1704 + k, 0, of_side(1)) for k, part in enumerate(("y", "v", "lambda", "z"))),
    )
    found += rows("5-xinprime", recursion, nth, ("right side", 1714, 1717, 0, of_side(2)))
    series = example.PRINTED
    rows_of_series = (("p", 1848, 1852), ("b", 1853, 1858), ("y", 1859, 1864), ("v", 1865, 1869), ("z", 1870, 1875))
    for name, first, until in rows_of_series:
        found += rows(f"5-example-{name}", series, CONSTANTS, ("series", first, until, 0, of_side(1)))
        entry = "5-example-b-error" if name == "b" else f"5-example-{name}"
        found += rows(entry, series, CONSTANTS, ("error", first, until, 0, order_of(1)))
    rest = CONSTANTS | {r"\mathcal{O}(t^4,\eps t^2,\eps^2t,\eps^3)": "0"}
    zbar = series["5-example-zbar"]
    for part, first, until, side, size in (
        ("scaled", 1896, 1901, 2, "delta^6"),
        ("first", 1902, 1904, 0, "epsilon^2"),
        ("second", 1905, 1906, 0, "epsilon^2"),
    ):
        found.append(
            Row(
                "5-example-zbar",
                part,
                zbar,
                first,
                until,
                0,
                of_side(side),
                rest,
                lambda p, part=part, size=size: f"{size}*({p[part]})",
            )
        )
    found.append(Row("5-example-zbar", "error", zbar, 1896, 1901, 0, order_of(2), rest, lambda p: p["error"]))
    spaces = CONSTANTS | {"P_": "1", r"\nu": "nu", r"\sigma": "sigma", "K": "1"}
    places = {"p": 2, "b": 2, "xi": 2, "y": 4, "z": 4, "v": 5, "lambda_n": 6}
    for first, parity in ((1510, 0), (1517, 1)):
        for part, piece in places.items():
            shift = str(SPACES[part][parity])
            found.append(
                Row(
                    "5-theorem-1-spaces",
                    f"{part}, parity {parity}",
                    {"shift": shift},
                    first,
                    first + 5,
                    piece,
                    of_side(1),
                    spaces,
                    lambda p: f"nu+({p['shift']})",
                )
            )
    for first, parity, highest in ((1818, "even", r"\nu+1"), (1830, "odd", r"\nu-3")):
        named = spaces | {rf"\sum_{{0\leq\sigma\leq({highest})/3}}": "1"}
        lowered = highest.replace("+1", "-2").replace("-3", "-6")
        named |= {rf"\sum_{{\rho={highest},{lowered},...}}": "1", r"\rho": "rho"}
        by_side: tuple[Callable[[Parts], str], ...] = (
            lambda p: f"t^rho*delta^({p['delta by rho']})",
            lambda p: f"delta^({p['delta by sigma']})*t^({p['t']})",
            lambda p: f"epsilon^({p['epsilon']})*t^({p['t']})",
        )
        found += [
            Row(
                *("5-corollary", f"{parity}, side {k}", COROLLARY[parity], first, first + 10, 0, of_side(k)),
                names=named,
                typed=typed,
            )
            for k, typed in enumerate(by_side)
        ]
    system = section_5_outer.PRINTED
    slow = (
        CONSTANTS
        | {f"{name}_o": name for name in "yvz"}
        | {r"F(\xi)": "F", r"G(\xi)": "G"}
        | {rf"\alpha_{k}(\xi)": f"alpha{k}" for k in (1, 2, 3)}
    )
    outer = slow | {r"F(\xi)": "f", r"G(\xi)": "g"} | {rf"\alpha_{k}(\xi)": f"a{k}" for k in (1, 2, 3)}
    for k, part in enumerate(("xi", "p", "b", "y", "v", "z", "lambda")):
        found += rows("5-outer-system", system, outer, (part, 1928 + k, 1928 + k, 0, of_side(1)))
    for row, part in enumerate("yvz"):
        found.append(
            Row(
                "5-fast-system",
                part,
                system["5-fast-system"],
                1950 + row,
                1950 + row,
                0,
                lambda sides: f"({sides[0]})*y+({sides[1]})*v+({sides[2]})*z",
                slow,
                layout="row",
            )
        )
    found += rows("5-fast-polynomial", system, CONSTANTS, ("polynomial", 1956, 1958, 0, of_side(0)))
    for part, line in (("y", 1969), ("v", 1970), ("z", 1971), ("xi", 1975), ("p", 1976), ("b", 1977)):
        found += rows("5-slow-manifold", system, slow, (part, line, line, 0, of_side(1, "p")))
    ansatz = section_5_ansatz.PRINTED
    zero = CONSTANTS | {
        r"(-t)^{r-1}": "1",
        r"(-t)^{r}": "1",
        "G^*": "G",
        r"{\alpha_1}_\xi^*": "m",
        r"\xi_0": "xi0",
        "p_0": "p0",
        "b_0": "b0",
        r"\lambda_0": "lambda0",
    }
    found += rows(
        "5-ansatz",
        ansatz,
        zero,
        *((part, 2013 + k, 2013 + k, 0, of_side(0)) for k, part in enumerate(("xi", "p", "b", "balance"))),
    )
    found += rows(
        "5-ansatz-solution",
        ansatz,
        zero,
        ("alpha3 xi0", 2021, 2021, 0, of_side(1, "alpha3")),
        ("alpha1 lambda0", 2023, 2023, 0, of_side(1, "alpha1")),
    )
    found += rows("5-ansatz-p0", ansatz, zero, ("alpha3 (r+1) p0", 2022, 2022, 0, of_side(1)))
    matching = section_5_matching.PRINTED
    hatted = CONSTANTS | {
        r"\hat{b}": "g0",
        r"\hat{y}": "y",
        r"\hat{v}": "v",
        r"\hat{b}^\prime": "g1",
        r"\hat{b}^{\prime\prime\prime}": "g3",
    }
    for k, part in enumerate(("b'", "y'", "v'")):
        found += rows("5-perturbation", matching, hatted, (part, 2064 + k, 2064 + k, 0, of_side(1)))
    found += rows("5-perturbation", matching, hatted, ("third order", 2069, 2071, 0, of_side(0)))
    found.append(
        Row(
            "5-perturbation-theta",
            "kappa cubed",
            matching["5-perturbation-theta"],
            2072,
            2072,
            1,
            lambda sides: f"({sides[1]})^3",
            CONSTANTS,
            layout="inline",
        )
    )
    found.append(
        Row(
            "5-matching",
            "powers",
            matching["5-matching"],
            2081,
            2083,
            0,
            of_side(1),
            CONSTANTS | {"b_0": "1", r"\Theta(\kappa s,\beta)": "1"},
            lambda p: f"kappa^({p['power of kappa']})*epsilon^({p['power of epsilon']})",
        )
    )
    return found


def _oscillator() -> list[Row]:
    printed = oscillator.PRINTED
    names = CONSTANTS | {
        r"\phi-\phi_0": "e",
        r"\dot{\phi}": "w",
        r"\dot{\psi}": "x",
        r"\psi": "psi",
        r"\sin(\phi)": "S",
        r"\cos(\phi)": "C",
        "m_1": "m1",
        "m_2": "m2",
        r"M^{-1}": "1",
        "Q_N": "QN",
        "Q_T": "QT",
        r"\frac{g}{l}": "om^2",
    }
    for angle in ("phi", "psi"):
        for index in (rf"_\{angle}", rf"_{{\{angle}}}"):
            names |= {f"{kind}{index}": f"{kind}{angle}" for kind in "kc"}

    def reduced(text: str) -> str:
        for name, value in (("I", "(1/m1)"), ("J", "(1/l)"), ("R", "(1/(m2+m1*C^2))")):
            text = text.replace(name, value)
        return text

    def row(
        entry: str, part: str, first: int, last: int, piece: int, side: int, layout: str = "display", **more: str
    ) -> Row:
        return Row(
            entry,
            part,
            printed[entry],
            first,
            last,
            piece,
            of_side(side),
            names | more,
            lambda p: reduced(p[part]),
            layout,
        )

    found = [
        row("6-motion", part, 2120, 2122, k, -1, "matrix") for k, part in enumerate(("M11", "M12", "M21", "M22"), 2)
    ]
    found += [row("6-motion", part, 2123, 2126, k, -1) for k, part in enumerate(("f1", "f2"))]
    found += [
        row("6-motion", part, first, first + 2, k, -1)
        for first, q in ((2127, "QT"), (2130, "QN"))
        for k, part in enumerate((f"{q}1", f"{q}2"))
    ]
    found += [row("6-motion", part, 2135, 2137, k, 1) for k, part in enumerate("xy")]
    unit = {r"\sqrt{\frac{g}{l}}": "om", r"\sqrt{gl}": "l*om", r"\phi^*": "0", r"\kappa": "kappa"}
    given = ("m2", "mu", "e", "kphi", "cphi", "kpsi", "cpsi")
    for table, first, last, keys in (
        (oscillator.PARAMETERS, 2155, 2161, given),
        (oscillator.G_SPOT, 2169, 2174, ("C", "S", "w", "psi", "x")),
    ):
        for k, part in enumerate(keys):
            found.append(
                Row(
                    "6-alpha_1",
                    part,
                    table,
                    first,
                    last,
                    k,
                    of_side(1, "-1" if part == "e" else "1"),
                    names | unit,
                    lambda p, part=part: reduced(p[part]),
                )
            )
    found += [row("6-sign-of-G", "M G", 2147, 2147, 2, 0)]
    root = {r"\sqrt{\frac{g}{l}}": "om"}
    found += [row("6-alpha_1", "value", 2177, 2177, 0, 1, **root), row("6-alpha_3", "value", 2177, 2178, 1, 1, **root)]
    found += [row("6-alpha_2", "value", 2179, 2179, 0, 1, **root, g="l*om^2")]
    places = {
        "B-v": (2505, 2507),
        "B-p": (2508, 2510),
        "B-b": (2511, 2516),
        "B-alpha_1": (2517, 2520),
        "B-alpha_2": (2521, 2543),
        "B-alpha_3": (2544, 2556),
    }
    return found + [row(entry, "formula", *place, 0, 1) for entry, place in places.items()]


def _appendix_a() -> list[Row]:
    names = CONSTANTS | {
        r"(-\tau)": "x",
        r"(-\tau)^{3/2}": "lam",
        r"\tau^{3/2}": "lam",
        r"(\tau)": "tau",
        r"\sum_{k=0}^\infty": "1",
        r"c_k(\beta)": "1",
        r"h(\tau,\beta)": "1",
        r"e_1(\tau,\beta)": "1",
        r"e_r(\tau,\beta)": "1",
        r"e_i(\tau,\beta)": "0",
    }
    h, real, imaginary = (
        names | {r"h(\tau,\beta)": a, r"e_r(\tau,\beta)": b, r"e_i(\tau,\beta)": c}
        for a, b, c in (("1", "0", "0"), ("0", "1", "0"), ("0", "0", "1"))
    )

    def row(
        entry: str,
        part: str,
        table: Parts,
        first: int,
        last: int,
        side: int,
        read: Names = names,
        piece: int = -1,
        typed: str = "",
    ) -> Row:
        return Row(
            entry,
            part,
            table,
            first,
            last,
            piece,
            of_side(side),
            read,
            (lambda _: typed) if typed else None,
            "closed form",
        )

    series, small, large = appendix.SERIES, appendix.SMALL, appendix.LARGE
    found = [
        row("A-leading", "h", series, 2404, 2407, 1),
        row("A-bsmall1", "e", series, 2410, 2414, 1),
        row("A-blarge1", "e_1", series, 2468, 2471, 1),
    ]
    fronts = {r"\theta(0)": "1", r"\frac{d}{d\tau}\theta(0)": "1", r"\frac{d^2}{d\tau^2}\theta(0)": "1"}
    for j in range(3):
        for k, name in enumerate(("front", "upper", "lower", "other lower", "argument")):
            part = name if name == "argument" else f"{name} {j}"
            side = 1 if j == k == 0 else 0
            found.append(
                Row(
                    "A-th3",
                    part,
                    appendix.FUNCTIONS,
                    2383,
                    2387,
                    5 * j + k,
                    of_side(side),
                    CONSTANTS | fronts,
                    layout="1F2",
                )
            )
    for j, (first, last) in enumerate(((2423, 2428), (2429, 2434), (2435, 2440))):
        found.append(row(f"A-bsmall{j + 1}", f"h {j}", small, first, last, -1, h))
        for part, read in (("real", real), ("imaginary", imaginary)):
            found.append(
                row(
                    f"A-bsmall{j + 1}",
                    f"{part} {j}",
                    small,
                    first,
                    last,
                    -1,
                    read,
                    typed=f"({small[f'e {j}']})*({small[f'{part} {j}']})",
                )
            )
    for j, first in enumerate((2474, 2479, 2484)):
        found.append(row(f"A-blarge{j + 1}", f"factor {j}", large, first, first + 4, -1))
    found += [
        row(f"A-{label}", label, appendix.INITIAL_VALUES, 2453 + j, 2453 + j, 1)
        for j, label in enumerate(appendix.INITIAL_VALUES)
    ]
    theta = appendix.THETA
    found += [
        row("A-leading", "small front", theta, 2458, 2460, 1),
        row("A-leading", "small leading", theta, 2458, 2460, 2),
    ]
    found += [
        row("A-tlarge", "large front", theta, 2494, 2499, 1),
        row("A-tlarge", "large leading", theta, 2494, 2499, 2),
    ]
    return found


ROWS = [*_section_5(), *_oscillator(), *_appendix_a()]
