function regime = beyond(regime, kink)
%BEYOND  The regime that a motion enters where it leaves another one through a kink: 1 for y = 0, 2 for x' = V.
%  regime = spragsym.beyond(regime, kink) with the number that ode45 gives for an event of spragsym.kinks
  if kink == 1
    regime.contact = ~regime.contact;
  else
    regime.side = -regime.side;
  end
end
