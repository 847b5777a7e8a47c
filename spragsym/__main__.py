"""``python -m spragsym``."""

import sys

from .cli import main

sys.exit(main())
