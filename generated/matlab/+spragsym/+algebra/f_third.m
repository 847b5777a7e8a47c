function result1 = f_third(cos, sin, a_f, b_f, d_f, m_f)
%F_THIRD  d³f/dθ³. Returns f‴, elements one after the other. Source: (12), (13) eliminated. Operations: 14.
  cos_2 = cos.*cos;
  sin_2 = sin.*sin;
  w0 = 4.*a_f;
  result1 = b_f.*sin - cos.*d_f + 8.*cos.*m_f.*sin - cos_2.*w0 + sin_2.*w0;
end
