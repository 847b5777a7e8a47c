function result = dd_sqrt(x)
%DD_SQRT  √x for x ≥ 0, to some units of 2^-106: a double root with one step of Newton's method.
  root = sqrt(x.high);
  root_squared = spragsym.kernel.two_product(root, root);
  rest = x.high - root_squared.high - root_squared.low + x.low;
  result = spragsym.kernel.fast_two_sum(root, spragsym.kernel.where(root > 0.0, rest ./ (2.0 .* root), 0.0));
end
