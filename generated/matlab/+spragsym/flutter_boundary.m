function found = flutter_boundary(p, n)
%FLUTTER_BOUNDARY  Every curve of flutter onsets in contact, for 0 < theta0 < pi and mu0 >= 0, as far as n directions show them.
%  found = spragsym.flutter_boundary(p) or spragsym.flutter_boundary(p, n): an array of structures as found.curves of
%  spragsym.bifurcation_set, with n directions to begin with, at least 8
  if nargin < 2
    n = 512;
  end
  given = spragsym.one_set(p, {'theta0', 'mu0'});
  n = spragsym.input.whole('n', n, 8);
  % Flutter needs pi/2 < theta < pi; towards both ends in ever smaller steps.
  even = linspace(0.5 * pi, pi, n + 1);
  towards = exp(linspace(log(1e-9), log(0.25 * pi), floor(n / 4) + 1));
  found = spragsym.curves('onsets', unique([even(2:end - 1), 0.5 * pi + towards, pi - towards]), given);
end
