// A planar arm with a target to drag: steps of damped least squares, the manipulability ellipse,
// the error over the steps.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { COLOURS } = globalThis.course.palette;
  const MAX_STEPS = 200;
  const REACHED = 1e-6; // metres
  // The goal: so many metres in so many steps, of a run that ends within REACHED of the target.
  const GOAL_METRES = 2;
  const GOAL_STEPS = 12;
  const MAX_DASHES = 30; // steps up to which the path of the tip is a line; more are dots
  const SIDE_BY_SIDE = 612; // pixels: room for the arm and the chart beside it
  const FLAT = 0.45; // the height of the chart below the arm, in widths
  const ELLIPSE = 0.3; // the length of an axis with the singular value 1 m
  // The largest number on an axis of the chart, and the distance between its ticks.
  const DISTANCES = [
    [0.5, 0.1],
    [1, 0.2],
    [2, 0.5],
    [5, 1],
    [10, 2],
    [20, 5],
  ];
  const STEPS = [
    [20, 5],
    [50, 10],
    [MAX_STEPS, 50],
  ];
  const LEAST_EXPONENT = -7; // of the chart's logarithmic axis
  const POWERS = [
    [0, "1"],
    [-2, "10⁻²"],
    [-4, "10⁻⁴"],
    [-6, "10⁻⁶"],
  ];

  /** The first scale that reaches as far as x, or the last one. */
  const scaleFor = (scales, x) => scales.find(([top]) => top >= x) ?? scales.at(-1);
  const ticksOf = ([top, distance]) =>
    Array.from({ length: Math.round(top / distance) + 1 }, (_, i) => {
      const tick = i * distance;
      return [tick, String(Number(tick.toFixed(2)))];
    });

  P.toy("planar_arm", "A planar arm and its target", (card, meta) => {
    const { lengths } = meta;
    const n = lengths.length;
    const reach = lengths.reduce((sum, length) => sum + length, 0);
    const state = card.state({
      q: [...meta.q],
      target: [...meta.target],
      damping: meta.damping,
      step: meta.step,
      errors: [],
      path: [],
    });

    // ---- the iteration ----

    const tip = () => M.planarPoints(lengths, state.q)[n];
    const miss = () => M.norm(M.subtract(state.target, tip()));
    function note() {
      state.errors.push(miss());
      state.path.push(tip());
    }
    /** One step; returns whether another one should follow. */
    function step() {
      if (!state.errors.length) note();
      const J = M.planarJacobian(lengths, state.q);
      const error = M.subtract(state.target, tip());
      state.q = M.add(state.q, M.dampedStep(J, error, state.damping), state.step);
      note();
      return state.errors.at(-1) > REACHED && state.errors.length <= MAX_STEPS;
    }
    function forget() {
      state.errors = [];
      state.path = [];
    }
    /**
     * Another step size or damping is tried from the first configuration: an arm at its target
     * would not move.
     */
    function putBack() {
      card.halt();
      state.q = [...meta.q];
      forget();
    }
    function run() {
      forget();
      card.run(step);
    }

    // ---- controls ----

    const plane = card.map({
      half: 1.12 * reach,
      step: reach > 6 ? 2 : 1,
      label: "The arm, its target and its manipulability ellipse",
    });
    plane.handle({
      name: "Target",
      colour: COLOURS.blue,
      at: () => state.target,
      moved: (p) => {
        state.target = p;
        run();
      },
      describe: () => `${P.metres(state.target)}, distance left ${P.number(miss(), 3)} m`,
    });
    const chart = chartOf(card, state);
    const stepLimits = { min: 0.05, max: 4, step: 0.05, value: state.step };
    const writeStep = (x) => x.toFixed(2);
    card.range("Step size", stepLimits, writeStep, (x) => {
      state.step = x;
      putBack();
      run();
    });
    const dampingLimits = { min: -4, max: 1.5, step: 0.1, value: Math.log10(state.damping) };
    const writeDamping = (exponent) => String(Number((10 ** exponent).toPrecision(2)));
    card.range("Damping (m²)", dampingLimits, writeDamping, (exponent) => {
      state.damping = 10 ** exponent;
      putBack();
      run();
    });
    card.button("One step", () => {
      card.halt();
      step();
    });
    card.button("Run", run);
    card.button("Arm to its start", putBack);
    card.checkbox("logarithmic error", state, "log");
    const words = card.words();
    const goal = card.goal(
      state,
      `choose step size and damping so that the tip moves ${GOAL_METRES} m or more to its target ` +
        `in at most ${GOAL_STEPS} steps.`,
    );
    if (!state.errors.length) run();

    // ---- drawing ----

    function drawPath() {
      if (state.path.length <= MAX_DASHES) {
        plane.line(state.path, COLOURS.crimson, 1.2, { dash: [4, 4] });
        return;
      }
      for (const p of state.path) plane.dot(p, COLOURS.crimson, 1.5);
    }
    function drawEllipse(end, vectors, singularValues) {
      const [a, b] = vectors.map((v, i) => M.scale(v, ELLIPSE * singularValues[i]));
      const ellipse = P.circle(1).map(([c, s]) => M.add(M.add(end, a, c), b, s));
      plane.line(ellipse, COLOURS.green, 1.5, { fill: 0.13 });
    }
    function drawLinks(points) {
      lengths.forEach((_, i) => {
        const colour = i % 2 ? COLOURS.link : COLOURS.steel;
        const width = Math.max(4, 11 - 2 * i);
        plane.line(points.slice(i, i + 2), colour, width);
      });
      for (const joint of points.slice(0, n)) plane.dot(joint, COLOURS.dark, 4);
      plane.dot(points[n], COLOURS.crimson, 5);
    }

    return () => {
      const points = M.planarPoints(lengths, state.q);
      const J = M.planarJacobian(lengths, state.q);
      const { values, vectors } = M.eigen(M.times(J, M.transpose(J)));
      const singularValues = values.map((x) => Math.sqrt(Math.max(0, x)));
      plane.begin();
      plane.line(P.circle(reach), COLOURS.steel, 1.2, { dash: [6, 6] });
      drawEllipse(points[n], vectors, singularValues);
      drawPath();
      drawLinks(points);
      plane.end();
      const errors = state.errors.length ? state.errors : [miss()];
      chart.draw(errors);
      const steps = errors.length - 1;
      words.textContent = comment(steps, miss(), singularValues);
      const isFarAndFast = errors[0] >= GOAL_METRES && steps <= GOAL_STEPS;
      goal(isFarAndFast && errors.at(-1) <= REACHED);
    };
  });

  /** The chart of the error over the steps, in the card beside the arm. */
  function chartOf(card, state) {
    const parent = P.element("div", {}, card.views);
    let plane = null;
    let axes = ""; // those that the plane has, in words

    const height = (error) =>
      state.log ? Math.log10(Math.max(error, 10 ** LEAST_EXPONENT)) : error;
    /** Make the plane anew if it needs other axes. */
    function fit(errors) {
      const steps = scaleFor(STEPS, errors.length);
      const distances = scaleFor(DISTANCES, Math.max(...errors));
      const needed = `${state.log} ${steps} ${distances}`;
      if (needed === axes) return;
      axes = needed;
      plane?.stop();
      plane = card.plane({
        x: [0, steps[0]],
        y: [state.log ? LEAST_EXPONENT : 0, height(distances[0])],
        margin: true,
        proportion: () => (card.views.clientWidth < SIDE_BY_SIDE ? FLAT : 1),
        parent,
        ticks: [ticksOf(steps), state.log ? POWERS : ticksOf(distances)],
        names: ["steps", "distance left (m)"],
        label: "Distance from the target over the steps",
      });
    }
    function draw(errors) {
      fit(errors);
      const points = errors.map((error, i) => [i, height(error)]);
      plane.begin();
      plane.line(points, COLOURS.crimson, 2.5);
      plane.dot(points.at(-1), COLOURS.crimson, 3.5);
      plane.end();
    }
    return { draw };
  }

  function comment(steps, miss, singularValues) {
    const taken = `${steps} ${steps === 1 ? "step" : "steps"}`;
    const left = miss < 0.001 ? P.power(miss) : P.number(miss, 3);
    const values = singularValues.map((x) => P.number(x)).join(" and ");
    return `${taken}, distance left ${left} m. Singular values of the Jacobian: ${values} m.`;
  }
})();
