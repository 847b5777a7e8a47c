"""Models that ``spragsym derive`` made from a page: equilibria, folds, cusps, flutter and motion of any of them."""
