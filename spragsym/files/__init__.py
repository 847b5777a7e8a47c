"""Files: datasets with units and provenance, the journal that a long sweep writes as it goes, and
locks.
"""

#: Modules that other rooms ask; each is loaded when it is imported.
__all__ = ["journal", "storage", "text"]
