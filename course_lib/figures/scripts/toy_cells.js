// Cells: the plane is cut into squares, each with two planes that stand for the joint angles of a two-link arm in it.
(() => {
  "use strict";
  const K = globalThis.course.kinematics, P = globalThis.course.parts, { COLOURS } = P;
  const LEVELS = [[2e-3, "#2166ac", "below 2 mm"], [1e-2, "#92c5de", "below 1 cm"], [2e-2, "#f7e6c4", "below 2 cm"],
    [5e-2, "#f4a582", "below 5 cm"], [Infinity, "#b01a2a", "5 cm and more"]];

  globalThis.course.kinds["toy:cells"] = (host, meta) => {
    const { lengths } = meta, reach = lengths[0] + lengths[1];
    const state = meta.state || (meta.state = { size: meta.size, at: [...meta.at] });
    const card = P.card(host, "Cells and their two planes");
    const plane = P.plane(card.views, { half: 1.08 * reach, step: 1, label: "The workspace cut into cells, coloured by the error of each cell's planes" });
    const field = P.shape("g", {}, plane.up), rim = plane.line("#555555", 0.6);
    rim.set(Array.from({ length: 91 }, (_, i) => [reach * Math.cos((i * Math.PI) / 45), reach * Math.sin((i * Math.PI) / 45)]));
    const chosen = plane.line(COLOURS.black, 1.6), links = [plane.line("#444444", 3.5), plane.line(COLOURS.link, 3)], tip = plane.dot(COLOURS.crimson, 1.3);
    const query = plane.handle({ name: "Query", colour: COLOURS.blue, moved: (p) => { state.at = p; draw(); }, describe: () => state.at.map((x) => P.number(x)).join(", ") + " m" });
    const view = P.space(card.views, { radius: 1, azimuth: -2.2, elevation: 0.35, shape: 1, label: "The joint angles over the cell and the two planes fitted to them", meta: state, redraw: () => draw() });
    card.range("Cell size", { min: -2, max: 0, step: 0.05, value: Math.log2(state.size) }, (x) => `${(2 ** x).toFixed(2)} m`, (x) => { state.size = 2 ** x; fill(); draw(); });
    const legend = P.element("p", { style: "display:flex;flex-wrap:wrap;gap:.2rem 1rem" }, card.controls);
    LEVELS.forEach(([, colour, label]) => {
      const item = P.element("span", {}, legend);
      P.element("span", { style: `display:inline-block;width:.9em;height:.9em;margin-right:.35em;background:${P.tint(colour)}` }, item);
      item.append(label);
    });
    const numbers = card.numbers(), words = card.words();

    // A cell's samples (a square of 6 x 6, those within reach, q1 without a jump), planes and worst error.
    function cell(i, j) {
      const h = state.size, points = [], angles = [];
      for (let a = 0; a < 6; a++) for (let b = 0; b < 6; b++) {
        const p = [(i + a / 5) * h, (j + b / 5) * h], q = K.twoLink(lengths, p);
        if (!q) continue;
        if (angles.length) q[0] -= 2 * Math.PI * Math.round((q[0] - angles[0][0]) / (2 * Math.PI));
        points.push(p);
        angles.push(q);
      }
      if (points.length < 6) return null;
      const centre = [(i + 0.5) * h, (j + 0.5) * h], shifted = points.map((p) => K.add(p, centre, -1));
      const planes = [0, 1].map((k) => K.fitPlane(shifted, angles.map((q) => q[k])));
      const model = (p) => planes.map(([a, b, c]) => a + b * (p[0] - centre[0]) + c * (p[1] - centre[1]));
      const errors = points.map((p) => K.norm(K.add(K.planarPoints(lengths, model(p))[2], p, -1)));
      return { points, angles, planes, centre, model, worst: Math.max(...errors), mean: errors.reduce((s, e) => s + e, 0) / errors.length };
    }
    let count = 0, bad = 0;
    function fill() {
      const h = state.size, most = Math.ceil(reach / h), paths = LEVELS.map(() => "");
      count = bad = 0;
      for (let i = -most; i < most; i++) for (let j = -most; j < most; j++) {
        const found = cell(i, j);
        if (!found) continue;
        const level = LEVELS.findIndex(([limit]) => found.mean < limit);
        paths[level] += `M${i * h},${j * h}h${h}v${h}h${-h}Z`;
        count++;
        bad += level === LEVELS.length - 1;
      }
      field.replaceChildren();
      LEVELS.forEach(([, colour], k) => P.shape("path", { d: paths[k], fill: colour, "fill-opacity": 0.75, stroke: COLOURS.ground, "stroke-width": 0.006 }, field));
    }
    function draw() {
      const h = state.size, [i, j] = state.at.map((x) => Math.floor(x / h)), found = cell(i, j);
      query.set(state.at);
      chosen.set([[i * h, j * h], [(i + 1) * h, j * h], [(i + 1) * h, (j + 1) * h], [i * h, (j + 1) * h]], true);
      const answer = found && found.model(state.at), shown = answer && K.planarPoints(lengths, answer);
      links.forEach((link, k) => link.set(shown ? [shown[k], shown[k + 1]] : []));
      tip.set(shown && shown[2]);
      view.begin();
      if (found) {
        const all = found.angles.flat(), low = Math.min(...all), high = Math.max(...all), tall = Math.max(high - low, 1e-9);
        const put = (p, angle) => [((p[0] - found.centre[0]) / h) * 1.1, ((p[1] - found.centre[1]) / h) * 1.1, ((angle - low) / tall - 0.5) * 1.1];
        const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map((c) => c.map((x) => x * h));
        [COLOURS.blue, COLOURS.orange].forEach((colour, k) => {
          const at = corners.map((p) => put(p, found.model(p)[k]));
          view.mesh({ vertices: at, faces: [[0, 1, 2], [0, 2, 3], [0, 2, 1], [0, 3, 2]], colours: [0, 0, 0, 0], bodies: [0, 0, 0, 0] }, [K.eye(4)], [colour], 0.4);
          view.line([...at, at[0]], colour, 1.5);
          found.points.forEach((p, m) => view.line([put(p, found.angles[m][k]), put(p, found.model(p)[k])], COLOURS.crimson, 1.5));
          found.points.forEach((p, m) => { const x = put(p, found.angles[m][k]); view.line([x, K.add(x, [0, 0, 0.001])], colour, 5); });
          view.text(K.add(at[0], [0, 0, 0.12]), `q${k + 1}`, colour);
        });
        const floor = corners.map((p) => put(p, low));
        view.line([...floor, floor[0]], "#999999", 1);
        view.text(K.add(floor[1], [0.12, 0, 0]), "x", COLOURS.grey);
        view.text(K.add(floor[3], [0, 0.12, 0]), "y", COLOURS.grey);
      }
      view.end();
      numbers.textContent = found
        ? found.planes.map(([a, b, c], k) => `q${k + 1} = ${P.number(a, 3)} ${b < 0 ? "-" : "+"} ${P.number(Math.abs(b), 3)} (x - ${P.number(found.centre[0], 2)}) ${c < 0 ? "-" : "+"} ${P.number(Math.abs(c), 3)} (y - ${P.number(found.centre[1], 2)})   rad`).join("\n") +
          `\nthe arm stands ${P.number(1000 * K.norm(K.add(shown[2], state.at, -1)), 1)} mm from the query; on average in this cell ${P.number(1000 * found.mean, 1)} mm, at worst ${P.number(1000 * found.worst, 1)} mm`
        : "this cell holds too few points that the arm reaches";
      words.textContent = `${count} cells of ${P.number(h)} m, 6 numbers each, branch q2 >= 0; ${bad} of them are 5 cm off or more on average.`;
    }
    fill();
    draw();
    return () => { view.stop(); card.end(); };
  };
})();
