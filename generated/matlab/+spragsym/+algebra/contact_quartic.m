function [result1, result2, result3, result4, result5] = contact_quartic(cos0, sin0, mu0, kappa, alpha, sigma, beta)
%CONTACT_QUARTIC  Coefficients of c0 + c1 L + c2 L² + c3 L³ + c4 L⁴ = 0 in contact. Returns c0, c1, c2, c3, c4, elements one
%  after the other. Source: (21), (A1)–(A5). Operations: 45.
  M = mu0;
  b1 = -M.*sin0 - alpha.*cos0;
  B = beta + 1;
  b2 = -B.*sin0 - kappa;
  p = alpha + sigma;
  q = B + sigma;
  b1_2 = b1.*b1;
  sigma_2 = sigma.*sigma;
  b2_2 = b2.*b2;
  w0 = -sigma_2;
  w1 = b2_2 + w0;
  w2 = 2.*sigma;
  base3 = M.*b2 - b1.*q;
  base3_2 = base3.*base3;
  p_2 = p.*p;
  q_2 = q.*q;
  w3 = p.*q;
  result1 = sigma_2.*(b1_2 + w1);
  result2 = w2.*(M.*b1.*b2 - p.*w1 - q.*(b1_2 + w0));
  result3 = b2_2.*p_2 + base3_2 - sigma_2.*(p_2 + q_2 + 4.*w3);
  result4 = w2.*w3.*(p + q);
  result5 = -p_2.*q_2;
end
