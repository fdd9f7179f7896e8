"""The notebook of the documentation: cells begin with ``# %%``; ``make docs`` runs it from top to bottom."""

# %% [markdown]
# # A notebook
#
# Every output below was computed when this page was built. In Jupyter: [notebook.ipynb](static/notebook.ipynb). The
# script is `docs/notebook.py`; an editor that knows `# %%` cells opens it as a notebook too.
#
# A result as the last line of a cell is shown as `print` shows it, a picture as a picture.
#
# ## Θ in balls

# %%
from gspot_verified import ball_text, theta

for tau in (-10, 0, "1/2", 3):
    print(f"Θ({tau}, 7/3) = {ball_text(theta(tau, '7/3', digits=30), 30)}")

# %% [markdown]
# ## A mechanism

# %%
from gspot_verified import classify, load

oscillator = load("oscillator")
classify(oscillator)

# %% [markdown]
# ## Its distinguished trajectory
#
# The coefficients are exact here, because the G-spot is rational.

# %%
from gspot_verified import expand

expand(oscillator, 3)

# %% [markdown]
# ## Which side lifts off, over β

# %%
from gspot_verified import side

side(1, 5)

# %% [markdown]
# ## Pictures
#
# `plot` draws a result, a mechanism, or a figure by its name; `plot(subject, "file.svg")` writes it as PNG, PDF or SVG.
# Here is the slip of the oscillator next to its G-spot, with
# one of the paper's starts (violet): it stays above the distinguished trajectory, C₁ > 0, the side that lifts off.

# %%
from gspot_verified import plot

plot(oscillator, state={"phi": "phi_ref + 1/10", "phi_dot": "-9/10"})

# %% [markdown]
# What the inner scale predicts for the compliant model, and what the model does:

# %%
plot("b-hat", beta="7/3")

# %% [markdown]
# How well the expansion satisfies the equations, under its proved bound:

# %%
plot(expand(load("rod"), 12))

# %% [markdown]
# A mechanism whose file says how it looks (the table `[drawing]`) is drawn at its G-spot, or at another state:

# %%
plot("mechanism", mechanism=load("rod"))

# %% [markdown]
# And it moves, here along a float run of the scene `rod`. The file is one SVG, played by the browser without a script:

# %%
plot("animation", scene="rod")
