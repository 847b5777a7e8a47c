// Runs in a worker, behind the exported module's text: answers what the page asks for, so that its drawings never stand still.

import { answer } from "./shapes.js";

export function serve(solver) {
  self.onmessage = ({ data }) => self.postMessage(answer(solver, data));
}
