"""Where equilibria of any model meet, vanish, flutter and jump: points, curves in a plane, and paths."""
