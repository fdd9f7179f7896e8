"""The text of a mechanism given by fields: p and b are components of the state, A = 3/(2(1 - p)), μ = 1 - p."""


def model_text(F: str, alpha_3: str, parameters: str = "") -> str:
    """With the entries of F for x, u, y, v, p, b, the formula of α_3, and lines of parameters."""
    return f"""
format = 1
name = "model"
[parameters]
{parameters}
[fields]
state = ["x", "u", "y", "v", "p", "b"]
F = [{F}]
G_T = [0, "3/(2*(1 - p))", 0, "1/2", 0, "({alpha_3})/(2*(1 - p))"]
G_N = [0, "1/2", 0, "(1 + p)/2", 0, "-({alpha_3})/2"]
[contact]
x = "x"
y = "y"
mu = "1 - p"
[g_spot]
fixed = ["x", "u"]
[g_spot.point]
x = 0
u = 1
y = 0
v = 0
p = 0
b = 0
"""
