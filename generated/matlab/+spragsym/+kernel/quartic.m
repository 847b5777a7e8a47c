function result = quartic(a, b, d, m)
%QUARTIC  The quartic in t = tan(θ/2) whose roots are those of f.
  [e0, e1, e2, e3, e4] = spragsym.algebra.t_quartic(a, b, d, m);
  result.e0 = e0;
  result.e1 = e1;
  result.e2 = e2;
  result.e3 = e3;
  result.e4 = e4;
end
