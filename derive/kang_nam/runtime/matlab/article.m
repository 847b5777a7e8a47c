function p = article(varargin)
%ARTICLE  The article's base values as a structure, with changes.
%  p = spragsym.article('theta0', 49/180*pi, 'mu0', 0.7)
%
%  theta0 is the control parameter and has no base value. Any field may be a vector: then each element is a point, and fields
%  with one number hold for all.
  p = struct(@base@);
  if mod(numel(varargin), 2) ~= 0
    error('spragsym:name', 'article takes names and values in turn');
  end
  for k = 1:2:numel(varargin)
    if ~ischar(varargin{k})
      error('spragsym:name', 'article takes names and values in turn; argument %d is no name', k);
    end
    p.(varargin{k}) = varargin{k + 1};
  end
end
