function result = wide_direction(t)
%WIDE_DIRECTION  cos θ and sin θ at t = tan(θ/2).
  inverse = spragsym.kernel.dd_divide(spragsym.kernel.paired(1.0, 0.0), ...
      spragsym.kernel.dd_add_double(spragsym.kernel.dd_multiply(t, t), 1.0));
  result.cosine = spragsym.kernel.dd_multiply(spragsym.kernel.dd_multiply(spragsym.kernel.dd_add_double( ...
      spragsym.kernel.dd_negative(t), 1.0), spragsym.kernel.dd_add_double(t, 1.0)), inverse);
  result.sine = spragsym.kernel.dd_multiply(spragsym.kernel.dd_scaled(t, 2.0), inverse);
end
