"""What all commands have in common: the names of their help, wherever and however they are called."""

from __future__ import annotations

from functools import partial

import click

HELP = {"help_option_names": ["-h", "--help"]}
#: As ``click.command``.
command = partial(click.command, context_settings=HELP)
