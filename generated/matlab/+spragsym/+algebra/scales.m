function [result1, result2, result3] = scales(m, k_c, L_0)
%SCALES  Scales of length, time and force. Returns length, time, force, elements one after the other. Source: text after
%  (9). Operations: 6.
  result1 = L_0;
  result2 = sqrt(m)./sqrt(k_c);
  result3 = L_0.*k_c;
end
