function result = arctangent(t)
%ARCTANGENT  atan t in double precision, within one unit in the last place.
%
%  By atan t = atan c + atan((t − c)/(1 + c t)) with c one of 0, 1/2, 1, 3/2 and infinity, whose arc tangents stand in two
%  parts; then the polynomial of fdlibm's s_atan.c.
  size = abs(t);
  first = size < 0.4375;
  second = size < 0.6875;
  third = size < 1.1875;
  fourth = size < 2.4375;
  beyond = spragsym.kernel.where(fourth, size - 1.5, -1.0) ./ spragsym.kernel.where(fourth, 1.0 + 1.5 .* size, size);
  about_one = spragsym.kernel.where(second, 2.0 .* size - 1.0, size - 1.0) ./ spragsym.kernel.where(second, 2.0 + size, size ...
      + 1.0);
  x = spragsym.kernel.where(first, size, spragsym.kernel.where(third, about_one, beyond));
  high = spragsym.kernel.where(third, spragsym.kernel.where(second, 0.4636476090008061, 0.7853981633974483), ...
      spragsym.kernel.where(fourth, 0.982793723247329, 1.5707963267948966));
  low = spragsym.kernel.where(third, spragsym.kernel.where(second, 2.2698777452961687e-17, 3.061616997868383e-17), ...
      spragsym.kernel.where(fourth, 1.3903311031230998e-17, 6.123233995736766e-17));
  z = x .* x;
  w = z .* z;
  even = 0.06661073137387531 + w .* (0.049768779946159324 + w .* 0.016285820115365782);
  even = 0.3333333333333293 + w .* (0.14285714272503466 + w .* (0.09090887133436507 + w .* even));
  odd = -0.058335701337905735 + w .* -0.036531572744216916;
  odd = -0.19999999999876483 + w .* (-0.11111110405462356 + w .* (-0.0769187620504483 + w .* odd));
  rest = x .* (z .* even + w .* odd);
  result = spragsym.kernel.where(first, x - rest, high - (rest - low - x));
  result = spragsym.kernel.where(t < 0.0, -result, result);
end
