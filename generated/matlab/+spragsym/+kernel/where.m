function result = where(condition, yes, no)
%WHERE  The elements of yes where the condition holds, and those of no elsewhere.
  if isscalar(condition)
    if condition
      result = yes;
    else
      result = no;
    end
    return
  end
  result = no;
  if isscalar(no)
    result = repmat(no, size(condition));
  end
  if isscalar(yes)
    result(condition) = yes;
  else
    result(condition) = yes(condition);
  end
end
