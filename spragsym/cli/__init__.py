"""The command line: data on stdout, everything else on stderr.

Exit codes: 0 done; 1 a check did not hold or a computation failed; 2 usage, bad values included; 130 interrupted.
"""

from __future__ import annotations

import importlib
import os
import sys
import traceback
from contextlib import suppress
from typing import NoReturn

import click

from .._version import __version__
from ..errors import MissingExtraError, ParameterError, ParameterTypeError, SpragsymError

#: Command → (module that holds it, one line of help). Modules are loaded when their command is called.
COMMANDS = {
    "check": ("check", "Hold the article against the derivation."),
    "equilibria": ("equilibria", "All equilibria of one point."),
    "bifurcation": ("bifurcation", "Folds, cusps, flutter onsets, critical frictions."),
    "simulate": ("motion", "Integrate the motion from an initial state."),
    "sweep": ("motion", "Simulate over a grid of parameters, to a file."),
    "figures": ("figures", "Draw the article's figures, and more."),
    "export": ("export", "Write the solver in another language."),
}

#: Module that may be missing → the extra that brings it.
EXTRAS = {"sympy": "derive", "matplotlib": "plot", "heyoka": "fast", "numba": "fast", "flint": "certify",
          "xarray": "sweep", "h5netcdf": "sweep", "h5py": "sweep", "dask": "sweep", "distributed": "sweep"}  # fmt: skip


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
@click.option("--debug", is_flag=True, help="Show the traceback of an error. May stand anywhere.")
def cli(debug: bool) -> None:
    """Sprag-slip oscillation: equilibria, catastrophe, motion.

    Angles are degrees here and radians in Python. Parameters that are left out have the article's base values.
    Results go to stdout, everything else to stderr. NO_COLOR=1 turns colours off.

    \b
    Examples:
      spragsym check
      spragsym equilibria --theta0 49
      spragsym bifurcation --mu0 0.5 --plot folds.pdf

    \b
    Shell completion (bash; zsh and fish alike):
      eval "$(_SPRAGSYM_COMPLETE=bash_source spragsym)"

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """


def main(arguments: list[str] | None = None) -> NoReturn:
    """Entry point: one line for every error, and with ``--debug``, anywhere on the line, the traceback before it."""
    arguments = sys.argv[1:] if arguments is None else arguments
    debug = "--debug" in arguments
    sys.exit(_run([argument for argument in arguments if argument != "--debug"], debug))


def _run(arguments: list[str], debug: bool) -> int:
    try:
        if "_SPRAGSYM_COMPLETE" in os.environ:  # a shell asks what could come next
            cli.main(arguments, prog_name="spragsym")
        with cli.make_context("spragsym", arguments) as context:
            code = cli.invoke(context)
        sys.stdout.flush()  # here, so that a reader that has left is noticed here
    except click.exceptions.Exit as stop:
        return stop.exit_code
    except (click.Abort, KeyboardInterrupt) as stop:
        return _report("; ".join(["interrupted", *map(str, stop.args)]), 130, debug)
    except BrokenPipeError:
        return _left_alone()
    except click.exceptions.NoArgsIsHelpError as error:
        error.show()
        return error.exit_code
    except click.ClickException as error:
        where = f"; see {error.ctx.command_path} --help" if isinstance(error, click.UsageError) and error.ctx else ""
        return _report(error.format_message().rstrip(".") + where, error.exit_code, debug)
    except (ParameterError, ParameterTypeError) as error:
        return _report(str(error), 2, debug)
    except SpragsymError as error:
        return _report(str(error), 1, debug)
    except ModuleNotFoundError as error:
        module = (error.name or "").partition(".")[0]
        if module not in EXTRAS:
            return _report_mistake(error, debug)
        return _report(str(MissingExtraError("this command", module, EXTRAS[module])), 1, debug)
    except OSError as error:
        known = error.filename is not None and error.strerror
        return _report(f"{error.filename}: {error.strerror}; give another path" if known else str(error), 1, debug)
    except MemoryError:
        return _report("out of memory; ask for fewer points at a time", 1, debug)
    except Exception as error:
        return _report_mistake(error, debug)
    return code if isinstance(code, int) else 0


def _left_alone() -> int:
    """Whoever read our output, head for one, has seen enough: no error. What is buffered has nowhere to go."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 0


def _report_mistake(error: Exception, debug: bool) -> int:
    remedy = "a mistake in spragsym; report it with what --debug prints"
    return _report(f"unexpected {type(error).__name__}: {error}; this is {remedy}", 1, debug)


def _report(message: str, code: int, debug: bool) -> int:
    """One line on stderr."""
    if debug:
        traceback.print_exc()
    click.echo(f"spragsym: {' '.join(message.split())}", err=True)
    return code
