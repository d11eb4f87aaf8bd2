// A pose built up factor by factor: the product of exponentials, with each screw axis where it was and where it is now,
// and the column of the Jacobian that belongs to it; or the rows of a DH table, four elementary motions each.
(() => {
  "use strict";
  const M = globalThis.course.motion, P = globalThis.course.parts, S = globalThis.course.scene, { COLOURS } = P;
  const rad = Math.PI / 180;
  const along = (k, x) => M.pose(M.eye(3), [0, 1, 2].map((i) => (i === k ? x : 0)));
  const about = (k, x) => M.pose(M.rotation([0, 1, 2].map((i) => (i === k ? 1 : 0)), x), [0, 0, 0]);

  globalThis.course.kinds["toy:build_up"] = (host, meta) => {
    const { arm, limits, size, rows } = meta, n = arm.screws.length, solid = S.unpack(meta.solid);
    const state = meta.state || (meta.state = { q: [...meta.q], k: meta.start });
    const card = P.card(host, meta.title), draw = P.once(() => paint());
    const view = P.space(card.views, {
      radius: 0.1 * size, centre: meta.centre, azimuth: -1, elevation: meta.elevation, label: meta.title, meta: state,
      redraw: draw,
    });
    const most = rows ? 4 * n : n;
    const name = (k) => (!k ? "none" : rows ? `row ${Math.ceil(k / 4)}: ${"αaθd"[(k - 1) % 4]}` : `${k} of ${n}`);
    const factors = card.range("Factors", { min: 0, max: most, step: 1, value: state.k }, name, (k) => go(k));
    const joint = () => Math.max(0, Math.ceil(state.k / (rows ? 4 : 1)) - 1); // that of the last factor
    const options = { min: -180, max: 180, step: 1, value: Math.round(state.q[joint()] / rad) };
    const angle = card.range("Angle of its joint", options, (x) => `θ${joint() + 1} = ${x}°`, (x) => {
      const [low, high] = limits[joint()];
      state.q[joint()] = Math.min(high, Math.max(low, x * rad));
      draw();
    });
    // The next factor grows from nothing to its full size.
    let halt = null, grown = 1;
    function go(k) {
      if (halt) halt();
      const forwards = k === state.k + 1;
      state.k = k;
      grown = forwards ? 0 : 1;
      angle.set(Math.round(state.q[joint()] / rad));
      halt = card.run(() => (grown = Math.min(1, grown + 0.04)) < 1, draw);
    }
    const step = (d) => () => {
      const k = Math.min(most, Math.max(0, state.k + d));
      factors.set(k);
      go(k);
    };
    card.button("Previous factor", step(-1));
    card.button("Next factor", step(1));
    const numbers = card.numbers();

    function axis(at, direction, colour, now) {
      const l = 0.17 * size, ends = [M.add(at, direction, -l), M.add(at, direction, l)];
      if (now) view.arrow(...ends, colour, { thick: 0.006 * size });
      else view.line(ends, colour, 1.5, { dash: [5, 5] });
      return ends[1];
    }
    function paint() {
      view.begin();
      if (rows) paintRows();
      else paintProduct();
      view.end();
    }
    function drawArm(q, opacity) {
      const moved = M.bodies(arm, q);
      view.onStage(solid, moved, meta);
      view.mesh(solid, moved, solid.palette, { opacity, shadow: true });
      return moved;
    }
    function paintProduct() {
      const { k } = state, q = state.q.map((x, i) => (i < k - 1 ? x : i === k - 1 ? grown * x : 0));
      const moved = drawArm(q, 0.45);
      arm.screws.forEach((screw, i) => {
        const w = screw.slice(0, 3), p = M.positionOf(arm.home[i]), lit = i === k - 1;
        axis(p, w, COLOURS.grey, false);
        const colour = lit ? COLOURS.crimson : COLOURS.purple;
        const end = axis(M.move(moved[i], p), M.apply(M.rotationOf(moved[i]), w), colour, true);
        view.text(end, String(i + 1), colour, 10);
      });
      const T = M.times(moved[n], arm.home[n]), J = M.spaceJacobian(arm, q, moved);
      view.frame(M.eye(4), 0.1 * size, { thick: 0.004 * size });
      view.frame(T, 0.1 * size, { thick: 0.006 * size });
      const product = arm.screws.map((_, i) => {
        const factor = `e<sup>[S<sub>${i + 1}</sub>]θ<sub>${i + 1}</sub></sup>`;
        return i < k - 1 ? factor : i === k - 1 ? `<mark>${factor}</mark>` : `<span class="dim">${factor}</span>`;
      });
      numbers([`<span>T = ${product.join(" ")} M =</span>`, P.matrix(T)],
        [`<span>J<sub>s</sub> =</span>`, P.matrix(J, { digits: 2, lit: k - 1 })],
        k ? `Column ${k} is the screw axis ${k} where it is now: the joints before it have moved it, the joint itself `
          + "and those after it have not." : "All joints at 0: each axis is where it was, the columns are the screws.");
    }
    function paintRows() {
      const { k } = state, parts = rows.flatMap(([a, alpha, d], i) =>
        [about(0, alpha), along(0, a), about(2, state.q[i]), along(2, d)]);
      drawArm(state.q, 0.3);
      let T = M.eye(4);
      view.frame(T, 0.1 * size, { thick: 0.004 * size });
      parts.slice(0, k).forEach((part, i) => {
        const last = i === k - 1, before = T;
        T = last ? M.times(T, M.exp(M.scale(M.log(part), grown))) : M.times(T, part);
        const colour = i % 4 === 1 ? COLOURS.red : COLOURS.blue; // along x, or along z
        view.line([before, T].map(M.positionOf), colour, 3, { above: true });
        if (i % 4 !== 3 && !last) return;
        view.frame(T, (last ? 0.12 : 0.075) * size, { thick: (last ? 0.007 : 0.004) * size });
        if (i % 4 === 3) view.text(M.positionOf(T), `{${(i + 1) / 4}}`, COLOURS.black, 12);
      });
      const cell = (words, i, j) => (4 * i + j === k - 1 ? `<mark>${words}</mark>` : `<span>${words}</span>`);
      const heads = ["", "α", "a (m)", "θ", "d (m)"].map((word) => `<b>${word}</b>`).join("");
      const lines = rows.map(([a, alpha, d], i) => {
        const row = [P.degrees(alpha), P.number(a, 4), P.degrees(state.q[i]), P.number(d, 3)];
        return `<b>${i + 1}</b>${row.map((words, j) => cell(words, i, j)).join("")}`;
      });
      const look = "display:inline-grid;grid-template-columns:repeat(5,auto);gap:0 1em;text-align:right";
      const upTo = k < most ? "T up to here =" : "T =";
      numbers([`<span style="${look}">${heads}${lines.join("")}</span>`], [upTo, P.matrix(T)]);
    }
    paint();
    return () => { view.stop(); card.end(); };
  };
})();
