// Two circles on a sphere, of p1 about k1 and of p2 about k2: they meet twice, once or not at all.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const S = globalThis.course.scene;
  const { COLOURS } = globalThis.course.palette;
  const GLOBE = S.ball(64);
  const LIFT = 1.004; // radii at which the circles run, so that the globe does not hide them
  const Y = [0, 1, 0];
  const K1 = [0, 0, 1];
  const MISS_COMMENTS = {
    apart: "The circles miss: the axes are farther apart than the two circles reach together.",
    inside: "The circles miss: one lies inside the other.",
    around: "The circles miss: together they reach around the far side of the sphere.",
  };
  const RANGES = [
    ["between", "Between the axes k₁, k₂", 1, 179],
    ["p1", "From k₁ to p₁", 0, 180],
    ["p2", "From k₂ to p₂", 0, 180],
    ["around1", "p₁ around k₁", -180, 180],
    ["around2", "p₂ around k₂", -180, 180],
  ];

  /**
   * The unit vector at an angle (degrees) from the axis k, rotated about it by another one; both at
   * 0 it is k.
   */
  function pointAt(k, away, around) {
    const p = M.apply(M.rotation(Y, away * P.rad), k);
    return M.apply(M.rotation(k, around * P.rad), p);
  }
  /** The two angles, in radians, of a unit vector. */
  function anglesOf(k, p) {
    const zero = M.apply(M.rotation(Y, Math.PI / 2), k); // where `around` is 0
    const away = Math.acos(P.clamp(M.dot(k, p), -1, 1));
    return [away, M.angleAbout(k, zero, p)];
  }

  P.toy("circles", "Two circles on a sphere", (card, meta) => {
    const state = card.state({ ...meta.angles });
    const view = card.space({
      radius: 1.4,
      elevation: 0.45,
      label: "A sphere with the circle of p₁ about k₁ and of p₂ about k₂",
      proportion: 0.8,
    });
    function axes() {
      const between = state.between * P.rad;
      return [K1, [Math.sin(between), 0, Math.cos(between)]];
    }
    const points = () =>
      axes().map((k, i) => pointAt(k, state[`p${i + 1}`], state[`around${i + 1}`]));

    const ranges = {};
    for (const [key, label, min, max] of RANGES) {
      ranges[key] = card.angle(label, state, key, min, max);
    }
    function change(key, angle) {
      state[key] = Math.round(angle / P.rad);
      ranges[key].set(state[key]);
    }
    [COLOURS.blue, COLOURS.green].forEach((colour, i) => {
      const [away, around] = [`p${i + 1}`, `around${i + 1}`];
      const axis = P.sub("k", i + 1);
      view.handle({
        name: `Point ${P.sub("p", i + 1)}`,
        colour,
        at: () => points()[i],
        describe: () => `${state[away]}° from ${axis}, ${P.inDegrees(state[around])} around it`,
        moved: (p) => {
          const angles = anglesOf(axes()[i], M.unit(p));
          change(away, angles[0]);
          change(around, angles[1]);
        },
      });
    });
    const numbers = card.numbers();
    const words = card.words([freeComment(1, 2)]);
    const goal = card.goal(state, "let one circle touch the other one from inside.");

    function drawCircle(k, p, colour, index) {
      view.line([M.scale(k, -1.25), M.scale(k, 1.1)], COLOURS.purple, 2, { dash: [6, 4] });
      view.arrow(M.scale(k, 1.1), M.scale(k, 1.3), COLOURS.purple);
      view.text(M.scale(k, 1.4), P.sub("k", index), COLOURS.purple);
      const circle = M.sampled(96, (share) => {
        const moved = M.apply(M.rotation(k, 2 * Math.PI * share), p);
        return M.scale(moved, LIFT);
      });
      view.line(circle, colour, 4);
      view.ball(p, 0.045, colour);
      view.text(p, P.sub("p", index), colour, 20);
    }

    return () => {
      const [k1, k2] = axes();
      const [p1, p2] = points();
      const meetings = M.meetings(k1, k2, p1, p2);
      view.begin();
      view.mesh(GLOBE, [M.eye(4)], [COLOURS.globe], { opacity: 0.6 });
      drawCircle(k1, p1, COLOURS.blue, 1);
      drawCircle(k2, p2, COLOURS.green, 2);
      meetings.forEach((meeting, i) => {
        view.ball(meeting, 0.055, COLOURS.crimson);
        view.text(meeting, String(i + 1), COLOURS.crimson, 20);
      });
      view.end();

      // A point on its axis stays where it is, whatever its angle is.
      const theta = (k, p, meeting) =>
        isOnAxis(k, p) ? "any angle" : P.degrees(M.angleAbout(k, p, meeting), 1);
      const lines = meetings.map((meeting, i) => {
        const [first, second] = [theta(k1, p1, meeting), theta(k2, p2, meeting)];
        return `${i + 1}: θ₁ = ${first}, θ₂ = ${second}`;
      });
      if (!lines.length) lines.push("no pair of angles brings p₁ and p₂ together");
      numbers(...lines);
      words.textContent = comment(meetings.length, state);
      goal(meetings.length === 1 && touchFromInside(state));
    };
  });

  /** Whether the smaller circle lies inside the larger one, of those that touch. */
  function touchFromInside({ between, p1, p2 }) {
    const [smaller, larger] = [Math.min(p1, p2), Math.max(p1, p2)];
    return smaller > 0 && larger < 180 && between + smaller === larger;
  }

  const isOnAxis = (k, p) => M.norm(M.cross(k, p)) < 1e-9;

  /** Of one meeting; the axes differ, so not more than one of the points lies on its own. */
  function meetingComment(p1, p2) {
    const isPole = (away) => away === 0 || away === 180;
    if (isPole(p1)) return freeComment(1, 2);
    if (isPole(p2)) return freeComment(2, 1);
    return "The circles touch: one solution.";
  }
  function freeComment(fixed, other) {
    const [p, k, theta] = ["p", "k", "θ"].map((letter) => P.sub(letter, fixed));
    return (
      `${p} lies on its axis ${k}, so its circle is a point, and the circle of ` +
      `${P.sub("p", other)} runs through it: infinitely many solutions, because ${theta} is free.`
    );
  }

  function comment(meetings, { between, p1, p2 }) {
    if (meetings === 2) return "The circles meet twice: two solutions.";
    if (meetings === 1) return meetingComment(p1, p2);
    if (between > p1 + p2) return MISS_COMMENTS.apart;
    const isInside = between + Math.min(p1, p2) < Math.max(p1, p2);
    return isInside ? MISS_COMMENTS.inside : MISS_COMMENTS.around;
  }
})();
