"""Names that a page can't give away, since Python's code or a file of data has them; those that
targets have are spelled in another way, :mod:`derive.emit.names`.

Items of results, sets and files are by names of pages; where one of the package's own is the same,
the package's has an underscore behind it. Names that generated code makes begin with an underscore,
as no name of a page does, and in other languages than Python a page's names end with one.
"""

#: What generated Python calls by its own name.
OF_CODE = frozenset(("abs", "xp"))

#: Keys of a file with a user's own data, where quantities stand by their names on the page.
OF_FILES = frozenset(("begin", "correlation", "friction", "model", "state", "vary"))
