function [result1, result2, result3, result4, result5, result6] = dimensionless_groups(m, k_c, L_0, F_L, k_x, k, k_y, V_dim, ...
    d_dim)
%DIMENSIONLESS_GROUPS  The dimensionless parameters of dimensional data. Returns kappa, alpha, sigma, beta, V, d, elements
%  one after the other. Source: text after (9). Operations: 19.
  result1 = F_L./(L_0.*k_c);
  result2 = k_x./k_c;
  result3 = k./k_c;
  result4 = k_y./k_c;
  result5 = V_dim.*sqrt(m)./(L_0.*sqrt(k_c));
  result6 = L_0.*d_dim.*sqrt(k_c)./sqrt(m);
end
