// The bent arm: q2 over the distance r of the tip is a root at the workspace's edge, and the square of q2 is smooth.
(() => {
  "use strict";
  const K = globalThis.course.kinematics, P = globalThis.course.parts, { COLOURS } = P;
  const LENGTHS = [1, 1], NEAR = 1.2, REACH = 2, SAMPLES = 41, LEFT = 44, RIGHT = 312, TOP = 12, BOTTOM = 140;

  // A chart over r with the axis y from low to high. Returns what draws lines and the cell into it.
  function chart(parent, { label, unit, low, high, ticks }) {
    const svg = P.shape("svg", { viewBox: "0 0 324 176", role: "img", "aria-label": label }, parent);
    const x = (r) => LEFT + ((RIGHT - LEFT) * (r - NEAR)) / (REACH - NEAR), y = (value) => BOTTOM + ((TOP - BOTTOM) * (value - low)) / (high - low);
    const cell = P.shape("rect", { y: TOP, height: BOTTOM - TOP, fill: COLOURS.blue, "fill-opacity": 0.12 }, svg);
    P.shape("path", { d: `M${LEFT},${TOP}V${BOTTOM}H${RIGHT}M${LEFT},${y(0)}H${RIGHT}`, fill: "none", stroke: "#555555" }, svg);
    const words = P.shape("g", { "font-size": 12, fill: "#444444", "aria-hidden": "true" }, svg);
    ticks.forEach(([value, text]) => P.shape("text", { x: LEFT - 5, y: y(value) + 4, "text-anchor": "end" }, words, text));
    [1.2, 1.4, 1.6, 1.8, 2].forEach((r) => P.shape("text", { x: x(r), y: BOTTOM + 16, "text-anchor": "middle" }, words, r.toFixed(1)));
    P.shape("text", { x: (LEFT + RIGHT) / 2, y: BOTTOM + 31, "text-anchor": "middle" }, words, "distance r of the tip (m)");
    P.shape("text", { x: RIGHT - 4, y: TOP + 8, "text-anchor": "end", "font-weight": 600 }, words, unit);
    const inside = (value) => Math.min(high, Math.max(low, value));
    const line = (colour, width, dash = "none") => {
      const made = P.shape("path", { fill: "none", stroke: colour, "stroke-width": width, "stroke-dasharray": dash, "stroke-linejoin": "round" }, svg);
      return (points) => made.setAttribute("d", points.map(([r, value], i) => `${i ? "L" : "M"}${x(r).toFixed(2)},${y(inside(value)).toFixed(2)}`).join(""));
    };
    const dot = P.shape("circle", { r: 4.5, fill: COLOURS.ground, stroke: COLOURS.black, "stroke-width": 2 }, svg);
    return {
      line,
      mark: (r, value) => { P.set(dot, { cx: x(r), cy: y(value) }); svg.append(dot); },
      shade: (from, to) => P.set(cell, { x: x(from), width: x(to) - x(from) }),
    };
  }

  globalThis.course.kinds["toy:bent_arm"] = (host, meta) => {
    const state = meta.state || (meta.state = { at: [...meta.at], width: meta.width, degree: 1, sign: 1 });
    const card = P.card(host, "The bent arm");
    const plane = P.plane(card.views, { half: 1.08 * REACH, step: 1, label: "The arm, and its elbow on the other side" });
    const rim = plane.line("#555555", 0.6), pale = [0, 1].map(() => plane.line(COLOURS.steel, 1.4, { "stroke-dasharray": 0.05 }));
    rim.set(Array.from({ length: 91 }, (_, i) => [REACH * Math.cos((i * Math.PI) / 45), REACH * Math.sin((i * Math.PI) / 45)]));
    const links = [plane.line("#444444", 3.5), plane.line(COLOURS.link, 3)], elbow = plane.dot("#2f3338", 1.3);
    const tip = plane.handle({
      name: "Tip", colour: COLOURS.blue, moved: (p) => { place(p); reach.set(K.norm(state.at)); draw(); },
      describe: () => `${state.at.map((x) => P.number(x)).join(", ")} m, bent by ${P.degrees(state.sign * bend(K.norm(state.at)))}`,
    });
    const charts = P.element("div", { style: "display:flex;flex-direction:column;gap:.5rem;justify-content:space-between" }, card.views);
    const angle = chart(charts, { label: "The bend q2 over the distance of the tip", unit: "q2", low: -2, high: 2, ticks: [[-Math.PI / 2, "-90°"], [0, "0°"], [Math.PI / 2, "90°"]] });
    const square = chart(charts, { label: "The square of q2 over the distance of the tip", unit: "q2² (rad²)", low: 0, high: 4, ticks: [[0, "0"], [2, "2"], [4, "4"]] });
    const all = Array.from({ length: 201 }, (_, i) => REACH - (REACH - NEAR) * (1 - i / 200) ** 2);
    [1, -1].forEach((sign) => angle.line(COLOURS.steel, 2)(all.map((r) => [r, sign * bend(r)])));
    square.line(COLOURS.steel, 2)(all.map((r) => [r, bend(r) ** 2]));
    const direct = angle.line(COLOURS.crimson, 2.5), rooted = angle.line(COLOURS.green, 2.5, "6 4"), fitted = square.line(COLOURS.green, 2.5, "6 4");

    const reach = card.range("Distance r", { min: NEAR, max: REACH, step: 0.01, value: K.norm(state.at) }, (r) => `${r.toFixed(2)} m`, (r) => { place(K.scale(state.at, r / K.norm(state.at))); draw(); });
    card.range("Width of the cells", { min: 0.05, max: 0.8, step: 0.05, value: state.width }, (h) => `${h.toFixed(2)} m`, (h) => { state.width = h; draw(); });
    card.range("Degree", { min: 1, max: 3, step: 1, value: state.degree }, (n) => ["line", "parabola", "cubic"][n - 1], (n) => { state.degree = n; draw(); });
    card.button("Other elbow", () => { state.sign = -state.sign; draw(); });
    const numbers = card.numbers(), words = card.words();

    function bend(r) { return 2 * Math.acos(Math.min(1, r / REACH)); }
    // The handle stays in the ring that the charts show.
    function place(p) {
      const r = K.norm(p);
      state.at = r ? K.scale(p, Math.min(REACH, Math.max(NEAR, r)) / r) : [NEAR, 0];
    }
    function draw() {
      const r = Math.min(REACH, K.norm(state.at)), h = state.width, direction = Math.atan2(state.at[1], state.at[0]);
      const put = (sign) => K.planarPoints(LENGTHS, [direction - (sign * bend(r)) / 2, sign * bend(r)]);
      const arm = put(state.sign), other = put(-state.sign);
      links.forEach((link, k) => link.set([arm[k], arm[k + 1]]));
      pale.forEach((link, k) => link.set([other[k], other[k + 1]]));
      elbow.set(arm[1]);
      tip.set(state.at);
      // Cells are counted from the edge inwards, so that one of them touches it.
      const k = Math.max(0, Math.ceil(Math.min(REACH - r, REACH - NEAR) / h - 1e-9) - 1), to = REACH - k * h, from = Math.max(NEAR, to - h);
      const found = K.bendFits(from, to, state.degree, SAMPLES);
      angle.shade(from, to);
      square.shade(from, to);
      direct(found.r.map((x, i) => [x, state.sign * found.direct[i]]));
      rooted(found.r.map((x, i) => [x, state.sign * found.rooted[i]]));
      fitted(found.r.map((x, i) => [x, found.square[i]]));
      angle.mark(r, state.sign * bend(r));
      square.mark(r, bend(r) ** 2);
      const off = (name) => `${P.degrees(found[name].angle, 2).padStart(6)} off, tip ${P.number(1000 * found[name].tip, 2).padStart(5)} mm`;
      numbers.textContent = `At most, in this cell:\nq2, red:    ${off("directError")}\nq2², green: ${off("rootedError")}`;
      words.textContent = `Cell from ${P.number(from)} to ${P.number(to)} m. ` +
        (k ? "Here q2 and its square are both smooth. " : "This cell touches the edge of the workspace, where q2 has a vertical tangent. ") +
        `q2 = ${P.degrees(state.sign * bend(r))}, q2² = ${P.number(bend(r) ** 2)} rad² for both elbows.`;
    }
    draw();
    return () => card.end();
  };
})();
