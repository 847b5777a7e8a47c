classdef input
%INPUT  Checks of what is given.
  methods (Static)
    function given = parameters(p, spanned)
    %PARAMETERS  The fields of a structure of parameters as columns of one length, checked.
    %  Those that are spanned are not used: they are NaN.
      names = {'theta0', 'mu0', 'kappa', 'alpha', 'sigma', 'beta'};
      if nargin < 2
        spanned = {};
      end
      if ~isstruct(p) || ~isscalar(p)
        error('spragsym:type', 'the parameters are %s; give a structure with %s', spragsym.input.shown(p), strjoin(names, ', '));
      end
      unknown = setdiff(fieldnames(p), names);
      if ~isempty(unknown)
        error('spragsym:name', '%s is not among the parameters, which are %s', unknown{1}, strjoin(names, ', '));
      end
      count = 1;
      for k = 1:numel(names)
        name = names{k};
        if any(strcmp(name, spanned))
          given.(name) = NaN;
          continue
        end
        if ~isfield(p, name)
          [~, text] = spragsym.input.range(name);
          error('spragsym:missing', '%s is missing; it is a number in %s', name, text);
        end
        given.(name) = spragsym.input.numbers(name, p.(name));
        if numel(given.(name)) > 1 && count > 1 && numel(given.(name)) ~= count
          error('spragsym:size', '%s has %d numbers, and another parameter has %d; give one number or as many', ...
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

    function value = numbers(quantity, value, count, name)
    %NUMBERS  Real numbers in the range of a quantity as a column, or an error that names it.
    %  With a count other than [] there must be exactly that many. An error names NAME where it is given, else the quantity.
      [ends, text, remedy] = spragsym.input.range(quantity);
      if nargin < 4
        name = quantity;
      end
      if ~isnumeric(value) || ~isreal(value) || isempty(value)
        error('spragsym:type', '%s = %s must be real numbers in %s', name, spragsym.input.shown(value), text);
      end
      value = double(value(:));
      if nargin > 2 && ~isempty(count) && numel(value) ~= count
        error('spragsym:size', '%s has %d numbers in [%s]; it must be %d', name, numel(value), text, count);
      end
      low = value > ends(1) | (~ends(3) & value == ends(1));
      high = value < ends(2) | (~ends(4) & value == ends(2));
      wrong = find(~(low & high & isfinite(value)), 1);
      if ~isempty(wrong)
        place = '';
        if numel(value) > 1
          place = sprintf('(%d)', wrong);
        end
        if ~isfinite(value(wrong))
          remedy = '';
        end
        error('spragsym:range', '%s%s = %s is not in %s%s', name, place, spragsym.input.shown(value(wrong)), text, remedy);
      end
    end

    function text = shown(value)
    %SHOWN  A value as errors show it.
      if ischar(value)
        text = ['''' value ''''];
      elseif isscalar(value) && (isnumeric(value) || islogical(value))
        text = sprintf('%.15g', double(value));
        if str2double(text) ~= value
          text = sprintf('%.17g', double(value));
        end
      else
        text = sprintf('%s of size %s', class(value), strrep(num2str(size(value)), '  ', ' x '));
      end
    end

    function value = whole(name, value, least)
    %WHOLE  A whole number of at least so much, or an error that names it.
      if ~isnumeric(value) || ~isscalar(value) || ~isreal(value) || ~isfinite(value) || value ~= floor(value) || value < least
        error('spragsym:range', '%s = %s is not a whole number >= %d', name, spragsym.input.shown(value), least);
      end
    end

    function [ends, text, remedy] = range(name)
    %RANGE  Allowed values of a quantity: [low, high, low is left out, high is left out], as text, and what to do about others.
      switch name
        case {'theta0'}
          ends = [0, pi, 1, 1]; text = '(0, pi)'; remedy = ': angles are radians';
        case {'mu0', 'alpha', 'beta', 'k_x', 'k_y'}
          ends = [0, Inf, 0, 1]; text = '[0, Inf)'; remedy = '';
        case {'kappa', 'sigma', 'F_L', 'L', 'L_0', 'T', 'd', 'd_dim', 'k', 'k_c', 'm'}
          ends = [0, Inf, 1, 1]; text = '(0, Inf)'; remedy = '';
        case {'C11', 'K11', 'K12', 'K21', 'K22', 'V', 'V_dim', 'a_f', 'a_v', 'b_f', 'b_v', 'd_f', 'd_v', 'm_f', 'm_v', 'side', ...
            'vx', 'vy', 'x', 'y'}
          ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
        case {'cos', 'cos0', 'sin', 'sin0'}
          ends = [-1, 1, 0, 0]; text = '[-1, 1]'; remedy = '';
        case {'nbar'}
          ends = [0, 1, 0, 0]; text = '[0, 1]'; remedy = '';
        otherwise
          error('spragsym:name', '%s is not a quantity of this model', name);
      end
    end
  end
end
