function [ends, text, remedy] = range(name)
%RANGE  Allowed values of a quantity: [low, high, low is left out, high is left out], as text, and what to do about others.
  switch name
    @cases@
    otherwise
      error('@library@:name', '%s is not a quantity of this model', name);
  end
end
