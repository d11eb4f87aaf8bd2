// Queries in the plane with the errors of their answers, and the arm at the answers to one of them,
// which is clicked or chosen by its rank.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { COLOURS, tint } = globalThis.course.palette;
  const HEIGHT = 0.75; // of the picture, in widths
  const LEVELS = [
    { below: 0.1, colour: COLOURS.blue, words: "below 1 mm" },
    { below: 0.3, colour: COLOURS.green, words: "below 3 mm" },
    { below: 1, colour: COLOURS.amber, words: "below 1 cm" },
    { below: 10, colour: COLOURS.red, words: "below 10 cm" },
    { below: Infinity, colour: COLOURS.crimson, words: "10 cm and more" },
  ];
  const LEAST_RADIUS = 1.8; // pixels, of a dot without an error
  const MORE = 6; // pixels, by which the dot with the largest error is larger
  const SWATCH =
    "display:inline-block;width:.8em;height:.8em;border-radius:50%;margin-right:.35em;";

  P.toy("errors", "Queries, their errors and the arm at an answer", (card, meta) => {
    const { lengths, queries, angles, errors, cells, names } = meta;
    const largest = Math.max(...errors.flat().filter((error) => error !== null));
    const state = card.state({ rank: 1, worse: false });
    const shown = () => (state.worse ? 1 : 0);
    // The queries, those with the largest errors first, for the better and for the worse answer.
    const orders = errors.map((column) => {
      const answered = queries.map((_, i) => i).filter((i) => column[i] !== null);
      return answered.sort((i, j) => column[j] - column[i] || i - j);
    });
    const chosen = () => {
      const order = orders[shown()];
      return order[Math.min(state.rank, order.length) - 1];
    };
    const plane = card.map({
      half: meta.half,
      centre: meta.centre,
      proportion: HEIGHT,
      label: "Queries, coloured by the error of their answers, and the arm at the chosen query",
    });
    const limits = { min: 1, max: queries.length, step: 1 };
    const rank = card.setting("Query, by the size of its error", state, "rank", limits, String);
    P.onClick(plane, (p) => {
      const order = orders[shown()];
      const distances = order.map((i) => M.norm(M.subtract(queries[i], p)));
      state.rank = distances.indexOf(Math.min(...distances)) + 1;
      rank.set(state.rank);
      card.draw();
    });
    card.checkbox(names[1], state, "worse");
    addLegend(card.controls);
    const words = card.words([comment(queries[0], cells[0], [10.1, 10.1], names)]);

    const levelOf = (error) => LEVELS.find(({ below }) => error < below);
    function drawArm(q, isSecond) {
      const points = M.planarPoints(lengths, q);
      if (isSecond) {
        plane.line(points, COLOURS.grey, 3, { dash: [6, 5] });
        plane.dot(points[2], COLOURS.grey, 4);
        return;
      }
      plane.line(points.slice(0, 2), COLOURS.dark, 7);
      plane.line(points.slice(1), COLOURS.link, 6);
      for (const joint of points.slice(0, 2)) plane.dot(joint, COLOURS.dark, 4);
      plane.dot(points[2], COLOURS.black, 5);
    }

    return () => {
      const column = errors[shown()];
      const i = chosen();
      plane.begin();
      // The large errors are drawn last, above the others.
      for (const k of [...orders[shown()]].reverse()) {
        const radius = LEAST_RADIUS + MORE * Math.sqrt(column[k] / largest);
        plane.dot(queries[k], levelOf(column[k]).colour, radius);
      }
      const both = [1 - shown(), shown()];
      for (const which of both) {
        if (angles[which][i]) drawArm(angles[which][i], which !== shown());
      }
      const tip = M.planarPoints(lengths, angles[shown()][i])[2];
      plane.line([tip, queries[i]], COLOURS.black, 2);
      plane.dot(queries[i], COLOURS.black, 7, { hollow: true });
      plane.dot(queries[i], levelOf(column[i]).colour, 4);
      plane.end();
      const bothErrors = errors.map((list) => list[i]);
      words.textContent = comment(queries[i], cells[i], bothErrors, names);
    };
  });

  function addLegend(parent) {
    const look = { style: "display:flex;flex-wrap:wrap;gap:.2rem 1rem" };
    const legend = P.element("p", look, parent, "Error:");
    for (const { colour, words } of LEVELS) {
      const item = P.element("span", {}, legend);
      P.element("span", { style: `${SWATCH}background:${tint(colour)}` }, item);
      item.append(words);
    }
  }

  function comment(query, cell, errors, names) {
    const parts = errors.map((error, i) =>
      error === null ? `there is no ${names[i]}` : `${names[i]} misses it by ${P.number(error)} cm`,
    );
    return `Query at (${P.list(query)}) m, in cell ${cell}: ${parts.join(", ")}.`;
  }
})();
