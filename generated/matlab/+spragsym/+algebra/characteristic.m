function [result1, result2, result3, result4, result5] = characteristic(K11, K12, K21, K22, C11)
%CHARACTERISTIC  Coefficients of det(λ² I + λ C + K), highest power first; C11 = 0 is (27). Returns e4, e3, e2, e1, e0,
%  elements one after the other. Source: (27) with damping. Operations: 5.
  result1 = 1;
  result2 = C11;
  result3 = K11 + K22;
  result4 = C11.*K22;
  result5 = K11.*K22 - K12.*K21;
end
