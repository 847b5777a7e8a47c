// Runs in a worker, together with the exported module's text: computes the drawings that the page asks for, while the page goes on.

import { answer } from "./shapes.js";

export function serve(solver) {
  self.onmessage = ({ data }) => self.postMessage(answer(solver, data));
}
