// "fly": two orientations, and the motion between them. The orientations are asked, and a motion is
// answered.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const S = globalThis.course.scene;
  const { FIGURES, credit } = globalThis.course.alive;
  const { COLOURS } = globalThis.course.palette;
  const SIZE = 0.85; // of the aircraft, in its own lengths
  const NOSE = [0.85 * SIZE, 0, 0]; // as scene/bodies.js makes it
  const WING = [0, 0.85 * SIZE, 0];
  const PLACES = [
    [-1.7, 0, 0],
    [1.7, 0, 0],
  ];
  const ROOM = [
    [-2.4, 0, 0.7],
    [2.4, 0, 0.7],
  ];
  const SAMPLES = 40; // of a motion
  const AGREES = 1e-3; // radians

  const angleBetween = (R, Q) => M.norm(M.rotationVector(M.times(M.transpose(R), Q)));
  const placeAt = (share) => M.add(M.scale(PLACES[0], 1 - share), PLACES[1], share);

  /**
   * R rotated so that `tip` points to a point: a nose by the shortest rotation, a wing tip about
   * the nose.
   */
  function dragged(R, tip, point) {
    const nose = M.apply(R, [1, 0, 0]);
    const from = M.apply(R, M.unit(tip));
    const to = M.unit(point);
    if (tip === WING) return M.times(M.rotation(nose, M.angleAbout(nose, from, to)), R);
    const axis = M.cross(from, to);
    const sine = M.norm(axis);
    if (sine < 1e-9) return R;
    return M.times(M.rotation(M.unit(axis), Math.atan2(sine, M.dot(from, to))), R);
  }

  FIGURES.fly = (card, meta, ask) => {
    const state = card.state({ ends: meta.ends, s: 0.5 });
    const view = card.space({
      radius: 1.5,
      elevation: 0.3,
      azimuth: -1.2,
      proportion: 0.55,
      label: meta.title,
    });
    function addHandle(end, name, colour, part, tip) {
      view.handle({
        name: `${name}, ${part}`,
        colour,
        small: tip === WING,
        at: () => M.add(PLACES[end], M.apply(state.ends[end], tip)),
        describe: () => `points to (${P.list(M.apply(state.ends[end], M.unit(tip)))})`,
        moved: (p) => {
          state.ends[end] = dragged(state.ends[end], tip, M.subtract(p, PLACES[end]));
          ask({ ends: state.ends });
        },
      });
    }
    [
      ["Start", COLOURS.blue],
      ["Goal", COLOURS.orange],
    ].forEach(([name, colour], end) => {
      addHandle(end, name, colour, "nose", NOSE);
      addHandle(end, name, colour, "wing", WING);
    });
    card.player("Fly", card.share("Along the motion", state, "s"), 0.008);
    const numbers = card.numbers();
    const words = card.words();
    ask({ ends: state.ends });

    function libraryMotion(share) {
      const [from, to] = state.ends.map((R) => M.pose(R, [0, 0, 0]));
      return M.rotationOf(M.interpolate(from, to, share));
    }
    function drawAircraft(R, share, look) {
      const sized = R.map((row) => M.scale(row, SIZE));
      view.mesh(S.aircraft, [M.pose(sized, placeAt(share))], S.PALETTE, look);
    }
    /** The paths of nose and wing tip. */
    function drawTrails(motion, colour, look) {
      for (const tip of [NOSE, WING]) {
        const path = M.sampled(SAMPLES, (share) =>
          M.add(placeAt(share), M.apply(motion(share), tip)),
        );
        view.line(path, colour, 2, look);
      }
    }

    return () => {
      const answered = state.answer?.value;
      const motion = answered
        ? (share) => answered[Math.round(share * (answered.length - 1))]
        : libraryMotion;
      const [start, goal] = state.ends;
      view.begin();
      view.contain(ROOM);
      drawAircraft(start, 0, { opacity: 0.4 });
      drawAircraft(goal, 1, { opacity: 0.4 });
      drawAircraft(motion(state.s), state.s);
      if (answered) drawTrails(libraryMotion, COLOURS.blue, { dash: [5, 5] });
      drawTrails(motion, COLOURS.crimson);
      view.end();

      const orientations = M.sampled(SAMPLES, motion);
      const steps = orientations.slice(1).map((R, k) => angleBetween(orientations[k], R));
      const whole = steps.reduce((sum, angle) => sum + angle, 0);
      const shortest = P.degrees(angleBetween(start, goal), 1);
      numbers(
        ["R now =", P.matrix(motion(state.s))],
        `the shortest rotation: ${shortest}\n` +
          `this motion rotates by ${P.degrees(whole, 1)} in all`,
      );
      const differences = M.sampled(SAMPLES, (share) =>
        angleBetween(motion(share), libraryMotion(share)),
      );
      const largest = answered ? Math.max(...differences) : 0;
      const ofAnswer =
        largest < AGREES
          ? "It agrees with the library."
          : `The library's motion, dashed, differs by up to ${P.degrees(largest, 1)}.`;
      const ofLibrary = "Drag a nose or a wing tip; the library flies the shortest rotation.";
      words.textContent = credit(state, ofAnswer, ofLibrary);
    };
  };
})();
