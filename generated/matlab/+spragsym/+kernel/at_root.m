function result = at_root(t, point, line, u)
%AT_ROOT  State, error bounds and stability at a root of f that is proved to lie near θ = 2 atan t.
%
%  Newton–Kantorovich on f at θ: a root lies within about |f|/|f′|. Then, with R = (β + n̄) sin θ₀ + κ, L = σ/q + R/(q sin
%  θ), y = (σ (sin θ₀ − sin θ) − κ)/q and x = cos θ₀ − L cos θ over that radius: sin θ changes by at most radius (|cos θ| +
%  radius), cos θ by radius (|sin θ| + radius), and 1/sin θ as sin θ does, over sin² θ, but for some thousandths.
  INFINITY = Inf;
  % The largest h = |f| max|f″| / f′² for which a root is taken as proved: Kantorovich's theorem asks for 1/2.
  LARGEST_H = 0.4;
  LARGEST_RADIUS = 0.001;  % The largest radius around θ, over sin θ, for which the bounds on the state below hold.
  COUNT_F = 21.0;  % a count of roundings
  COUNT_SLOPE = 24.0;  % a count of roundings
  COUNT_STATE = 18.0;  % a count of roundings
  COUNT_THETA = 16.0;  % a count of roundings
  at = spragsym.kernel.direction(t);
  c_size = abs(at.cosine);
  s_size = abs(at.sine);
  b_size = abs(line.b);
  m_size = line.m;
  f_size = spragsym.algebra.f(c_size, s_size, line.a_size, b_size, line.d_size, -m_size);
  value = abs(spragsym.algebra.f(at.cosine, at.sine, line.a, line.b, line.d, line.m)) + COUNT_F .* u .* f_size;
  slope = spragsym.algebra.f_slope(at.cosine, at.sine, line.a, line.b, line.d, line.m);
  slope_size = line.a_size + b_size .* s_size + (line.d_size + 2.0 .* m_size .* s_size) .* c_size;
  steepness = abs(slope) - COUNT_SLOPE .* u .* slope_size;
  bend = 2.0 .* (line.a_size + m_size) + b_size + line.d_size;
  newton = value ./ steepness;
  h = newton .* bend ./ steepness;
  proved = (steepness > 0.0) & (h < LARGEST_H) & (newton < LARGEST_RADIUS .* s_size) & spragsym.kernel.sound(point);
  % The root is within (1 − √(1 − 2 h))/h ≤ 1/(1 − h) Newton steps.
  radius = spragsym.kernel.where(proved, 1.0001 .* newton ./ (1.0 - h), INFINITY);
  [wide_L, wide_x, wide_y] = spragsym.algebra.state(at.cosine, at.sine, point.cos0, point.sin0, point.kappa, point.sigma, ...
      point.beta, point.nbar);
  L = wide_L;
  x = wide_x;
  y = wide_y;
  sin0 = point.sin0;
  kappa = point.kappa;
  sigma = point.sigma;
  nbar = point.nbar;
  stiff = point.beta + nbar;
  over = 1.0 ./ (stiff + sigma);
  L_size = (sigma .* s_size + stiff .* sin0 + kappa) .* over ./ s_size;
  relative = radius ./ s_size;
  swing = c_size + relative;
  rounding = COUNT_STATE .* u;
  L_error = L_size .* (1.01 .* relative .* swing + rounding);
  y_size = sigma .* (sin0 + s_size) + kappa;
  y_error = (1.01 .* sigma .* radius .* swing + rounding .* y_size) .* over;
  turn = 1.01 .* radius .* (s_size + radius);
  x_error = L_error .* swing + L_size .* (turn + rounding .* c_size) + rounding;
  state_error = spragsym.kernel.larger(L_error, x_error) ./ spragsym.kernel.larger(spragsym.kernel.smaller(L, abs(x)), 1.0);
  error = spragsym.kernel.larger(state_error, spragsym.kernel.larger(radius + COUNT_THETA .* u, y_error));
  beyond = (1.0 - 2.0 .* nbar) .* y;
  member = (L > L_error) & (beyond > y_error);
  outsider = (L < -L_error) | (beyond < -y_error);
  uncertainty = spragsym.kernel.larger(relative, L_error ./ abs(L)) + 8.0 .* u;
  kind = spragsym.kernel.stability(at, wide_L, slope, uncertainty, point);
  result.L = L;
  result.x = x;
  result.y = y;
  result.radius = radius;
  result.error = error;
  result.member = member;
  result.outsider = outsider;
  result.code = kind.code;
  result.known = proved & kind.certain;
end
