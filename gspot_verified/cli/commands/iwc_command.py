"""Commands ``iwc`` and ``verdict``: for which epsilon the contact holds, or the lift-off time; the side from afar."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gspot_verified.cli.app import JsonFlag, app, progress, show, warn
from gspot_verified.cli.command_groups import example
from gspot_verified.cli.commands.approach_command import Spot, Surface
from gspot_verified.cli.commands.mechanism_commands import Settings
from gspot_verified.cli.load import load_with_settings
from gspot_verified.cli.output import Outputs

if TYPE_CHECKING:
    from gspot_verified.expansion.from_state.model_side import ModelSide
    from gspot_verified.mechanisms.approach.mechanism_side import MechanismSide


@app.command(epilog=example("iwc --beta 7/3"))
def iwc(
    beta: Annotated[str | None, typer.Option(help="β = α3/α1, not an integer; or give --alpha3.")] = None,
    alpha1: Annotated[str | None, typer.Option(help="α1* < 0; -1 if left out.")] = None,
    alpha2: Annotated[str | None, typer.Option(help="α2*; -1 if left out.")] = None,
    alpha3: Annotated[str | None, typer.Option(help="α3* < 0; β α1 if left out.")] = None,
    mechanism: Annotated[
        str | None, typer.Option(help="In their place: a TOML file or a name; its alphas, or all in their balls.")
    ] = None,
    settings: Annotated[
        list[str] | None, typer.Option("--set", metavar="NAME=VALUE", help='A parameter of the mechanism, "mu=2".')
    ] = None,
    spot: Annotated[
        int | None, typer.Option(help="Which of the mechanism's G-spots: its number in `classify --all`.")
    ] = None,
    c1: Annotated[str | None, typer.Option(help="C1; left out: 1 or -1, on the side without lift-off.")] = None,
    tau_start: Annotated[str, typer.Option(help="The statement holds for τ from here to +∞.")] = "-10",
    epsilon: Annotated[
        str | None, typer.Option("--epsilon", "--eps", help="ε at which the lift-off time is bracketed, or λ_N > 0.")
    ] = None,
    digits: Annotated[int, typer.Option(help="Decimal digits of the answer, 1..100.")] = 15,
    growth: Annotated[
        bool, typer.Option("--growth", help="Lift-off side, at leading order: τ_LO for ε = 1e-10 to 1e-10000.")
    ] = False,
    certificate: Annotated[Path | None, typer.Option(help="Write a certificate, 1 < β < 5, for a range of ε.")] = None,
    as_json: JsonFlag = False,
) -> None:
    """An ε0 below which the contact holds, or the lift-off time. The time comes as a bracket.

    Each statement names its system: "at leading order" is the paper's formula; "on the slow manifold of the compliant
    model" is the exact solution at that ε. The exit code is that of the last statement. The certificate's own
    statement, for all ε up to (lift-off: from) a rounded one, is printed when it is written.
    """
    from flint import arb

    from gspot_verified.compliant.zeros.force_certificate import check_ratio, iwc_certificate
    from gspot_verified.leading_order.contact_force import contact_force
    from gspot_verified.leading_order.iwc import IwcResult
    from gspot_verified.mechanisms.iwc import iwc as of_force
    from gspot_verified.mechanisms.spots.chosen_spot import at_spot
    from gspot_verified.mechanisms.spots.classify import classify

    outputs = Outputs()
    if mechanism is not None:
        outputs.reads(mechanism)
    outputs.file("--certificate", certificate)
    if mechanism is None and settings:
        raise ValueError("--set: it goes with --mechanism")
    if mechanism is None and spot is not None:
        raise ValueError("--spot: it goes with --mechanism")
    if mechanism is not None and beta is not None:
        raise ValueError("--beta: the mechanism has its own")
    found = None if mechanism is None else classify(at_spot(load_with_settings(mechanism, settings), spot))
    if certificate is not None:  # its domain, before the work
        if found is None:
            second = -1 if alpha2 is None else alpha2
            check_ratio(contact_force(beta, alpha_1=alpha1, alpha_2=second, alpha_3=alpha3, c1=c1).beta)
        elif isinstance(found.beta, arb):
            raise ValueError("--certificate: it needs rational alphas, and those of this mechanism are balls")
        elif found.beta is not None:
            check_ratio(found.beta)
    result = of_force(
        beta if found is None else found,
        alpha_1=alpha1,
        alpha_2=alpha2,
        alpha_3=alpha3,
        c1=c1,
        tau_start=tau_start,
        epsilon=epsilon,
        digits=digits,
        growth=growth,
    )
    leading = result.leading
    show(result, as_json)
    if certificate is not None and isinstance(leading, IwcResult):
        place, rational = certificate, leading

        written: list[str] = []

        def write() -> None:
            proof = iwc_certificate(rational)
            proof.write(place)
            written.append(f"certificate of: {proof.statement}: {place}")

        outputs.write("--certificate", place, write)
        for line in written:
            (progress if as_json else typer.echo)(line)
    outputs.leave(result.verdict.exit_code)


@app.command(epilog=example('verdict oscillator --from "phi=phi_ref+1/10,phi_dot=-9/10"'))
def verdict(
    name: Annotated[
        str | None, typer.Argument(metavar="[name]", help="A mechanism: a TOML file or a name; or give --beta.")
    ] = None,
    beta: Annotated[str | None, typer.Option(help="Without a mechanism: β = α3/α1 > 1, rational, no integer.")] = None,
    state: Annotated[
        str | None,
        typer.Option(
            "--from", help='The state: of the mechanism, as in `approach`; of the model system, "p=1/2,b=-2".'
        ),
    ] = None,
    epsilon: Annotated[
        str | None, typer.Option("--epsilon", "--eps", help="With --beta --from: ε0; left out: as far as it is proved.")
    ] = None,
    within: Annotated[
        str | None,
        typer.Option(
            help="With --beta --from: how far λ, v, y may be from rest, a share of the excess of -b/p; 1/100."
        ),
    ] = None,
    alpha1: Annotated[str | None, typer.Option(help="With --beta --from: α1* < 0; -1 if left out.")] = None,
    alpha2: Annotated[str | None, typer.Option(help="With --beta --from: α2* < 0; -1 if left out.")] = None,
    certificate: Annotated[
        Path | None,
        typer.Option(help="With --beta --from: write a certificate of it, that `check` reads."),
    ] = None,
    explicit: Annotated[
        bool,
        typer.Option(
            "--explicit",
            help="Of a mechanism: an explicit ε0 for starts around the state, by a chart at the G-spot; minutes.",
        ),
    ] = False,
    surface: Surface = None,
    settings: Settings = None,
    spot: Spot = None,
    as_json: JsonFlag = False,
) -> None:
    """Lift-off or impact, for every small ε at once. From a state far from the G-spot.

    Of a mechanism, from a state: there is an ε0 > 0. It is computed where α1, α2, α3 are functions of p, b, y, v that
    are analytic at the G-spot, these are components, and the state is near enough to the G-spot; with --explicit where
    they are not: for starts around a state near the G-spot that rigid slip passes, and around your own. With --beta and
    --from: the model system (constant α's) from p and b, with an explicit ε0. With --beta alone: every mechanism of
    Case III with this β; ε0 is not computed. Exit code 0 when it is proved, 2 when undecided, with --explicit also
    where an explicit ε0 is; what is not certain is printed then.
    """
    from gspot_verified.cli.load import components
    from gspot_verified.expansion.from_state.limit_side import LimitSide, limit_side
    from gspot_verified.expansion.from_state.model_side import ModelSide, model_side
    from gspot_verified.mechanisms.approach.affine_motion import with_explicit
    from gspot_verified.mechanisms.approach.chart_motion import with_chart
    from gspot_verified.mechanisms.approach.mechanism_side import MechanismSide, mechanism_side
    from gspot_verified.mechanisms.own_state.own_state import with_own_state

    if (name is None) == (beta is None):
        raise ValueError("give a mechanism or --beta")
    of_model = {
        "--epsilon": epsilon,
        "--within": within,
        "--alpha1": alpha1,
        "--alpha2": alpha2,
        "--certificate": certificate,
    }
    of_mechanism = {
        "--surface-velocity": surface,
        "--set": settings or None,
        "--spot": spot,
        "--explicit": explicit or None,
    }
    for option, value in (of_model if name is not None else of_mechanism).items():
        if value is not None:
            raise ValueError(f"{option}: it goes with " + ("a mechanism" if name is None else "--beta"))
    outputs = Outputs()
    outputs.file("--certificate", certificate)
    found: LimitSide | ModelSide | MechanismSide
    if name is not None:
        if state is None:
            raise ValueError("--from: a mechanism needs a state, as in `approach`")
        mechanism, given = load_with_settings(name, settings), components(state)
        found = mechanism_side(mechanism, given, surface_velocity=surface, spot=spot)
        found = with_explicit(found, mechanism, given)
        if explicit:
            found = with_own_state(with_chart(found, mechanism, spot), mechanism, given, spot)
    elif state is None:
        for option, value in of_model.items():
            if value is not None:
                raise ValueError(f"{option}: it goes with --from")
        found = limit_side(beta or "")
    else:
        given = components(state)
        if set(given) != {"p", "b"}:
            raise ValueError(f'--from: it needs p and b, "p=1/2,b=-2", got {state!r}')
        found = model_side(
            beta or "",
            given["p"],
            given["b"],
            epsilon=epsilon,
            within="1/100" if within is None else within,
            alpha_1=-1 if alpha1 is None else alpha1,
            alpha_2=-1 if alpha2 is None else alpha2,
        )
    show(found, as_json)
    if certificate is not None and isinstance(found, ModelSide):
        _write_certificate(outputs, certificate, found, progress if as_json else typer.echo)
    left_open = explicit and isinstance(found, MechanismSide) and _explicit_is_open(found)
    outputs.leave(2 if left_open else found.verdict.exit_code)


def _explicit_is_open(found: MechanismSide) -> bool:
    own = found.own
    return found.explicit is None or found.explicit.side is None or (own is not None and own.side is None)


def _write_certificate(outputs: Outputs, place: Path, side: ModelSide, say: Callable[[str], object]) -> None:
    from gspot_verified.certificates.text import write_text
    from gspot_verified.expansion.from_state.side_certificate import side_certificate

    if side.side is None:
        warn(f"--certificate: nothing was proved, so {place} was not written")
    elif outputs.write("--certificate", place, lambda: write_text(place, side_certificate(side))):
        say(f"certificate of it, for every epsilon up to {side.epsilon}: {place}")
