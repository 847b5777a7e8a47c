function result = one_or_three(point, u)
%ONE_OR_THREE  The number of equilibria in contact, 1 or 3; 0 where that is open.
%
%  Each is a positive root in t. One is positive unless all four are real and e1 > 0; then three are, by Descartes' rule. Of
%  these the ones in contact have sin θ > s* = sin θ₀ − κ/σ. At the lower end t = c of these directions f is negative, so
%  that none or two of the three lie below it. None lies beyond the upper end, where cos θ < 0 and sin θ = s < s* < sin θ₀:
%  there f = |cos θ| (|b| − a s) + s (m (s* − s) + α q cos θ₀) is positive, by |b| − a s > α q s and |cos θ| > |cos θ₀|.
%
%  ``margin`` is more than what the derivatives at c may be off by. All coefficients are at most 4 and c at most 1; the
%  largest share is that of c, which is off by √(22 u) at most, near c = 1, and changes a derivative by up to 44 times as
%  much; the rest is below 480 u (1 + a_size + d_size).
  line = spragsym.kernel.balance_(point);
  e = spragsym.kernel.quartic(line.a, line.b, line.d, line.m);
  D = spragsym.kernel.discriminant(line, spragsym.kernel.cubic(line.a, line.b, line.d, line.m), u);
  margin = 512.0 .* sqrt(u) .* (1.0 + line.a_size + line.d_size);
  lowest = spragsym.kernel.larger(point.sin0 - point.kappa ./ point.sigma, 0.0);
  c = lowest ./ (1.0 + sqrt((1.0 - lowest) .* (1.0 + lowest)));
  in_contact = spragsym.kernel.above(e.e1, e.e2, e.e3, e.e4, c, margin);
  certain = spragsym.kernel.sound(point) & spragsym.kernel.representable(line);
  three_positive = certain & (D.value < -D.error) & (e.e1 > margin);
  one_positive_root = certain & ((D.value > D.error) | spragsym.kernel.one_positive(line, e, u));
  one = one_positive_root | (three_positive & in_contact.one);
  result = spragsym.kernel.where(one, 1.0, spragsym.kernel.where(three_positive & in_contact.all, 3.0, 0.0));
end
