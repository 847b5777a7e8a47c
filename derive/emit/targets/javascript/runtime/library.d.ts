// Types of @library@.mjs. @header@

/** Head of the SHA-256 of what was emitted together. */
export declare const SOURCE: string;
/** Names of the parameters, in the order in which the algebra takes them. */
export declare const NAMES: readonly [@typed_names@];
/** Base values of the parameters that have one. */
export declare const BASE: Readonly<{ @typed_base@ }>;
/** Allowed values of all that the algebra takes. */
export declare const RANGES: Readonly<Record<string, { low?: number; low_open?: boolean; high?: number; high_open?: boolean }>>;

/** The generated algebra, by the names that it has in Python. */
export declare const algebra: {
// @members@
};

// @declarations@
