  double precision, external :: getp
  integer :: points
  points = 1
  if (getp('DTM', 1, u) > 0.0d0) points = nint(getp('NTST', 0, u)) * nint(getp('NCOL', 0, u)) + 1
  call margins(points, u, par, par(@first@:@last@))
