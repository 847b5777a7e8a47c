function result = dd_cosine_and_sine(x)
%DD_COSINE_AND_SINE  cos x and sin x of a double 0 < x < π, within 2^-101 of themselves.
%
%  x = k π/2 + r with |r| ≤ π/4 by π/2 in three parts, of which the first leaves nothing to round; then Taylor's series,
%  whose terms from the tenth on need a double only.
  k = spragsym.kernel.where(x > 0.7853981633974483, 1.0, 0.0) + spragsym.kernel.where(x > 2.356194490192345, 1.0, 0.0);
  near = x - k .* 1.5707963267948966;
  r = spragsym.kernel.dd_add_double(spragsym.kernel.two_sum(near, -k .* 6.123233995736766e-17), k .* ...
      1.4973849048591698e-33);
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
  result.cosine_high = cosine.high;
  result.cosine_low = cosine.low;
  result.sine_high = sine.high;
  result.sine_low = sine.low;
end
