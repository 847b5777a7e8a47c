function point = point(given, nbar)
%POINT  Checked parameters as the kernel takes them: with cos and sin of theta0; nbar is 1 in contact and 0 in lift-off.
  along = spragsym.kernel.cosine_and_sine(given.theta0);
  point = struct('cos0', along.cosine, 'sin0', along.sine, 'mu0', given.mu0, 'kappa', given.kappa, ...
                 'alpha', given.alpha, 'sigma', given.sigma, 'beta', given.beta, 'nbar', nbar);
end
