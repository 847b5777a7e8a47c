function result = outermost(P, Q)
%OUTERMOST  The root of z³ + 3 P z + 2 Q of largest magnitude, which is far from the others.
  % Where P or Q vanishes, as at a cusp, it is replaced by the smallest normal number.
  SMALLEST_NORMAL = 2.2250738585072014e-308;
  size = abs(Q);
  inside = P .* P .* P + Q .* Q;
  % One real root: Cardano, in the form that does not cancel for P > 0.
  w = spragsym.kernel.cube_root(size + sqrt(spragsym.kernel.larger(inside, 0.0)) + SMALLEST_NORMAL);
  v = P ./ w;
  alone = spragsym.kernel.where(P > 0.0, 2.0 .* size ./ (w .* w + P + v .* v), w - v);
  % Three: 2 √−P cos(φ/3) with cos φ = |Q| / √−P³, from 4 z³ − 3 z = cos φ on [√3/2, 1], where Newton converges at once.
  root = sqrt(spragsym.kernel.larger(-P, SMALLEST_NORMAL));
  cosine = spragsym.kernel.smaller(size ./ (root .* root .* root), 1.0);
  z = 0.8660254037844386 + cosine .* (0.16306 - 0.02908 .* cosine);
  for pass = 1:2
    z = z - ((4.0 .* z .* z - 3.0) .* z - cosine) ./ (12.0 .* z .* z - 3.0);
  end
  largest = spragsym.kernel.where(inside < 0.0, 2.0 .* root .* z, alone);
  result = spragsym.kernel.where(Q > 0.0, -largest, largest);
end
