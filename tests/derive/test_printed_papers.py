"""Files of ``validation/papers``, as papers print their equations: every verdict is the expected
one, by hand or by a second derivation that the file names.
"""

import numpy as np
import pytest

from validation.printed_papers import CASES, judge

pytestmark = pytest.mark.thorough


@pytest.mark.parametrize("number", range(CASES))
def test_every_verdict_on_a_paper_is_the_expected_one(number: int) -> None:
    """Also where its misprints are repaired."""
    assert judge(number, np.random.default_rng(0))["wrong"] == []
