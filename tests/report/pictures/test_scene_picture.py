"""Pictures of scenes: what the curves of the theory are worth, and captions that say what is known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from flint import fmpq

from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state
from gspot_verified.compliant.motion.compliant_force import force
from gspot_verified.report.pictures.canvas import canvas
from gspot_verified.report.pictures.scene_picture import (
    canard,
    caption,
    legend_above,
    panels_of,
    scaled_theta,
    scene_picture,
)
from gspot_verified.scenes.certified_run import certified_run, with_boxes
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.file import load_scene


@pytest.mark.parametrize("beta", ["3/2", "5/2"])
def test_the_scaled_theta_is_the_limit_of_the_exact_solution(beta: str) -> None:
    """b-hat at the G-spot over the prediction tends to 1 like epsilon^(2/3) or so; lambda likewise."""
    errors = []
    for eps in ("1e-3", "1e-6"):
        scene = load_scene("fig-varsim1", beta=beta, epsilon=eps)
        start, curve = scene.initial(), scaled_theta(scene)
        assert curve is not None
        model = compliant_model(beta, eps)
        exact = force(model, compliant_state(*(start[name] for name in "pbyvz")), 0)
        b = np.interp(0, curve.p[::-1], curve.b[::-1])
        errors.append(abs(b / float(exact.b.mid()) - 1))
    assert errors[1] < 2e-3
    assert errors[1] < errors[0]


def test_the_canard_of_the_model_is_its_trivial_solution() -> None:
    curve = canard(load_scene("fig-varsim1", beta="5/2"), -0.1)
    assert curve is not None
    assert curve.b == pytest.approx((-1 / 3, 1 / 15))
    assert (curve.force[0], curve.y[0]) == pytest.approx((2 / 3, -4e-6 / 3))
    assert canard(load_scene("fig-varsim1", beta="1/2"), -0.1) is None
    assert canard(load_scene("fig-varsim2"), -0.1) is None


def test_the_canard_of_a_mechanism_is_its_expansion() -> None:
    """The scene that starts on it: at its start p, the curve has its b, y and force."""
    scene = load_scene("oscillator-canard")
    curve = canard(scene, -0.1)
    assert curve is not None
    assert min(curve.p) < 0 < max(curve.p)
    near = int(np.argmin(np.abs(curve.p)))
    assert curve.force[near] == pytest.approx(1.8764 / (1.0008 - 0.4289), rel=2e-2)
    assert canard(load_scene("extended"), -0.1) is None  # there it would have to pull


def test_nothing_is_predicted_where_the_linear_model_does_not_hold() -> None:
    for name in ("fig-varsim2", "oscillator", "rod"):
        assert scaled_theta(load_scene(name)) is None
    assert scaled_theta(load_scene("fig-varsim1", nu=1)) is None


def test_the_caption_says_what_is_certified() -> None:
    scene = load_scene("fig-varsim1")
    drawn = scene_picture(scene, [certified_run(scene, points=5), float_run(scene, tolerance=1e-6)])
    assert "Certified: lift-off, touch-down, impact without collision." in drawn.caption
    assert "The float run proves nothing." in drawn.caption
    assert "no error of these curves is bounded" in drawn.caption
    assert "Effects left out: tangential_motion" in drawn.caption
    assert drawn.svg.startswith("<svg")
    with pytest.raises(ValueError, match="needs a run with samples"):
        scene_picture(scene, [certified_run(scene)])


def test_the_caption_says_no_more_of_the_end_than_the_verdict() -> None:
    """Exact for all times, by the integrator to its end, with its conditions, or not to the end at all."""
    scene = load_scene("fig-varsim1", epsilon="1/10", until="1/20")
    assert "Proved: exactly one flight, then contact for ever: an impact without collision." in caption(
        scene, [certified_run(scene)], [], "p"
    )
    ended = caption(scene, [certified_run(scene, route="integrator")], [], "p")
    assert "Proved: no change of phase until t = 1/20 after the start." in ended
    longer = replace(scene, until=fmpq(1))
    unfinished = caption(longer, [certified_run(longer, route="integrator", budget=1)], [], "p")
    assert "Undecided: the events of the run." in unfinished
    assert "for all times" not in ended + unfinished


@pytest.mark.parametrize("length", [9, 40])
def test_the_legend_is_no_wider_than_the_picture(length: int) -> None:
    """Five words beside their marks: in as many columns as have room."""
    figure = canvas(2)
    axes = figure.subplots()
    for number in range(5):
        axes.plot([0, 1], [0, number], label=f"{number}".ljust(length, "w"))
    whole = legend_above(figure, axes).get_window_extent()
    assert whole.x0 >= 0
    assert whole.x1 <= figure.bbox.x1
    assert len(figure.legends) == 1
    assert len(figure.legends[0].get_texts()) == 5


def test_own_coordinates_and_the_slip_velocity_have_panels() -> None:
    """As they are integrated, an angle from its reference; of a surface that moves the line is at its velocity."""
    scene = load_scene("rod", until="1/100")
    run = float_run(scene, tolerance=1e-6, points=3)
    assert run.samples is not None
    panels = panels_of(scene, run.samples)
    assert [panel.name for panel in panels] == ["lambda_N", "y", "b", "u", "theta - theta_ref", "X_dot", "theta_dot"]
    assert panels[4].label == r"$\theta$ − $\theta_{\mathrm{ref}}$"
    assert [panel.line for panel in panels] == [0, 0, 0, 0, None, None, None]
    assert [panel.scale for panel in panels[:3]] == [1, 1e-6, 1]
    moving = load_scene("rod")
    moving = replace(moving, effects=(*moving.effects, "belt"), parameters={"belt_velocity": fmpq(-3)})
    assert panels_of(moving, run.samples)[3].line == -3


def test_the_caption_says_whether_points_or_boxes_are_certified() -> None:
    scene = load_scene("fig-varsim1", epsilon="1/100", until="1/4")
    points = certified_run(scene, points=3)
    boxes = with_boxes(scene, points)
    assert "The points are certified, nothing between them." in caption(scene, [points], [], "p")
    drawn = caption(scene, [boxes], [], "p")
    assert "at each time that is shown the trajectory lies in them" in drawn
    assert "Not shown, because nothing is sampled there: lift-off, touch-down." in drawn
    assert with_boxes(scene, boxes) is boxes


def test_of_several_events_of_one_name_each_that_has_no_place_is_named() -> None:
    """The model with two lift-offs: what is sampled ends at the first touch-down."""
    scene = load_scene("fig-varsim1", epsilon="1/100", until="3/2")
    run = certified_run(scene, points=5)
    first, second = run.events[:2]
    again = tuple(replace(event, lower=event.lower + 9, upper=event.upper + 9) for event in (first, second))
    drawn = caption(scene, [replace(run, events=(first, second, *again))], [], "p")
    assert "Not shown, because nothing is sampled there: lift-off, touch-down." in drawn
    assert "Not shown" not in caption(scene, [replace(run, events=(first, second, *again))], [], "t")


def test_over_time_where_p_turns() -> None:
    name = r"a name with $\\frac 1$, which is no formula"
    scene = replace(load_scene("fig-varsim2", epsilon="1/50", until=fmpq(1)), name=name)
    drawn = scene_picture(scene, [float_run(scene, tolerance=1e-6)])
    assert "Beside it" not in drawn.caption
    assert drawn.title == f"The scene {name}, ε = 1/50"
