// Cells: the plane is cut into squares, each with two planes that stand for the joint angles of a
// two-link arm in it.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const S = globalThis.course.scene;
  const { COLOURS, tint } = globalThis.course.palette;
  const SAMPLES = 6; // along each side of a cell
  const MIN_POINTS = 6; // within reach, of which two planes are fitted
  const GOAL_MISS = 0.2; // metres
  const BAD = 5e-2; // metres: the mean error of a cell that is of no use
  const LEVELS = [
    { below: 2e-3, colour: COLOURS.tiny, words: "below 2 mm" },
    { below: 1e-2, colour: COLOURS.small, words: "below 1 cm" },
    { below: 2e-2, colour: COLOURS.medium, words: "below 2 cm" },
    { below: BAD, colour: COLOURS.large, words: "below 5 cm" },
    { below: Infinity, colour: COLOURS.huge, words: "5 cm and more" },
  ];
  const SQUARE = [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ];
  const BOTH_SIDES = [
    [0, 1, 2],
    [0, 2, 3],
    [0, 2, 1],
    [0, 3, 2],
  ];
  const SWATCH =
    "display:inline-block;width:.9em;height:.9em;margin-right:.35em;opacity:.75;background:";

  // ---- cells ----

  /**
   * The samples of the cell (i, j) that the arm reaches, and its joint angles there, q1 without a
   * jump.
   */
  function samplesOf(lengths, size, i, j) {
    const points = [];
    const angles = [];
    for (let a = 0; a < SAMPLES; a++) {
      for (let b = 0; b < SAMPLES; b++) {
        const p = [(i + a / (SAMPLES - 1)) * size, (j + b / (SAMPLES - 1)) * size];
        const q = M.twoLink(lengths, p);
        if (!q) continue;
        const revolutions = angles.length ? Math.round((q[0] - angles[0][0]) / (2 * Math.PI)) : 0;
        points.push(p);
        angles.push([q[0] - 2 * Math.PI * revolutions, q[1]]);
      }
    }
    return { points, angles };
  }
  /** A cell with its samples, planes and errors; null if the arm reaches too few of its points. */
  function cellAt(lengths, size, i, j) {
    const { points, angles } = samplesOf(lengths, size, i, j);
    if (points.length < MIN_POINTS) return null;
    const centre = [(i + 0.5) * size, (j + 0.5) * size];
    const rowOf = ([x, y]) => [1, x - centre[0], y - centre[1]];
    const rows = points.map(rowOf);
    const planes = [0, 1].map((k) =>
      M.leastSquares(
        rows,
        angles.map((q) => q[k]),
      ),
    );
    const model = (p) => planes.map((coefficients) => M.dot(coefficients, rowOf(p)));
    const errors = points.map((p) => {
      const tip = M.planarPoints(lengths, model(p))[2];
      return M.norm(M.subtract(tip, p));
    });
    const mean = errors.reduce((sum, error) => sum + error, 0) / errors.length;
    return { i, j, points, angles, planes, centre, model, worst: Math.max(...errors), mean };
  }
  function allCells(lengths, size) {
    const reach = lengths[0] + lengths[1];
    const half = Math.ceil(reach / size);
    const indices = Array.from({ length: 2 * half }, (_, i) => i - half);
    const cells = indices.flatMap((i) => indices.map((j) => cellAt(lengths, size, i, j)));
    return cells.filter(Boolean);
  }

  // ---- the toy ----

  P.toy("cells", "Cells and their two planes", (card, meta) => {
    const { lengths } = meta;
    const reach = lengths[0] + lengths[1];
    const state = card.state({ size: meta.size, at: [...meta.at] });
    let cells = allCells(lengths, state.size);

    // Side by side on a phone, too, where both stay square.
    const halfOfViews = () => P.element("div", { class: "half" }, card.views);
    const plane = card.map({
      parent: halfOfViews(),
      half: 1.3 * reach,
      label: "The workspace cut into cells, coloured by the error of each cell's planes",
    });
    plane.handle({
      name: "Query",
      colour: COLOURS.blue,
      at: () => state.at,
      moved: (p) => {
        state.at = p;
      },
    });
    const view = card.space({
      parent: halfOfViews(),
      radius: 0.95,
      azimuth: -2.2,
      elevation: 0.35,
      proportion: 1,
      label: "The joint angles over the cell and the two planes fitted to them",
    });
    const limits = { min: -2, max: 0, step: 0.05, value: Math.log2(state.size) };
    const writeSize = (exponent) => P.metres([2 ** exponent]);
    card.range("Cell size", limits, writeSize, (exponent) => {
      state.size = 2 ** exponent;
      cells = allCells(lengths, state.size);
    });
    addLegend(card.controls);
    const numbers = card.numbers();
    const words = card.words();
    const goal = card.goal(
      state,
      `find a query that the arm misses by more than ${100 * GOAL_MISS} cm.`,
    );

    const cornersOf = (i, j) => SQUARE.map((corner) => M.scale(M.add(corner, [i, j]), state.size));
    function drawCells(query, tipPoints) {
      plane.begin();
      for (const cell of cells) {
        const { colour } = LEVELS.find(({ below }) => cell.mean < below);
        const corners = cornersOf(cell.i, cell.j);
        plane.line(corners, colour, 0, { closed: true, fill: 0.75 });
        plane.line(corners, COLOURS.ground, 1, { closed: true });
      }
      plane.line(P.circle(reach), COLOURS.grey, 1);
      plane.line(query, COLOURS.black, 2.5, { closed: true });
      if (tipPoints) {
        plane.line(tipPoints.slice(0, 2), COLOURS.dark, 6);
        plane.line(tipPoints.slice(1), COLOURS.link, 5);
        plane.dot(tipPoints[2], COLOURS.crimson, 5);
      }
      plane.end();
    }
    /** The samples of a cell and its planes, in a box of sides 1.1 whatever their range is. */
    function drawPlanes({ i, j, points, angles, model, centre }) {
      const allAngles = angles.flat();
      const low = Math.min(...allAngles);
      const range = Math.max(Math.max(...allAngles) - low, 1e-9);
      const place = (p, angle) => {
        const across = M.scale(M.subtract(p, centre), 1.1 / state.size);
        return [...across, ((angle - low) / range - 0.5) * 1.1];
      };
      const corners = cornersOf(i, j);
      [COLOURS.blue, COLOURS.orange].forEach((colour, k) => {
        const plate = corners.map((p) => place(p, model(p)[k]));
        const mesh = { ...S.mesh(plate, BOTH_SIDES, 0), fleeting: true };
        view.mesh(mesh, [M.eye(4)], [colour], { opacity: 0.4 });
        view.line([...plate, plate[0]], colour, 1.5);
        const samples = points.map((p, m) => place(p, angles[m][k]));
        const residuals = points.flatMap((p, m) => [samples[m], place(p, model(p)[k]), null]);
        view.line(residuals, COLOURS.crimson, 1.5);
        for (const sample of samples) view.ball(sample, 0.022, colour);
        view.text(M.add(plate[0], [0, 0, 0.12]), P.sub("q", k + 1), colour);
      });
      const floor = corners.map((p) => place(p, low));
      view.line([...floor, floor[0]], COLOURS.grey, 1);
      view.text(M.add(floor[1], [0.12, 0, 0]), "x", COLOURS.grey);
      view.text(M.add(floor[3], [0, 0.12, 0]), "y", COLOURS.grey);
    }

    return () => {
      const [i, j] = state.at.map((x) => Math.floor(x / state.size));
      const cell = cellAt(lengths, state.size, i, j);
      const points = cell && M.planarPoints(lengths, cell.model(state.at));
      drawCells(cornersOf(i, j), points);
      view.begin();
      if (cell) drawPlanes(cell);
      view.end();
      const miss = cell ? M.norm(M.subtract(points[2], state.at)) : 0;
      if (cell) numbers(...linesOf(cell, miss));
      else numbers("this cell holds too few points that the arm reaches");
      words.textContent = comment(cells, state.size);
      goal(miss > GOAL_MISS && M.norm(state.at) <= reach);
    };
  });

  function addLegend(parent) {
    const look = { style: "display:flex;flex-wrap:wrap;gap:.2rem 1rem" };
    const legend = P.element("p", look, parent);
    for (const { colour, words } of LEVELS) {
      const item = P.element("span", {}, legend);
      P.element("span", { style: SWATCH + tint(colour) }, item);
      item.append(words);
    }
  }

  const millimetres = (x) => `${P.number(1000 * x, 1)} mm`;
  const sign = (x) => (x < 0 ? "−" : "+");
  /** A slope of a plane: "+ 0.123 (x − 0.25)". */
  const termOf = (slope, axis, offset) =>
    `${sign(slope)} ${P.number(Math.abs(slope), 3)} ` +
    `(${axis} ${sign(-offset)} ${P.number(Math.abs(offset))})`;

  /** The equations of a cell's planes, and its errors; `miss` is that of the query. */
  function linesOf({ planes, centre, mean, worst }, miss) {
    const equations = planes.map(([constant, slopeX, slopeY], k) => {
      const x = termOf(slopeX, "x", centre[0]);
      const y = termOf(slopeY, "y", centre[1]);
      return `${P.sub("q", k + 1)} = ${P.number(constant, 3)} ${x} ${y} rad`;
    });
    const errors =
      `the arm stands ${millimetres(miss)} from the query; ` +
      `on average in this cell ${millimetres(mean)}, at worst ${millimetres(worst)}`;
    return [...equations, errors];
  }
  function comment(cells, size) {
    const bad = cells.filter(({ mean }) => mean >= BAD).length;
    const worst = cells.reduce((a, b) => (b.mean > a.mean ? b : a));
    return (
      `${cells.length} cells of ${P.number(size)} m, 6 numbers each, branch q₂ ≥ 0; ${bad} ` +
      "of them are 5 cm off or more on average. " +
      `The worst has its centre at (${P.list(worst.centre)}) m.`
    );
  }
})();
