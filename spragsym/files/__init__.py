"""Files: datasets with units and provenance, the journal of a running sweep, texts and caches."""

#: Modules for other rooms.
__all__ = ["journal", "storage", "text"]
