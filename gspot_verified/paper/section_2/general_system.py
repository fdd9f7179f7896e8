"""Ledger of the equations of p, b, y, v in positive slip (Sec. 2).

r is λ_N; LFp, LGp, ... are Lie derivatives along F and G.
"""

from __future__ import annotations

from collections.abc import Iterable
from operator import mul

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts

ALGEBRA = Algebra("p b r v y alpha1 alpha2 alpha3 LFp LGp LFb LGb LFy LGy LFv LGv c s w g k mu W Y U X F T N lamT B C")
PRINTED = {"p": "alpha1", "b": "alpha2 - alpha3*r", "y": "v", "v": "b + p*r"}
DEFINED = {"LFp": "alpha1", "LFb": "alpha2", "LGb": "-alpha3", "LFy": "v", "LFv": "b", "LGv": "p"}
"""What p, b, v and the α's of Sec. 2 are."""
LAGRANGIAN = {"LGp": "0*p", "LGy": "0*p"}
"""Eqs. lagrangian1 and lagrangian2: the force does not change y and p at once."""
SYSTEM = {"rate": "F + T*lamT + N*r", "in slip": "F + (N - mu*T)*r"}
"""Eqs. genTN and genx with G = G_N - μ G_T; T is G_T, N is G_N."""
COULOMB = {"lamT": "-mu*r"}
"""In positive slip."""
PARAMETER = "C - mu*B"
"""p of Sec. 1, line 170."""
ALONG = {"F": "0*F", "T": "B", "N": "C"}
"""What G_T and G_N do to v: B and C."""

MODEL = {"p": "alpha1", "b": "alpha2 - alpha3*r", "y": "v", "v": "b + p*r"}
"""Eqs. modelsys1 to modelsys4: the α's are constants."""

MECHANISM = Algebra("w1 w2 m11 m12 m22 f1 f2 t1 t2 n1 n2 mu lamT lam xt yt k1 k2")
"""A mechanism with two coordinates: functions of them and of t but for the velocities w and the forces f, λ_T, λ_N."""
PUSHES = ("(f1 + t1*lamT + n1*lam)", "(f2 + t2*lamT + n2*lam)")
MOTION = {
    "q1": "w1", "q2": "w2",
    "w1": f"m22*{PUSHES[0]} - m12*{PUSHES[1]}", "w2": f"m11*{PUSHES[1]} - m12*{PUSHES[0]}",
}  # fmt: skip
"""The rates of the coordinates and, times det M, of the velocities: M q'' = f + t λ_T + n λ_N."""
SLOPES = {"x": ("t1", "t2", "0", "0"), "y": ("n1", "n2", "0", "0")}
"""The slopes of x and of y in q1, q2, w1, w2: functions of the coordinates and of t alone."""
NORMAL = {"v": "n1*w1 + n2*w2 + yt"}
TANGENTIAL = {"u": "t1*w1 + t2*w2 + xt"}
STATE = ("q1", "q2", "w1", "w2")
_TANGENTIAL_TO_NORMAL = "m22*t1*n1 - m12*(t1*n2 + t2*n1) + m11*t2*n2"
INNER_PRODUCTS = (
    ("u", "lamT", "m22*t1^2 - 2*m12*t1*t2 + m11*t2^2"),
    ("u", "lam", _TANGENTIAL_TO_NORMAL),
    ("v", "lamT", _TANGENTIAL_TO_NORMAL),
    ("v", "lam", "m22*n1^2 - 2*m12*n1*n2 + m11*n2^2"),
)
"""A, B, B and C times det M, as inner products of the gradients t of x and n of y, by the adjugate of M."""
FRICTION = {"mu": "mu"}
"""A function of the coordinates and of t."""

NEWTON = {"c": "-s*w", "s": "c*w", "w": "-k*(c - mu*s)*r", "W": "-g + r", "Y": "W"}
"""The sliding rod of mass and half length 1: the rates of cos, sin and speed of its angle, and of its centre's speed W
and height Y. The contact is at (c, -s) from the centre, k is 1 over the moment of inertia.
"""
ROD = {
    "p": "1 + k*c*(c - mu*s)", "b": "s*w^2 - g", "y": "Y - s", "v": "W - c*w",
    "alpha1": "k*w*(mu*(s^2 - c^2) - 2*c*s)", "alpha2": "c*w^3", "alpha3": "2*k*s*w*(c - mu*s)",
}  # fmt: skip
"""p, b and the α's of the rod, by hand."""


FORCES = {"T": {"w": "-k*s", "U": "1+0*k"}, "N": {"w": "-k*c", "W": "1+0*k"}}
"""G_T and G_N of the rod: λ_T and λ_N turn it, and push its centre with the speeds U and W."""
PLACES = {"x": "X + c", "y": "Y - s"}
"""Its contact point, with the centre at X, Y."""
SPEEDS = {"u": "U - s*w", "v": "W - c*w"}
"""The rates of its place."""


def defined(text: str) -> fmpq_mpoly:
    """A formula in Lie derivatives, in the quantities of Sec. 2."""
    images = {name: ALGEBRA.read(value) for name, value in {**DEFINED, **LAGRANGIAN}.items()}
    return ALGEBRA.substitute(ALGEBRA.read(text), images)


def pushed(force: str) -> list[fmpq_mpoly]:
    """The field of a force in q1, q2, w1, w2 (w times det M): "lamT", "lam", or that of positive slip, "slip"."""
    rates = [MECHANISM.read(MOTION[name]) for name in STATE]
    if force != "slip":
        return [rate.derivative(force) for rate in rates]
    return [rate.derivative("lam") - MECHANISM.read(FRICTION["mu"]) * rate.derivative("lamT") for rate in rates]


def painleve_parameter() -> fmpq_mpoly:
    """The function p = L_G v times det M."""
    return _changed(MECHANISM.read(NORMAL["v"]), "slip")


def _changed(value: fmpq_mpoly, force: str) -> fmpq_mpoly:
    """The Lie derivative of a function with the slopes k1, k2 in the coordinates."""
    slopes = [*(MECHANISM.symbols[name] for name in ("k1", "k2")), *(value.derivative(name) for name in STATE[2:])]
    return _summed(slopes, force)


def _summed(slopes: Iterable[fmpq_mpoly], force: str) -> fmpq_mpoly:
    """The slopes in q1, q2, w1, w2 times the parts of a field."""
    return sum(map(mul, slopes, pushed(force)), start=MECHANISM.constant(0))


def of_two_coordinates() -> bool | None:
    """Whether λ_T and λ_N change neither x nor y at once, and the force of positive slip does not change p.

    From the equations of motion: the rates of the coordinates have no force, and p has no velocity. det M is a function
    of the coordinates, as p is.
    """
    places = [
        _summed((MECHANISM.read(f"{slope} + 0*mu") for slope in row), force)
        for row in SLOPES.values()
        for force in ("lamT", "lam")
    ]
    return all(value.is_zero() for value in (*places, _changed(painleve_parameter(), "slip")))


def of_each_coordinate() -> bool | None:
    """The same for what one coordinate adds where M is diagonal, in any number of them.

    It adds nothing to L_G x and L_G y for either force, and to p = L_G v nothing with a velocity.
    """
    return all(_adds_nothing_at_once(place, velocity) for place, velocity in (("q1", "w1"), ("q2", "w2")))


def _adds_nothing_at_once(place: str, velocity: str) -> bool:
    none = {"m12": MECHANISM.constant(0)}
    own = {name: MECHANISM.substitute(MECHANISM.read(MOTION[name]), none) for name in (place, velocity)}
    pushed_by = {force: {name: rate.derivative(force) for name, rate in own.items()} for force in ("lamT", "lam")}
    changes = [
        MECHANISM.read(f"{row[STATE.index(name)]} + 0*mu") * value
        for row in SLOPES.values()
        for push in pushed_by.values()
        for name, value in push.items()
    ]
    push = pushed_by["lam"][velocity] - MECHANISM.read(FRICTION["mu"]) * pushed_by["lamT"][velocity]
    added = MECHANISM.read(NORMAL["v"]).derivative(velocity) * push
    return all(value.is_zero() for value in (*changes, *(added.derivative(name) for name in STATE[2:])))


def one_coefficient() -> bool | None:
    """Whether u' and v' are linear in the forces, with the factors t M^-1 t, t M^-1 n, t M^-1 n, n M^-1 n.

    All times det M: so one B stands in both, and A, B, C are the Lie derivatives along G_T and G_N.
    """
    velocities = {name: MECHANISM.read(text) for name, text in {**TANGENTIAL, **NORMAL}.items()}
    linear = all(
        part.derivative(other).is_zero()
        for force in ("lamT", "lam")
        for part in pushed(force)
        for other in ("lamT", "lam")
    )
    return linear and all(
        bool((_changed(velocities[velocity], force) - MECHANISM.read(product)).is_zero())
        for velocity, force, product in INNER_PRODUCTS
    )


def one_coefficient_of_each() -> bool | None:
    """The same for the parts that one coordinate adds to u' and v', where M is diagonal: for any number of them.

    No factor of a force has a velocity: M and the gradients are functions of the coordinates and t. Every symmetric M
    is so at one configuration, in coordinates that its eigenvectors make.
    """
    rate = MECHANISM.substitute(MECHANISM.read(MOTION["w1"]), {"m12": MECHANISM.constant(0)})
    parts = {name: MECHANISM.read(text).derivative("w1") * rate for name, text in {**TANGENTIAL, **NORMAL}.items()}
    curved = [
        part.derivative(force).derivative(other)
        for part in parts.values()
        for force in ("lamT", "lam")
        for other in ("lamT", "lam")
    ]
    moving = [
        part.derivative(force).derivative(velocity)
        for part in parts.values()
        for force in ("lamT", "lam")
        for velocity in STATE[2:]
    ]
    same = parts["u"].derivative("lam") - parts["v"].derivative("lamT")
    return same.is_zero() and all(value.is_zero() for value in (*curved, *moving))


def one_coefficient_of_the_rod() -> bool | None:
    """The same for the rod, from its forces and the velocity of its contact point."""
    fields = {name: {key: ALGEBRA.read(text) for key, text in field.items()} for name, field in FORCES.items()}
    u, v = (ALGEBRA.read(SPEEDS[name]) for name in "uv")
    return bool((ALGEBRA.derivative(u, fields["N"]) - ALGEBRA.derivative(v, fields["T"])).is_zero())


def of_the_rod() -> bool | None:
    """Whether x, y and p of the rod are not changed at once by λ_T, λ_N, and p by the force of positive slip."""
    fields = {name: {key: ALGEBRA.read(text) for key, text in field.items()} for name, field in FORCES.items()}
    turning = fields["N"]["w"] - ALGEBRA.symbols["mu"] * fields["T"]["w"]
    as_in_slip = (turning - ALGEBRA.read(NEWTON["w"]).derivative("r")).is_zero()
    values = [ALGEBRA.read(text) for text in (*PLACES.values(), ROD["p"])]
    return as_in_slip and all(
        ALGEBRA.derivative(value, field).is_zero() for value in values for field in fields.values()
    )


def _at_once() -> Entry:
    return Section("Section 2").settled(
        "2-at-once",
        "eq:lagrangian1, eq:lagrangian2",
        r"\mathcal L_{G_T}x=\mathcal L_{G_N}x=\mathcal L_{G_T}y=\mathcal L_{G_N}y=0,\ \mathcal L_Gp=0",
        "Forces change accelerations alone, and x, y and p depend on the coordinates and t alone (for a μ that does): "
        "so L_{G_T} x = L_{G_N} x = L_{G_T} y = L_{G_N} y = 0 and L_G p = 0",
        Rung.EXACT.check(
            "where the mass matrix is diagonal: the rate of each coordinate has no force, and what it adds to "
            "p = L_G v has no velocity, for any number of coordinates",
            of_each_coordinate(),
        ),
        Rung.POINTS.check(
            "the equations of motion of two coordinates, with symbols for M, the gradients of x and y, and μ: the "
            "rates of the coordinates have no force, and p = L_G v has no velocity",
            of_two_coordinates(),
        ),
        Rung.POINTS.check(
            "the rod that slides, with its tangential and its normal force: in every state of this mechanism",
            of_the_rod(),
        ),
        note="p = C - μB, where B and C are inner products of the gradients of x and y (1-mass-matrix). Every mass "
        "matrix is diagonal at one configuration, in coordinates that its eigenvectors make.",
    )


def _projected() -> Entry:
    return Section("Section 2").settled(
        "2-projected",
        "eqs. udynamics, vdynamics, lines 448 to 453",
        r"\dot u=a+\lambda_TA+\lambda_NB,\ \dot v=b+\lambda_TB+\lambda_NC,\quad"
        r"A=\mathcal L_{G_T}u,\ B=\mathcal L_{G_N}u=\mathcal L_{G_T}v,\ C=\mathcal L_{G_N}v",
        "M q'' = f + t λ_T + n λ_N with a positive definite mass matrix of any size, t and n the gradients of x and y: "
        "du/dt and dv/dt are linear in λ_T and λ_N, with a = L_F u and b = L_F v as the parts without a force; one B "
        "stands in both, L_{G_N} u = L_{G_T} v, and A, B and C are functions of the coordinates and t, as M, t and n "
        "are; a and b may have the velocities too",
        Rung.EXACT.check(
            "where the mass matrix is diagonal: what each coordinate adds to du/dt and dv/dt, for any number of "
            "coordinates; no factor of a force has a velocity",
            one_coefficient_of_each(),
        ),
        Rung.POINTS.check(
            "the equations of motion of two coordinates, with symbols for M and the gradients of x and y; A, B and C "
            "are t M^-1 t, t M^-1 n and n M^-1 n there",
            one_coefficient(),
        ),
        Rung.POINTS.check("the rod that slides, in every state of this mechanism", one_coefficient_of_the_rod()),
        note="Every mass matrix is diagonal at one configuration, in coordinates that its eigenvectors make. That a "
        "and b are the parts without a force is how F is defined: the field for λ_T = λ_N = 0. Signs of A, C and AC "
        "- B²: 1-mass-matrix.",
    )


def not_pushed_by_both_forces() -> list[fmpq_mpoly]:
    """The factor of λ_N in the speeds of the rod less G_N - μ G_T: 0 where λ_T is -μ λ_N."""
    fields = {name: {key: ALGEBRA.read(text) for key, text in field.items()} for name, field in FORCES.items()}
    none = ALGEBRA.constant(0)
    return [
        ALGEBRA.read(NEWTON[name]).derivative("r")
        - fields["N"].get(name, none)
        + ALGEBRA.symbols["mu"] * fields["T"].get(name, none)
        for name in ("w", "W")
    ]


def slip_field() -> list[fmpq_mpoly]:
    """Eq. genTN with λ_T = -μ λ_N less eq. genx, and the factor of λ_N that G_N - μ G_T gives dv/dt less C - μB."""
    images = {name: ALGEBRA.read(text) for name, text in COULOMB.items()}
    general, slip = (ALGEBRA.read(SYSTEM[name]) for name in ("rate", "in slip"))
    parameter = ALGEBRA.substitute(slip.derivative("r"), {name: ALGEBRA.read(text) for name, text in ALONG.items()})
    return [
        ALGEBRA.substitute(general, images) - slip,
        parameter - ALGEBRA.read(PARAMETER),
    ]


def parameter_of_two_coordinates() -> bool | None:
    """Whether L_G v of two coordinates is C - μB, with B and C as inner products of the gradients, times det M."""
    products = {f"{speed} {force}": MECHANISM.read(text) for speed, force, text in INNER_PRODUCTS}
    expected = products["v lam"] - MECHANISM.read(FRICTION["mu"]) * products["v lamT"]
    return bool((painleve_parameter() - expected).is_zero())


def _slip_equations() -> Entry:
    this = Claim(ALGEBRA, PRINTED)

    def along_the_field(parts: Parts) -> list[fmpq_mpoly]:
        return [*slip_field(), *(defined(f"LF{name} + r*LG{name}") - parts[name] for name in "pbyv")]

    def sliding_rod(parts: Parts) -> list[fmpq_mpoly]:
        rates = {name: ALGEBRA.read(text) for name, text in NEWTON.items()}
        images = {name: ALGEBRA.read(text) for name, text in ROD.items()}
        along = [ALGEBRA.derivative(images[name], rates) - ALGEBRA.substitute(parts[name], images) for name in "pbyv"]
        return [*along, *not_pushed_by_both_forces()]

    return Section("Section 2").settled(
        "2-slip-equations",
        "eqs. genTN, genx, lines 473 to 476, gensys2 to gensys5",
        r"\dot p=\alpha_1,\ \dot b=\alpha_2-\alpha_3\lambda_N,\ \dot y=v,\ \dot v=b+p\lambda_N",
        "In positive slip, λ_T = -μ λ_N, eq. genTN is eq. genx with G = G_N - μ G_T, so that L_G v is C - μB; by the "
        "definitions of Sec. 2 and the two Lagrangian relations p, b, y, v then satisfy eqs. gensys2 to gensys5",
        this.check(
            "λ_T = -μ λ_N put into eq. genTN; L_G v with B = L_{G_T} v, C = L_{G_N} v; the derivatives along F + λ_N G",
            along_the_field,
        ),
        this.check(
            "the rod that slides, by Newton's law: in every state of this mechanism; the factor G_N - μ G_T of its λ_N",
            sliding_rod,
            Rung.POINTS,
        ),
        Rung.POINTS.check(
            "the equations of motion of two coordinates: L_G v is C - μB, with B and C by M^-1",
            parameter_of_two_coordinates(),
        ),
    )


def _motivating() -> Entry:
    this = Claim(ALGEBRA, MODEL)

    def of_the_general_system(parts: Parts) -> list[fmpq_mpoly]:
        return [parts[name] - ALGEBRA.read(PRINTED[name]) for name in "pbyv"]

    def of_its_fields(parts: Parts) -> list[fmpq_mpoly]:
        linear = [value.derivative("r").derivative("r") for value in parts.values()]
        push = {name: value.derivative("r") for name, value in parts.items()}
        rest = {name: parts[name] - push[name] * ALGEBRA.symbols["r"] for name in parts}
        along = {"LF": rest, "LG": push}
        stated = {**DEFINED, **LAGRANGIAN}
        return [
            *linear,
            *(
                ALGEBRA.derivative(ALGEBRA.symbols[key[2]], along[key[:2]]) - ALGEBRA.read(stated[key])
                for key in stated
            ),
        ]

    return Section("Section 2").settled(
        "2-motivating",
        "eqs. modelsys1 to modelsys4, lines 588 to 596",
        r"\dot p=\alpha_1^*,\ \dot b=\alpha_2^*-\alpha_3^*\lambda_N,\ \dot y=v,\ \dot v=b+p\lambda_N",
        "With constant α_1, α_2, α_3 the equations of p, b, y, v in positive slip are those of the motivating example; "
        "and as a general system with the state (p, b, y, v) this has these p, b and α's by the definitions of Sec. 2",
        this.check("constants put into gensys2 to gensys5", of_the_general_system),
        this.check("L_F and L_G of p, b, y and v, with F and G read off the example", of_its_fields),
        note="Eq. modelsys5 is eq. compl1 as it stands (2-compliant).",
    )


ENTRIES: Builders = {
    "2-projected": _projected,
    "2-at-once": _at_once,
    "2-slip-equations": _slip_equations,
    "2-motivating": _motivating,
}
"""The general system in positive slip."""
