function result1 = f_slope(cos, sin, a_f, b_f, d_f, m_f)
%F_SLOPE  df/dθ, which is L det K at an equilibrium. Returns f′, elements one after the other. Source: (12), (13)
%  eliminated. Operations: 13.
  cos_2 = cos.*cos;
  sin_2 = sin.*sin;
  result1 = a_f.*cos_2 - a_f.*sin_2 + cos.*d_f + sin.*(-b_f - 2.*cos.*m_f);
end
