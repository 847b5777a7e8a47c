//# start
globalThis.brought.closed = closed_forms.createClosed({ NAMES, equilibria, surface, bifurcation_set, critical_friction, flutter_boundary });
