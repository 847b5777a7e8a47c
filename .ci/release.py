"""Tag the version of the tree, once it is fit for that: ``python .ci/release.py``; with ``--check``
say only what is missing.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def git(*words: str, root: Path = ROOT) -> str:
    """Output of a git command."""
    done = subprocess.run(["git", *words], cwd=root, capture_output=True, text=True, check=True)
    return done.stdout.strip()


def version_of(root: Path) -> str:
    """The version of the package."""
    text = (root / "spragsym/_version.py").read_text(encoding="utf-8")
    found = re.search(r'"(\d+\.\d+\.\d+)"', text)
    return found[1] if found else ""


def obstacles(root: Path = ROOT) -> list[str]:
    """Reasons for which the tree can't be tagged, each with its remedy."""
    version, found = version_of(root), []
    if not version:
        return ["spragsym/_version.py has no version such as 0.1.0; write one"]
    heading = re.search(
        rf"^## {re.escape(version)}, (.*)$",
        (root / "CHANGELOG.md").read_text(encoding="utf-8"),
        re.MULTILINE,
    )
    date = heading[1] if heading and re.fullmatch(r"\d{4}-\d{2}-\d{2}", heading[1]) else ""
    if not date:
        found.append(f"CHANGELOG.md has no line '## {version}, YEAR-MONTH-DAY'; date its head")
    cited = (root / "CITATION.cff").read_text(encoding="utf-8")
    if f"\nversion: {version}\n" not in cited:
        found.append(f"CITATION.cff has another version than {version}; write that")
    if date and f"\ndate-released: {date}\n" not in cited:
        found.append(f"CITATION.cff lacks 'date-released: {date}'; write the day of CHANGELOG.md")
    if git("status", "--porcelain", root=root):
        found.append("the tree has changes that are not committed; commit them")
    if git("tag", "--list", f"v{version}", root=root):
        found.append(f"the tag v{version} is there; raise the version")
    return found


#: What only those who publish can say: in which file, what stands there until then, and the remedy.
PLACEHOLDERS = (
    ("paper.md", "name: The spragsym developers", "write the authors, with ORCID and affiliation"),
    ("paper.md", "To be stated by the authors.", "write disclosures and acknowledgements"),
    ("CITATION.cff", "name: The spragsym developers", "write the authors"),
    ("pyproject.toml", "# Repository: ", "write the address of the repository under project.urls"),
)


def placeholders(root: Path = ROOT) -> list[str]:
    """What only a maintainer can write, and has not yet."""
    return [
        f"{name} has {held!r} still; {remedy}"
        for name, held, remedy in PLACEHOLDERS
        if (root / name).is_file() and held in (root / name).read_text(encoding="utf-8")
    ]


def main(words: list[str]) -> int:
    """Say what is missing, or tag; the code to exit with."""
    missing = [*obstacles(), *placeholders()]
    for one in missing:
        print(f"release: {one}", file=sys.stderr)
    if missing or "--check" in words:
        return int(bool(missing))
    subprocess.run([str(ROOT / ".ci/run")], check=True)
    version = version_of(ROOT)
    git("tag", "--annotate", f"v{version}", "--message", f"spragsym {version}")
    print(f"tagged v{version}; git push origin v{version} builds the wheels")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
