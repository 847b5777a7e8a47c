! @summary@
@meanings@
! @header@
module @library@
  implicit none
  double precision, parameter, private :: pi = 3.14159265358979323846d0

contains

elemental double precision function sgn(u)
  double precision, intent(in) :: u
  sgn = merge(sign(1.0d0, u), 0.0d0, u /= 0.0d0)
end function sgn

@algebra@
@margins@
end module @library@
