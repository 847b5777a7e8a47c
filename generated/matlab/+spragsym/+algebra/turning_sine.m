function [result1, result2] = turning_sine(sin, kappa, alpha, sigma, beta)
%TURNING_SINE  Numerator and denominator of sin θ₀ where the curve of folds turns back in μ₀. Returns numerator,
%  denominator, elements one after the other. Source: f = f′ = f_θ₀ = 0. Operations: 47.
  B = beta + 1;
  a_f = sigma.*(B - alpha);
  p = alpha + sigma;
  sin_2 = sin.*sin;
  width = 1 - sin_2;
  sin_3 = sin.*sin_2;
  w0 = B.*p;
  w1 = sin.*width;
  lean = -a_f.*sin_3 + kappa.*p - w0.*w1;
  a_0 = lean.*sigma;
  w2 = sigma.*sin;
  v = kappa + w2;
  a_2 = -v.*w0;
  w3 = alpha.*w2;
  l_0 = w3;
  w_line = kappa.*p + w3;
  l_0_2 = l_0.*l_0;
  w_line_2 = w_line.*w_line;
  w4 = w_line_2.*width;
  c_0 = l_0_2 - w4;
  l_1 = -alpha.*sin.*v;
  l_1_2 = l_1.*l_1;
  c_2 = l_1_2 + w4;
  q = B + sigma;
  a_1 = B.*p.*sigma - lean.*v - q.*w1.*w_line;
  c_1 = 2.*l_0.*l_1;
  result1 = a_0.*c_2 - a_2.*c_0;
  result2 = -a_1.*c_2 + a_2.*c_1;
end
