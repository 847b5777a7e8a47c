"""Names of the article's figures that are drawn, and of some that it lacks, and formats of files,
which a command knows before what draws them is loaded.
"""

DRAWN = (
    *(str(number) for number in range(3, 15)),
    "cusp-friction",
    "cycles",
    "cycles-plane",
    "false-double-root",
    "rms-map",
    "sensitivity",
)
