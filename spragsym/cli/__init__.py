"""The command line: data on stdout, everything else on stderr.

Exit codes: 0 done; 1 a check did not hold or a computation failed; 2 usage, bad values included; 130 interrupted.
"""

from __future__ import annotations

import importlib
import sys
import traceback

import click

from .._version import __version__
from ..errors import ParameterError, ParameterTypeError, SpragsymError

#: Command → (module that holds it, one line of help). Modules are loaded when their command is called.
COMMANDS = {
    "check": ("check", "Hold the article against the derivation."),
    "equilibria": ("equilibria", "All equilibria, stable and unstable, in contact and in lift-off."),
    "bifurcation": ("bifurcation", "Folds, cusps, flutter onsets and critical frictions."),
    "simulate": ("motion", "Integrate the motion from an initial state."),
    "sweep": ("motion", "Simulate over a grid of parameters, resumable, to a file."),
    "figures": ("figures", "Draw the figures of the article, and some that it lacks."),
    "export": ("export", "Write the solver in another language."),
}


class LazyGroup(click.Group):
    """A group whose commands are imported when called, so that ``spragsym --help`` is quick."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in COMMANDS:
            return None
        module = importlib.import_module(f".{COMMANDS[cmd_name][0]}", __name__)
        command = getattr(module, cmd_name)
        assert isinstance(command, click.Command)
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl([(name, summary) for name, (_, summary) in COMMANDS.items()])


@click.group(cls=LazyGroup, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="spragsym")
@click.option("--debug", is_flag=True, help="Show the traceback of an error.")
@click.pass_context
def cli(ctx: click.Context, debug: bool) -> None:
    """Sprag-slip oscillation: equilibria, catastrophe, motion.

    Angles are degrees here and radians in Python. Parameters that are left out have the article's base values.

    \b
    Examples:
      spragsym equilibria --theta0 49
      spragsym bifurcation --mu0 0.5 --plot folds.pdf
      spragsym check

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """


def main(arguments: list[str] | None = None) -> None:
    """Entry point: one line for every error, unless ``--debug``."""
    arguments = sys.argv[1:] if arguments is None else arguments
    debug = "--debug" in arguments
    try:
        code = cli.main(arguments, prog_name="spragsym", standalone_mode=False)
    except click.exceptions.Exit as stop:
        code = stop.exit_code
    except click.ClickException as error:
        error.show()
        code = error.exit_code
    except (click.Abort, KeyboardInterrupt):
        click.echo("spragsym: interrupted", err=True)
        code = 130
    except (SpragsymError, OSError) as error:
        if debug:
            traceback.print_exc()
        click.echo(f"spragsym: {' '.join(str(error).split())}", err=True)
        code = 2 if isinstance(error, ParameterError | ParameterTypeError) else 1
    sys.exit(code if isinstance(code, int) else 0)
