"""The command line: data on stdout, everything else on stderr.

Exit codes: 0 done; 1 a check did not hold or a computation failed; 2 usage, bad values included;
130 interrupted.
"""

import codecs
import importlib
import os
import re
import sys
import traceback
import warnings
from contextlib import suppress
from typing import NoReturn

import click

from .._version import __version__
from ..core.errors import (
    MissingExtraError,
    ParameterError,
    ParameterTypeError,
    SpragsymError,
    closest,
    latin,
)
from ..core.interrupts import ending
from ..core.shown import visible

__all__ = ["COMMANDS", "cli", "main"]

#: Command → (module that holds it, one line of help). Modules are loaded when their command is
#: called.
COMMANDS = {
    "report": ("pages", "A verdict on the brake of a file, with units."),
    "squeal": ("squeal", "Every onset of squeal of a finite-element model."),
    "check": ("article", "Hold the article against the derivation."),
    "equilibria": ("equilibria", "All equilibria of one point."),
    "bifurcation": ("bifurcation", "Folds, flutter onsets, and cusps."),
    "onsets": ("bifurcation", "Where oscillation sets in, over two parameters."),
    "folds": ("bifurcation", "Folds along one parameter: what ends there."),
    "path": ("equilibria", "A state followed as one parameter moves."),
    "critical": ("equilibria", "Where a state jumps first, and critical frictions."),
    "simulate": ("motion", "Integrate the motion from an initial state."),
    "cycles": ("motion", "Cycles of the motion, and branches of them."),
    "sweep": ("motion", "Simulate over a grid of parameters, to a file."),
    "fates": ("motion", "What motions come to, over a grid of parameters."),
    "figures": ("article", "Draw the article's figures, and more."),
    "explore": ("pages", "Write the explorer, a page for the browser."),
    "derive": ("export", "Derive a model from its model page to code."),
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

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args and args[0] not in COMMANDS and not args[0].startswith("-"):
            meant = closest(args[0], COMMANDS)
            remark = (
                f"did you mean {meant}?" if meant else f"the commands are {', '.join(COMMANDS)}"
            )
            ctx.fail(f"no command {args[0]!r}; {remark}")
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl([(name, summary) for name, (_, summary) in COMMANDS.items()])


@click.group(
    cls=LazyGroup, context_settings={"help_option_names": ["-h", "--help"], "show_default": True}
)
@click.version_option(__version__, prog_name="spragsym")
@click.option("--debug", is_flag=True, help="Show the traceback of an error. May stand anywhere.")
def cli(debug: bool) -> None:
    """Sprag-slip oscillation: equilibria, catastrophe, motion.

    Angles are degrees here and radians in Python. Parameters that are left out have the article's
    base values. Results go to stdout, everything else to stderr. NO_COLOR=1 turns colours off.

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
    """Entry point: one line for every error, and with ``--debug``, anywhere on the line, the
    traceback before it.
    """
    arguments = sys.argv[1:] if arguments is None else arguments
    debug = "--debug" in arguments
    if sys.stdout is None:  # closed by the caller: what is said there is lost, which is an error
        sys.stdout = os.fdopen(os.open(os.devnull, os.O_RDONLY), "w", encoding="utf-8")
    codecs.register_error("spragsym.latin", _in_latin)
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="spragsym.latin")
    code = _run([argument for argument in arguments if argument != "--debug"], debug)
    for stream in (sys.stdout, sys.stderr):
        try:
            if stream is not None:
                stream.flush()
        except (OSError, ValueError):
            # Let go of what can't be written; otherwise the interpreter tries again when it ends,
            # and exits with code 120.
            with suppress(OSError, ValueError):
                os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
    sys.exit(code)


def _in_latin(error: UnicodeError) -> tuple[str, int]:
    """Replaces characters that a stream can't write: Greek letters by their names, others by an
    escape.
    """
    if not isinstance(error, UnicodeEncodeError):
        raise error
    text = (
        latin(error.object[error.start : error.end])
        .replace("−", "-")
        .replace("–", "-")
        .replace("′", "'")
    )
    return text.encode("ascii", "backslashreplace").decode("ascii"), error.end


def _require_epoch() -> None:
    """Raise if the environment has a date that NumPy and matplotlib can't read."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH", "0")
    if not re.fullmatch("[0-9]{1,11}", epoch):  # until the year 5138
        raise ParameterError(
            f"SOURCE_DATE_EPOCH = {epoch!r:.60} of the environment is no whole number of seconds "
            "of up to 11 digits; unset it, or give one"
        )


def _run(arguments: list[str], debug: bool) -> int:
    """The exit code; an error is told on one line of stderr, if there is one."""
    try:
        _require_epoch()
        if "_SPRAGSYM_COMPLETE" in os.environ:  # the shell asks for completions
            cli.main(arguments, prog_name="spragsym")
        with ending(), warnings.catch_warnings():
            warnings.showwarning = lambda message, *_: click.echo(
                f"spragsym: warning: {visible(str(message))}", err=True
            )
            plain = False if "NO_COLOR" in os.environ else None
            with cli.make_context("spragsym", arguments, color=plain) as context:
                cli.invoke(context)
        sys.stdout.flush()  # flush here, so that a closed pipe and a full disk are noticed here
    except click.exceptions.Exit as stop:
        return stop.exit_code
    except BrokenPipeError:
        return 0  # the reader, such as head, has closed the pipe, which is not an error
    except click.exceptions.NoArgsIsHelpError as error:
        error.show()
        return error.exit_code
    except (Exception, KeyboardInterrupt) as error:
        message, code = _message_and_code(error, arguments)
        with suppress(OSError, ValueError):
            if debug:
                traceback.print_exc()
            line = " ".join(visible(message).split())
            click.echo(
                f"spragsym: {line if len(line) <= 2000 else f'{line[:500]} … {line[-500:]}'}",
                err=True,
            )
        return code
    return 0


def _message_and_code(error: BaseException, arguments: list[str]) -> tuple[str, int]:
    """Message of an error, and its exit code."""
    # Module that may be missing → the extra that brings it.
    extras = {
        "sympy": "derive",
        "matplotlib": "plot",
        "heyoka": "fast",
        "flint": "certify",
        "xarray": "sweep",
        "h5netcdf": "sweep",
        "h5py": "sweep",
        "dask": "sweep",
        "distributed": "sweep",
    }
    match error:
        case click.Abort() | KeyboardInterrupt():
            return "; ".join(["interrupted", *map(str, error.args)]), 130
        case click.ClickException():
            where = (
                f"; see {error.ctx.command_path} --help"
                if isinstance(error, click.UsageError) and error.ctx
                else ""
            )
            return _message(error, arguments).rstrip(".") + where, error.exit_code
        case SpragsymError():
            return str(error), 2 if isinstance(error, ParameterError | ParameterTypeError) else 1
        case ModuleNotFoundError() if (module := (error.name or "").partition(".")[0]) in extras:
            return str(MissingExtraError(f"spragsym {arguments[0]}", module, extras[module])), 1
        case OSError() if not error.strerror:
            return str(error), 1
        case OSError() if error.filename is None:
            return (
                f"the output can't be written: {error.strerror}; make room, or send it elsewhere",
                1,
            )
        case OSError():
            return f"{error.filename}: {error.strerror}; give another path", 1
        case MemoryError():
            return "out of memory; ask for fewer points at a time", 1
    remedy = "this is a mistake in spragsym; report it with what --debug prints"
    return f"unexpected {type(error).__name__}: {error}; {remedy}", 1


def _message(error: click.ClickException, arguments: list[str]) -> str:
    """The message of click; for an unknown option, with the one that was probably meant, for a
    missing one with what to give.
    """
    if (
        isinstance(error, click.MissingParameter)
        and isinstance(error.param, click.Option)
        and error.ctx is not None
    ):
        flag = max(error.param.opts, key=len)
        return f"{flag} is missing; give {flag} {error.param.make_metavar(error.ctx)}"
    if not isinstance(error, click.NoSuchOption) or error.ctx is None:
        return error.format_message()
    typed = error.option_name
    if len(typed) == 2:  # of -theta0 click sees only -t
        typed = next((word for word in arguments if word.startswith(typed)), typed)
    typed = typed.partition("=")[0]
    options = [
        flag
        for option in error.ctx.command.params
        for flag in (*option.opts, *option.secondary_opts)
    ]
    short = f"-{typed.lstrip('-')}"  # of --V it is -V
    long = [flag for flag in options if flag.startswith("--")] + ["--help", "--debug"]
    meant = short if short in options else closest(typed, long)
    return f"no option {typed}" + (f"; did you mean {meant}?" if meant else "")
