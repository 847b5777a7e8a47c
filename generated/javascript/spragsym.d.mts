// Types of spragsym.mjs for TypeScript, which looks for them under this name.
export * from "./spragsym.js";
