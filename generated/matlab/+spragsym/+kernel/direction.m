function result = direction(t)
%DIRECTION  cos θ and sin θ at t = tan(θ/2).
  inverse = 1.0 ./ (1.0 + t .* t);
  result.cosine = (1.0 - t) .* (1.0 + t) .* inverse;
  result.sine = 2.0 .* t .* inverse;
end
