// Dead reckoning: a vacuum cleaner drives a plan home; its position is computed by Euler steps of a length to choose.
(() => {
  "use strict";
  const M = globalThis.course.motion, P = globalThis.course.parts, { COLOURS } = P, R = 0.17; // of the robot, metres

  P.toy("dead_reckoning", "Dead reckoning and its step", (card, meta) => {
    const state = card.state({ dt: meta.dt, rate: 1, s: 1 }), { half, centre } = meta;
    const label = "The path driven and the path computed by Euler steps";
    const plane = card.map({ half, centre, label, proportion: 0.7 });
    const total = meta.plan.reduce((sum, [, seconds]) => sum + seconds, 0);
    card.range("Step dt", { min: -2, max: 0, step: 0.02, value: Math.log10(state.dt) },
      (x) => `${(10 ** x).toPrecision(2)} s`, (x) => (state.dt = 10 ** x));
    card.setting("How sharp the bends are", state, "rate", { min: 0.5, max: 1.5, step: 0.05 }, P.percent);
    const time = card.setting("Time", state, "s", { min: 0, max: 1, step: 0.005 }, (x) => `${(x * total).toFixed(1)} s`);
    card.player("Drive", time, 0.006);
    const words = card.words();
    return () => {
      const plan = meta.plan.map(([[vx, vy, omega], seconds]) => [[vx, vy, omega * state.rate], seconds]);
      const exact = M.propagate(meta.start, plan, 0.02).exact, { euler } = M.propagate(meta.start, plan, state.dt);
      const driven = (poses) => poses.slice(0, Math.round(state.s * (poses.length - 1)) + 1);
      const home = exact[exact.length - 1], end = euler[euler.length - 1];
      const ahead = [Math.cos(home[2]), Math.sin(home[2])], side = [-ahead[1], ahead[0]];
      const front = M.add(home.slice(0, 2), ahead, 1.2 * R);
      plane.begin();
      plane.line([M.add(front, side, 0.25), M.add(front, side, -0.25)], COLOURS.green, 5);
      plane.text(M.add(front, ahead, 0.3), "dock", COLOURS.green);
      [[exact, COLOURS.blue, []], [euler, COLOURS.crimson, [7, 5]]].forEach(([poses, colour, dash]) => {
        const path = driven(poses);
        plane.line(path, colour, 2, { dash });
        if (poses === euler && euler.length < 200) path.forEach((p) => plane.dot(p, colour, 2.5));
        plane.robot(path[path.length - 1], R, colour);
      });
      if (state.s === 1) plane.line([home, end], COLOURS.black, 1.5);
      plane.end();
      const off = M.norm(M.add(home.slice(0, 2), end, -1)), steps = euler.length - 1;
      const miss = off < 0.01 ? `${P.number(1000 * off, 1)} mm` : `${P.number(100 * off, 1)} cm`;
      const wanted = `Docking needs ${P.number(100 * meta.tolerance, 0)} cm: which dt is the largest that does?`;
      words.textContent = `${steps} Euler steps miss the dock by ${miss}. `
        + (off < meta.tolerance ? "Close enough to dock." : wanted);
    };
  });
})();
