function regime = regime(model, state)
%REGIME  The smooth regime that the motion goes on in: contact, and side 1 with the mass slower than the belt, else -1.
%  regime = spragsym.regime(model, state)
%
%  By the state, and on a kink by where the state is headed, for which the regime does not matter: forces are continuous there.
  given = struct('contact', state(2) < 0, 'side', 2 * (model.V >= state(3)) - 1);
  rate = spragsym.regime_rhs(model, given, state);
  regime = struct('contact', leading_sign(state(2), state(4), rate(4)) < 0, ...
                  'side', leading_sign(model.V - state(3), -rate(3), 1));
end

function result = leading_sign(value, first, second)
% The sign of the first of three that is not zero.
  deciding = second;
  if abs(value) > 0
    deciding = value;
  elseif abs(first) > 0
    deciding = first;
  end
  result = 2 * (deciding > 0) - 1;
end
