function result1 = flutter_friction(cos, sin, L, alpha, sigma, beta)
%FLUTTER_FRICTION  μ₀ at a flutter onset with spring length L in direction θ, in contact. Returns mu0, elements one after
%  the other. Source: (27). Operations: 21.
  B = beta + 1;
  L_2 = L.*L;
  cos_2 = cos.*cos;
  sigma_2 = sigma.*sigma;
  sin_2 = sin.*sin;
  w0 = -B + alpha;
  w0_2 = w0.*w0;
  result1 = (-2.*L.*sigma.*w0.*(cos_2 - sin_2) - L_2.*w0_2 - sigma_2)./(4.*L.*cos.*sigma.*sin);
end
