// The lengths of the undamped and of the damped step over a singular value, and the two singular
// values of a Jacobian, which are dragged on the ellipse of the velocities that it can make.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { COLOURS, tint } = globalThis.course.palette;
  const HALF = 4.2; // metres of the ellipse's map, and of the chart's axis
  const LARGEST = 4; // metres, of a singular value
  const LEAST = 0.02;
  const TICKS = [-4, -2, 0, 2, 4]; // of the map
  const TOP = 2.2; // rad/m, of the chart
  const SAMPLES = 120; // of a curve
  const TILT = 30 * P.rad; // of u1, so that both coordinates of a handle change its value
  const DIRECTIONS = [
    [Math.cos(TILT), Math.sin(TILT)],
    [-Math.sin(TILT), Math.cos(TILT)],
  ];
  const SIDE_BY_SIDE = 612; // pixels: room for both pictures beside each other
  const FLAT = 0.6; // the heights of the pictures below each other, in widths
  const HEAD = 0.22; // metres: the length of an arrow's head
  const SHADES = [COLOURS.blue, COLOURS.green, COLOURS.purple]; // of the curves that stay
  const SWATCH =
    "display:inline-block;width:1.6em;vertical-align:middle;margin-right:.35em;border-top:2.5px ";
  const NAMES = ["s₁", "s₂"];

  const undamped = (s) => 1 / s;
  const damped = (s, damping) => s / (s * s + damping);

  P.toy("gains", "What damping does to a step", (card, meta) => {
    const initial = () => ({
      s: [...meta.singularValues],
      logDamping: Math.log10(meta.damping),
      angle: -15 * P.rad,
    });
    const state = card.state(initial());
    const damping = () => 10 ** state.logDamping;
    const error = () => [Math.cos(state.angle), Math.sin(state.angle)];
    const shape = () => (card.views.clientWidth < SIDE_BY_SIDE ? FLAT : 1);
    const plane = card.plane({
      x: [-HALF, HALF],
      y: [-HALF * FLAT, HALF * FLAT],
      ticks: (low, high) => TICKS.filter((tick) => tick > low && tick < high),
      names: ["x (m)", "y (m)"],
      proportion: shape,
      label: "The ellipse of the Jacobian, the error and the damped step",
    });
    NAMES.forEach((name, i) => {
      plane.handle({
        name: `Singular value ${name}`,
        colour: COLOURS.orange,
        at: () => M.scale(DIRECTIONS[i], state.s[i]),
        moved: (p) => {
          const [low, high] = i === 0 ? [state.s[1], LARGEST] : [LEAST, state.s[0]];
          state.s[i] = P.clamp(M.dot(p, DIRECTIONS[i]), low, high);
        },
        describe: () => P.metres([state.s[i]]),
      });
    });
    plane.handle({
      name: "Direction of the error",
      colour: COLOURS.blue,
      small: true,
      at: error,
      moved: ([x, y]) => {
        state.angle = Math.atan2(y, x);
      },
      describe: () => P.degrees(state.angle),
    });
    const chart = card.plane({
      x: [0, HALF],
      y: [0, TOP],
      margin: true,
      proportion: shape,
      ticks: [
        [0, 1, 2, 3, 4],
        [0, 0.5, 1, 1.5, 2],
      ],
      names: ["singular value s (m)", "joint step per error (rad/m)"],
      label: "The length of the joint step over the singular value",
    });
    const limits = { min: -3, max: 1.3, step: 0.05 };
    const writeDamping = (exponent) => `${Number((10 ** exponent).toPrecision(2))} m²`;
    card.setting("Damping ε", state, "logDamping", limits, writeDamping);
    addLegend(card.controls, meta.dampings);
    const numbers = card.numbers();
    const words = card.words([comment(0.123, 12.3)]);

    function drawArrow(from, to, colour, width) {
      const way = M.subtract(to, from);
      const length = M.norm(way);
      if (length < 1e-6) return;
      const back = M.scale(way, -Math.min(HEAD, length) / length);
      const aside = M.scale([-back[1], back[0]], 0.5);
      plane.line([from, to], colour, width);
      const barbs = [M.add(M.add(to, back), aside), to, M.subtract(M.add(to, back), aside)];
      plane.line(barbs, colour, width);
    }
    function drawEllipse(moved) {
      const [a, b] = DIRECTIONS.map((u, i) => M.scale(u, state.s[i]));
      const ellipse = P.circle(1).map(([c, s]) => M.add(M.scale(a, c), b, s));
      plane.begin();
      plane.line(ellipse, COLOURS.orange, 1.5, { closed: true, fill: 0.13 });
      for (const axis of [a, b]) plane.line([[0, 0], axis], COLOURS.orange, 1.5);
      plane.line([moved, error()], COLOURS.grey, 1.5, { dash: [3, 3] });
      drawArrow([0, 0], error(), COLOURS.blue, 2);
      drawArrow([0, 0], moved, COLOURS.crimson, 3);
      NAMES.forEach((name, i) => {
        const beyond = M.scale(DIRECTIONS[i], state.s[i] + 0.55);
        plane.text(beyond, name, COLOURS.orange);
      });
      plane.text(M.scale(error(), 1.7), "error", COLOURS.blue);
      plane.end();
    }
    function drawCurve(gain, colour, width, dash = []) {
      const points = M.sampled(SAMPLES, (share) => {
        const s = LEAST + share * (HALF - LEAST);
        return [s, gain(s)];
      });
      chart.line(points, colour, width, { dash });
    }
    function drawChart() {
      chart.begin();
      meta.dampings.forEach((eps, i) => {
        drawCurve((s) => damped(s, eps), SHADES[i % SHADES.length], 1.5, [6, 4]);
      });
      drawCurve(undamped, COLOURS.black, 1.5);
      drawCurve((s) => damped(s, damping()), COLOURS.crimson, 3);
      const best = Math.sqrt(damping());
      if (best < HALF) chart.dot([best, damped(best, damping())], COLOURS.crimson, 4);
      state.s.forEach((s, i) => {
        const across = [
          [s, 0],
          [s, 0.72 * TOP],
        ];
        chart.line(across, COLOURS.grey, 1, { dash: [4, 4] });
        chart.dot([s, damped(s, damping())], COLOURS.orange, 5);
        chart.dot([s, undamped(s)], COLOURS.black, 4, { hollow: true });
        chart.text([s, 0.78 * TOP], NAMES[i], COLOURS.orange);
      });
      chart.text([0.95, 1.5], "1/s", COLOURS.black);
      chart.end();
    }

    return () => {
      const [u1, u2] = DIRECTIONS;
      const [s1, s2] = state.s;
      // J = U S, with the joints' axes along the vectors v.
      const J = [
        [s1 * u1[0], s2 * u2[0]],
        [s1 * u1[1], s2 * u2[1]],
      ];
      const step = M.dampedStep(J, error(), damping());
      const long = M.norm(DIRECTIONS.map((u, i) => M.dot(u, error()) * undamped(state.s[i])));
      drawEllipse(M.apply(J, step));
      drawChart();
      numbers(
        ...state.s.map((s, i) => {
          const share = P.percent((s * s) / (s * s + damping()));
          return (
            `along u${NAMES[i][1]}: 1/${NAMES[i]} = ${P.number(undamped(s))} rad/m, damped ` +
            `${P.number(damped(s, damping()))} rad/m, which removes ${share} of the error`
          );
        }),
      );
      words.textContent = comment(M.norm(step), long);
    };
  });

  /** The colours of the chart's curves, in words. */
  function addLegend(parent, dampings) {
    const look = { style: "display:flex;flex-wrap:wrap;gap:.2rem 1rem;align-items:center" };
    const legend = P.element("p", look, parent);
    const add = (colour, kind, words) => {
      const item = P.element("span", {}, legend);
      const swatch = `${SWATCH}${kind} ${tint(colour)}`;
      P.element("span", { style: swatch }, item);
      item.append(words);
    };
    add(COLOURS.black, "solid", "1/s");
    add(COLOURS.crimson, "solid", "your ε");
    dampings.forEach((eps, i) => {
      add(SHADES[i % SHADES.length], "dashed", `ε = ${eps} m²`);
    });
  }

  function comment(step, long) {
    return (
      `For an error of 1 m the damped step, red, is ${P.number(step)} rad long; ` +
      `the undamped one would be ${P.number(long)} rad long.`
    );
  }
})();
