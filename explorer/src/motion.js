// The motion in time: integrates a field as fast as the chosen pace asks, a little before each picture.

/** Time from one sample to the next, and the longest step of integration, both in sqrt(m/k_c). */
const SAMPLE = 0.1;
const STEP = 0.05;
/** The longest time that is integrated before one picture, milliseconds: a slow machine shows a slow motion on a page that still responds. */
const BUDGET = 10;

/**
 * Calls `on.sample(t, state, regime)` for each sample, `on.frame(t, state, regime)` for each picture, `on.stop()` where the motion can't go on.
 * `set` takes a field as fieldOf gives it.
 */
export function createMotion(on) {
  let [run, state, t, running, last, debt, pace] = [null, [], 0, false, 0, 0, 10];
  let parts = 2;

  function set(field) {
    run = field;
    parts = state.length ? run.pieces(state, SAMPLE, STEP) : parts;
  }

  function start(from) {
    [state, t, debt] = [from, 0, 0];
    parts = run.pieces(state, SAMPLE, STEP);
    on.sample(t, state, run.regime(state));
    on.frame(t, state, run.regime(state));
  }

  function advance() {
    for (let i = 0; i < parts; i++) {
      state = run.step(state, SAMPLE / parts);
    }
    t += SAMPLE;
    on.sample(t, state, run.regime(state));
  }

  function tick(now) {
    if (!running) {
      return;
    }
    debt = Math.min(debt + ((now - last) / 1000) * pace, 0.5 * pace);
    last = now;
    const end = performance.now() + BUDGET;
    try {
      while (debt >= SAMPLE && performance.now() < end) {
        advance();
        debt -= SAMPLE;
      }
    } catch {
      running = false;
      on.stop();
      return;
    }
    on.frame(t, state, run.regime(state));
    requestAnimationFrame(tick);
  }

  return {
    set, start,
    play() {
      if (!running) {
        running = true;
        last = performance.now();
        requestAnimationFrame(tick);
      }
    },
    pause() { running = false; },
    running: () => running,
    pace(value) { pace = value; },
    state: () => state,
  };
}
