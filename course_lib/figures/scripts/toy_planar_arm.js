// A planar arm with a target to drag: steps of damped least squares, the manipulability ellipse, the error over the
// steps.
(() => {
  "use strict";
  const M = globalThis.course.motion,
    P = globalThis.course.parts,
    { COLOURS } = P,
    MOST = 200;
  const SCALES = [
    [0.5, 0.1],
    [1, 0.2],
    [2, 0.5],
    [5, 1],
    [10, 2],
  ]; // the largest distance shown, and its ticks
  const POWERS = [
    [1, "1"],
    [1e-2, "10⁻²"],
    [1e-4, "10⁻⁴"],
    [1e-6, "10⁻⁶"],
  ];

  P.toy("planar_arm", "A planar arm and its target", (card, meta) => {
    const { lengths } = meta,
      reach = lengths.reduce((a, b) => a + b, 0),
      n = lengths.length;
    const state = card.state({
      q: [...meta.q],
      target: [...meta.target],
      damping: meta.damping,
      step: meta.step,
      errors: [],
      path: [],
    });
    const label = "The arm, its target and its manipulability ellipse";
    const plane = card.map({ half: 1.12 * reach, step: reach > 6 ? 2 : 1, label });
    plane.handle({
      name: "Target",
      colour: COLOURS.blue,
      at: () => state.target,
      moved: (p) => {
        state.target = p;
        start();
      },
      describe: () => `${P.metres(state.target)}, distance left ${P.number(miss(), 3)} m`,
    });
    const parent = P.element("div", {}, card.views);
    let chart = null;
    card.range(
      "Step size",
      { min: 0.05, max: 4, step: 0.05, value: state.step },
      (x) => x.toFixed(2),
      (x) => {
        state.step = x;
        again();
        start();
      },
    );
    card.range(
      "Damping (m²)",
      { min: -4, max: 1.5, step: 0.1, value: Math.log10(state.damping) },
      (x) => String(Number((10 ** x).toPrecision(2))),
      (x) => {
        state.damping = 10 ** x;
        again();
        start();
      },
    );
    card.button("One step", () => {
      card.halt();
      once();
    });
    card.button("Run", () => start());
    card.button("Start again", () => again());
    card.checkbox("logarithmic error", state, "log");
    const words = card.words();

    const tip = () => M.planarPoints(lengths, state.q)[n];
    const miss = () => M.norm(M.add(state.target, tip(), -1));
    const note = () => {
      state.errors.push(miss());
      state.path.push(tip());
    };
    function once() {
      if (!state.errors.length) note();
      const J = M.planarJacobian(lengths, state.q),
        e = M.add(state.target, tip(), -1);
      state.q = M.add(state.q, M.dampedStep(J, e, state.damping), state.step);
      note();
      return state.errors[state.errors.length - 1] > 1e-6 && state.errors.length <= MOST;
    }
    // Another step size or damping is tried from the first configuration: an arm at its target would not move.
    const again = () => {
      card.halt();
      Object.assign(state, { q: [...meta.q], errors: [], path: [] });
    };
    function start() {
      Object.assign(state, { errors: [], path: [] });
      card.run(once);
    }
    function drawErrors() {
      const E = state.errors.length ? state.errors : [miss()],
        most = E.length <= 20 ? 20 : E.length <= 50 ? 50 : MOST;
      const [top, each] = SCALES.find(([x]) => x >= Math.max(...E)) || [20, 5];
      const y = (e) => (state.log ? Math.log10(Math.max(e, 1e-7)) : e),
        round = (to, by) =>
          Array.from({ length: Math.round(to / by) + 1 }, (_, i) => [
            i * by,
            String(Number((i * by).toFixed(2))),
          ]);
      const marks = state.log ? POWERS.map(([e, name]) => [y(e), name]) : round(top, each);
      const key = `${state.log} ${most} ${top}`;
      if (!chart || chart.key !== key) {
        // other axes
        if (chart) chart.stop();
        chart = Object.assign(
          card.plane({
            x: [0, most],
            y: state.log ? [-7, y(top)] : [0, top],
            margin: true,
            proportion: 1,
            parent,
            ticks: [round(most, { 20: 5, 50: 10 }[most] || 50), marks],
            names: ["steps", "distance left (m)"],
            label: "Distance from the target over the steps",
          }),
          { key },
        );
      }
      chart.begin();
      chart.line(
        E.map((e, i) => [i, y(e)]),
        COLOURS.crimson,
        2.5,
      );
      chart.dot([E.length - 1, y(E[E.length - 1])], COLOURS.crimson, 3.5);
      chart.end();
    }
    if (!state.errors.length) start(); // the first run
    return () => {
      const points = M.planarPoints(lengths, state.q),
        J = M.planarJacobian(lengths, state.q);
      const { values, vectors } = M.eigen(M.times(J, M.transpose(J))),
        s = values.map((x) => Math.sqrt(Math.max(0, x)));
      plane.begin();
      plane.line(P.circle(reach), COLOURS.steel, 1.2, { dash: [6, 6] });
      const [a, b] = vectors.map((v, i) => M.scale(v, 0.3 * s[i]));
      plane.line(
        P.circle(1).map(([c, d]) => M.add(M.add(points[n], a, c), b, d)),
        COLOURS.green,
        1.5,
        { fill: 0.13 },
      );
      plane.line(state.path, COLOURS.crimson, 1.2, { dash: [4, 4] });
      lengths.forEach((_, i) =>
        plane.line(
          [points[i], points[i + 1]],
          i % 2 ? COLOURS.link : COLOURS.steel,
          Math.max(4, 11 - 2 * i),
        ),
      );
      points.slice(0, n).forEach((p) => plane.dot(p, COLOURS.dark, 4));
      plane.dot(points[n], COLOURS.crimson, 5);
      plane.end();
      drawErrors();
      const taken = Math.max(0, state.errors.length - 1),
        left = miss();
      words.textContent =
        `${taken} ${taken === 1 ? "step" : "steps"}, distance left ` +
        `${left < 0.001 ? P.power(left) : P.number(left, 3)} m. Singular values of the Jacobian: ` +
        `${s.map((x) => P.number(x)).join(" and ")} m.`;
    };
  });
})();
