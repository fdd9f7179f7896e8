"""The notebook of an arm of one's own; cells begin with ``# %%``, as in ``notebook.py``."""

# %% [markdown]
# # A notebook: an arm from SymPy
#
# A two-link arm whose tip slides on a floor: from a `LagrangesMethod` to its G-spots, the critical friction, the side
# from a state, a certified run through the G-spot, and the pictures. In Jupyter:
# [notebook_arm.ipynb](static/notebook_arm.ipynb). What each step may be given is on the page
# [From your own equations](your_equations.md).
#
# ## The equations
#
# Two uniform rods and a motor at the shoulder; q1 and q2 are the angles of the links to the horizontal.

# %%
from sympy import Rational, symbols
from sympy.physics.mechanics import (
    LagrangesMethod,
    Lagrangian,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

q1, q2 = dynamicsymbols("q1 q2")
m1, m2, l1, l2, g, torque, h, mu = symbols("m1 m2 l1 l2 g torque h mu")
N = ReferenceFrame("N")
A, B = N.orientnew("A", "Axis", [q1, N.z]), N.orientnew("B", "Axis", [q2, N.z])
base = Point("O")
base.set_vel(N, 0)


def rod(start, frame, mass, length):
    """A uniform rod from a point along the x of its frame, and its other end."""
    centre, end = start.locatenew("C", length / 2 * frame.x), start.locatenew("E", length * frame.x)
    centre.v2pt_theory(start, N, frame)
    end.v2pt_theory(start, N, frame)
    body = RigidBody("rod", centre, frame, mass, (inertia(frame, 0, 0, mass * length**2 / 12), centre))
    body.potential_energy = mass * g * centre.pos_from(base).dot(N.y)
    return body, end


upper, elbow = rod(base, A, m1, l1)
lower, tip = rod(elbow, B, m2, l2)
method = LagrangesMethod(Lagrangian(N, upper, lower), [q1, q2], forcelist=[(A, torque * N.z)], frame=N)
equations = method.form_lagranges_equations()

# %% [markdown]
# ## The contact
#
# The floor lies h below the shoulder. Numbers are exact: `"9.81"` is 981/100. Before a mechanism is made, its
# accelerations are compared with those of SymPy's own equations.

# %%
from gspot_verified import from_sympy

place = tip.pos_from(base)
arm = from_sympy(
    method,
    contact={"x": place.dot(N.x), "y": place.dot(N.y) + h, "mu": mu},
    parameters={m1: 1, m2: 2, l1: 1, l2: Rational(3, 2), g: "9.81", torque: 30, h: "0.36", mu: "0.7"},
    name="two-link arm",
)
arm.state

# %% [markdown]
# ## All its G-spots, and the critical friction

# %%
from gspot_verified import classify_all, critical_friction

classify_all(arm)

# %%
critical_friction(arm)

# %% [markdown]
# ## From a state: which side
#
# Two components are enough, contact (y = 0, v = 0) gives the others.

# %%
from gspot_verified import approach

approach(arm, {"q1": 2, "q1_dot": "-5.4"}, spot=1)

# %% [markdown]
# ## Through the G-spot
#
# With the compliant contact at ε = 1/1000, certified: the list of events is proved to be all until the end of the
# time. It takes some seconds; `simulate(scene, floats=True)` is quick and proves nothing.

# %%
from gspot_verified import scene_before_spot, simulate

scene = scene_before_spot(arm, 1)
run = simulate(scene, points=101)
run

# %%
from gspot_verified import plot

plot("run", scene=scene, run=run)

# %% [markdown]
# ## The slip next to the G-spot
#
# In the plane of p and b, with the state of above (violet).

# %%
plot(arm, spot=1, state={"q1": 2, "q1_dot": "-5.4"})
