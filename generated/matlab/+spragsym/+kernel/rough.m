function result = rough(x)
%ROUGH  A number as a double, for bounds and for results: itself, and of a double-double the leading part.
  result = x;
end
