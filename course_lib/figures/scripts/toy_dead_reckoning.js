// Dead reckoning: a vacuum cleaner drives a plan home; the position is computed by Euler steps of a length dt to choose.
(() => {
  "use strict";
  const K = globalThis.course.kinematics, P = globalThis.course.parts, { COLOURS } = P;

  globalThis.course.kinds["toy:dead_reckoning"] = (host, meta) => {
    const state = meta.state || (meta.state = { dt: meta.dt, rate: 1, s: 1 });
    const card = P.card(host, "Dead reckoning and its step");
    const plane = P.plane(card.views, { half: meta.half, centre: meta.centre, step: 1, label: "The path driven and the path computed by Euler steps", height: 0.8 });
    const r = 0.17, exact = plane.line(COLOURS.blue, 1.6), euler = plane.line(COLOURS.crimson, 1.4, { "stroke-dasharray": meta.half * 0.03 });
    const dots = plane.line(COLOURS.crimson, 2.6, { "stroke-dasharray": `0 ${meta.half}` }), miss = plane.line(COLOURS.black, 0.8);
    const robots = [COLOURS.blue, COLOURS.crimson].map((colour) => [plane.dot(colour, 1, { r, "fill-opacity": 0.25, stroke: colour, "stroke-width": 0.02 }), plane.line(colour, 1.2)]);
    const dock = plane.line(COLOURS.green, 3), label = plane.text(COLOURS.green);
    card.range("Step dt", { min: -2, max: 0, step: 0.02, value: Math.log10(state.dt) }, (x) => `${(10 ** x).toPrecision(2)} s`, (x) => { state.dt = 10 ** x; draw(); });
    card.range("How sharp the bends are", { min: 0.5, max: 1.5, step: 0.05, value: state.rate }, (x) => `${Math.round(100 * x)} %`, (x) => { state.rate = x; draw(); });
    const share = card.range("Time", { min: 0, max: 1, step: 0.005, value: state.s }, (x) => `${(x * total()).toFixed(1)} s`, (x) => { state.s = x; draw(); });
    let halt = null;
    card.button("Drive", () => {
      if (halt) halt();
      state.s = 0;
      halt = card.run(() => { state.s = Math.min(1, state.s + 0.006); share.set(state.s); return state.s < 1; }, draw);
    });
    const words = card.words();
    function total() { return meta.plan.reduce((sum, [, seconds]) => sum + seconds, 0); }
    function draw() {
      const plan = meta.plan.map(([[vx, vy, omega], seconds]) => [[vx, vy, omega * state.rate], seconds]);
      const fine = K.propagate(meta.start, plan, 0.02).exact, coarse = K.propagate(meta.start, plan, state.dt);
      const last = (poses) => poses[Math.round(state.s * (poses.length - 1))];
      const home = fine[fine.length - 1], end = coarse.euler[coarse.euler.length - 1];
      exact.set(fine.slice(0, Math.round(state.s * (fine.length - 1)) + 1));
      euler.set(coarse.euler.slice(0, Math.round(state.s * (coarse.euler.length - 1)) + 1));
      dots.node.setAttribute("d", coarse.euler.length < 200 ? coarse.euler.slice(0, Math.round(state.s * (coarse.euler.length - 1)) + 1).map(([x, y]) => `M${x},${y}h0.0001`).join("") : "");
      dots.node.removeAttribute("stroke-dasharray");
      [last(fine), last(coarse.euler)].forEach(([x, y, theta], k) => {
        robots[k][0].set([x, y]);
        robots[k][1].set([[x, y], [x + r * Math.cos(theta), y + r * Math.sin(theta)]]);
      });
      const ahead = [Math.cos(home[2]), Math.sin(home[2])], side = [-ahead[1], ahead[0]], front = K.add(home.slice(0, 2), ahead, 1.2 * r);
      dock.set([K.add(front, side, 0.25), K.add(front, side, -0.25)]);
      label.set(K.add(K.add(front, ahead, 0.35), [0, -0.06]), "dock");
      miss.set(state.s === 1 ? [home, end] : []);
      const off = K.norm(K.add(home.slice(0, 2), end.slice(0, 2), -1)), steps = coarse.euler.length - 1;
      words.textContent = `${steps} Euler steps miss the dock by ${off < 0.01 ? `${(1000 * off).toFixed(1)} mm` : `${(100 * off).toFixed(1)} cm`}. ` +
        (off < meta.tolerance ? "Close enough to dock." : `Docking needs ${(100 * meta.tolerance).toFixed(0)} cm: which dt is the largest that does?`);
    }
    draw();
    return () => { if (halt) halt(); card.end(); };
  };
})();
