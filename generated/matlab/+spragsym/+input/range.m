function [ends, text, remedy] = range(name)
%RANGE  Allowed values of a quantity: [low, high, low is left out, high is left out], as text, and what to do about others.
  switch name
    case 'theta0'
      ends = [0, pi, 1, 1]; text = '(0, pi)'; remedy = ': angles are radians';
    case 'mu0'
      ends = [0, Inf, 0, 1]; text = '[0, Inf)'; remedy = '';
    case 'kappa'
      ends = [0, Inf, 1, 1]; text = '(0, Inf)'; remedy = '';
    case 'alpha'
      ends = [0, Inf, 0, 1]; text = '[0, Inf)'; remedy = '';
    case 'sigma'
      ends = [0, Inf, 1, 1]; text = '(0, Inf)'; remedy = '';
    case 'beta'
      ends = [0, Inf, 0, 1]; text = '[0, Inf)'; remedy = '';
    case 'C11'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'F_L'
      ends = [0, Inf, 1, 1]; text = '(0, Inf)'; remedy = '';
    case 'K11'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'K12'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'K21'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'K22'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'L'
      ends = [0, Inf, 1, 1]; text = '(0, Inf)'; remedy = '';
    case 'L_0'
      ends = [0, Inf, 1, 1]; text = '(0, Inf)'; remedy = '';
    case 'T'
      ends = [0, Inf, 1, 1]; text = '(0, Inf)'; remedy = '';
    case 'V'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'V_dim'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'a_f'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'a_v'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'b_f'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'b_v'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'cos'
      ends = [-1, 1, 0, 0]; text = '[-1, 1]'; remedy = '';
    case 'cos0'
      ends = [-1, 1, 0, 0]; text = '[-1, 1]'; remedy = '';
    case 'd'
      ends = [0, Inf, 1, 1]; text = '(0, Inf)'; remedy = '';
    case 'd_dim'
      ends = [0, Inf, 1, 1]; text = '(0, Inf)'; remedy = '';
    case 'd_f'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'd_v'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'k'
      ends = [0, Inf, 1, 1]; text = '(0, Inf)'; remedy = '';
    case 'k_c'
      ends = [0, Inf, 1, 1]; text = '(0, Inf)'; remedy = '';
    case 'k_x'
      ends = [0, Inf, 0, 1]; text = '[0, Inf)'; remedy = '';
    case 'k_y'
      ends = [0, Inf, 0, 1]; text = '[0, Inf)'; remedy = '';
    case 'm'
      ends = [0, Inf, 1, 1]; text = '(0, Inf)'; remedy = '';
    case 'm_f'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'm_v'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'nbar'
      ends = [0, 1, 0, 0]; text = '[0, 1]'; remedy = '';
    case 'side'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'sin'
      ends = [-1, 1, 0, 0]; text = '[-1, 1]'; remedy = '';
    case 'sin0'
      ends = [-1, 1, 0, 0]; text = '[-1, 1]'; remedy = '';
    case 'vx'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'vy'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'x'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    case 'y'
      ends = [-Inf, Inf, 1, 1]; text = '(-Inf, Inf)'; remedy = '';
    otherwise
      error('spragsym:name', '%s is not a quantity of this model', name);
  end
end
