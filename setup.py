"""Extension modules, each with a digest of its sources compiled in; all else stands in
pyproject.toml.
"""

import runpy
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

OF = runpy.run_path("spragsym/core/extensions.py")


class BuildWithDigest(build_ext):
    """A build of what has another digest, whatever the times of the files are."""

    def build_extension(self, ext: Extension) -> None:
        """Build one module; its sources are found by what they include."""
        folders = [Path(folder) for folder in ext.include_dirs]
        ext.depends = [str(path) for path in OF["sources"](Path(ext.sources[0]), folders)]
        digest = OF["digest"](map(Path, ext.depends))
        ext.define_macros.append(("SPRAGSYM_DIGEST", digest))
        built = Path(self.get_ext_fullpath(ext.name))
        self.force = not (built.is_file() and digest.encode() in built.read_bytes())
        super().build_extension(ext)


setup(cmdclass={"build_ext": BuildWithDigest})
