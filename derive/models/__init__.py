"""The shipped pages, one model each."""
