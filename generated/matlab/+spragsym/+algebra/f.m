function result1 = f(cos, sin, a_f, b_f, d_f, m_f)
%F  The scalar function whose roots are the equilibria. Returns f, elements one after the other. Source: (12), (13)
%  eliminated. Operations: 9.
  sin_2 = sin.*sin;
  result1 = a_f.*cos.*sin + b_f.*cos + d_f.*sin - m_f.*sin_2;
end
