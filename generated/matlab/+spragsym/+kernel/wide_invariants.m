function result = wide_invariants(K11, K12, K21, K22)
%WIDE_INVARIANTS  Trace, determinant (negative: divergence) and discriminant in λ² (negative: flutter) of K.
  w0 = spragsym.kernel.dd_multiply(K12, K21);
  base0 = spragsym.kernel.dd_add(K11, spragsym.kernel.dd_negative(K22));
  base0_2 = spragsym.kernel.dd_multiply(base0, base0);
  result.value0 = spragsym.kernel.dd_add(K11, K22);
  result.value1 = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(K11, K22), spragsym.kernel.dd_negative(w0));
  result.value2 = spragsym.kernel.dd_add(base0_2, spragsym.kernel.dd_scaled(w0, 4.0));
end
