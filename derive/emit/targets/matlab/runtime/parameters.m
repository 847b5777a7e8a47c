function given = parameters(p, spanned)
%PARAMETERS  The fields of a structure of parameters as columns of one length, checked.
%  Those that are spanned are not used: they are NaN.
  names = {@names@};
  if nargin < 2
    spanned = {};
  end
  if ~isstruct(p) || ~isscalar(p)
    error('@library@:type', 'the parameters are %s; give a structure with %s', @library@.checks.shown(p), strjoin(names, ', '));
  end
  unknown = setdiff(fieldnames(p), names);
  if ~isempty(unknown)
    error('@library@:name', '%s is not among the parameters, which are %s', unknown{1}, strjoin(names, ', '));
  end
  count = 1;
  for k = 1:numel(names)
    name = names{k};
    if any(strcmp(name, spanned))
      given.(name) = NaN;
      continue
    end
    if ~isfield(p, name)
      [~, text] = @library@.checks.range(name);
      error('@library@:missing', '%s is missing; it is a number in %s', name, text);
    end
    given.(name) = @library@.checks.numbers(name, p.(name));
    if numel(given.(name)) > 1 && count > 1 && numel(given.(name)) ~= count
      error('@library@:size', '%s has %d numbers, and another parameter has %d; give one number or as many', ...
          name, numel(given.(name)), count);
    end
    count = max(count, numel(given.(name)));
  end
  for k = 1:numel(names)
    if isscalar(given.(names{k}))
      given.(names{k}) = repmat(given.(names{k}), count, 1);
    end
  end
end
