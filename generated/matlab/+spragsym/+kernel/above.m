function result = above(e1, e2, e3, e4, c, margin)
%ABOVE  How many of the positive roots of e0 + e1 t + e2 t² + e3 t³ + e4 t⁴ are above c ≥ 0.
%
%  Three are positive, the fourth is real as well, and the value at c is negative. As many are above c as the derivatives
%  there, over factorials, change their sign (Budan and Fourier), from that value to e4 > 0: three times or once.
  d1 = ((4.0 .* e4 .* c + 3.0 .* e3) .* c + 2.0 .* e2) .* c + e1;
  d2 = (6.0 .* e4 .* c + 3.0 .* e3) .* c + e2;
  d3 = 4.0 .* e4 .* c + e3;
  falls2 = d2 < -margin;
  falls3 = d3 < -margin;
  rises2 = d2 > margin;
  rises3 = d3 > margin;
  thrice = ((d1 > margin) & (falls2 | falls3)) | (rises2 & falls3);
  once = ((d1 < -margin) | (rises2 & rises3)) & (falls2 | rises3);
  result.all = thrice;
  result.one = once;
end
