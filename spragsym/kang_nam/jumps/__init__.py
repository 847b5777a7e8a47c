"""Jumps in closed form: where the followed state ends first, whether it has, and certificates."""
