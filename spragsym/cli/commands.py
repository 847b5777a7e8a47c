"""What all commands have in common: the names of their help, and that nothing that is typed is passed over."""

from __future__ import annotations

from functools import partial

import click

HELP = {"help_option_names": ["-h", "--help"]}


class Command(click.Command):
    """A command that refuses what is empty, and what is given twice, of which click takes the last."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        values, _, order = self.make_parser(ctx).parse_args(list(args))
        for one in () if ctx.resilient_parsing else order:
            given, times = values[one.name or ""], order.count(one)
            if times > 1 and not getattr(one, "multiple", False) and (one.secondary_opts or not getattr(one, "is_flag", False)):
                raise click.BadParameter(f"it is given {times} times; give it once", ctx, one)
            if "" in (given if isinstance(given, list | tuple) else [given]):
                raise click.BadParameter("it is empty; leave it out, or give a value", ctx, one)
        return super().parse_args(ctx, args)


#: As ``click.command``.
command = partial(click.command, cls=Command, context_settings=HELP)
