"""Where states meet, vanish and flutter: the surface, folds, cusps and onsets, all without a guess."""
