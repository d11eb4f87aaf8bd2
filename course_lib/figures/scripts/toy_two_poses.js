// Two planar poses to drag: the straight motion and the screw motion between them, and the pole of
// the screw.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { COLOURS } = globalThis.course.palette;
  const HEIGHT = 0.8; // of the picture, in widths
  // The body, seen from its own frame, and where the handle of its direction is.
  const OUTLINE = [
    [-0.5, -0.3],
    [0.5, -0.3],
    [0.75, 0],
    [0.5, 0.3],
    [-0.5, 0.3],
  ];
  const DIRECTION = [1.15, 0];
  const GHOSTS = [0.2, 0.4, 0.6, 0.8]; // shares of the motions at which the body is drawn, too

  const pointOf = (pose, p) => M.move(M.planar(pose), [...p, 0]).slice(0, 2);

  P.toy("two_poses", "Two poses and two motions between them", (card, meta) => {
    const { half } = meta;
    const state = card.state({ start: [...meta.start], goal: [...meta.goal], s: 0.5 });
    const plane = card.map({
      half,
      step: half > 6 ? 2 : 1,
      label: "Two poses, the motions between them and the pole",
      proportion: HEIGHT,
    });
    for (const [key, title, colour] of [
      ["start", "Start", COLOURS.blue],
      ["goal", "Goal", COLOURS.orange],
    ]) {
      plane.poseHandles({
        title,
        colour,
        pose: () => state[key],
        ahead: () => pointOf(state[key], DIRECTION),
        moved: (pose) => {
          state[key] = pose;
        },
      });
    }
    card.player("Play", card.share("Along the motion", state, "s"), 0.008);
    const words = card.words();

    function drawBody(pose, colour, width, fill) {
      const outline = OUTLINE.map((p) => pointOf(pose, p));
      plane.line(outline, colour, width, { closed: true, fill });
    }
    function drawMotion(motion, colour, dash) {
      plane.line(M.sampled(60, motion), colour, 2, { dash });
      for (const share of GHOSTS) drawBody(motion(share), colour, 1);
      drawBody(motion(state.s), colour, 2, 0.22);
    }
    function drawPole(pole) {
      plane.dot(pole, COLOURS.black, 5);
      plane.text(M.add(pole, [0, 0.06 * half]), "pole", COLOURS.black);
    }
    const isInPicture = ([x, y]) => Math.abs(x) < half && Math.abs(y) < HEIGHT * half;

    return () => {
      const { start, goal } = state;
      const twist = M.logPlanar(start, goal);
      const pole = M.pole(start, twist);
      const screw = (share) => M.expPlanar(start, M.scale(twist, share));
      const way = M.subtract(goal.slice(0, 2), start.slice(0, 2));
      const straight = (share) => [
        ...M.add(start.slice(0, 2), way, share),
        start[2] + share * twist[0],
      ];
      plane.begin();
      if (pole) {
        plane.line([pole, start], COLOURS.black, 1, { dash: [2, 4] });
        plane.line([pole, goal], COLOURS.black, 1, { dash: [2, 4] });
      }
      drawMotion(straight, COLOURS.grey, [8, 5]);
      drawMotion(screw, COLOURS.crimson, []);
      drawBody(start, COLOURS.blue, 2, 0.15);
      drawBody(goal, COLOURS.orange, 2, 0.15);
      const isPoleSeen = pole && isInPicture(pole);
      if (isPoleSeen) drawPole(pole);
      plane.end();
      words.textContent = pole
        ? rotationComment(twist[0], pole, isPoleSeen)
        : "Both poses have the same orientation: the screw motion is a translation, " +
          "along the same straight line; its pole is infinitely far away.";
    };
  });

  function rotationComment(angle, pole, isSeen) {
    const outside = isSeen ? "" : ", outside the picture";
    return (
      `The screw motion is a rotation by ${P.degrees(angle)} about the pole ` +
      `at (${P.list(pole)}) m${outside}. ` +
      "The straight motion has no fixed pole."
    );
  }
})();
