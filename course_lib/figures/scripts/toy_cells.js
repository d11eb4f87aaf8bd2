// Cells: the plane is cut into squares, each with two planes that stand for the joint angles of a two-link arm in it.
(() => {
  "use strict";
  const M = globalThis.course.motion,
    P = globalThis.course.parts,
    S = globalThis.course.scene,
    { COLOURS } = P;
  const LEVELS = [
    [2e-3, "#2166ac", "below 2 mm"],
    [1e-2, "#92c5de", "below 1 cm"],
    [2e-2, "#f7e6c4", "below 2 cm"],
    [5e-2, "#f4a582", "below 5 cm"],
    [Infinity, "#b01a2a", "5 cm and more"],
  ];
  const SQUARE = [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ];

  P.toy("cells", "Cells and their two planes", (card, meta) => {
    const { lengths } = meta,
      reach = lengths[0] + lengths[1];
    const state = card.state({ size: meta.size, at: [...meta.at] });
    const label = "The workspace cut into cells, coloured by the error of each cell's planes";
    const beside = () => P.element("div", { class: "half" }, card.views); // on a phone too, where both stay square
    const plane = card.map({ parent: beside(), half: 1.3 * reach, label });
    plane.handle({
      name: "Query",
      colour: COLOURS.blue,
      at: () => state.at,
      moved: (p) => (state.at = p),
    });
    const view = card.space({
      parent: beside(),
      radius: 0.95,
      azimuth: -2.2,
      elevation: 0.35,
      proportion: 1,
      label: "The joint angles over the cell and the two planes fitted to them",
    });
    card.range(
      "Cell size",
      { min: -2, max: 0, step: 0.05, value: Math.log2(state.size) },
      (x) => P.metres([2 ** x]),
      (x) => {
        state.size = 2 ** x;
        cells = all();
      },
    );
    const legend = P.element(
      "p",
      { style: "display:flex;flex-wrap:wrap;gap:.2rem 1rem" },
      card.controls,
    );
    LEVELS.forEach(([, colour, label]) => {
      const item = P.element("span", {}, legend);
      const look =
        "display:inline-block;width:.9em;height:.9em;margin-right:.35em;opacity:.75;background:";
      P.element("span", { style: look + P.tint(colour) }, item);
      item.append(label);
    });
    const numbers = card.numbers(),
      words = card.words();

    // A cell's samples (a square of 6 x 6, those within reach, q1 without a jump), planes and errors.
    function cell(i, j) {
      const h = state.size,
        points = [],
        angles = [],
        centre = [(i + 0.5) * h, (j + 0.5) * h];
      for (let a = 0; a < 6; a++)
        for (let b = 0; b < 6; b++) {
          const p = [(i + a / 5) * h, (j + b / 5) * h],
            q = M.twoLink(lengths, p);
          if (!q) continue;
          if (angles.length)
            q[0] -= 2 * Math.PI * Math.round((q[0] - angles[0][0]) / (2 * Math.PI));
          points.push(p);
          angles.push(q);
        }
      if (points.length < 6) return null;
      const rows = points.map(([x, y]) => [1, x - centre[0], y - centre[1]]);
      const planes = [0, 1].map((k) =>
        M.leastSquares(
          rows,
          angles.map((q) => q[k]),
        ),
      );
      const model = (p) => planes.map((c) => M.dot(c, [1, p[0] - centre[0], p[1] - centre[1]]));
      const errors = points.map((p) => M.norm(M.add(M.planarPoints(lengths, model(p))[2], p, -1)));
      const mean = errors.reduce((s, e) => s + e, 0) / errors.length;
      return { i, j, points, angles, planes, centre, model, worst: Math.max(...errors), mean };
    }
    function all() {
      const most = Math.ceil(reach / state.size),
        range = Array.from({ length: 2 * most }, (_, i) => i - most);
      return range.flatMap((i) => range.map((j) => cell(i, j))).filter(Boolean);
    }
    const corners = (i, j) => SQUARE.map((c) => M.scale(M.add(c, [i, j]), state.size));
    let cells = all();
    function drawCells(here, answer) {
      plane.begin();
      cells.forEach((each) => {
        const [, colour] = LEVELS.find(([limit]) => each.mean < limit),
          edge = corners(each.i, each.j);
        plane.line(edge, colour, 0, { closed: true, fill: 0.75 });
        plane.line(edge, COLOURS.ground, 1, { closed: true });
      });
      plane.line(P.circle(reach), COLOURS.grey, 1);
      plane.line(here, COLOURS.black, 2.5, { closed: true });
      if (answer)
        [0, 1].forEach((k) =>
          plane.line(answer.slice(k, k + 2), [COLOURS.dark, COLOURS.link][k], 6 - k),
        );
      if (answer) plane.dot(answer[2], COLOURS.crimson, 5);
      plane.end();
    }
    function drawPlanes({ i, j, points, angles, model, centre }) {
      const flat = angles.flat(),
        low = Math.min(...flat),
        tall = Math.max(Math.max(...flat) - low, 1e-9);
      const put = (p, angle) => [
        ...M.scale(M.add(p, centre, -1), 1.1 / state.size),
        ((angle - low) / tall - 0.5) * 1.1,
      ];
      const square = corners(i, j),
        floor = square.map((p) => put(p, low));
      [COLOURS.blue, COLOURS.orange].forEach((colour, k) => {
        const at = square.map((p) => put(p, model(p)[k]));
        const faces = [
          [0, 1, 2],
          [0, 2, 3],
          [0, 2, 1],
          [0, 3, 2],
        ];
        view.mesh({ ...S.mesh(at, faces, 0), fleeting: true }, [M.eye(4)], [colour], {
          opacity: 0.4,
        });
        view.line([...at, at[0]], colour, 1.5);
        view.line(
          points.flatMap((p, m) => [put(p, angles[m][k]), put(p, model(p)[k]), null]),
          COLOURS.crimson,
          1.5,
        );
        points.forEach((p, m) => view.ball(put(p, angles[m][k]), 0.022, colour));
        view.text(M.add(at[0], [0, 0, 0.12]), P.sub("q", k + 1), colour);
      });
      view.line([...floor, floor[0]], COLOURS.grey, 1);
      [
        ["x", 1, [0.12, 0, 0]],
        ["y", 3, [0, 0.12, 0]],
      ].forEach(([name, k, d]) => view.text(M.add(floor[k], d), name, COLOURS.grey));
    }
    function describe({ planes, centre, mean, worst }, answer) {
      const sign = (x) => (x < 0 ? "−" : "+");
      const term = (c, axis, x) =>
        `${sign(c)} ${P.number(Math.abs(c), 3)} (${axis} ${sign(-x)} ${P.number(Math.abs(x))})`;
      const mm = (x) => `${P.number(1000 * x, 1)} mm`,
        off = M.norm(M.add(answer[2], state.at, -1));
      return [
        ...planes.map(
          ([a, b, c], k) =>
            `${P.sub("q", k + 1)} = ${P.number(a, 3)} ${term(b, "x", centre[0])} ${term(c, "y", centre[1])} rad`,
        ),
        `the arm stands ${mm(off)} from the query; on average in this cell ${mm(mean)}, at worst ${mm(worst)}`,
      ];
    }
    return () => {
      const [i, j] = state.at.map((x) => Math.floor(x / state.size)),
        found = cell(i, j);
      const answer = found && M.planarPoints(lengths, found.model(state.at));
      drawCells(corners(i, j), answer);
      view.begin();
      if (found) drawPlanes(found);
      view.end();
      numbers(
        ...(found
          ? describe(found, answer)
          : ["this cell holds too few points that the arm reaches"]),
      );
      const bad = cells.filter(({ mean }) => mean >= 5e-2).length;
      const worst = P.list(cells.reduce((a, b) => (b.mean > a.mean ? b : a)).centre);
      words.textContent =
        `${cells.length} cells of ${P.number(state.size)} m, 6 numbers each, branch q₂ ≥ 0; ${bad} ` +
        `of them are 5 cm off or more on average. The worst has its centre at (${worst}) m.`;
    };
  });
})();
