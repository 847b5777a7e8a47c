# @summary@
@meanings@
@header@
module @library@

@exported@

@algebra@
end
