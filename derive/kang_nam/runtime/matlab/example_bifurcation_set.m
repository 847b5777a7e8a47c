% Draws the bifurcation set of the article's base values: where the number of equilibria in contact changes.
p = spragsym.article();
found = spragsym.bifurcation_set(p);
figure
hold on
for k = 1:numel(found.curves)
  curve = found.curves(k);
  plot(180/pi*curve.theta0, curve.mu0, 'k-');
end
plot(180/pi*found.cusps.theta0, found.cusps.mu0, 'ro');
axis([0, 180, 0, 1.5]);
xlabel('\theta_0 in degrees');
ylabel('\mu_0');
title('Across a fold two equilibria in contact appear or vanish');
for k = 1:numel(found.cusps.mu0)
  fprintf('cusp at theta0 = %.6f degrees, mu0 = %.9f\n', 180/pi*found.cusps.theta0(k), found.cusps.mu0(k));
end
