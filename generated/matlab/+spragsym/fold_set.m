function given = fold_set(p, spanned)
%FOLD_SET  Checked parameters of one point at which double precision can tell folds.
  given = spragsym.one_set(p, spanned);
  % Where f and its derivatives know where contact begins.
  least = 1e-12 * max(given.sigma, 1 + given.beta);
  if given.kappa < least
    error('spragsym:range', ['kappa = %s is too small beside sigma and 1 + beta for folds in double precision; give at least ' ...
          '%g, or ask the Python package'], spragsym.input.shown(given.kappa), least);
  end
end
