"""The commands in the groups of the help, and the help itself: whole sentences, and no wider than people read."""

from __future__ import annotations

from typing import Any

from typer.core import TyperGroup

WIDEST = 110  # columns of the help on a wide terminal
_MARGIN = 6  # columns of a line of the table beside the name and the text: at the left, between, at the right

GROUPS = {
    "Your mechanism": {
        "classify": "mechanism_commands",
        "expand": "mechanism_commands",
        "approach": "approach_command",
        "sweep": "sweep_command",
    },
    "Contact force and motion": {
        "iwc": "iwc_command",
        "verdict": "iwc_command",
        "force": "force_command",
        "events": "events_command",
        "simulate": "simulate_command",
        "scenes": "simulate_command",
    },
    "Θ(τ, β) and its signs": {
        "theta": "theta_commands",
        "side": "theta_commands",
        "sign": "sign_commands",
        "zeros": "sign_commands",
    },
    "The paper, certificates and pictures": {
        "verify": "paper_commands",
        "report": "paper_commands",
        "check": "sign_commands",
        "plot": "plot_command",
    },
    "Accuracy: its cost, and what floats get wrong": {
        "cost": "cost_command",
        "hard-cases": "hard_cases_command",
        "wrong-sides": "wrong_sides_command",
        "simulators": "approach_command",
    },
}
"""Title, commands in the order of the help, and the modules whose import adds them to the application."""


class CommandGroups(TyperGroup):
    """The application's help: a table for each of :data:`GROUPS`, with the first sentence of each command."""

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """The tables, one width for the names."""
        widest = max(map(len, self.commands), default=0)
        limit = formatter.width - _MARGIN - widest
        for title, members in GROUPS.items():
            found = [(name, self.get_command(ctx, name)) for name in members]
            rows = [(name.ljust(widest), command.get_short_help_str(limit)) for name, command in found if command]
            with formatter.section(title):
                formatter.write_dl(rows)
        formatter.write_paragraph()
        formatter.write_text("gspot-verified COMMAND --help says what a command takes, with an example that runs.")


def example(words: str) -> str:
    r"""The end of a command's help: a line to copy, whole where the terminal is wide enough.

    >>> example("side 1/2 4")
    '\x08\nExample:\n  gspot-verified side 1/2 4'
    """
    return f"\b\nExample:\n  gspot-verified {words}"
