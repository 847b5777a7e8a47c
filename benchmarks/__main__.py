"""``python -m benchmarks [--write FILE] [--quick] [NAME ...]``: run the benchmarks and print, or
write, one report of tables.

With names, the other sections of a report that is there stay as they are.
"""

import argparse
import datetime
import importlib.metadata
import os
import platform
import subprocess
import sys
from pathlib import Path

#: Name → module and title.
_SECTIONS = {
    "equilibria": ("benchmarks.bench_equilibria", "Equilibria: speed"),
    "accuracy": ("benchmarks.bench_accuracy", "Equilibria: accuracy beside speed"),
    "c": ("benchmarks.bench_c", "The C target"),
    "languages": ("benchmarks.bench_languages", "JavaScript and MATLAB"),
    "models": ("benchmarks.bench_models", "Models from pages beside the closed forms"),
    "general": ("benchmarks.bench_general", "Questions over one another"),
    "peers": ("benchmarks.bench_peers", "Beside AUTO, Ibex and SciPy"),
    "catastrophe": ("benchmarks.bench_catastrophe", "The bifurcation set"),
    "dynamics": ("benchmarks.bench_dynamics", "Motion in time"),
    "scale": ("benchmarks.bench_scale", "How cost grows"),
    "matrices": ("benchmarks.bench_matrices", "Brakes as matrices"),
}
#: What ``--quick`` gives a benchmark for its size: enough to see that it runs, too little to
#: measure.
_QUICK = {
    "equilibria": "20000",
    "accuracy": "10",
    "c": "10000",
    "languages": "100",
    "models": "25",
    "general": "inclined_belt",
    "scale": "4",
    "matrices": "10",
}
_VERSIONS = ("numpy", "scipy", "mpmath", "sympy", "python-flint", "heyoka")


def main() -> int:
    """Exit code 1 if a benchmark failed."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks")
    parser.add_argument("names", nargs="*", help="which; all by default")
    parser.add_argument("--write", type=Path, help="file for the report")
    parser.add_argument(
        "--quick",
        action="store_true",
        help="few points, to see that all runs; the figures mean nothing",
    )
    options = parser.parse_args()
    failed = 0
    found = (
        _sections(options.write)
        if options.names and options.write and options.write.exists()
        else {}
    )
    for name in options.names or _SECTIONS:
        if name not in _SECTIONS:
            parser.error(f"{name} is not one of {', '.join(_SECTIONS)}")
        module, title = _SECTIONS[name]
        print(f"# {title}", flush=True)
        # A process of its own for each, so that none meets what another imported, compiled or
        # allocated.
        size = [_QUICK[name]] if options.quick and name in _QUICK else []
        command = [sys.executable, "-m", module, *size]
        run = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
        print(run.stdout, flush=True)
        failed += run.returncode != 0
        day = datetime.date.today().isoformat()
        found[title] = (
            f"## {title}\n\n`python -m {module}`, {day}, of {_state()}\n\n{_demoted(run.stdout)}\n"
        )
    if options.write:
        parts = [_header(), *(found[title] for _, title in _SECTIONS.values() if title in found)]
        options.write.write_text("\n".join(parts), encoding="utf-8")
    return int(failed > 0)


def _state() -> str:
    """The commit, and whether files differ from it."""
    command = ["git", "describe", "--always", "--abbrev=8", "--dirty=, changed", "--exclude=*"]
    run = subprocess.run(
        command, capture_output=True, text=True, cwd=Path(__file__).parent, check=False
    )
    return run.stdout.strip() or "a tree without its history"


def _sections(report: Path) -> dict[str, str]:
    """Title → section of a report; those that are not measured again stay."""
    _, *sections = report.read_text(encoding="utf-8").split("\n## ")
    return {section.partition("\n")[0]: f"## {section.rstrip()}\n" for section in sections}


def _demoted(text: str) -> str:
    """A benchmark's own headings, one level below that of its section."""
    return "\n".join(
        f"#{line}" if line.startswith("## ") else line for line in text.strip().splitlines()
    )


def _header() -> str:
    versions = []
    for package in _VERSIONS:
        try:
            versions.append(f"{package} {importlib.metadata.version(package)}")
        except importlib.metadata.PackageNotFoundError:
            continue
    return (
        "# Performance\n\n"
        "Measured by `make bench`; ratios within a table come from one run and carry over to "
        "other machines better than times do.\n"
        "`python -m benchmarks.bench_before REV` times what is asked of this tree beside "
        "another commit.\n\n"
        f"{_processor()}, {os.cpu_count()} cores; Python {platform.python_version()}; "
        f"{', '.join(versions)}.\n"
    )


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    wide = ", AVX-512" if any("avx512f" in line for line in lines) else ""
    return (names[0] if names else platform.machine()) + wide


if __name__ == "__main__":
    sys.exit(main())
