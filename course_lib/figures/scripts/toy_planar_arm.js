// A planar arm with a target to drag: steps of damped least squares, the manipulability ellipse, the error over the steps.
(() => {
  "use strict";
  const K = globalThis.course.kinematics, P = globalThis.course.parts, { COLOURS } = P;

  globalThis.course.kinds["toy:planar_arm"] = (host, meta) => {
    const { lengths } = meta, reach = lengths.reduce((a, b) => a + b, 0), n = lengths.length;
    const state = meta.state || (meta.state = { q: [...meta.q], target: [...meta.target], damping: meta.damping, step: meta.step, errors: [], path: [] });
    const card = P.card(host, "A planar arm and its target");
    const plane = P.plane(card.views, { half: 1.12 * reach, step: reach > 6 ? 2 : 1, label: "The arm, its target and its manipulability ellipse" });
    const rim = plane.line(COLOURS.steel, 0.6, { "stroke-dasharray": reach * 0.02 });
    rim.set(Array.from({ length: 91 }, (_, i) => [reach * Math.cos((i * Math.PI) / 45), reach * Math.sin((i * Math.PI) / 45)]));
    const ellipse = plane.line(COLOURS.green, 1, { fill: COLOURS.green, "fill-opacity": 0.13 }), trail = plane.line(COLOURS.crimson, 0.7, { "stroke-dasharray": reach * 0.03 });
    const links = lengths.map((_, i) => plane.line(i % 2 ? COLOURS.link : COLOURS.steel, Math.max(2.2, 6.5 - i)));
    const joints = lengths.map(() => plane.dot("#2f3338", 1.1)), tip = plane.dot(COLOURS.crimson, 1.4);
    const goal = plane.handle({
      name: "Target", colour: COLOURS.blue,
      moved: (p) => { state.target = p; start(); },
      describe: () => `${state.target.map((x) => P.number(x)).join(", ")} m, distance left ${P.number(miss(), 3)} m`,
    });

    // The error over the steps, on a linear or a logarithmic axis.
    const chart = P.shape("svg", { viewBox: "0 0 320 260", role: "img", "aria-label": "Distance from the target over the steps" }, card.views);
    const frame = P.shape("path", { d: "M52 12V220H312", fill: "none", stroke: "#555555" }, chart);
    P.shape("text", { x: 182, y: 252, "text-anchor": "middle", "font-size": 13, fill: COLOURS.black }, chart, "steps");
    P.shape("text", { x: 12, y: 116, "text-anchor": "middle", "font-size": 13, fill: COLOURS.black, transform: "rotate(-90 12 116)" }, chart, "distance left (m)");
    const ticks = P.shape("g", { "font-size": 12, fill: "#444444", "text-anchor": "end" }, chart);
    const curve = P.shape("path", { fill: "none", stroke: COLOURS.crimson, "stroke-width": 2.5, "stroke-linejoin": "round" }, chart);
    frame.setAttribute("stroke-width", 1);

    const steps = card.range("Step size", { min: 0.05, max: 2.5, step: 0.05, value: state.step }, (x) => x.toFixed(2), (x) => { state.step = x; again(); start(); });
    const dampings = card.range("Damping (m²)", { min: -4, max: 1.5, step: 0.1, value: Math.log10(state.damping) }, (x) => (10 ** x).toPrecision(2).replace(/e.*/, (e) => e), (x) => { state.damping = 10 ** x; again(); start(); });
    card.button("One step", () => { stop(); once(); draw(); });
    card.button("Run", () => start());
    card.button("Start again", () => { again(); draw(); });
    card.tick("logarithmic error", Boolean(state.log), (on) => { state.log = on; draw(); });
    const words = card.words();
    let halt = null;

    const tipAt = () => K.planarPoints(lengths, state.q)[n];
    const miss = () => K.norm(K.add(state.target, tipAt(), -1));
    function once() {
      if (!state.errors.length) { state.errors.push(miss()); state.path.push(tipAt()); }
      const J = K.planarJacobian(lengths, state.q), e = K.add(state.target, tipAt(), -1);
      state.q = K.add(state.q, K.dampedStep(J, e, state.damping), state.step);
      state.errors.push(miss());
      state.path.push(tipAt());
      return state.errors[state.errors.length - 1] > 1e-6 && state.errors.length < 201;
    }
    const stop = () => { if (halt) halt(); halt = null; };
    // Another step size or damping is tried from the first configuration: an arm that has arrived would show nothing.
    const again = () => { stop(); Object.assign(state, { q: [...meta.q], errors: [], path: [] }); };
    function start() {
      stop();
      state.errors = [];
      state.path = [];
      draw();
      halt = card.run(once, draw);
    }
    function drawErrors() {
      const E = state.errors.length ? state.errors : [miss()], most = Math.max(20, E.length - 1);
      const low = -7, high = Math.log10(Math.max(1, ...E)), top = Math.max(0.5, ...E);
      const y = state.log ? (e) => 12 + (208 * (high - Math.max(low, Math.log10(e + 1e-12)))) / (high - low) : (e) => 220 - (208 * e) / top;
      curve.setAttribute("d", E.map((e, i) => `${i ? "L" : "M"}${(52 + (260 * i) / most).toFixed(1)},${y(e).toFixed(1)}`).join(""));
      const marks = state.log ? [0, -2, -4, -6].map((k) => [10 ** k, { 0: "1", "-2": "10⁻²", "-4": "10⁻⁴", "-6": "10⁻⁶" }[k]]) : [0, 0.5, 1].map((share) => [share * top, P.number(share * top, 2)]);
      ticks.replaceChildren();
      marks.forEach(([e, label]) => P.shape("text", { x: 48, y: y(e) + 4 }, ticks, label));
      [0, most].forEach((k, i) => P.shape("text", { x: i ? 312 : 58, y: 236 }, ticks, String(k)));
    }
    function draw() {
      const points = K.planarPoints(lengths, state.q), J = K.planarJacobian(lengths, state.q);
      links.forEach((link, i) => link.set([points[i], points[i + 1]]));
      joints.forEach((joint, i) => joint.set(points[i]));
      tip.set(points[n]);
      trail.set(state.path);
      goal.set(state.target);
      const { values, vectors } = K.eigen(K.times(J, K.transpose(J))), s = values.map((x) => Math.sqrt(Math.max(0, x)));
      ellipse.set(Array.from({ length: 61 }, (_, i) => {
        const t = (i * Math.PI) / 30;
        return K.add(K.add(points[n], vectors[0], 0.3 * s[0] * Math.cos(t)), vectors[1], 0.3 * s[1] * Math.sin(t));
      }), true);
      drawErrors();
      const limit = 2 * (1 + state.damping / values[0]), taken = Math.max(0, state.errors.length - 1);
      words.textContent = `${taken} ${taken === 1 ? "step" : "steps"}, distance left ${miss() < 0.001 ? miss().toExponential(0) : P.number(miss(), 3)} m. ` +
        `Singular values of the Jacobian: ${s.map((x) => P.number(x)).join(" and ")} m. ` +
        `Near this configuration steps above ${P.number(limit)} overshoot and diverge.`;
    }
    draw();
    return () => { stop(); card.end(); };
  };
})();
