"""References that tests, campaigns and benchmarks hold the package against."""
