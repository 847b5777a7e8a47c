function result = single_(point, u)
%SINGLE_  Whether there certainly is exactly one equilibrium in contact: one root in t is positive, and there
%  always is an equilibrium.
  line = spragsym.kernel.balance_(point);
  D = spragsym.kernel.discriminant(line, u);
  result = ((D.value > D.error) | spragsym.kernel.one_positive(line, u)) & spragsym.kernel.sound(point) & ...
      spragsym.kernel.representable(line);
end
