/** Dimensionless parameters of a point. */
export interface Parameters {
  /** Inclination of the undeformed spring, radians, in (0, pi). */
  theta0: number;
  /** Friction coefficient at full slip, >= 0. */
  mu0: number;
  /** Preload F_L / (k_c L_0), > 0. */
  kappa: number;
  /** Stiffness ratio k_x / k_c, >= 0. */
  alpha: number;
  /** Stiffness ratio k / k_c, > 0. */
  sigma: number;
  /** Stiffness ratio k_y / k_c, >= 0. */
  beta: number;
}

/** What functions take that span theta0 and mu0. */
export type Fixed = Omit<Parameters, "theta0" | "mu0"> & Partial<Pick<Parameters, "theta0" | "mu0">>;

/** The belt's speed, and the steepness > 0 of the friction law in creep. */
export interface Drive {
  V: number;
  d: number;
}

/** Stability by (27). */
export type Stability = "stable" | "divergent" | "flutter";

/** One equilibrium. */
export interface State {
  /** Inclination of the spring, in (-pi, pi). */
  theta: number;
  /** Length of the spring. */
  L: number;
  /** Displacement along the belt. */
  x: number;
  /** Displacement across the belt, negative into it. */
  y: number;
  stability: Stability;
  /** Bound on |error| of theta, L, x and y, each over max(1, |exact value|); Infinity if none is known. */
  error: number;
}

/** What double precision, and where that is not enough double-double arithmetic, says about a point. */
export type Status = "ok" | "uncertain" | "out_of_range";

export interface Equilibria {
  /** "ok": the number, the kinds and twelve digits are vouched for. "uncertain": a best guess. "out_of_range": no states. */
  status: Status;
  count: number;
  /** By ascending theta. */
  states: State[];
}

/** A point of the equilibrium surface. */
export interface SurfacePoint {
  mu0: number;
  L: number;
  x: number;
  y: number;
  stability: Stability;
}

/** A point of the plane of theta0 and mu0 with its state. */
export interface Turn {
  theta0: number;
  mu0: number;
  theta: number;
  L: number;
  x: number;
  y: number;
}

/** A fold along one parameter: its point with the state. */
export interface Fold extends Parameters, Turn {}

/** A curve in the plane of theta0 and mu0 with its states: points in order. */
export interface Curve {
  theta0: number[];
  mu0: number[];
  theta: number[];
  L: number[];
  x: number[];
  y: number[];
}

/** x, y, dx/dtau, dy/dtau. */
export type Phase = [number, number, number, number];

/** The smooth regime of a motion: side 1 with the mass slower than the belt, -1 with it faster. */
export interface Regime {
  contact: boolean;
  side: 1 | -1;
}

export interface Motion {
  rhs(state: ArrayLike<number>): Phase;
  regime(state: ArrayLike<number>): Regime;
  energy(state: ArrayLike<number>): number;
  /** One step of length h > 0, cut at the kinks y = 0 and x' = V. */
  step(state: ArrayLike<number>, h: number): Phase;
}

/** All equilibria of one regime with their stability; in contact unless told otherwise. */
export declare function equilibria(parameters: Parameters, options?: { contact?: boolean }): Equilibria;
/** The equilibrium surface at a direction theta and an inclination theta0; null where there is no state in contact. */
export declare function surface(parameters: Fixed, theta: number, theta0: number): SurfacePoint | null;
/** All cusps in contact with mu0 >= 0, by ascending mu0. */
export declare function cusps(parameters: Fixed): Turn[];
/** The critical friction: below it the reference state jumps at no inclination; Infinity where it never jumps. */
export declare function critical_friction(parameters: Fixed): { mu0: number; theta0: number; kind: "cusp" | "turn" | "end" | "" };
/** Every curve of folds with mu0 >= 0, and the cusps on them. */
export declare function bifurcation_set(parameters: Fixed, options?: { n?: number }): { curves: Curve[]; cusps: Turn[] };
/** Every curve of flutter onsets in contact with mu0 >= 0. */
export declare function flutter_boundary(parameters: Fixed, options?: { n?: number }): Curve[];
/** The folds along one of the six parameters, the others fixed; that one may be left out. */
export declare function folds(parameters: Partial<Parameters>, options?: { vary?: keyof Parameters }): Fold[];
/** Right-hand side, regimes and steps of the motion at given parameters. */
export declare function motion(parameters: Parameters, drive: Drive): Motion;
