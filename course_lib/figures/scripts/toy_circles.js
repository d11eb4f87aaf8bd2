// Two circles on a sphere, of p1 about k1 and of p2 about k2: they meet twice, once or not at all.
(() => {
  "use strict";
  const M = globalThis.course.motion,
    P = globalThis.course.parts,
    S = globalThis.course.scene,
    { COLOURS, rad } = P;
  const GLOBE = S.ball(64),
    Y = [0, 1, 0],
    K1 = [0, 0, 1];

  P.toy("circles", "Two circles on a sphere", (card, meta) => {
    const state = card.state({ ...meta.angles });
    const view = card.space({
      radius: 1.4,
      elevation: 0.45,
      label: "A sphere with the circle of p₁ about k₁ and of p₂ about k₂",
      proportion: 0.8,
    });
    const axes = () => [K1, [Math.sin(state.between * rad), 0, Math.cos(state.between * rad)]];
    // The point at an angle from an axis and rotated about it, and the angles of a point that was dragged.
    const point = (k, away, around) =>
      M.apply(M.rotation(k, around * rad), M.apply(M.rotation(Y, away * rad), k));
    const points = () =>
      axes().map((k, i) => point(k, state[`p${i + 1}`], state[`around${i + 1}`]));
    const ranges = Object.fromEntries(
      [
        ["between", "Between the axes k₁, k₂", 1, 179],
        ["p1", "From k₁ to p₁", 0, 180],
        ["p2", "From k₂ to p₂", 0, 180],
        ["around1", "p₁ around k₁", -180, 180],
        ["around2", "p₂ around k₂", -180, 180],
      ].map(([key, label, min, max]) => [key, card.angle(label, state, key, min, max)]),
    );
    const change = (key, angle) => ranges[key].set((state[key] = Math.round(angle / rad)));
    [COLOURS.blue, COLOURS.green].forEach((colour, i) =>
      view.handle({
        name: `Point ${P.sub("p", i + 1)}`,
        colour,
        at: () => points()[i],
        describe: () =>
          `${state[`p${i + 1}`]}° from ${P.sub("k", i + 1)}, ${P.inDegrees(state[`around${i + 1}`])} around it`,
        moved: (p) => {
          const k = axes()[i],
            v = M.unit(p);
          change(`p${i + 1}`, Math.acos(Math.min(1, Math.max(-1, M.dot(k, v)))));
          change(`around${i + 1}`, M.angleAbout(k, M.apply(M.rotation(Y, Math.PI / 2), k), v));
        },
      }),
    );
    const numbers = card.numbers(),
      words = card.words();
    return () => {
      const [k1, k2] = axes(),
        [p1, p2] = points(),
        meet = M.meetings(k1, k2, p1, p2);
      view.begin();
      view.mesh(GLOBE, [M.eye(4)], ["#e4e7ea"], { opacity: 0.6 });
      [
        [k1, p1, COLOURS.blue, "1"],
        [k2, p2, COLOURS.green, "2"],
      ].forEach(([k, v, colour, i]) => {
        view.line([M.scale(k, -1.25), M.scale(k, 1.1)], COLOURS.purple, 2, { dash: [6, 4] });
        view.arrow(M.scale(k, 1.1), M.scale(k, 1.3), COLOURS.purple);
        view.text(M.scale(k, 1.4), P.sub("k", i), COLOURS.purple);
        view.line(
          M.sampled(96, (s) => M.scale(M.apply(M.rotation(k, 2 * Math.PI * s), v), 1.004)),
          colour,
          4,
        );
        view.ball(v, 0.045, colour);
        view.text(v, P.sub("p", i), colour, 20);
      });
      meet.forEach((m, i) => {
        view.ball(m, 0.055, COLOURS.crimson);
        view.text(m, String(i + 1), COLOURS.crimson, 20);
      });
      view.end();
      const theta = (m, k, p) => P.degrees(M.angleAbout(k, p, m), 1);
      numbers(
        ...(meet.length
          ? meet.map((m, i) => `${i + 1}: θ₁ = ${theta(m, k1, p1)}, θ₂ = ${theta(m, k2, p2)}`)
          : ["no pair of angles brings p₁ and p₂ together"]),
      );
      const { between, p1: a, p2: b } = state;
      words.textContent =
        meet.length === 2
          ? "The circles meet twice: two solutions."
          : meet.length === 1
            ? "The circles touch: one solution."
            : between > a + b
              ? "The circles miss: the axes are farther apart than the two circles reach together."
              : between + Math.min(a, b) < Math.max(a, b)
                ? "The circles miss: one lies inside the other."
                : "The circles miss: together they reach around the far side of the sphere.";
    };
  });
})();
