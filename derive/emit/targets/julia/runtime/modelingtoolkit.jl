# The motion of @library@ in one smooth regime, which its parameters select: a system of ModelingToolkit.
@header@
include("@library@.jl")
import .@library@ as model
using ModelingToolkit
using ModelingToolkit: t_nounits as t, D_nounits as D

@states@
@numbers@
accelerations = @symbols@
equations = [@equations@
]
@named motion = System(equations, t, [@places@], [@given@])
