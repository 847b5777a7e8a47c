function [result1, result2, result3] = fold_events(sin, kappa, alpha, sigma, beta)
%FOLD_EVENTS  Polynomials in s = sin θ that are 0 at a θ < π/2 where two folds meet, where one has θ₀ = 0 or π, and where
%  one has μ₀ = 0. Needs α > 0. Returns meeting, border, frictionless, elements one after the other. Source: f = f′ = 0.
%  Operations: 76.
  B = beta + 1;
  a_f = sigma.*(B - alpha);
  p = alpha + sigma;
  sin_2 = sin.*sin;
  sin_3 = sin.*sin_2;
  w0 = a_f.*sin_3 - kappa.*p;
  w1 = kappa + sigma.*sin.*(2 - sin_2);
  w2 = B.*p;
  e1 = sigma.*w0 + w1.*w2;
  e0 = -a_f.*sin_2.*(kappa.*sin + sigma) + kappa.*p.*w1;
  e2 = -sigma.*w2;
  middle = 2.*e0 + 4.*e2;
  q = B + sigma;
  sigma_2 = sigma.*sigma;
  sin_4 = sin_2.*sin_2;
  w3 = 1 - sin_2;
  alpha_2 = alpha.*alpha;
  q_2 = q.*q;
  w4 = alpha_2.*q_2;
  ec_2 = sigma_2.*sin_4.*w3.*w4;
  e0_2 = e0.*e0;
  product = e0_2 - ec_2;
  e1_2 = e1.*e1;
  middle_2 = middle.*middle;
  P = -12.*e1_2 + middle_2 + 12.*product;
  middle_3 = middle.*middle_2;
  Q = -216.*e0.*e1_2 + 36.*e1_2.*middle + 72.*middle.*product - 2.*middle_3;
  P_2 = P.*P;
  P_3 = P.*P_2;
  Q_2 = Q.*Q;
  a_f_2 = a_f.*a_f;
  w0_2 = w0.*w0;
  w3_2 = w3.*w3;
  w3_3 = w3.*w3_2;
  B_2 = B.*B;
  p_2 = p.*p;
  w5 = B_2.*p_2;
  result1 = 4.*P_3 - Q_2;
  result2 = product;
  result3 = a_f_2.*w3_3.*w5 + w0_2.*w4 - w4.*w5;
end
