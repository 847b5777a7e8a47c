"""Files: datasets with units and provenance, the journal that a long sweep writes as it goes, and locks."""
