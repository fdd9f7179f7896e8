"""Names of variables as matplotlib sets formulas: λ_N with its index, theta_dot as a letter with a dot."""

from __future__ import annotations

_GREEK_WORDS = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi "
    "omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
)
_GREEK = frozenset(_GREEK_WORDS.split())
_ACCENTS = {"dot": r"\dot", "ddot": r"\ddot", "hat": r"\hat", "bar": r"\bar"}
_VARIANTS = {"epsilon": r"\varepsilon", "phi": r"\varphi"}

LAMBDA_N = r"$\lambda_\mathrm{N}$"


def typeset(name: str) -> str:
    """A name as a formula; one that does not read as a letter with accents and one index stays as it is.

    >>> typeset("theta_dot"), typeset("theta_ref"), typeset("X"), typeset("a__b")
    ('$\\\\dot{\\\\theta}$', '$\\\\theta_{\\\\mathrm{ref}}$', '$X$', 'a__b')
    """
    head, *rest = name.split("_")
    accents = [_ACCENTS[part] for part in rest if part in _ACCENTS]
    indices = [part for part in rest if part not in _ACCENTS]
    if (
        not (head in _GREEK or (len(head) == 1 and head.isascii() and head.isalpha()))
        or len(accents) > 1
        or len(indices) > 1
    ):
        return name
    if not all(part.isalnum() and part.isascii() for part in indices):
        return name
    letter = _letter(head)
    for accent in accents:
        letter = f"{accent}{{{letter}}}"
    return f"${letter}{''.join(_index(part) for part in indices)}$"


def _letter(name: str) -> str:
    return _VARIANTS.get(name, f"\\{name}") if name in _GREEK else name


def _index(name: str) -> str:
    return f"_{{{_letter(name)}}}" if name in _GREEK or len(name) == 1 else f"_{{\\mathrm{{{name}}}}}"
