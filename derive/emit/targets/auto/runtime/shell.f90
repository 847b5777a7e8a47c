
! What AUTO calls: the field U' = F in the regime that the parameters select, with its derivatives.
subroutine func(ndim, u, icp, par, ijac, f, dfdu, dfdp)
  use @library@, only: regime_rhs, regime_jacobian, regime_by_parameters
  implicit none
  integer, intent(in) :: ndim, icp(*), ijac
  double precision, intent(in) :: u(ndim), par(*)
  double precision, intent(out) :: f(ndim)
  double precision, intent(inout) :: dfdu(ndim, ndim), dfdp(ndim, *)
  double precision :: slopes(@slopes@), turns(@turns@)
  integer :: i
  f(1:@count@) = u(@count@ + 1:@size@)
@rhs@
  if (ijac == 0) return
@jacobian@
  dfdu = 0.0d0
  do i = 1, @count@
    dfdu(i, @count@ + i) = 1.0d0
    dfdu(@count@ + i, 1:@size@) = slopes((i - 1) * @size@ + 1:i * @size@)
  end do
  if (ijac == 1) return
@by_parameters@
  dfdp(1:ndim, 1:@last@) = 0.0d0
  do i = 1, @count@
@columns@
  end do
end subroutine func

subroutine stpnt(ndim, u, par, t)
  implicit none
  integer, intent(in) :: ndim
  double precision, intent(inout) :: u(ndim), par(*)
  double precision, intent(in) :: t
@start@
end subroutine stpnt

! Margins of the borders, which stand behind the parameters, for stops: of a cycle the least.
subroutine pvls(ndim, u, par)
@uses@
  implicit none
  integer, intent(in) :: ndim
  double precision, intent(in) :: u(ndim)
  double precision, intent(inout) :: par(*)
@measured@
end subroutine pvls

subroutine bcnd
end subroutine bcnd
subroutine icnd
end subroutine icnd
subroutine fopt
end subroutine fopt
