classdef kernel
%KERNEL  How the equilibria of one point are found and how far the result can be trusted, written once for every target
%  language.
  methods (Static)
    function result = paired(high, low)
    %PAIRED  The number of which both parts are known.
      result = struct('high', high, 'low', low);
    end

    function result = two_sum(a, b)
    %TWO_SUM  a + b, exactly (Knuth).
      s = a + b;
      of_b = s - a;
      of_a = s - of_b;
      result = struct('high', s, 'low', a - of_a + (b - of_b));
    end

    function result = fast_two_sum(a, b)
    %FAST_TWO_SUM  a + b, exactly where |a| ≥ |b| or a = 0 (Dekker).
      s = a + b;
      result = struct('high', s, 'low', b - (s - a));
    end

    function result = two_product(a, b)
    %TWO_PRODUCT  a b, exactly (Dekker, Veltkamp).
      SPLITTER = 134217729.0;  % 2^27 + 1 splits a double into two halves of 26 bits.
      p = a .* b;
      big_a = SPLITTER .* a;
      high_a = big_a - (big_a - a);
      low_a = a - high_a;
      big_b = SPLITTER .* b;
      high_b = big_b - (big_b - b);
      low_b = b - high_b;
      result = struct('high', p, 'low', high_a .* high_b - p + high_a .* low_b + low_a .* high_b + low_a .* low_b);
    end

    function result = dd_negative(x)
    %DD_NEGATIVE  −x, exactly.
      result = struct('high', -x.high, 'low', -x.low);
    end

    function result = dd_absolute(x)
    %DD_ABSOLUTE  |x|, exactly.
      result = struct('high', abs(x.high), 'low', spragsym.kernel.where(x.high < 0.0, -x.low, x.low));
    end

    function result = dd_leading(x)
    %DD_LEADING  The double nearest to x.
      result = x.high;
    end

    function result = dd_scaled(x, power)
    %DD_SCALED  x times a power of two, exactly.
      result = struct('high', x.high .* power, 'low', x.low .* power);
    end

    function result = dd_less(x, y)
    %DD_LESS  Whether x < y, by the sign of the difference: low parts decide only where high ones are the same or next to each
    %  other.
      result = x.high - y.high + (x.low - y.low) < 0.0;
    end

    function result = dd_where(chosen, x, y)
    %DD_WHERE  x where the flag is set, y elsewhere.
      result = struct('high', spragsym.kernel.where(chosen, x.high, y.high), 'low', spragsym.kernel.where(chosen, x.low, y.low));
    end

    function result = dd_larger(x, y)
    %DD_LARGER  The larger of two.
      result = spragsym.kernel.dd_where(spragsym.kernel.dd_less(y, x), x, y);
    end

    function result = dd_smaller(x, y)
    %DD_SMALLER  The smaller of two.
      result = spragsym.kernel.dd_where(spragsym.kernel.dd_less(x, y), x, y);
    end

    function result = dd_add(x, y)
    %DD_ADD  x + y (algorithm 6).
      s = spragsym.kernel.two_sum(x.high, y.high);
      t = spragsym.kernel.two_sum(x.low, y.low);
      v = spragsym.kernel.fast_two_sum(s.high, s.low + t.high);
      result = spragsym.kernel.fast_two_sum(v.high, t.low + v.low);
    end

    function result = dd_add_double(x, y)
    %DD_ADD_DOUBLE  x + y with a double y (algorithm 4).
      s = spragsym.kernel.two_sum(x.high, y);
      result = spragsym.kernel.fast_two_sum(s.high, x.low + s.low);
    end

    function result = dd_multiply(x, y)
    %DD_MULTIPLY  x y (algorithm 10).
      c = spragsym.kernel.two_product(x.high, y.high);
      crossed = x.high .* y.low + x.low .* y.high;
      result = spragsym.kernel.fast_two_sum(c.high, c.low + crossed);
    end

    function result = dd_multiply_double(x, y)
    %DD_MULTIPLY_DOUBLE  x y with a double y (algorithm 7).
      c = spragsym.kernel.two_product(x.high, y);
      v = spragsym.kernel.fast_two_sum(c.high, x.low .* y);
      result = spragsym.kernel.fast_two_sum(v.high, v.low + c.low);
    end

    function result = dd_divide(x, y)
    %DD_DIVIDE  x / y (algorithm 17).
      t = x.high ./ y.high;
      r = spragsym.kernel.dd_multiply_double(y, t);
      rest = x.high - r.high + (x.low - r.low);
      result = spragsym.kernel.fast_two_sum(t, rest ./ y.high);
    end

    function result = dd_sqrt(x)
    %DD_SQRT  √x for x ≥ 0, to some units of 2^-106: a double root with one step of Newton's method.
      root = sqrt(x.high);
      root_squared = spragsym.kernel.two_product(root, root);
      rest = x.high - root_squared.high - root_squared.low + x.low;
      result = spragsym.kernel.fast_two_sum(root, spragsym.kernel.where(root > 0.0, rest ./ (2.0 .* root), 0.0));
    end

    function result = dd_cosine_and_sine(x)
    %DD_COSINE_AND_SINE  cos x and sin x of a double 0 < x < π, within 2^-101 of themselves.
    %
    %  x = k π/2 + r with |r| ≤ π/4 by π/2 in three parts, of which the first leaves nothing to round; then Taylor's series, whose
    %  terms from the tenth on need a double only.
      k = spragsym.kernel.where(x > 0.7853981633974483, 1.0, 0.0) + spragsym.kernel.where(x > 2.356194490192345, 1.0, 0.0);
      near = x - k .* 1.5707963267948966;
      r = spragsym.kernel.dd_add_double(spragsym.kernel.two_sum(near, -k .* 6.123233995736766e-17), k .* 1.4973849048591698e-33);
      z = spragsym.kernel.dd_multiply(r, r);
      odd = -9.183689863795546e-29;
      odd = 6.446950284384474e-26 + z.high .* odd;
      odd = -3.868170170630684e-23 + z.high .* odd;
      odd = 1.9572941063391263e-20 + z.high .* odd;
      odd = -8.22063524662433e-18 + z.high .* odd;
      s = spragsym.kernel.paired(odd, 0.0);
      s = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, s), spragsym.kernel.paired(2.8114572543455206e-15, ...
          1.6508842730861433e-31));
      s = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, s), spragsym.kernel.paired(-7.647163731819816e-13, ...
          -7.03872877733453e-30));
      s = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, s), spragsym.kernel.paired(1.6059043836821613e-10, ...
          1.2585294588752098e-26));
      s = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, s), spragsym.kernel.paired(-2.505210838544172e-08, ...
          1.448814070935912e-24));
      s = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, s), spragsym.kernel.paired(2.7557319223985893e-06, ...
          -1.858393274046472e-22));
      s = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, s), spragsym.kernel.paired(-0.0001984126984126984, ...
          -1.7209558293420705e-22));
      s = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, s), spragsym.kernel.paired(0.008333333333333333, ...
          1.1564823173178714e-19));
      s = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, s), spragsym.kernel.paired(-0.16666666666666666, ...
          -9.25185853854297e-18));
      s = spragsym.kernel.dd_multiply(r, spragsym.kernel.dd_add_double(spragsym.kernel.dd_multiply(z, s), 1.0));
      even = -2.4795962632247976e-27;
      even = 1.6117375710961184e-24 + z.high .* even;
      even = -8.896791392450574e-22 + z.high .* even;
      even = 4.110317623312165e-19 + z.high .* even;
      even = -1.5619206968586225e-16 + z.high .* even;
      c = spragsym.kernel.paired(even, 0.0);
      c = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, c), spragsym.kernel.paired(4.779477332387385e-14, ...
          4.399205485834081e-31));
      c = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, c), spragsym.kernel.paired(-1.1470745597729725e-11, ...
          -2.0655512752830745e-28));
      c = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, c), spragsym.kernel.paired(2.08767569878681e-09, ...
          -1.20734505911326e-25));
      c = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, c), spragsym.kernel.paired(-2.755731922398589e-07, ...
          -2.3767714622250297e-23));
      c = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, c), spragsym.kernel.paired(2.48015873015873e-05, ...
          2.1511947866775882e-23));
      c = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, c), spragsym.kernel.paired(-0.001388888888888889, ...
          5.300543954373577e-20));
      c = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, c), spragsym.kernel.paired(0.041666666666666664, ...
          2.3129646346357427e-18));
      c = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(z, c), spragsym.kernel.paired(-0.5, 0.0));
      c = spragsym.kernel.dd_add_double(spragsym.kernel.dd_multiply(z, c), 1.0);
      sine = spragsym.kernel.dd_where(k == 1.0, c, spragsym.kernel.dd_where(k > 1.0, spragsym.kernel.dd_negative(s), s));
      cosine = spragsym.kernel.dd_where(k == 1.0, spragsym.kernel.dd_negative(s), spragsym.kernel.dd_where(k > 1.0, ...
          spragsym.kernel.dd_negative(c), c));
      result = struct('cosine_high', cosine.high, 'cosine_low', cosine.low, 'sine_high', sine.high, 'sine_low', sine.low);
    end

    function result = direction(t)
    %DIRECTION  cos θ and sin θ at t = tan(θ/2).
      inverse = 1.0 ./ (1.0 + t .* t);
      result = struct('cosine', (1.0 - t) .* (1.0 + t) .* inverse, 'sine', 2.0 .* t .* inverse);
    end

    function result = ordinary(parameter)
    %ORDINARY  Whether a parameter is 0 or large enough for relative rounding errors.
      % A parameter that is smaller, but not 0, may lose digits to underflow, which no count of roundings covers.
      SMALLEST_PARAMETER = 1e-250;
      result = (parameter > SMALLEST_PARAMETER) | (parameter <= 0.0);
    end

    function result = sound(point)
    %SOUND  Whether the bounds below can count on relative rounding errors.
      SMALLEST_PARAMETER = 1e-250;
      sin0 = point.sin0;
      kappa = point.kappa;
      sigma = point.sigma;
      across = (sin0 > SMALLEST_PARAMETER) & (kappa > SMALLEST_PARAMETER) & (sigma > SMALLEST_PARAMETER);
      result = across & spragsym.kernel.ordinary(point.mu0) & spragsym.kernel.ordinary(point.alpha) & ...
          spragsym.kernel.ordinary(point.beta);
    end

    function result = tame(parameter)
    %TAME  Whether a parameter is 0 or far from underflow and overflow.
      % Between these, numbers are far enough from underflow and overflow for the exact products of double-double arithmetic.
      SMALLEST_WIDE = 1e-50;
      LARGEST_WIDE = 1e+50;
      result = (parameter < LARGEST_WIDE) & ((parameter > SMALLEST_WIDE) | (parameter <= 0.0));
    end

    function result = balance_(point)
    %BALANCE_  f of the point: coefficients and sizes over the largest coefficient.
      [a, b, d, m] = spragsym.algebra.f_coefficients(point.cos0, point.sin0, point.mu0, point.kappa, point.alpha, point.sigma, ...
          point.beta, point.nbar);
      [a_size, d_size] = spragsym.algebra.f_magnitudes(point.cos0, point.sin0, point.mu0, point.kappa, point.alpha, ...
          point.sigma, point.beta, point.nbar);
      % m = μ₀ σ n̄ is not negative.
      scale = spragsym.kernel.larger(spragsym.kernel.larger(abs(a), abs(b)), spragsym.kernel.larger(abs(d), m));
      over = 1.0 ./ scale;
      result = struct('a', a .* over, 'b', b .* over, 'd', d .* over, 'm', m .* over, 'a_size', a_size .* over, 'd_size', ...
          d_size .* over, 'scale', scale);
    end

    function result = representable(line)
    %REPRESENTABLE  Whether double precision can carry the quartic of this balance.
      SMALLEST_SCALE = 1e-200;  % Between these the largest coefficient of f can be divided out without underflow or overflow.
      LARGEST_SCALE = 1e+200;
      % The least |b| over the largest coefficient: the quartic in t is divided by it, and roots farther apart share no scale.
      SMALLEST_RATIO = 1e-60;
      result = (line.scale > SMALLEST_SCALE) & (line.scale < LARGEST_SCALE) & (line.b <= -SMALLEST_RATIO);
    end

    function result = depressed(r0, r1, r2)
    %DEPRESSED  The resolvent r0 + r1 ℓ + r2 ℓ² + ℓ³ without its quadratic term; P³ + Q² < 0: four real roots in t.
      mean = r2 ./ 3.0;
      result = struct('P', (r1 - r2 .* mean) ./ 3.0, 'Q', 0.5 .* (r0 - mean .* (r1 - 2.0 .* mean .* mean)));
    end

    function result = depressed_size(a_size, b_size, d_size, m_size)
    %DEPRESSED_SIZE  The sizes of P and Q.
      r1_size = 0.25 .* (a_size .* a_size + b_size .* b_size + d_size .* d_size);
      r0_size = 0.25 .* b_size .* (a_size .* d_size + m_size .* b_size);
      mean = m_size ./ 3.0;
      result = struct('P', (r1_size + m_size .* mean) ./ 3.0, 'Q', 0.5 .* (r0_size + mean .* (r1_size + 2.0 .* mean .* mean)));
    end

    function result = cubic(a, b, d, m)
    %CUBIC  The resolvent of the quartic in t, and the same without its quadratic term.
      [r0, r1, r2] = spragsym.algebra.resolvent(a, b, d, m);
      it = spragsym.kernel.depressed(r0, r1, r2);
      result = struct('r0', r0, 'r1', r1, 'r2', r2, 'P', it.P, 'Q', it.Q);
    end

    function result = quartic(a, b, d, m)
    %QUARTIC  The quartic in t = tan(θ/2) whose roots are those of f.
      [e0, e1, e2, e3, e4] = spragsym.algebra.t_quartic(a, b, d, m);
      result = struct('e0', e0, 'e1', e1, 'e2', e2, 'e3', e3, 'e4', e4);
    end

    function result = discriminant(line, it, u)
    %DISCRIMINANT  The sign of P³ + Q² is that of the discriminant, reversed.
    %
    %  From bounds on the errors of P and Q: |P̃³ − P³| ≤ 3 (|P| + error)² error and |Q̃² − Q²| ≤ 2 (|Q| + error) error; cubing,
    %  squaring and adding round four times more.
      UNDERFLOW = 1e-307;  % What underflow may add to P³ + Q² at most, generously.
      COUNT_P = 22.0;  % a count of roundings
      COUNT_Q = 27.0;  % a count of roundings
      size = spragsym.kernel.depressed_size(line.a_size, abs(line.b), line.d_size, line.m);
      P_bound = abs(it.P) + COUNT_P .* u .* size.P;
      Q_bound = abs(it.Q) + COUNT_Q .* u .* size.Q;
      from_P = P_bound .* P_bound .* size.P .* (3.0 .* COUNT_P + 4.0);
      from_Q = Q_bound .* size.Q .* (2.0 .* COUNT_Q + 4.0);
      result = struct('value', it.P .* it.P .* it.P + it.Q .* it.Q, 'error', u .* (from_P + from_Q) + UNDERFLOW);
    end

    function result = one_positive(line, e, u)
    %ONE_POSITIVE  Whether certainly exactly one root in t is positive: Descartes' rule with e0 < 0 < e4, e2 ≤ 0 and e1 < 0.
      COUNT_E1 = 10.0;  % a count of roundings
      result = e.e1 < -2.0 .* COUNT_E1 .* u .* (line.a_size + line.d_size);
    end

    function result = outermost(P, Q)
    %OUTERMOST  The root of z³ + 3 P z + 2 Q of largest magnitude, which is far from the others.
      % Where P or Q vanishes, as at a cusp, it is replaced by the smallest normal number.
      SMALLEST_NORMAL = 2.2250738585072014e-308;
      size = abs(Q);
      inside = P .* P .* P + Q .* Q;
      % One real root: Cardano, in the form that does not cancel for P > 0.
      w = spragsym.kernel.cube_root(size + sqrt(spragsym.kernel.larger(inside, 0.0)) + SMALLEST_NORMAL);
      v = P ./ w;
      alone = spragsym.kernel.where(P > 0.0, 2.0 .* size ./ (w .* w + P + v .* v), w - v);
      % Three: 2 √−P cos(φ/3) with cos φ = |Q| / √−P³, from 4 z³ − 3 z = cos φ on [√3/2, 1], where Newton converges at once.
      root = sqrt(spragsym.kernel.larger(-P, SMALLEST_NORMAL));
      cosine = spragsym.kernel.smaller(size ./ (root .* root .* root), 1.0);
      z = 0.8660254037844386 + cosine .* (0.16306 - 0.02908 .* cosine);
      for pass = 1:2
        z = z - ((4.0 .* z .* z - 3.0) .* z - cosine) ./ (12.0 .* z .* z - 3.0);
      end
      largest = spragsym.kernel.where(inside < 0.0, 2.0 .* root .* z, alone);
      result = spragsym.kernel.where(Q > 0.0, -largest, largest);
    end

    function result = simple_root(it)
    %SIMPLE_ROOT  The real root of the resolvent cubic farthest from the mean of the three, to full relative accuracy.
      % Newton's step squares the error, so that more than a double would be lost on the start.
      z = spragsym.kernel.outermost(it.P, it.Q);
      x = z - it.r2 ./ 3.0;
      slope = (3.0 .* x + 2.0 .* it.r2) .* x + it.r1;
      step = (((x + it.r2) .* x + it.r1) .* x + it.r0) ./ slope;
      result = x - spragsym.kernel.where(abs(step) < abs(z), step, 0.0);
    end

    function result = polish(A1, A2, A3, p1, q1, p2, q2)
    %POLISH  One Newton step on both factors of t⁴ + A3 t³ + A2 t² + A1 t − 1 at once.
    %
    %  The change of the second factor is the remainder over the first, modulo the second. q1 q2 = −1 is kept by setting the
    %  smaller from the larger.
      INFINITY = Inf;
      r3 = A3 - (p1 + p2);
      r2 = A2 - (q1 + q2) - p1 .* p2;
      r1 = A1 - p1 .* q2 - p2 .* q1;
      r0 = -1.0 - q1 .* q2;
      s1 = r3 .* (p2 .* p2 - q2) - r2 .* p2 + r1;
      s0 = (r3 .* p2 - r2) .* q2 + r0;
      du = p1 - p2;
      dv = q1 - q2;
      dw = dv - du .* p2;
      inverse = 1.0 ./ (dv .* dw + du .* du .* q2);
      dp2 = (s1 .* dv - s0 .* du) .* inverse;
      dq2 = (s0 .* dw + s1 .* du .* q2) .* inverse;
      dp1 = r3 - dp2;
      dq1 = r2 - dq2 - p2 .* dp1 - p1 .* dp2;
      % Where three roots meet, the factors share a root and the step is not reliable.
      new_q1 = q1 + dq1;
      new_q2 = q2 + dq2;
      good = (new_q1 < 0.0) & (new_q2 > 0.0) & (abs(dp1 + dp2 + dq1 + dq2) < INFINITY);
      q1 = spragsym.kernel.where(good, new_q1, q1);
      q2 = spragsym.kernel.where(good, new_q2, q2);
      larger_second = -q1 < q2;
      inverse_q = -1.0 ./ spragsym.kernel.where(larger_second, q2, q1);
      result = struct('p1', spragsym.kernel.where(good, p1 + dp1, p1), 'q1', spragsym.kernel.where(larger_second, inverse_q, ...
          q1), 'p2', spragsym.kernel.where(good, p2 + dp2, p2), 'q2', spragsym.kernel.where(larger_second, q2, inverse_q));
    end

    function result = factors(e, resolved)
    %FACTORS  The two real quadratic factors of the quartic in t.
      over = 1.0 ./ e.e4;
      A1 = e.e1 .* over;
      A2 = e.e2 .* over;
      A3 = e.e3 .* over;
      y = -4.0 .* over .* spragsym.kernel.simple_root(resolved);
      width = sqrt(y .* y + 4.0);
      large = 0.5 .* (abs(y) + width);
      small = 1.0 ./ large;
      q2 = spragsym.kernel.where(y > 0.0, large, small);
      q1 = -spragsym.kernel.where(y > 0.0, small, large);
      inverse = 1.0 ./ width;
      result = spragsym.kernel.polish(A1, A2, A3, (A1 - A3 .* q1) .* inverse, q1, (A3 .* q2 - A1) .* inverse, q2);
    end

    function result = root_pair(p, q)
    %ROOT_PAIR  The two roots of t² + p t + q without cancellation.
      half = 0.5 .* p;
      quarter = half .* half - q;
      radical = sqrt(spragsym.kernel.larger(quarter, 0.0));
      large = -half - spragsym.kernel.where(half > 0.0, radical, -radical);
      result = struct('large', large, 'small', q ./ large, 'discriminant', quarter);
    end

    function result = guesses(point, line, u)
    %GUESSES  The roots that may be equilibria.
    %
    %  In contact only positive ones: with sin θ < 0 < L, y = sin θ₀ − L sin θ would be positive. The first factor has a root of
    %  either sign; those of the second are complex, or both negative, or both positive.
      INFINITY = Inf;
      e = spragsym.kernel.quartic(line.a, line.b, line.d, line.m);
      resolved = spragsym.kernel.cubic(line.a, line.b, line.d, line.m);
      D = spragsym.kernel.discriminant(line, resolved, u);
      halves = spragsym.kernel.factors(e, resolved);
      first = spragsym.kernel.root_pair(halves.p1, halves.q1);
      second = spragsym.kernel.root_pair(halves.p2, halves.q2);
      contact = point.nbar > 0.0;
      spared = (D.value > D.error) | (contact & spragsym.kernel.one_positive(line, e, u));
      real = second.discriminant >= 0.0;
      more = real & (~spared);
      % A sorting network; places without a root go to the end.
      low = spragsym.kernel.where(contact, INFINITY, spragsym.kernel.smaller(first.large, first.small));
      high = spragsym.kernel.larger(first.large, first.small);
      third = spragsym.kernel.where(more, second.large, INFINITY);
      fourth = spragsym.kernel.where(more, second.small, INFINITY);
      a1 = spragsym.kernel.smaller(low, high);
      a2 = spragsym.kernel.larger(low, high);
      b1 = spragsym.kernel.smaller(third, fourth);
      b2 = spragsym.kernel.larger(third, fourth);
      inner = spragsym.kernel.larger(a1, b1);
      outer = spragsym.kernel.smaller(a2, b2);
      count = spragsym.kernel.where(contact, 1.0, 2.0) + spragsym.kernel.where(more, 2.0, 0.0);
      result = struct('t0', spragsym.kernel.smaller(a1, b1), 't1', spragsym.kernel.smaller(inner, outer), 't2', ...
          spragsym.kernel.larger(inner, outer), 't3', spragsym.kernel.larger(a2, b2), 'count', count, 'certain', spared | ...
          real);
    end

    function result = at_root(t, point, line, u)
    %AT_ROOT  State, error bounds and stability at a root of f that is proved to lie near θ = 2 atan t.
    %
    %  Newton–Kantorovich on f at θ: a root lies within about |f|/|f′|. Then, with R = (β + n̄) sin θ₀ + κ, L = σ/q + R/(q sin θ),
    %  y = (σ (sin θ₀ − sin θ) − κ)/q and x = cos θ₀ − L cos θ over that radius: sin θ changes by at most radius (|cos θ| +
    %  radius), cos θ by radius (|sin θ| + radius), and 1/sin θ as sin θ does, over sin² θ, but for some thousandths.
      INFINITY = Inf;
      % The largest h = |f| max|f″| / f′² for which a root is taken as proved: Kantorovich's theorem asks for 1/2.
      LARGEST_H = 0.4;
      LARGEST_RADIUS = 0.001;  % The largest radius around θ, over sin θ, for which the bounds on the state below hold.
      COUNT_F = 21.0;  % a count of roundings
      COUNT_SLOPE = 24.0;  % a count of roundings
      COUNT_STATE = 18.0;  % a count of roundings
      COUNT_THETA = 16.0;  % a count of roundings
      at = spragsym.kernel.direction(t);
      c_size = abs(at.cosine);
      s_size = abs(at.sine);
      b_size = abs(line.b);
      m_size = line.m;
      f_size = spragsym.algebra.f(c_size, s_size, line.a_size, b_size, line.d_size, -m_size);
      value = abs(spragsym.algebra.f(at.cosine, at.sine, line.a, line.b, line.d, line.m)) + COUNT_F .* u .* f_size;
      slope = spragsym.algebra.f_slope(at.cosine, at.sine, line.a, line.b, line.d, line.m);
      slope_size = line.a_size + b_size .* s_size + (line.d_size + 2.0 .* m_size .* s_size) .* c_size;
      steepness = abs(slope) - COUNT_SLOPE .* u .* slope_size;
      bend = 2.0 .* (line.a_size + m_size) + b_size + line.d_size;
      newton = value ./ steepness;
      h = newton .* bend ./ steepness;
      proved = (steepness > 0.0) & (h < LARGEST_H) & (newton < LARGEST_RADIUS .* s_size) & spragsym.kernel.sound(point);
      % The root is within (1 − √(1 − 2 h))/h ≤ 1/(1 − h) Newton steps.
      radius = spragsym.kernel.where(proved, 1.0001 .* newton ./ (1.0 - h), INFINITY);
      [wide_L, wide_x, wide_y] = spragsym.algebra.state(at.cosine, at.sine, point.cos0, point.sin0, point.kappa, point.sigma, ...
          point.beta, point.nbar);
      L = wide_L;
      x = wide_x;
      y = wide_y;
      sin0 = point.sin0;
      kappa = point.kappa;
      sigma = point.sigma;
      nbar = point.nbar;
      stiff = point.beta + nbar;
      over = 1.0 ./ (stiff + sigma);
      L_size = (sigma .* s_size + stiff .* sin0 + kappa) .* over ./ s_size;
      relative = radius ./ s_size;
      swing = c_size + relative;
      rounding = COUNT_STATE .* u;
      L_error = L_size .* (1.01 .* relative .* swing + rounding);
      y_size = sigma .* (sin0 + s_size) + kappa;
      y_error = (1.01 .* sigma .* radius .* swing + rounding .* y_size) .* over;
      turn = 1.01 .* radius .* (s_size + radius);
      x_error = L_error .* swing + L_size .* (turn + rounding .* c_size) + rounding;
      state_error = spragsym.kernel.larger(L_error, x_error) ./ spragsym.kernel.larger(spragsym.kernel.smaller(L, abs(x)), 1.0);
      error = spragsym.kernel.larger(state_error, spragsym.kernel.larger(radius + COUNT_THETA .* u, y_error));
      beyond = (1.0 - 2.0 .* nbar) .* y;
      member = (L > L_error) & (beyond > y_error);
      outsider = (L < -L_error) | (beyond < -y_error);
      uncertainty = spragsym.kernel.larger(relative, L_error ./ abs(L)) + 8.0 .* u;
      kind = spragsym.kernel.stability(at, wide_L, slope, uncertainty, point);
      result = struct('L', L, 'x', x, 'y', y, 'radius', radius, 'error', error, 'member', member, 'outsider', outsider, ...
          'code', kind.code, 'known', proved & kind.certain);
    end

    function result = stability(at, L, slope, uncertainty, point)
    %STABILITY  1 stable, 2 divergent, 3 flutter, by (27).
    %
    %  The sign of det K is that of f′, which is known where the root is proved. ``uncertainty`` bounds the errors of cos θ, and
    %  of sin θ and L over themselves.
      COUNT_K = 9.0;  % a count of roundings
      [K11, K12, K21, K22] = spragsym.algebra.stiffness(at.cosine, at.sine, L, point.mu0, point.alpha, point.sigma, ...
          point.beta, point.nbar);
      [wide_trace, ~, wide_flutter] = spragsym.algebra.invariants(K11, K12, K21, K22);
      trace = wide_trace;
      flutter = wide_flutter;
      sigma = point.sigma;
      nbar = point.nbar;
      pull = sigma ./ abs(L);
      % N + 2 pull.
      size = point.alpha + point.beta + nbar + 2.0 .* sigma + 3.0 .* pull;
      margin = COUNT_K .* uncertainty .* size;
      saddle = slope < 0.0;
      fluttering = flutter < 0.0;
      code = spragsym.kernel.where(saddle, 2.0, spragsym.kernel.where(fluttering, 3.0, spragsym.kernel.where(trace > 0.0, 1.0, ...
          2.0)));
      % Far from a vanishing discriminant, and from a vanishing trace where that decides.
      far = abs(flutter) > margin .* (size + 1.5 .* point.mu0 .* nbar);
      result = struct('code', code, 'certain', saddle | (far & (fluttering | (abs(trace) > margin))));
    end

    function result = apart(low, low_radius, high, high_radius)
    %APART  Whether two intervals in θ around 2 atan(low) < 2 atan(high) are disjoint: dθ = 2 dt/(1 + t²).
      low_square = low .* low;
      high_square = high .* high;
      result = 2.0 .* (high - low) > (low_radius + high_radius) .* (1.0 + spragsym.kernel.larger(low_square, high_square));
    end

    function result = cosine_and_sine(x)
    %COSINE_AND_SINE  cos x and sin x for 0 < x < π in double precision, within one unit in the last place, which not every
    %  library's are.
    %
    %  x = k π/2 + (r + tail) with r at most π/4, by π/2 in two parts, of which the first leaves nothing to round; then the
    %  polynomials of fdlibm's k_sin.c and k_cos.c.
      k = spragsym.kernel.where(x > 0.7853981633974483, 1.0, 0.0) + spragsym.kernel.where(x > 2.356194490192345, 1.0, 0.0);
      near = x - k .* 1.5707963267948966;
      rest = k .* 6.123233995736766e-17;
      r = near - rest;
      tail = near - r - rest;
      z = r .* r;
      odd4 = -2.5050760253406863e-08 + z .* 1.58969099521155e-10;
      odd = 0.00833333333332249 + z .* (-0.0001984126982985795 + z .* (2.7557313707070068e-06 + z .* odd4));
      s = r - (z .* (0.5 .* tail - z .* r .* odd) - tail - z .* r .* -0.16666666666666632);
      even4 = -2.7557314351390663e-07 + z .* (2.087572321298175e-09 + z .* -1.1359647557788195e-11);
      even = 0.0416666666666666 + z .* (-0.001388888888887411 + z .* (2.480158728947673e-05 + z .* even4));
      half = 0.5 .* z;
      top = 1.0 - half;
      c = top + (1.0 - top - half + (z .* z .* even - r .* tail));
      sine = spragsym.kernel.where(k == 1.0, c, spragsym.kernel.where(k > 1.0, -s, s));
      cosine = spragsym.kernel.where(k == 1.0, -s, spragsym.kernel.where(k > 1.0, -c, c));
      result = struct('cosine', cosine, 'sine', sine);
    end

    function result = arctangent(t)
    %ARCTANGENT  atan t in double precision, within one unit in the last place.
    %
    %  By atan t = atan c + atan((t − c)/(1 + c t)) with c one of 0, 1/2, 1, 3/2 and infinity, whose arc tangents stand in two
    %  parts; then the polynomial of fdlibm's s_atan.c.
      size = abs(t);
      first = size < 0.4375;
      second = size < 0.6875;
      third = size < 1.1875;
      fourth = size < 2.4375;
      beyond = spragsym.kernel.where(fourth, size - 1.5, -1.0) ./ spragsym.kernel.where(fourth, 1.0 + 1.5 .* size, size);
      about_one = spragsym.kernel.where(second, 2.0 .* size - 1.0, size - 1.0) ./ spragsym.kernel.where(second, 2.0 + size, ...
          size + 1.0);
      x = spragsym.kernel.where(first, size, spragsym.kernel.where(third, about_one, beyond));
      high = spragsym.kernel.where(third, spragsym.kernel.where(second, 0.4636476090008061, 0.7853981633974483), ...
          spragsym.kernel.where(fourth, 0.982793723247329, 1.5707963267948966));
      low = spragsym.kernel.where(third, spragsym.kernel.where(second, 2.2698777452961687e-17, 3.061616997868383e-17), ...
          spragsym.kernel.where(fourth, 1.3903311031230998e-17, 6.123233995736766e-17));
      z = x .* x;
      w = z .* z;
      even = 0.06661073137387531 + w .* (0.049768779946159324 + w .* 0.016285820115365782);
      even = 0.3333333333333293 + w .* (0.14285714272503466 + w .* (0.09090887133436507 + w .* even));
      odd = -0.058335701337905735 + w .* -0.036531572744216916;
      odd = -0.19999999999876483 + w .* (-0.11111110405462356 + w .* (-0.0769187620504483 + w .* odd));
      rest = x .* (z .* even + w .* odd);
      result = spragsym.kernel.where(first, x - rest, high - (rest - low - x));
      result = spragsym.kernel.where(t < 0.0, -result, result);
    end

    function [result1, result2, result3, result4] = wide_f_coefficients(cos0, sin0, mu0, kappa, alpha, sigma, beta, nbar)
    %WIDE_F_COEFFICIENTS  a, b, d, m of f(θ) = a sin θ cos θ + b cos θ + d sin θ − m sin² θ = q sin θ F_x(θ, L(θ)).
      B = spragsym.kernel.dd_add(beta, nbar);
      a_f = spragsym.kernel.dd_multiply(sigma, spragsym.kernel.dd_add(B, spragsym.kernel.dd_negative(alpha)));
      p = spragsym.kernel.dd_add(alpha, sigma);
      b_f = spragsym.kernel.dd_multiply(spragsym.kernel.dd_negative(p), spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(B, ...
          sin0), kappa));
      M = spragsym.kernel.dd_multiply(mu0, nbar);
      q = spragsym.kernel.dd_add(B, sigma);
      d_f = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(M, spragsym.kernel.dd_add(spragsym.kernel.dd_negative(kappa), ...
          spragsym.kernel.dd_multiply(sigma, sin0))), spragsym.kernel.dd_multiply(spragsym.kernel.dd_multiply(alpha, cos0), ...
          q));
      m_f = spragsym.kernel.dd_multiply(M, sigma);
      result1 = a_f;
      result2 = b_f;
      result3 = d_f;
      result4 = m_f;
    end

    function result = wide_balance(point)
    %WIDE_BALANCE  ``balance`` in double-double arithmetic.
      [a, b, d, m] = spragsym.kernel.wide_f_coefficients(point.cos0, point.sin0, point.mu0, point.kappa, point.alpha, ...
          point.sigma, point.beta, point.nbar);
      [a_size, d_size] = spragsym.algebra.f_magnitudes(point.cos0.high, point.sin0.high, point.mu0.high, point.kappa.high, ...
          point.alpha.high, point.sigma.high, point.beta.high, point.nbar.high);
      scale = spragsym.kernel.larger(spragsym.kernel.larger(abs(a.high), abs(b.high)), spragsym.kernel.larger(abs(d.high), ...
          m.high));
      over = 1.0 ./ scale;
      result = struct('a', spragsym.kernel.dd_multiply_double(a, over), 'b', spragsym.kernel.dd_multiply_double(b, over), 'd', ...
          spragsym.kernel.dd_multiply_double(d, over), 'm', spragsym.kernel.dd_multiply_double(m, over), 'a_size', a_size .* ...
          over, 'd_size', d_size .* over, 'scale', scale);
    end

    function result = wide_moderate(point)
    %WIDE_MODERATE  ``moderate`` in double-double arithmetic.
      SMALLEST_WIDE = 1e-50;
      sin0 = point.sin0.high;
      across = (sin0 > SMALLEST_WIDE) & spragsym.kernel.tame(point.kappa.high) & spragsym.kernel.tame(point.sigma.high) & ...
          spragsym.kernel.tame(point.beta.high);
      result = across & spragsym.kernel.tame(point.mu0.high) & spragsym.kernel.tame(point.alpha.high);
    end

    function result = wide_representable(line)
    %WIDE_REPRESENTABLE  ``representable`` in double-double arithmetic.
      SMALLEST_SCALE = 1e-200;
      LARGEST_SCALE = 1e+200;
      SMALLEST_RATIO = 1e-60;
      result = (line.scale > SMALLEST_SCALE) & (line.scale < LARGEST_SCALE) & (line.b.high <= -SMALLEST_RATIO);
    end

    function [result1, result2, result3, result4, result5] = wide_t_quartic(a_f, b_f, d_f, m_f)
    %WIDE_T_QUARTIC  Coefficients of (1 + t²)² f = e0 + e1 t + e2 t² + e3 t³ + e4 t⁴ with t = tan(θ/2).
      result1 = b_f;
      result2 = spragsym.kernel.dd_scaled(spragsym.kernel.dd_add(a_f, d_f), 2.0);
      result3 = spragsym.kernel.dd_scaled(m_f, -4.0);
      result4 = spragsym.kernel.dd_scaled(spragsym.kernel.dd_add(spragsym.kernel.dd_negative(a_f), d_f), 2.0);
      result5 = spragsym.kernel.dd_negative(b_f);
    end

    function result = wide_quartic(a, b, d, m)
    %WIDE_QUARTIC  ``quartic`` in double-double arithmetic.
      [e0, e1, e2, e3, e4] = spragsym.kernel.wide_t_quartic(a, b, d, m);
      result = struct('e0', e0, 'e1', e1, 'e2', e2, 'e3', e3, 'e4', e4);
    end

    function [result1, result2, result3] = wide_resolvent(a_f, b_f, d_f, m_f)
    %WIDE_RESOLVENT  Coefficients of the cubic r0 + r1 ℓ + r2 ℓ² + ℓ³ with the discriminant of the quartic in t.
      result1 = spragsym.kernel.dd_scaled(spragsym.kernel.dd_multiply(spragsym.kernel.dd_negative(b_f), ...
          spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(a_f, d_f), spragsym.kernel.dd_multiply(b_f, m_f))), 0.25);
      result2 = spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_scaled(spragsym.kernel.dd_negative( ...
          spragsym.kernel.dd_multiply(a_f, a_f)), 0.25), spragsym.kernel.dd_scaled(spragsym.kernel.dd_multiply(b_f, ...
          b_f), 0.25)), spragsym.kernel.dd_scaled(spragsym.kernel.dd_multiply(d_f, d_f), 0.25));
      result3 = spragsym.kernel.dd_negative(m_f);
    end

    function result = wide_depressed(r0, r1, r2)
    %WIDE_DEPRESSED  ``depressed`` in double-double arithmetic.
      mean = spragsym.kernel.dd_divide(r2, spragsym.kernel.paired(3.0, 0.0));
      result = struct('P', spragsym.kernel.dd_divide(spragsym.kernel.dd_add(r1, ...
          spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(r2, mean))), spragsym.kernel.paired(3.0, 0.0)), 'Q', ...
          spragsym.kernel.dd_scaled(spragsym.kernel.dd_add(r0, spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(mean, ...
          spragsym.kernel.dd_add(r1, spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(spragsym.kernel.dd_scaled(mean, ...
          2.0), mean)))))), 0.5));
    end

    function result = wide_cubic(a, b, d, m)
    %WIDE_CUBIC  ``cubic`` in double-double arithmetic.
      [r0, r1, r2] = spragsym.kernel.wide_resolvent(a, b, d, m);
      it = spragsym.kernel.wide_depressed(r0, r1, r2);
      result = struct('r0', r0, 'r1', r1, 'r2', r2, 'P', it.P, 'Q', it.Q);
    end

    function result = wide_discriminant(line, it, u)
    %WIDE_DISCRIMINANT  ``discriminant`` in double-double arithmetic.
      UNDERFLOW = 1e-307;
      COUNT_P = 22.0;
      COUNT_Q = 27.0;
      size = spragsym.kernel.depressed_size(line.a_size, abs(line.b.high), line.d_size, line.m.high);
      P_bound = abs(it.P.high) + COUNT_P .* u .* size.P;
      Q_bound = abs(it.Q.high) + COUNT_Q .* u .* size.Q;
      from_P = P_bound .* P_bound .* size.P .* (3.0 .* COUNT_P + 4.0);
      from_Q = Q_bound .* size.Q .* (2.0 .* COUNT_Q + 4.0);
      result = struct('value', ...
          spragsym.kernel.dd_leading(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(spragsym.kernel.dd_multiply(it.P, ...
          it.P), it.P), spragsym.kernel.dd_multiply(it.Q, it.Q))), 'error', u .* (from_P + from_Q) + UNDERFLOW);
    end

    function result = wide_simple_root(it)
    %WIDE_SIMPLE_ROOT  ``simple_root`` in double-double arithmetic.
      z = spragsym.kernel.outermost(it.P.high, it.Q.high);
      x = spragsym.kernel.dd_add_double(spragsym.kernel.dd_negative(spragsym.kernel.dd_divide(it.r2, ...
          spragsym.kernel.paired(3.0, 0.0))), z);
      slope = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply_double(x, ...
          3.0), spragsym.kernel.dd_scaled(it.r2, 2.0)), x), it.r1);
      step = spragsym.kernel.dd_divide(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(spragsym.kernel.dd_add( ...
          spragsym.kernel.dd_multiply(spragsym.kernel.dd_add(x, it.r2), x), it.r1), x), it.r0), slope);
      result = spragsym.kernel.dd_add(x, ...
          spragsym.kernel.dd_negative(spragsym.kernel.dd_where(spragsym.kernel.dd_less(spragsym.kernel.dd_absolute(step), ...
          spragsym.kernel.paired(abs(z), 0.0)), step, spragsym.kernel.paired(0.0, 0.0))));
    end

    function result = wide_polish(A1, A2, A3, p1, q1, p2, q2)
    %WIDE_POLISH  ``polish`` in double-double arithmetic.
      INFINITY = Inf;
      r3 = spragsym.kernel.dd_add(A3, spragsym.kernel.dd_negative(spragsym.kernel.dd_add(p1, p2)));
      r2 = spragsym.kernel.dd_add(spragsym.kernel.dd_add(A2, spragsym.kernel.dd_negative(spragsym.kernel.dd_add(q1, q2))), ...
          spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(p1, p2)));
      r1 = spragsym.kernel.dd_add(spragsym.kernel.dd_add(A1, spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(p1, ...
          q2))), spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(p2, q1)));
      r0 = spragsym.kernel.dd_add_double(spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(q1, q2)), -1.0);
      s1 = spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(r3, ...
          spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(p2, p2), spragsym.kernel.dd_negative(q2))), ...
          spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(r2, p2))), r1);
      s0 = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(r3, p2), ...
          spragsym.kernel.dd_negative(r2)), q2), r0);
      du = spragsym.kernel.dd_add(p1, spragsym.kernel.dd_negative(p2));
      dv = spragsym.kernel.dd_add(q1, spragsym.kernel.dd_negative(q2));
      dw = spragsym.kernel.dd_add(dv, spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(du, p2)));
      inverse = spragsym.kernel.dd_divide(spragsym.kernel.paired(1.0, 0.0), ...
          spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(dv, dw), ...
          spragsym.kernel.dd_multiply(spragsym.kernel.dd_multiply(du, du), q2)));
      dp2 = spragsym.kernel.dd_multiply(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(s1, dv), ...
          spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(s0, du))), inverse);
      dq2 = spragsym.kernel.dd_multiply(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(s0, dw), ...
          spragsym.kernel.dd_multiply(spragsym.kernel.dd_multiply(s1, du), q2)), inverse);
      dp1 = spragsym.kernel.dd_add(r3, spragsym.kernel.dd_negative(dp2));
      dq1 = spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_add(r2, spragsym.kernel.dd_negative(dq2)), ...
          spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(p2, dp1))), ...
          spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(p1, dp2)));
      new_q1 = spragsym.kernel.dd_add(q1, dq1);
      new_q2 = spragsym.kernel.dd_add(q2, dq2);
      good = (new_q1.high < 0.0) & (new_q2.high > 0.0) & spragsym.kernel.dd_less(spragsym.kernel.dd_absolute( ...
          spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_add(dp1, dp2), dq1), dq2)), ...
          spragsym.kernel.paired(INFINITY, 0.0));
      q1 = spragsym.kernel.dd_where(good, new_q1, q1);
      q2 = spragsym.kernel.dd_where(good, new_q2, q2);
      larger_second = spragsym.kernel.dd_less(spragsym.kernel.dd_negative(q1), q2);
      inverse_q = spragsym.kernel.dd_divide(spragsym.kernel.paired(-1.0, 0.0), spragsym.kernel.dd_where(larger_second, q2, q1));
      result = struct('p1', spragsym.kernel.dd_where(good, spragsym.kernel.dd_add(p1, dp1), p1), 'q1', ...
          spragsym.kernel.dd_where(larger_second, inverse_q, q1), 'p2', spragsym.kernel.dd_where(good, ...
          spragsym.kernel.dd_add(p2, dp2), p2), 'q2', spragsym.kernel.dd_where(larger_second, q2, inverse_q));
    end

    function result = wide_factors(e, resolved)
    %WIDE_FACTORS  ``factors`` in double-double arithmetic.
      over = spragsym.kernel.dd_divide(spragsym.kernel.paired(1.0, 0.0), e.e4);
      A1 = spragsym.kernel.dd_multiply(e.e1, over);
      A2 = spragsym.kernel.dd_multiply(e.e2, over);
      A3 = spragsym.kernel.dd_multiply(e.e3, over);
      y = spragsym.kernel.dd_multiply(spragsym.kernel.dd_scaled(over, -4.0), spragsym.kernel.wide_simple_root(resolved));
      width = spragsym.kernel.dd_sqrt(spragsym.kernel.dd_add_double(spragsym.kernel.dd_multiply(y, y), 4.0));
      large = spragsym.kernel.dd_scaled(spragsym.kernel.dd_add(spragsym.kernel.dd_absolute(y), width), 0.5);
      small = spragsym.kernel.dd_divide(spragsym.kernel.paired(1.0, 0.0), large);
      q2 = spragsym.kernel.dd_where(y.high > 0.0, large, small);
      q1 = spragsym.kernel.dd_negative(spragsym.kernel.dd_where(y.high > 0.0, small, large));
      inverse = spragsym.kernel.dd_divide(spragsym.kernel.paired(1.0, 0.0), width);
      result = spragsym.kernel.wide_polish(A1, A2, A3, spragsym.kernel.dd_multiply(spragsym.kernel.dd_add(A1, ...
          spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(A3, q1))), inverse), q1, ...
          spragsym.kernel.dd_multiply(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(A3, q2), ...
          spragsym.kernel.dd_negative(A1)), inverse), q2);
    end

    function result = wide_root_pair(p, q)
    %WIDE_ROOT_PAIR  ``root_pair`` in double-double arithmetic.
      half = spragsym.kernel.dd_scaled(p, 0.5);
      quarter = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(half, half), spragsym.kernel.dd_negative(q));
      radical = spragsym.kernel.dd_sqrt(spragsym.kernel.dd_larger(quarter, spragsym.kernel.paired(0.0, 0.0)));
      large = spragsym.kernel.dd_add(spragsym.kernel.dd_negative(half), ...
          spragsym.kernel.dd_negative(spragsym.kernel.dd_where(half.high > 0.0, radical, ...
          spragsym.kernel.dd_negative(radical))));
      result = struct('large', large, 'small', spragsym.kernel.dd_divide(q, large), 'discriminant', quarter);
    end

    function result = wide_one_positive(line, e, u)
    %WIDE_ONE_POSITIVE  ``one_positive`` in double-double arithmetic.
      COUNT_E1 = 10.0;
      result = e.e1.high < -2.0 .* COUNT_E1 .* u .* (line.a_size + line.d_size);
    end

    function result = wide_guesses(point, line, u)
    %WIDE_GUESSES  ``guesses`` in double-double arithmetic.
      INFINITY = Inf;
      e = spragsym.kernel.wide_quartic(line.a, line.b, line.d, line.m);
      resolved = spragsym.kernel.wide_cubic(line.a, line.b, line.d, line.m);
      D = spragsym.kernel.wide_discriminant(line, resolved, u);
      halves = spragsym.kernel.wide_factors(e, resolved);
      first = spragsym.kernel.wide_root_pair(halves.p1, halves.q1);
      second = spragsym.kernel.wide_root_pair(halves.p2, halves.q2);
      contact = point.nbar.high > 0.0;
      spared = (D.value > D.error) | (contact & spragsym.kernel.wide_one_positive(line, e, u));
      real = second.discriminant.high >= 0.0;
      more = real & (~spared);
      low = spragsym.kernel.dd_where(contact, spragsym.kernel.paired(INFINITY, 0.0), spragsym.kernel.dd_smaller(first.large, ...
          first.small));
      high = spragsym.kernel.dd_larger(first.large, first.small);
      third = spragsym.kernel.dd_where(more, second.large, spragsym.kernel.paired(INFINITY, 0.0));
      fourth = spragsym.kernel.dd_where(more, second.small, spragsym.kernel.paired(INFINITY, 0.0));
      a1 = spragsym.kernel.dd_smaller(low, high);
      a2 = spragsym.kernel.dd_larger(low, high);
      b1 = spragsym.kernel.dd_smaller(third, fourth);
      b2 = spragsym.kernel.dd_larger(third, fourth);
      inner = spragsym.kernel.dd_larger(a1, b1);
      outer = spragsym.kernel.dd_smaller(a2, b2);
      count = spragsym.kernel.where(contact, 1.0, 2.0) + spragsym.kernel.where(more, 2.0, 0.0);
      result = struct('t0', spragsym.kernel.dd_smaller(a1, b1), 't1', spragsym.kernel.dd_smaller(inner, outer), 't2', ...
          spragsym.kernel.dd_larger(inner, outer), 't3', spragsym.kernel.dd_larger(a2, b2), 'count', count, 'certain', spared ...
          | real);
    end

    function result = wide_direction(t)
    %WIDE_DIRECTION  ``direction`` in double-double arithmetic.
      inverse = spragsym.kernel.dd_divide(spragsym.kernel.paired(1.0, 0.0), ...
          spragsym.kernel.dd_add_double(spragsym.kernel.dd_multiply(t, t), 1.0));
      result = struct('cosine', spragsym.kernel.dd_multiply(spragsym.kernel.dd_multiply(spragsym.kernel.dd_add_double( ...
          spragsym.kernel.dd_negative(t), 1.0), spragsym.kernel.dd_add_double(t, 1.0)), inverse), 'sine', ...
          spragsym.kernel.dd_multiply(spragsym.kernel.dd_scaled(t, 2.0), inverse));
    end

    function result = wide_f(cos_theta, sin_theta, a_f, b_f, d_f, m_f)
    %WIDE_F  The scalar function whose roots are the equilibria.
      result = spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply( ...
          spragsym.kernel.dd_multiply(a_f, cos_theta), sin_theta), spragsym.kernel.dd_multiply(b_f, cos_theta)), ...
          spragsym.kernel.dd_multiply(d_f, sin_theta)), spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(m_f, ...
          spragsym.kernel.dd_multiply(sin_theta, sin_theta))));
    end

    function result = wide_f_slope(cos_theta, sin_theta, a_f, b_f, d_f, m_f)
    %WIDE_F_SLOPE  df/dθ, which is L det K at an equilibrium.
      result = spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(a_f, ...
          spragsym.kernel.dd_multiply(cos_theta, cos_theta)), spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(a_f, ...
          spragsym.kernel.dd_multiply(sin_theta, sin_theta)))), spragsym.kernel.dd_multiply(cos_theta, d_f)), ...
          spragsym.kernel.dd_multiply(sin_theta, spragsym.kernel.dd_add(spragsym.kernel.dd_negative(b_f), ...
          spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(spragsym.kernel.dd_scaled(cos_theta, 2.0), m_f)))));
    end

    function result = wide_sound(point)
    %WIDE_SOUND  ``sound`` in double-double arithmetic.
      SMALLEST_PARAMETER = 1e-250;
      sin0 = point.sin0.high;
      kappa = point.kappa.high;
      sigma = point.sigma.high;
      across = (sin0 > SMALLEST_PARAMETER) & (kappa > SMALLEST_PARAMETER) & (sigma > SMALLEST_PARAMETER);
      result = across & spragsym.kernel.ordinary(point.mu0.high) & spragsym.kernel.ordinary(point.alpha.high) & ...
          spragsym.kernel.ordinary(point.beta.high);
    end

    function [result1, result2, result3] = wide_state(cos_theta, sin_theta, cos0, sin0, kappa, sigma, beta, nbar)
    %WIDE_STATE  Spring length and displacement at an equilibrium with direction θ.
      B = spragsym.kernel.dd_add(beta, nbar);
      q = spragsym.kernel.dd_add(B, sigma);
      w0 = spragsym.kernel.dd_divide(spragsym.kernel.paired(1.0, 0.0), q);
      L = spragsym.kernel.dd_divide(spragsym.kernel.dd_multiply(w0, ...
          spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(B, sin0), kappa), ...
          spragsym.kernel.dd_multiply(sigma, sin_theta))), sin_theta);
      result1 = L;
      result2 = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(spragsym.kernel.dd_negative(L), cos_theta), cos0);
      result3 = spragsym.kernel.dd_multiply(w0, spragsym.kernel.dd_add(spragsym.kernel.dd_negative(kappa), ...
          spragsym.kernel.dd_multiply(sigma, spragsym.kernel.dd_add(spragsym.kernel.dd_negative(sin_theta), sin0))));
    end

    function [result1, result2, result3, result4] = wide_stiffness(cos_theta, sin_theta, L, mu0, alpha, sigma, beta, nbar)
    %WIDE_STIFFNESS  K, the Jacobian of (F_x, F_y).
      p = spragsym.kernel.dd_add(alpha, sigma);
      M = spragsym.kernel.dd_multiply(mu0, nbar);
      B = spragsym.kernel.dd_add(beta, nbar);
      q = spragsym.kernel.dd_add(B, sigma);
      w0 = spragsym.kernel.dd_divide(sigma, L);
      w1 = spragsym.kernel.dd_multiply(spragsym.kernel.dd_multiply(cos_theta, sin_theta), w0);
      result1 = spragsym.kernel.dd_add(p, ...
          spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(spragsym.kernel.dd_multiply(sin_theta, sin_theta), w0)));
      result2 = spragsym.kernel.dd_add(M, w1);
      result3 = w1;
      result4 = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(spragsym.kernel.dd_negative( ...
          spragsym.kernel.dd_multiply(cos_theta, cos_theta)), w0), q);
    end

    function [result1, result2, result3] = wide_invariants(K11, K12, K21, K22)
    %WIDE_INVARIANTS  Trace, determinant (negative: divergence) and discriminant in λ² (negative: flutter) of K.
      w0 = spragsym.kernel.dd_multiply(K12, K21);
      base0 = spragsym.kernel.dd_add(K11, spragsym.kernel.dd_negative(K22));
      result1 = spragsym.kernel.dd_add(K11, K22);
      result2 = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(K11, K22), spragsym.kernel.dd_negative(w0));
      result3 = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(base0, base0), spragsym.kernel.dd_scaled(w0, 4.0));
    end

    function result = wide_stability(at, L, slope, uncertainty, point)
    %WIDE_STABILITY  ``stability`` in double-double arithmetic.
      COUNT_K = 9.0;
      [K11, K12, K21, K22] = spragsym.kernel.wide_stiffness(at.cosine, at.sine, L, point.mu0, point.alpha, point.sigma, ...
          point.beta, point.nbar);
      [wide_trace, ~, wide_flutter] = spragsym.kernel.wide_invariants(K11, K12, K21, K22);
      trace = wide_trace.high;
      flutter = wide_flutter.high;
      sigma = point.sigma.high;
      nbar = point.nbar.high;
      pull = sigma ./ abs(L.high);
      size = point.alpha.high + point.beta.high + nbar + 2.0 .* sigma + 3.0 .* pull;
      margin = COUNT_K .* uncertainty .* size;
      saddle = slope < 0.0;
      fluttering = flutter < 0.0;
      code = spragsym.kernel.where(saddle, 2.0, spragsym.kernel.where(fluttering, 3.0, spragsym.kernel.where(trace > 0.0, 1.0, ...
          2.0)));
      far = abs(flutter) > margin .* (size + 1.5 .* point.mu0.high .* nbar);
      result = struct('code', code, 'certain', saddle | (far & (fluttering | (abs(trace) > margin))));
    end

    function result = wide_at_root(t, point, line, u)
    %WIDE_AT_ROOT  ``at_root`` in double-double arithmetic.
      INFINITY = Inf;
      LARGEST_H = 0.4;
      LARGEST_RADIUS = 0.001;
      COUNT_F = 21.0;
      COUNT_SLOPE = 24.0;
      COUNT_STATE = 18.0;
      COUNT_THETA = 16.0;
      at = spragsym.kernel.wide_direction(t);
      c_size = abs(at.cosine.high);
      s_size = abs(at.sine.high);
      b_size = abs(line.b.high);
      m_size = line.m.high;
      f_size = spragsym.algebra.f(c_size, s_size, line.a_size, b_size, line.d_size, -m_size);
      value = abs(spragsym.kernel.dd_leading(spragsym.kernel.wide_f(at.cosine, at.sine, line.a, line.b, line.d, line.m))) + ...
          COUNT_F .* u .* f_size;
      slope = spragsym.kernel.dd_leading(spragsym.kernel.wide_f_slope(at.cosine, at.sine, line.a, line.b, line.d, line.m));
      slope_size = line.a_size + b_size .* s_size + (line.d_size + 2.0 .* m_size .* s_size) .* c_size;
      steepness = abs(slope) - COUNT_SLOPE .* u .* slope_size;
      bend = 2.0 .* (line.a_size + m_size) + b_size + line.d_size;
      newton = value ./ steepness;
      h = newton .* bend ./ steepness;
      proved = (steepness > 0.0) & (h < LARGEST_H) & (newton < LARGEST_RADIUS .* s_size) & spragsym.kernel.wide_sound(point);
      radius = spragsym.kernel.where(proved, 1.0001 .* newton ./ (1.0 - h), INFINITY);
      [wide_L, wide_x, wide_y] = spragsym.kernel.wide_state(at.cosine, at.sine, point.cos0, point.sin0, point.kappa, ...
          point.sigma, point.beta, point.nbar);
      L = wide_L.high;
      x = wide_x.high;
      y = wide_y.high;
      sin0 = point.sin0.high;
      kappa = point.kappa.high;
      sigma = point.sigma.high;
      nbar = point.nbar.high;
      stiff = point.beta.high + nbar;
      over = 1.0 ./ (stiff + sigma);
      L_size = (sigma .* s_size + stiff .* sin0 + kappa) .* over ./ s_size;
      relative = radius ./ s_size;
      swing = c_size + relative;
      rounding = COUNT_STATE .* u;
      L_error = L_size .* (1.01 .* relative .* swing + rounding);
      y_size = sigma .* (sin0 + s_size) + kappa;
      y_error = (1.01 .* sigma .* radius .* swing + rounding .* y_size) .* over;
      turn = 1.01 .* radius .* (s_size + radius);
      x_error = L_error .* swing + L_size .* (turn + rounding .* c_size) + rounding;
      state_error = spragsym.kernel.larger(L_error, x_error) ./ spragsym.kernel.larger(spragsym.kernel.smaller(L, abs(x)), 1.0);
      error = spragsym.kernel.larger(state_error, spragsym.kernel.larger(radius + COUNT_THETA .* u, y_error));
      beyond = (1.0 - 2.0 .* nbar) .* y;
      member = (L > L_error) & (beyond > y_error);
      outsider = (L < -L_error) | (beyond < -y_error);
      uncertainty = spragsym.kernel.larger(relative, L_error ./ abs(L)) + 8.0 .* u;
      kind = spragsym.kernel.wide_stability(at, wide_L, slope, uncertainty, point);
      result = struct('L', L, 'x', x, 'y', y, 'radius', radius, 'error', error, 'member', member, 'outsider', outsider, ...
          'code', kind.code, 'known', proved & kind.certain);
    end

    function result = wide_apart(low, low_radius, high, high_radius)
    %WIDE_APART  ``apart`` in double-double arithmetic.
      low_square = low.high .* low.high;
      high_square = high.high .* high.high;
      result = 2.0 .* spragsym.kernel.dd_leading(spragsym.kernel.dd_add(high, spragsym.kernel.dd_negative(low))) > (low_radius ...
          + high_radius) .* (1.0 + spragsym.kernel.larger(low_square, high_square));
    end

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

    function result = larger(one, other)
    %LARGER  The larger of two, element by element; the second where they do not compare.
      result = spragsym.kernel.where(one > other, one, other);
    end

    function result = smaller(one, other)
    %SMALLER  The smaller of two, element by element; the second where they do not compare.
      result = spragsym.kernel.where(one < other, one, other);
    end

    function root = cube_root(x)
    %CUBE_ROOT  Cube roots of numbers > 0, 0 for others.
    %  A third of the exponent by the bits, which is good to a few percent, then Halley's method: the C library's statements.
      third = bitshift(typecast(x(:), 'uint64'), -2);
      third = third + bitshift(third, -2);
      third = third + bitshift(third, -4);
      third = third + bitshift(third, -8);
      root = reshape(typecast(third + bitshift(uint64(715094163), 32), 'double'), size(x));
      for pass = 1:3
        cube = root .* root .* root;
        root = root .* ((cube + 2 .* x) ./ (2 .* cube + x));
      end
      root(~(x > 0)) = 0;
    end
  end
end
