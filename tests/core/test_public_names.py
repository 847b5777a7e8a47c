"""Public names: few at the top, none in the place of Python's own, and where former ones are."""

import builtins
import signal
import subprocess
import sys

import pytest

import spragsym as ss


def test_the_top_has_few_names_and_none_of_python() -> None:
    names = {*ss.__all__}
    assert len(names) <= 75
    assert names & {*dir(builtins)} == set()


@pytest.mark.parametrize(
    ("former", "now"),
    [("ParameterError", "errors"), ("Cycle", "results"), ("surface", "kang_nam")],
)
def test_a_name_that_has_moved_says_where_it_is(former: str, now: str) -> None:
    with pytest.raises(AttributeError, match=f"write spragsym.{now}.{former}"):
        getattr(ss, former)
    assert getattr(getattr(ss, now), former).__name__ == former


def test_a_name_that_there_never_was_is_no_name() -> None:
    with pytest.raises(AttributeError, match="gone"):
        getattr(ss, "gone")  # noqa: B009  # as an attribute no type checker lets it pass


@pytest.mark.parametrize("name", sorted(set(dir(ss.results))))
def test_each_answer_has_its_class(name: str) -> None:
    assert isinstance(getattr(ss.results, name), type)


def test_the_import_sets_no_handler_of_ctrl_c() -> None:
    """In whatever way Python was begun, such as by a script of the command's name."""
    code = (
        "import signal, sys; sys.argv[0] = '/bin/spragsym'; own = signal.getsignal(signal.SIGINT);"
        "import spragsym; spragsym.equilibria; assert signal.getsignal(signal.SIGINT) is own"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
    assert signal.getsignal(signal.SIGINT) is not None
