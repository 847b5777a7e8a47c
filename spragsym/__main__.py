"""``python -m spragsym``."""

from .cli import main

if __name__ == "__main__":
    main()
