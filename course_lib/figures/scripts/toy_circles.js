// Two circles on a sphere, of p1 about k1 and of p2 about k2: they meet twice, once or not at all.
(() => {
  "use strict";
  const K = globalThis.course.kinematics, P = globalThis.course.parts, S = globalThis.course.shapes, { COLOURS } = P;
  const rad = Math.PI / 180, GLOBE = S.ball(K.eye(4), 0.985, 0, 0, 32);

  globalThis.course.kinds["toy:circles"] = (host, meta) => {
    const state = meta.state || (meta.state = { ...meta.angles });
    const card = P.card(host, "Two circles on a sphere");
    const view = P.space(card.views, { radius: 1.5, azimuth: -0.9, elevation: 0.45, label: "A sphere with the circle of p1 about k1 and of p2 about k2", meta: state, redraw: () => draw() });
    const range = (label, key, min, max) => card.range(label, { min, max, step: 1, value: state[key] }, (x) => `${x}°`, (x) => { state[key] = x; draw(); });
    range("Between the axes k1, k2", "between", 1, 179);
    range("From k1 to p1", "p1", 0, 180);
    range("From k2 to p2", "p2", 0, 180);
    range("p1 around k1", "around1", -180, 180);
    range("p2 around k2", "around2", -180, 180);
    const numbers = card.numbers(), words = card.words();
    function draw() {
      const k1 = [0, 0, 1], k2 = [Math.sin(state.between * rad), 0, Math.cos(state.between * rad)], y = [0, 1, 0];
      const from = (k, angle, around) => K.apply(K.rotation(k, around * rad), K.apply(K.rotation(y, angle * rad), k));
      const p1 = from(k1, state.p1, state.around1), p2 = from(k2, state.p2, state.around2), meet = K.meetings(k1, k2, p1, p2);
      const circle = (k, v) => Array.from({ length: 73 }, (_, i) => K.apply(K.rotation(k, (i * Math.PI) / 36), v));
      view.begin();
      view.mesh(GLOBE, [K.eye(4)], ["#e4e7ea"], 0.55);
      [[k1, p1, COLOURS.blue, "k1", "p1"], [k2, p2, COLOURS.green, "k2", "p2"]].forEach(([k, v, colour, axis, point]) => {
        view.line([K.scale(k, -1.3), K.scale(k, 1.3)], COLOURS.purple, 2, { dash: [6, 4] });
        view.text(K.scale(k, 1.4), axis, COLOURS.purple);
        view.line(circle(k, v), colour, 3);
        view.mesh(S.ball(K.pose(K.eye(3), v), 0.045, 0), [K.eye(4)], [colour]);
        view.text(K.scale(v, 1.18), point, colour);
      });
      meet.forEach((m, i) => {
        view.mesh(S.ball(K.pose(K.eye(3), m), 0.055, 0), [K.eye(4)], [COLOURS.crimson]);
        view.text(K.scale(m, 1.2), String(i + 1), COLOURS.crimson);
      });
      view.end();
      numbers.textContent = meet.length
        ? meet.map((m, i) => `${i + 1}:  theta1 = ${P.degrees(K.angleAbout(k1, p1, m), 1)},  theta2 = ${P.degrees(K.angleAbout(k2, p2, m), 1)}`).join("\n")
        : "no pair of angles brings p1 and p2 together";
      const { between, p1: a, p2: b } = state;
      words.textContent = meet.length === 2 ? "The circles meet twice: two solutions."
        : meet.length === 1 ? "The circles touch: one solution."
          : between > a + b ? "The circles miss: the axes are farther apart than the two circles reach together."
            : between + Math.min(a, b) < Math.max(a, b) ? "The circles miss: one lies inside the other." : "The circles miss: together they reach around the far side of the sphere.";
    }
    draw();
    return () => { view.stop(); card.end(); };
  };
})();
