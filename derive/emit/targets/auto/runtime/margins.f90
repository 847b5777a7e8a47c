! How far a motion, or a state, stays from each border of its regime: the least margin over its points, negative beyond.
subroutine margins(points, u, par, least)
  integer, intent(in) :: points
  double precision, intent(in) :: u(@size@, points), par(*)
  double precision, intent(out) :: least(@edges@)
  double precision :: border(@borders@)@grips@
  integer :: at
  least = huge(1.0d0)
  do at = 1, points
@computed@
  end do
end subroutine margins
