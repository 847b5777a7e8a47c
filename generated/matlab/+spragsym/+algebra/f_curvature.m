function result1 = f_curvature(cos, sin, a_f, b_f, d_f, m_f)
%F_CURVATURE  d²f/dθ². Returns f″, elements one after the other. Source: (12), (13) eliminated. Operations: 15.
  cos_2 = cos.*cos;
  sin_2 = sin.*sin;
  result1 = -4.*a_f.*cos.*sin - b_f.*cos - 2.*cos_2.*m_f - d_f.*sin + 2.*m_f.*sin_2;
end
