"""Bodies of a file of bodies: their mass matrix and contact point are those of the mechanism's formulas."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from mechanisms.foreign import robots
from scenes.simulators.planar_numbers import PlanarNumbers

from gspot_verified import Mechanism, from_mjcf, load
from gspot_verified.mechanisms.input.planar_links import PlanarJoint, PlanarLink, PlanarLinks
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.contact_floats import contact_floats
from gspot_verified.scenes.simulators.planar_body import planar_model
from gspot_verified.scenes.simulators.planar_model import PlanarModel, moved_states

BRANCHED = """<mujoco model="walker"><compiler angle="radian"/><worldbody>
<body name="hip" pos="0 0 1">
  <joint name="far" type="slide" axis="3 0 4"/>
  <joint name="lean" axis="0 1 0" pos="0.1 0 0.2" ref="0.3" armature="0.7"/>
  <inertial pos="0.1 0 0.2" mass="3" diaginertia="0 0.4 0"/>
  <body name="plate" pos="0 0 0.5"><inertial pos="0.3 0 0" mass="2" diaginertia="0 0.2 0"/></body>
  <body name="left" pos="0.2 0 0"><joint name="knee" axis="0 -1 0"/>
    <inertial pos="0 0 -0.5" mass="1" diaginertia="0 0.1 0"/><body name="shoe" pos="0 0 -1"/></body>
  <body name="right" pos="-0.2 0 0"><joint name="other" axis="0 1 0"/>
    <inertial pos="0 0 -0.4" mass="2" diaginertia="0 0.3 0"/></body>
</body></worldbody></mujoco>"""


def branched(**options: str) -> Mechanism:
    return from_mjcf(BRANCHED, contact_body="shoe", contact_point=(0, 0, "-1/5"), mu="1/2", height="1/7", **options)


def model_of(mechanism: Mechanism) -> PlanarModel:
    functions = contact_floats(mechanism)
    return planar_model(mechanism.bodies, functions, [0.3 + i / 5 for i in range(len(functions.names))])


def walker() -> PlanarModel:
    return model_of(branched())


@pytest.mark.parametrize(
    ("made", "options", "right"),
    [
        (robots.urdf_arm, {}, 1),
        (robots.mjcf_arm, {}, 1),
        (branched, {}, 1),
        (branched, {"slip": "negative"}, -1),
        (branched, {"tangent": "z", "normal": "x"}, 1),
        (branched, {"tangent": "-x"}, 1),
    ],
)
def test_bodies_and_formulas_have_one_mass_matrix_and_contact_point(
    made: Callable[..., Mechanism], options: dict[str, str], right: int
) -> None:
    model = model_of(made(**options))
    numbers = PlanarNumbers(model.bodies)
    for state in moved_states(model.start):
        places = model.places(state)
        along, up = np.linalg.solve(numbers.mass_matrix(places), numbers.tip(places).T).T
        tangent, normal = model.directions(state)
        assert tangent == pytest.approx(right * along, rel=1e-7, abs=1e-8)
        assert normal == pytest.approx(up, rel=1e-7, abs=1e-8)
        tip = numbers.point(model.bodies.touching, model.bodies.point, places)
        assert tip.imag - model.height == pytest.approx(model.functions.contact(state).y)


def test_a_state_goes_there_and_back() -> None:
    model, state = walker(), [0.1, 0.5, -0.4, 0.9, 1.0, -2.0, 3.0, 0.5]
    assert model.places(state) == pytest.approx([0.1, 0.5 - 0.3, -0.4, 0.9])
    assert model.state(model.places(state), model.rates(state)) == pytest.approx(state)


def test_the_tree_of_bodies() -> None:
    """The plate is one with the hip, the shoe without mass one with the left leg."""
    model = walker()
    assert [(placed.above, placed.joints) for placed in model.tree()] == [(None, (0, 1)), (0, (2,)), (0, (3,))]
    assert model.tip == 1
    hip = model.tree()[0].link
    assert (hip.mass, hip.centre) == (5, pytest.approx((0.18, 1.32)))
    assert hip.inertia == pytest.approx(0.4 + 0.2 + 3 * (0.08**2 + 0.12**2) + 2 * (0.12**2 + 0.18**2))


def test_the_formulas_of_the_mechanism_say_all_of_it() -> None:
    """Its bodies are for other programs: without them it is the same mechanism."""
    arm = robots.mjcf_arm()
    assert arm.bodies is not None
    assert replace(arm, bodies=None) == arm
    assert arm.with_parameters(mu="1/3").bodies == arm.bodies


ARM = robots.mjcf_arm()
HINGE = PlanarJoint(is_hinge=True, place=(0, 0))
LINK = PlanarLink((0, 1), mass=1, inertia=1, centre=(1, 0))


@pytest.mark.parametrize(
    ("links", "touching", "message"),
    [
        ([LINK], (0,), "the body that touches has no mass"),
        ([replace(LINK, joints=(0,))], (0,), "a joint moves no body with a mass"),
        ([LINK, replace(LINK, joints=(1,))], (0, 1), "or two bodies that hang on one without"),
        ([replace(LINK, inertia=0)], (0, 1), "a body has no inertia"),
    ],
)
def test_bodies_that_no_program_takes(links: list[PlanarLink], touching: tuple[int, ...], message: str) -> None:
    bodies = PlanarLinks((HINGE, HINGE), tuple(links), touching, (2, 0))
    with pytest.raises(SceneError, match=message):
        planar_model(bodies, contact_floats(ARM), [0.1, 0.2, 0.3, 0.4])


def test_equations_alone_do_not_say_which_bodies_move() -> None:
    arm = load("two-link-arm")
    with pytest.raises(
        SceneError, match=r"its equations do not say which bodies move: only one rigid body .*from_urdf"
    ):
        planar_model(arm.bodies, contact_floats(arm), [0.1, 0.2, 0.3, 0.4])
