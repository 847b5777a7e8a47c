function given = one_set(p, spanned)
%ONE_SET  Checked parameters of one point, of which those that are spanned are not used.
  given = spragsym.checks.parameters(p, spanned);
  if numel(given.kappa) ~= 1
    error('spragsym:size', 'p has %d points; this function takes one', numel(given.kappa));
  end
  given.fixed = {given.kappa, given.alpha, given.sigma, given.beta};
end
