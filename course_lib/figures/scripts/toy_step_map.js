// A map of what a run of damped steps reaches, over step size and damping; and the run of the point
// that is chosen in it.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { COLOURS, tint } = globalThis.course.palette;
  const SIDE_BY_SIDE = 612; // pixels: room for the map and the arm beside each other
  const FLAT = 0.62; // the heights of both below each other, in widths
  const LEVELS = [
    { below: -6, colour: COLOURS.tiny, words: "below 1 µm" },
    { below: -2, colour: COLOURS.small, words: "below 1 cm" },
    { below: -1, colour: COLOURS.medium, words: "below 10 cm" },
    { below: 0, colour: COLOURS.large, words: "below 1 m" },
    { below: Infinity, colour: COLOURS.huge, words: "1 m and more" },
  ];
  // Where rounding decides, the map holds null.
  const UNSETTLED = { colour: COLOURS.steel, words: "jumps about" };
  const SWATCH = "display:inline-block;width:.9em;height:.9em;margin-right:.35em;background:";
  const DIGITS = 2; // of a step size or a damping in words

  const short = (x) => String(Number(x.toPrecision(DIGITS)));
  const levelOf = (error) =>
    error === null ? UNSETTLED : LEVELS.find(({ below }) => error < below);
  /** The index of the number in a list that is nearest to x. */
  function nearestIn(list, x) {
    const distances = list.map((y) => Math.abs(y - x));
    return distances.indexOf(Math.min(...distances));
  }

  P.toy("step_map", "Step size, damping and the run of the arm", (card, meta) => {
    const { lengths, target, steps, alphas, epsilons, logErrors } = meta;
    const reach = lengths.reduce((sum, length) => sum + length, 0);
    const x = [alphas[0], alphas.at(-1)];
    const y = [epsilons[0], epsilons.at(-1)];
    const initial = () => ({ at: meta.at.map(Math.log10), step: steps });
    const state = card.state(initial());
    let run = []; // the joint angles after each step
    let computed = ""; // the point whose run this is

    const shape = () => (card.views.clientWidth < SIDE_BY_SIDE ? FLAT : 1);
    /** A part of the card with a heading above its picture. */
    function below(heading) {
      const parent = P.element("div", {}, card.views);
      P.element("div", { style: "text-align:center;font-weight:600" }, parent, heading);
      return parent;
    }
    const chart = card.plane({
      parent: below("damping ε (m²) over step size α"),
      x,
      y,
      margin: true,
      proportion: shape,
      ticks: [powersWithin(x), powersWithin(y)],
      names: ["step size α", ""],
      label: "The distance from the target after the run, over step size and damping",
    });
    const put = ([a, b]) => {
      state.at = [P.clamp(a, ...x), P.clamp(b, ...y)];
    };
    chart.handle({
      name: "Run",
      colour: COLOURS.black,
      at: () => state.at,
      moved: put,
      describe: () =>
        `step size ${short(10 ** state.at[0])}, damping ${short(10 ** state.at[1])} m²`,
    });
    P.onClick(chart, (p) => {
      put(p);
      card.draw();
    });
    const half = 1.1 * reach;
    const plane = card.plane({
      parent: below("the chosen run"),
      x: [-half, half],
      y: [-half * FLAT, half * FLAT],
      proportion: shape,
      ticks: (low, high) => TICKS.filter((tick) => tick > low && tick < high),
      names: ["x (m)", "y (m)"],
      label: "The arm, its target and the path of its tip",
    });
    addLegend(card.controls);
    const writeStep = (k) => `${k} of ${steps}`;
    const step = card.setting("Steps", state, "step", { min: 0, max: steps, step: 1 }, writeStep);
    card.player("Play", step, 1 / steps);
    const words = card.words([comment([0.02, 99], 1.23, 99, true)]);
    function isUnsettled() {
      const [alpha, eps] = state.at;
      return logErrors[nearestIn(epsilons, eps)][nearestIn(alphas, alpha)] === null;
    }

    function compute() {
      const key = state.at.join();
      if (key === computed) return;
      computed = key;
      const [alpha, eps] = state.at.map((exponent) => 10 ** exponent);
      run = M.dampedRun(lengths, meta.q, target, alpha, eps, steps);
    }
    const tipAt = (k) => M.planarPoints(lengths, run[k]).at(-1);

    /** The largest step size over the damping, as far as the map's right end. */
    function limitWithin(end) {
      const points = epsilons.map((eps) => [
        Math.log10(2 * (1 + 10 ** eps / meta.largest ** 2)),
        eps,
      ]);
      const within = points.filter(([alpha]) => alpha < end);
      if (within.length === points.length) return points;
      return [...within, [end, Math.log10(meta.largest ** 2 * (10 ** end / 2 - 1))]];
    }
    function drawMap() {
      chart.begin();
      const [across, upwards] = [alphas, epsilons].map((list) => (list[1] - list[0]) * 0.6);
      logErrors.forEach((row, j) => {
        row.forEach((error, i) => {
          const { colour } = levelOf(error);
          const corners = [
            [alphas[i] - across, epsilons[j] - upwards],
            [alphas[i] + across, epsilons[j] - upwards],
            [alphas[i] + across, epsilons[j] + upwards],
            [alphas[i] - across, epsilons[j] + upwards],
          ];
          chart.line(corners, colour, 0, { closed: true, fill: 1 });
        });
      });
      const limit = limitWithin(x[1]);
      // With a white rim it is seen on each of the map's colours, and beside the map in the dark.
      chart.line(limit, COLOURS.white, 5);
      chart.line(limit, COLOURS.shade, 2);
      for (const [alpha, eps] of meta.runs) {
        const place = [Math.log10(alpha), Math.log10(eps)];
        chart.dot(place, COLOURS.shade, 5);
        chart.dot(place, COLOURS.white, 3.5);
      }
      chart.end();
    }
    function drawRun() {
      plane.begin();
      plane.line(P.circle(reach), COLOURS.steel, 1.2, { dash: [6, 6] });
      const tips = run.slice(0, state.step + 1).map((_, k) => tipAt(k));
      for (const tip of tips) plane.dot(tip, COLOURS.crimson, 2);
      const first = M.planarPoints(lengths, run[0]);
      plane.line(first, COLOURS.grey, 2, { dash: [5, 4] });
      const points = M.planarPoints(lengths, run[state.step]);
      lengths.forEach((_, i) => {
        const colour = i % 2 ? COLOURS.link : COLOURS.steel;
        plane.line(points.slice(i, i + 2), colour, 7 - i);
      });
      for (const joint of points.slice(0, -1)) plane.dot(joint, COLOURS.dark, 3.5);
      plane.dot(points.at(-1), COLOURS.crimson, 5);
      plane.dot(target, COLOURS.blue, 7, { hollow: true });
      plane.text(M.add(target, [0, 0.11 * reach]), "target", COLOURS.blue);
      plane.end();
    }

    return () => {
      compute();
      drawMap();
      drawRun();
      const miss = M.norm(M.subtract(target, tipAt(state.step)));
      words.textContent = comment(
        state.at.map((exponent) => 10 ** exponent),
        miss,
        state.step,
        isUnsettled(),
      );
    };
  });

  const TICKS = [-4, -2, 0, 2, 4]; // metres

  /** Ticks at the powers of ten within a range of exponents. */
  function powersWithin([low, high]) {
    const first = Math.ceil(low - 1e-6);
    const count = Math.floor(high + 1e-6) - first + 1;
    return Array.from({ length: count }, (_, i) => {
      const exponent = first + i;
      return [exponent, String(Number((10 ** exponent).toPrecision(1)))];
    });
  }

  function addLegend(parent) {
    const look = { style: "display:flex;flex-wrap:wrap;gap:.2rem 1rem" };
    const legend = P.element("p", look, parent, "Distance from the target:");
    for (const { colour, words } of [...LEVELS, UNSETTLED]) {
      const item = P.element("span", {}, legend);
      P.element("span", { style: SWATCH + tint(colour) }, item);
      item.append(words);
    }
  }

  function comment([alpha, eps], miss, steps, isUnsettled) {
    const left = miss < 0.001 ? P.power(miss) : P.number(miss, 3);
    const after = `after ${steps} ${steps === 1 ? "step" : "steps"}`;
    const chance = isUnsettled ? " It jumps about: rounding decides where it is in the end." : "";
    return (
      `With α = ${short(alpha)} and ε = ${short(eps)} m² the tip is ${left} m from the target ` +
      `${after}.${chance}`
    );
  }
})();
