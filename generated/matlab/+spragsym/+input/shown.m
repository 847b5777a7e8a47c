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
