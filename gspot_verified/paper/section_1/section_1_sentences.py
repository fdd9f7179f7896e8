"""Ledger of Section 1: sentences that other sentences and formulas of the paper contradict, and the slope of an impact.

P is the normal impulse of the compression, r > 0 the coefficient of restitution, s > 0 the rise of v with the impulse
in restitution.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Check, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.formulas import mended
from gspot_verified.paper.checks.identities import Algebra, rising_signs
from gspot_verified.paper.checks.words import Place, held_against
from gspot_verified.paper.section_1 import section_1_negative_p
from gspot_verified.paper.section_2.section_2_contact import CONSTANTS

SECTION = Section("Section 1")
ALGEBRA = Algebra("r P s A B C mu p T dP a b lamT lam u m k x")
_SYMBOLS = ALGEBRA.symbols
STIFFNESS = {"printed": 2, "corrected": -2}
"""The power of ε that the stiffness of the surface scales like."""
IMPULSE = {"printed": "-r*P", "corrected": "r*P"}
"""The normal impulse in restitution."""
COLOURS = "lines 299 to 301, 347 to 348, 376 to 377, 393 to 396, 1471 to 1472"
IN_THE_TEXT = {
    "Figure 3": Place("Sec. 1.3", r"dashed (\w+) line in Figs"),
    "Figure 4": Place("Sec. 1.4", r"dashed \((\w+)\) line in Fig\.~\\ref\{fig:qual\}"),
    "Figure 3 again": Place("Sec. 5.2", r"dashed \((\w+)\) line in Fig\.~\\ref\{fig:Gspot3\}"),
}
IN_THE_CAPTION = {
    "Figure 3": Place("caption", r"The dashed line \((\w+) online\)"),
    "Figure 4": Place("caption", r"thick dashed \((\w+) online\) line"),
}
"""The colour of the distinguished trajectory."""
SCALARS = "lines 144 to 152, 448 to 453"
LISTED = Place("listed last", r"\$\\c(\w)\$ are scalars")
LAST_OF = {
    "eqs. udynamics and vdynamics": Place("last in eq. vdynamics", r"\\c(\w)\\left\( q,t\\right\)\."),
    "the Lie derivatives of Sec. 2": Place("last of them", r"(\w)=\\mathsterling_\{G_N\} v"),
}
"""The last of the scalars, in the order of the alphabet."""
MIRROR = {"a": "-a", "B": "-B", "lamT": "-lamT"}
"""The tangential direction reversed: u, x, a, B and λ_T change their signs."""
PROJECTED = {"u": "a + lamT*A + lam*B", "v": "b + lamT*B + lam*C"}
"""udynamics and vdynamics."""
FRICTION = {"forwards": "-mu*lam", "backwards": "mu*lam"}
"""λ_T of eq. Coulomb for u > 0 and for u < 0."""
PARAMETER = {"forwards": "C - mu*B", "backwards": "C + mu*B"}
"""dv/dt for each unit of λ_N in positive and in negative slip."""
BOUND = "k*(1 + r)*m"
"""The value of p u at the start, k = μA - B, that divides lift-off in slip from lift-off in stick."""
SLOPE = {"v": "p", "u": "B - mu*A"}
"""The claimed slope dv/du of an impact in positive slip, as a quotient."""
NEAR_THE_G_SPOT = ({"p": "-x"}, {"p": "0*x"}, {"p": "x", "k": "A*x + m"})
"""p <= 0, and p > 0 with A p < k, where k = A C - B² > 0 (1-mass-matrix)."""


def is_the_power_of_the_springs(power: int) -> bool | None:
    """Whether the power is that of k_1 and of k_2."""
    return power == CONSTANTS["k1"] == CONSTANTS["k2"]


def deformation_vanishes(power: int) -> bool | None:
    """Whether the deformation under a given force, the force over the stiffness, has a positive power of ε."""
    return -power > 0


def _stiffness() -> Entry:
    def check(what: str, holds: list[bool | None], finding: str) -> Check:
        return Rung.EXACT.check(what, mended(*holds), finding)

    powers = (STIFFNESS["printed"], STIFFNESS["corrected"])
    return SECTION.settled(
        "1-stiffness",
        "lines 332 to 335",
        r"\text{stiffness scales like }\epsilon^2",
        "The stiffness of the compliant constraint scales like ε²",
        check(
            "eq. compliant3: k_1 = k_2 = 1/ε²",
            [is_the_power_of_the_springs(power) for power in powers],
            f"the power of ε is {CONSTANTS['k1']} (so also in the abstract and in Sec. 1.4)",
        ),
        check(
            "line 557: the deformation under a given force must tend to 0",
            [deformation_vanishes(power) for power in powers],
            f"force over stiffness has the power {-STIFFNESS['printed']} of ε: it grows",
        ),
        corrected="The stiffness scales like 1/ε²",
    )


def has_the_sign(value: fmpq_mpoly) -> bool | None:
    """Whether the value is positive for all positive symbols (True) or negative (False)."""
    return True if rising_signs(value) else False if rising_signs(-value) else None


def impulse_is_positive(form: str) -> bool | None:
    """Whether the impulse in restitution is positive, as λ_N >= 0 asks."""
    return has_the_sign(ALGEBRA.read(IMPULSE[form]))


def leaves(form: str) -> bool | None:
    """Whether v at the end is positive: in restitution it rises from 0 by s times the impulse."""
    return has_the_sign(_SYMBOLS["s"] * ALGEBRA.read(IMPULSE[form]))


def _poisson() -> Entry:
    forms = ("printed", "corrected")
    return SECTION.settled(
        "1-poisson",
        "lines 206 to 208",
        r"\text{the normal impulse in restitution is }-r\text{ times that in compression}",
        "Poisson's impact law: the normal impulse in restitution is -r times that in compression, r > 0",
        Rung.EXACT.check(
            "the normal impulse is an integral of λ_N >= 0 (line 153), in both phases",
            mended(*map(impulse_is_positive, forms)),
            "-r times a positive impulse is negative",
        ),
        Rung.EXACT.check(
            "v⁺ >= 0 (line 199): v rises from 0 with the impulse of the restitution",
            mended(*map(leaves, forms)),
            "v⁺ = -r s P < 0: the contact point would end inside the surface",
        ),
        corrected="The normal impulse in restitution is r times that in compression",
        note="The sentence before has the sign of works: the work of λ_N in restitution is -r² times that in "
        "compression, which is negative; what is lost in compression, as it says, is positive.",
    )


def _colours() -> Entry:
    return SECTION.settled(
        "1-colours",
        COLOURS,
        r"\text{dashed red line in Figs. 3 and 4}",
        "The distinguished trajectory is the dashed red line of Figures 3 and 4, as their captions say",
        *(
            held_against(COLOURS, f"{figure}: text and caption", words, IN_THE_CAPTION[figure.removesuffix(" again")])
            for figure, words in IN_THE_TEXT.items()
        ),
        corrected="The dashed line is green, if the captions are right",
        note="The figures decide; text and captions cannot both be right.",
    )


def _scalars() -> Entry:
    return SECTION.settled(
        "1-scalars",
        SCALARS,
        r"a,\ b,\ A,\ B,\ C,\ D\ \text{are scalars}",
        "The scalars that are listed below eq. vdynamics end with the last one of the equations",
        *(held_against(SCALARS, f"the list and {where}", LISTED, last) for where, last in LAST_OF.items()),
        corrected="a, b, A, B, C are scalars",
        note="No formula of the paper has this D.",
    )


def _rates() -> dict[str, fmpq_mpoly]:
    return {name: ALGEBRA.read(text) for name, text in section_1_negative_p.RATES.items()}


def slope_by_rates() -> bool | None:
    """Whether dv/dP is p and dv/du the claimed quotient: p = C - μB in one, B - μA in the other."""
    rates, parts = _rates(), {name: ALGEBRA.read(text) for name, text in SLOPE.items()}
    parameter = {"p": ALGEBRA.read("C - mu*B")}
    return (rates["v"] * parts["u"] - rates["u"] * ALGEBRA.substitute(parts["v"], parameter)).is_zero()


def slope_by_impulses() -> bool | None:
    """The same from the changes of v and u by an impulse dP with T = -μ dP; in stick u is kept for v alone."""
    impulses = {"P": _SYMBOLS["dP"], "T": -_SYMBOLS["mu"] * _SYMBOLS["dP"]}
    change = {
        name: ALGEBRA.substitute(ALGEBRA.read(text), impulses) for name, text in section_1_negative_p.STICK.items()
    }
    images = {"p": ALGEBRA.read("C - mu*B")}
    parts = {name: ALGEBRA.substitute(ALGEBRA.read(text), images) for name, text in SLOPE.items()}
    return (change["v"] * parts["u"] - change["u"] * parts["v"]).is_zero()


def signs_near_the_g_spot() -> bool | None:
    """Whether AμB = k + B² - A p and -B (B - μA) = k - A p are positive there: so B > 0, and B - μA < 0."""
    answers = []
    for near in NEAR_THE_G_SPOT:
        images = {name: ALGEBRA.read(text) for name, text in near.items()}
        answers += [
            rising_signs(ALGEBRA.substitute(ALGEBRA.read(text), images)) for text in ("k + B^2 - A*p", "k - A*p")
        ]
    return all(answers)


def factor_is_negative() -> bool | None:
    """Whether these are AμB and -B times the factor for k = AC - B² and p = C - μB, and have the signs."""
    parameters = {"k": ALGEBRA.read("A*C - B^2"), "p": ALGEBRA.read("C - mu*B")}
    first, second = (ALGEBRA.substitute(ALGEBRA.read(text), parameters) for text in ("k + B^2 - A*p", "k - A*p"))
    is_first = (ALGEBRA.read("A*mu*B") - first).is_zero()
    is_second = (ALGEBRA.read(SLOPE["u"]) * _SYMBOLS["B"] + second).is_zero()
    return is_first and is_second and signs_near_the_g_spot()


def factor_is_negative_by_impulses() -> bool | None:
    """The same from impulses with P = A: v rises by k where T = -B keeps u, and by A p in slip, with T = -μA.

    In slip u changes by A times the factor, and v rises by B times the factor more than in stick.
    """
    (kept, rise), (change, climb) = (
        [
            ALGEBRA.substitute(ALGEBRA.read(section_1_negative_p.STICK[name]), {"P": _SYMBOLS["A"], "T": friction})
            for name in "uv"
        ]
        for friction in (-_SYMBOLS["B"], -_SYMBOLS["mu"] * _SYMBOLS["A"])
    )
    factor = ALGEBRA.read(SLOPE["u"])
    left = (
        kept,
        rise - ALGEBRA.read("A*C - B^2"),
        climb - ALGEBRA.read("A*(C - mu*B)"),
        change - _SYMBOLS["A"] * factor,
        climb - rise - _SYMBOLS["B"] * factor,
    )
    return all(value.is_zero() for value in left) and signs_near_the_g_spot()


def _slope() -> Entry:
    return SECTION.settled(
        "1-impact-slope",
        "lines 210 to 214 and 320 to 322",
        r"\frac{dv}{du}=\frac{p}{B-\mu A}",
        "Rigid impact, forces other than those of contact left out: in positive slip dv/du = p/(B - μA) where B is "
        "not μA, for A, B, C, μ that depend on the configuration and time alone and so are constant in the impact: a "
        "straight line whose slope is proportional to p; for AC - B² > 0 B - μA is negative for p <= 0 and for small "
        "p > 0, where A p < AC - B²",
        Rung.EXACT.check("dv/dP over du/dP, P the normal impulse", all_of([slope_by_rates(), factor_is_negative()])),
        Rung.EXACT.check(
            "the changes of v and u by a normal impulse with the tangential one at the bound of friction",
            all_of([slope_by_impulses(), factor_is_negative_by_impulses()]),
        ),
        note="In stick u = 0: the line is vertical, and the corner is where slip ends. Near the G-spot p is small, "
        "and so is the change of v along the line.",
    )


def end_of_slip(share: str) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    """The functions p (v at the end) and p u there, where u is the share of BOUND at first: in slip to the end.

    v = -m at first rises with the slope p; compression ends at P = m/p, restitution has r times that impulse.
    """
    first = ALGEBRA.read(f"({share})*({BOUND})")  # p u
    impulse = ALGEBRA.read("(1 + r)*m")  # p P
    rates = {"v": _SYMBOLS["p"], "u": -_SYMBOLS["k"]}
    return -_SYMBOLS["m"] * _SYMBOLS["p"] + rates["v"] * impulse, first + rates["u"] * impulse


def slips_to_the_end() -> bool | None:
    """Whether above BOUND u is positive at the end of slip with v = r m there, and below it slip ends before."""
    (rise, fast), (_, slow) = end_of_slip("1 + x"), end_of_slip("1 - x")
    lifts = (rise - _SYMBOLS["p"] * ALGEBRA.read("r*m")).is_zero()
    return lifts and rising_signs(fast) and rising_signs(-slow)


def twice_the_work(impulse: str) -> fmpq_mpoly:
    """2 p times the integral of v over the normal impulse P, where ``impulse`` is p P, in slip: v = -m + p P."""
    end = ALGEBRA.read(impulse)
    return end**2 - 2 * _SYMBOLS["m"] * end


def works_have_the_same_bound() -> bool | None:
    """Whether in slip the impulse of restitution that is r times has the work that is -r² times: the energetic law."""
    compression, whole = twice_the_work("m"), twice_the_work("(1 + r)*m")
    return rising_signs(-compression) and (whole - compression + _SYMBOLS["r"] ** 2 * compression).is_zero()


def slips_by_the_impulses() -> bool | None:
    """Whether p u is BOUND at first where u is 0 at the end, from the changes by a whole impulse P with T = -μ P.

    v changes by p P: so p P is m for compression and (1 + r) m for all of it.
    """
    friction = {"T": -_SYMBOLS["mu"] * _SYMBOLS["P"]}
    slopes = {
        name: ALGEBRA.substitute(ALGEBRA.read(text), friction).derivative("P")
        for name, text in section_1_negative_p.STICK.items()
    }
    bound = ALGEBRA.substitute(ALGEBRA.read(BOUND), {"k": ALGEBRA.read("mu*A - B")})
    at_the_end = bound + slopes["u"] * ALGEBRA.read("(1 + r)*m")
    return (slopes["v"] - ALGEBRA.read("C - mu*B")).is_zero() and at_the_end.is_zero()


def rises_in_stick() -> bool | None:
    """Whether T = -B P/A keeps u, and then A dv/dP = AC - B² > 0; |T| < μ P is B < μA."""
    images = {"P": _SYMBOLS["A"], "T": -_SYMBOLS["B"]}
    kept, rise = (ALGEBRA.substitute(ALGEBRA.read(section_1_negative_p.STICK[name]), images) for name in "uv")
    return kept.is_zero() and (rise - ALGEBRA.read("A*C - B^2")).is_zero()


def _ends() -> Entry:
    return SECTION.settled(
        "1-impact-ends",
        "lines 226 to 227",
        r"\text{one initial condition lifts off in slip, the other (with smaller initial }u)\text{ in stick}",
        "Rigid impact with p > 0 and 0 < B < μA, v = -m < 0 and u > 0 at first, Poisson's law with r > 0: it lifts off "
        "in slip where p u is above (μA - B)(1 + r) m, and in stick where it is below; so where of two impacts with "
        "the same v one lifts off in slip and one in stick, the one in stick has the smaller u",
        Rung.EXACT.check(
            "along the normal impulse: v and u at the end of slip, and the works; v rises in stick",
            all_of([slips_to_the_end(), works_have_the_same_bound(), rises_in_stick()]),
        ),
        Rung.EXACT.check(
            "from the whole impulses of the impact; v rises in stick",
            all_of([slips_by_the_impulses(), rises_in_stick()]),
        ),
        note="For small p > 0 B is near C/μ, and B < μA (1-impact-slope). In slip v rises along a line, so that the "
        "energetic law has the same bound.",
    )


def mirrored(text: str) -> fmpq_mpoly:
    """A formula with the tangential direction reversed."""
    return ALGEBRA.substitute(ALGEBRA.read(text), {name: ALGEBRA.read(image) for name, image in MIRROR.items()})


def equations_are_mirrored() -> bool | None:
    """Whether du/dt changes its sign and dv/dt is kept, and Coulomb's law of u < 0 becomes that of u > 0."""
    read = ALGEBRA.read
    motion = (mirrored(PROJECTED["u"]) + read(PROJECTED["u"])).is_zero() and mirrored(PROJECTED["v"]) == read(
        PROJECTED["v"]
    )
    friction = (
        mirrored("lamT") == -_SYMBOLS["lamT"] and (read(FRICTION["forwards"]) + read(FRICTION["backwards"])).is_zero()
    )
    return motion and friction


def negative_slip_is_positive_slip() -> bool | None:
    """Whether the accelerations of negative slip are those of positive slip, mirrored (that of u reversed).

    So is what λ_N has as its factor in dv/dt: ``PARAMETER``.
    """

    def in_slip(name: str, way: str) -> fmpq_mpoly:
        return ALGEBRA.substitute(ALGEBRA.read(PROJECTED[name]), {"lamT": ALGEBRA.read(FRICTION[way])})

    backwards = {name: str(in_slip(name, "backwards")) for name in "uv"}
    parameters = [in_slip("v", way).derivative("lam") - ALGEBRA.read(text) for way, text in PARAMETER.items()]
    return (
        all(value.is_zero() for value in parameters)
        and mirrored(PARAMETER["backwards"]) == ALGEBRA.read(PARAMETER["forwards"])
        and mirrored(backwards["v"]) == in_slip("v", "forwards")
        and (mirrored(backwards["u"]) + in_slip("u", "forwards")).is_zero()
    )


def _mirror() -> Entry:
    return SECTION.settled(
        "1-mirror",
        "eqs. udynamics, vdynamics and Coulomb, lines 172 to 175",
        r"\text{without loss of generality, only positive slip}",
        "Negative slip is positive slip with the tangential direction reversed: x, u, a, B and λ_T change their signs, "
        "and C + μB of negative slip becomes p = C - μB",
        Rung.EXACT.check("Coulomb's law and eqs. udynamics and vdynamics, mirrored", equations_are_mirrored()),
        Rung.EXACT.check(
            "the accelerations of negative slip, mirrored, are those of positive slip; the factors C + μB and C - μB "
            "of λ_N in dv/dt",
            negative_slip_is_positive_slip(),
        ),
    )


ENTRIES: Builders = {
    "1-mirror": _mirror,
    "1-stiffness": _stiffness,
    "1-poisson": _poisson,
    "1-colours": _colours,
    "1-scalars": _scalars,
    "1-impact-slope": _slope,
    "1-impact-ends": _ends,
}
"""Sentences of Sec. 1."""
