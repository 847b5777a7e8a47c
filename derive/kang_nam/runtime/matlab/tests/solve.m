% Equilibria of the points in a file of doubles, for the tests: octave solve.m PACKAGE_FOLDER POINTS CONTACT ANSWERS
% The answers are doubles again, a point after the other: status, count, then theta, L, x, y, stability and error of every slot.
arguments = argv();
[folder, points, contact, answers] = arguments{:};
addpath(folder);
source = fopen(points);
table = fread(source, [6, Inf], 'double')';
fclose(source);
names = {'theta0', 'mu0', 'kappa', 'alpha', 'sigma', 'beta'};
for k = 1:6
  p.(names{k}) = table(:, k);
end
best = Inf;
for run = 1:2
  start = tic;
  found = spragsym.equilibria(p, contact == '1');
  best = min(best, toc(start));
end
columns = [found.status, found.count, found.theta, found.L, found.x, found.y, found.stability, found.error];
target = fopen(answers, 'w');
fwrite(target, columns', 'double');
fclose(target);
printf('%.0f\n', 1e9 * best / rows(table));
