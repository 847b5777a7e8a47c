function result = wide_representable(line)
%WIDE_REPRESENTABLE  Whether double precision can carry the quartic of this balance.
  SMALLEST_SCALE = 1e-200;  % Between these the largest coefficient of f can be divided out without underflow or overflow.
  LARGEST_SCALE = 1e+200;
  % The least |b| over the largest coefficient: the quartic in t is divided by it, and roots farther apart share no scale.
  SMALLEST_RATIO = 1e-60;
  result = (line.scale > SMALLEST_SCALE) & (line.scale < LARGEST_SCALE) & (line.b.high <= -SMALLEST_RATIO);
end
