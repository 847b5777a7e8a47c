// Asks the worker for the drawings of a family; without a worker the page itself works them out, a little later.

import { answer } from "./shapes.js";

/** The mark in the page's script between the exported module and the call of `start`. */
const BEGIN = "//# start";
/** How long the worker may take for one question, seconds: curves of extreme parameters may never end. */
const PATIENCE = 20;

/** Returns `ask(what, point, top, done)`, where `what` is "curves" or "surface"; of several questions of one kind only the last is answered. */
export function createAsking(solver) {
  const latest = {};
  const waiting = {};
  let id = 0;
  let busy = false;
  let watch = 0;
  let worker = started();

  function arrived({ id: answered, what, value, error }) {
    busy = false;
    clearTimeout(watch);
    const question = latest[what];
    if (question && question.id === answered) {
      question.done(value ?? null, error);
    }
    next();
  }

  function next() {
    const what = ["curves", "surface"].find((name) => waiting[name]);
    if (!what || busy) {
      return;
    }
    const question = waiting[what];
    delete waiting[what];
    busy = true;
    if (worker.thread) {
      worker.thread.postMessage(question);
      watch = setTimeout(() => {
        worker.thread.terminate();
        worker = started();
        arrived({ ...question, error: `Not drawn: not finished after ${PATIENCE} seconds; give other parameters.` });
      }, 1000 * PATIENCE);
    } else {
      setTimeout(() => arrived(answer(solver, question)), 0);
    }
  }

  function started() {
    const box = { thread: null };
    try {
      // A plain script: Chromium loads no module into a worker of a page that was opened from a file.
      const code = document.getElementById("code").textContent.split(BEGIN)[0].replace(/^export /gm, "");
      const text = `"use strict";\n${document.getElementById("worker").textContent}\n${code}\nworker.serve({ equilibria, bifurcation_set, critical_friction, flutter_boundary, surface });`;
      box.thread = new Worker(URL.createObjectURL(new Blob([text], { type: "text/javascript" })));
      box.thread.onmessage = ({ data }) => arrived(data);
      box.thread.onerror = (event) => {
        event.preventDefault();
        box.thread = null; // a browser that runs no worker from a file
        busy = false;
        Object.entries(latest).forEach(([what, { id: number, point, top }]) => (waiting[what] = { id: number, what, point, top }));
        next();
      };
    } catch {
      box.thread = null;
    }
    return box;
  }

  return (what, point, top, done) => {
    id += 1;
    latest[what] = { id, point, top, done };
    waiting[what] = { id, what, point, top };
    next();
  };
}
