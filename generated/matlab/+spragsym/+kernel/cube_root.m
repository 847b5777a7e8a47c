function root = cube_root(x)
%CUBE_ROOT  Cube roots of numbers > 0, 0 for others.
%  A third of the exponent by the bits, which is good to a few percent, then Halley's method: the C library's statements.
  third = bitshift(typecast(x(:), 'uint64'), -2);
  third = third + bitshift(third, -2);
  third = third + bitshift(third, -4);
  third = third + bitshift(third, -8);
  root = reshape(typecast(third + bitshift(uint64(715094163), 32), 'double'), size(x));
  for pass = 1:3
    cube = root .* root .* root;
    root = root .* ((cube + 2 .* x) ./ (2 .* cube + x));
  end
  root(~(x > 0)) = 0;
end
