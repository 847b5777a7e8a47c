function [result1, result2, result3, result4, result5] = liftoff_quartic(cos0, sin0, kappa, alpha, sigma, beta)
%LIFTOFF_QUARTIC  Coefficients of d0 + d1 L + d2 L² + d3 L³ + d4 L⁴ = 0 in lift-off, d0 as derived. Returns d0, d1, d2, d3,
%  d4, elements one after the other. Source: (26), (A1) corrected, (A6)–(A9). Operations: 37.
  b1 = -alpha.*cos0;
  B = beta;
  b2 = -B.*sin0 - kappa;
  p = alpha + sigma;
  q = B + sigma;
  b1_2 = b1.*b1;
  sigma_2 = sigma.*sigma;
  b2_2 = b2.*b2;
  w0 = -sigma_2;
  w1 = b2_2 + w0;
  w2 = 2.*sigma;
  p_2 = p.*p;
  q_2 = q.*q;
  w3 = p.*q;
  result1 = sigma_2.*(b1_2 + w1);
  result2 = w2.*(-p.*w1 - q.*(b1_2 + w0));
  result3 = b1_2.*q_2 + b2_2.*p_2 - sigma_2.*(p_2 + q_2 + 4.*w3);
  result4 = w2.*w3.*(p + q);
  result5 = -p_2.*q_2;
end
