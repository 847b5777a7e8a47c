// The motion in time, by the exported step, at the pace of the screen.

/** Time from one sample to the next, and the longest step of integration, both in sqrt(m/k_c). */
const SAMPLE = 0.1;
const STEP = 0.05;
/** No frame integrates for longer, milliseconds: on a slow machine the motion is slow, and the page is not. */
const BUDGET = 10;

/** Stiff supports need short steps: a share of the shortest period that they may give. */
function pieces({ alpha, beta, sigma }) {
  return Math.ceil((SAMPLE / STEP) * Math.sqrt(Math.max(1, alpha + sigma, 1 + beta + sigma)));
}

/** `on.sample(t, state, regime)` for each sample, `on.frame(t, state)` for each picture, `on.stop(message)` where it can't go on. */
export function createMotion(motion, on) {
  let [run, state, t, running, last, debt, pace] = [null, [0, 0, 0, 0], 0, false, 0, 0, 10];
  let parts = 2;

  function set(point, drive) {
    run = motion(point, drive);
    parts = pieces(point);
  }

  function start(from) {
    [state, t, debt] = [from, 0, 0];
    on.sample(t, state, run.regime(state));
    on.frame(t, state);
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
    } catch (error) {
      running = false;
      on.stop(error.message);
      return;
    }
    on.frame(t, state);
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
