function [result1, result2, result3] = fold_events_without_alpha(sin, kappa, sigma, beta)
%FOLD_EVENTS_WITHOUT_ALPHA  The same for α = 0: 0 where two folds meet, where two have θ₀ = 0 and π, and where they meet at
%  π/2. Returns meeting, border, middle, elements one after the other. Source: f = f′ = 0. Operations: 45.
  B = beta + 1;
  w0 = B.*sigma;
  a_f = w0;
  sin_2 = sin.*sin;
  w1 = kappa + sigma.*sin.*(2 - sin_2);
  e0 = -a_f.*sin_2.*(kappa.*sin + sigma) + kappa.*sigma.*w1;
  sin_3 = sin.*sin_2;
  e1 = -sigma.*(-a_f.*sin_3 + kappa.*sigma) + w0.*w1;
  sigma_2 = sigma.*sigma;
  e2 = -B.*sigma_2;
  e1_2 = e1.*e1;
  kappa_2 = kappa.*kappa;
  w2 = sin - 1;
  w3 = -w2;
  result1 = -4.*e0.*e2 + e1_2;
  result2 = e0;
  result3 = sigma.*(kappa_2 + w3.*(B.*kappa.*(sin + sin_2 + 1) - kappa.*sigma.*(-sin_2 - w2) - w0.*w3));
end
