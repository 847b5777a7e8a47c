function result = cosine_and_sine(x)
%COSINE_AND_SINE  cos x and sin x for 0 < x < π in double precision, within one unit in the last place, which not every
%  library's are.
%
%  x = k π/2 + (r + tail) with r at most π/4, by π/2 in two parts, of which the first leaves nothing to round; then the
%  polynomials of fdlibm's k_sin.c and k_cos.c.
  k = spragsym.kernel.where(x > 0.7853981633974483, 1.0, 0.0) + spragsym.kernel.where(x > 2.356194490192345, 1.0, 0.0);
  near = x - k .* 1.5707963267948966;
  rest = k .* 6.123233995736766e-17;
  r = near - rest;
  tail = near - r - rest;
  z = r .* r;
  odd4 = -2.5050760253406863e-08 + z .* 1.58969099521155e-10;
  odd = 0.00833333333332249 + z .* (-0.0001984126982985795 + z .* (2.7557313707070068e-06 + z .* odd4));
  s = r - (z .* (0.5 .* tail - z .* r .* odd) - tail - z .* r .* -0.16666666666666632);
  even4 = -2.7557314351390663e-07 + z .* (2.087572321298175e-09 + z .* -1.1359647557788195e-11);
  even = 0.0416666666666666 + z .* (-0.001388888888887411 + z .* (2.480158728947673e-05 + z .* even4));
  half = 0.5 .* z;
  top = 1.0 - half;
  c = top + (1.0 - top - half + (z .* z .* even - r .* tail));
  sine = spragsym.kernel.where(k == 1.0, c, spragsym.kernel.where(k > 1.0, -s, s));
  cosine = spragsym.kernel.where(k == 1.0, -s, spragsym.kernel.where(k > 1.0, -c, c));
  result.cosine = cosine;
  result.sine = sine;
end
