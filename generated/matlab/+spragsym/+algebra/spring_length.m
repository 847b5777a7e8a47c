function result1 = spring_length(x, y, cos0, sin0)
%SPRING_LENGTH  Length of the inclined spring. Returns L, elements one after the other. Source: (6) corrected. Operations:
%  7.
  base0 = cos0 - x;
  base0_2 = base0.*base0;
  base2 = sin0 - y;
  base2_2 = base2.*base2;
  result1 = sqrt(base0_2 + base2_2);
end
