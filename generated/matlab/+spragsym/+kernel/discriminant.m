function result = discriminant(line, it, u)
%DISCRIMINANT  The sign of P³ + Q² is that of the discriminant, reversed.
%
%  From bounds on the errors of P and Q: |P̃³ − P³| ≤ 3 (|P| + error)² error and |Q̃² − Q²| ≤ 2 (|Q| + error) error; cubing,
%  squaring and adding round four times more.
  UNDERFLOW = 1e-307;  % What underflow may add to P³ + Q² at most, generously.
  COUNT_P = 22.0;  % a count of roundings
  COUNT_Q = 27.0;  % a count of roundings
  size = spragsym.kernel.depressed_size(line.a_size, abs(line.b), line.d_size, line.m);
  P_bound = abs(it.P) + COUNT_P .* u .* size.P;
  Q_bound = abs(it.Q) + COUNT_Q .* u .* size.Q;
  from_P = P_bound .* P_bound .* size.P .* (3.0 .* COUNT_P + 4.0);
  from_Q = Q_bound .* size.Q .* (2.0 .* COUNT_Q + 4.0);
  result.value = it.P .* it.P .* it.P + it.Q .* it.Q;
  result.error = u .* (from_P + from_Q) + UNDERFLOW;
end
