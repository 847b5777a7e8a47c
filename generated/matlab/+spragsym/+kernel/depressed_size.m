function result = depressed_size(a_size, b_size, d_size, m_size)
%DEPRESSED_SIZE  The sizes of P and Q.
  r1_size = 0.25 .* (a_size .* a_size + b_size .* b_size + d_size .* d_size);
  r0_size = 0.25 .* b_size .* (a_size .* d_size + m_size .* b_size);
  mean = m_size ./ 3.0;
  result.P = (r1_size + m_size .* mean) ./ 3.0;
  result.Q = 0.5 .* (r0_size + mean .* (r1_size + 2.0 .* mean .* mean));
end
