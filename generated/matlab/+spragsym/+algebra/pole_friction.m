function result1 = pole_friction(T, alpha, sigma, beta)
%POLE_FRICTION  μ₀ with a pole at T = tan θ₀. Returns mu0, elements one after the other. Source: determinant of the linear
%  model. Operations: 13.
  T_2 = T.*T;
  result1 = (T_2.*alpha.*(beta + sigma + 1) + alpha.*beta + alpha + beta.*sigma + sigma)./(T.*sigma);
end
