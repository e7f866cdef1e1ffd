// What is measured, the same in Node and in a page: a hanging sheet of n x n nodes.

const STEP = 7.8125e-6; // s; stable for every size up to 800 x 800
export const STEPS_A_FRAME = 256;

/** The changes to scenes/hanging.json, for the native program too. */
export function changes(n) {
  return { "cloths.0.grid": [n, n], "time.frame": STEPS_A_FRAME * STEP, "time.substeps": STEPS_A_FRAME };
}

/** ms a step, many steps a submit, each frame waited for. */
export async function measureSteps({ createWorld }, where, n, frames) {
  const world = await createWorld({ ...where, set: changes(n) });
  const { adapter } = world.info;
  await world.step(2);
  const times = [];
  for (let i = 0; i < frames; i++) {
    const start = performance.now();
    await world.step(1);
    times.push((performance.now() - start) / STEPS_A_FRAME);
  }
  const { hash } = await world.snapshot();
  world.dispose();
  return { adapter, ms_per_step: summary(times), state_hash: hash };
}

/** The host's own ms for a frame of 64 substeps in real time, drawing included where there is a canvas. */
export async function measureHost({ createWorld }, where, frames) {
  const soft = { structural: 20, shear: 8, bend: 1 }; // stable at 1/3840 s; the host's work is the same
  const set = { "time.substeps": 64, "cloths.0.stiffness": soft };
  const world = await createWorld({ ...where, set });
  const times = [];
  await new Promise((done, fail) => {
    world.on("error", fail);
    world.on("frame", () => {
      times.push(world.hostMilliseconds);
      if (times.length === frames + 20) done();
    });
    world.run();
  });
  world.dispose();
  return summary(times.slice(20)); // the first are compiled while they run
}

function summary(values) {
  const sorted = values.toSorted((a, b) => a - b);
  return { median: sorted[Math.floor(sorted.length / 2)], min: sorted[0],
    p95: sorted[Math.floor(0.95 * sorted.length)] };
}
