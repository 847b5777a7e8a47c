// Types of @library@.mjs for TypeScript, which looks for them under this name.
export * from "./@library@.js";
