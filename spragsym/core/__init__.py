"""What every room stands on: errors, Ctrl-C, progress, remarks, and questions to a model."""

import lazy_loader as _lazy

__getattr__, __dir__, __all__ = _lazy.attach(__name__, {"errors"})
