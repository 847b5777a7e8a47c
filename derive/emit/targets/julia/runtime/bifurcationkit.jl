# Steady states of @library@ and their stability, in the smooth regime of a start, up to its borders: by BifurcationKit.
# After ] add BifurcationKit: include("@library@_bifurcationkit.jl"); branch(STARTS.NAME; p_min = 0.1, p_max = 1.5)
@header@
include("@library@.jl")
import .@library@ as model
using BifurcationKit

# Steady states at the base values, each proved, with the numbers that select its regime.
const STARTS = (@starts@
)

# The field u' = F(u, p): coordinates, then their rates.
field(u, p) = [u[@count@ + 1:@size@]..., @rhs@...]

# Its derivatives by the state.
function jacobian(u, p)
    lower = @jacobian@
    entry(i, j) = i > @count@ ? lower[i - @count@][j] : j == i + @count@ ? 1 : 0
    return [entry(i, j) + zero(eltype(u)) for i in 1:@size@, j in 1:@size@]
end

# How far a state is from each border of its regime: negative beyond.
function margins(u, p)
    border = @borders@@grips@
    return (@margins@
    )
end

problem(start, lens = (@optic _.@along@)) = BifurcationProblem(field, start.state, start.parameters, lens; J = jacobian,
    record_from_solution = (u, p; k...) -> @record@)

# A branch from a start along a parameter, with events where its stability changes, at folds and at the borders of its regime.
function branch(start, lens = (@optic _.@along@); p_min, p_max, options...)
    at_borders(iter, state) = margins(getx(state), setparam(iter, getp(state)))
    events = SetOfEvents(@at_borders@FoldDetectEvent, BifDetectEvent)
    newton_options = NewtonPar(tol = 1e-11)
    settings = ContinuationPar(; p_min, p_max, detect_bifurcation = 0, detect_fold = false, detect_event = 2, newton_options, options...)
    return continuation(problem(start, lens), PALC(), settings; bothside = true, event = events)
end
