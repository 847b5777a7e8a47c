function [result1, result2, result3] = invariants(K11, K12, K21, K22)
%INVARIANTS  Trace, determinant (negative: divergence) and discriminant in λ² (negative: flutter) of K. Returns trace,
%  determinant, discriminant, elements one after the other. Source: (27). Operations: 8.
  w0 = K12.*K21;
  base0 = K11 - K22;
  base0_2 = base0.*base0;
  result1 = K11 + K22;
  result2 = K11.*K22 - w0;
  result3 = base0_2 + 4.*w0;
end
