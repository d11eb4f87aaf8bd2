// Two planar poses to drag: the straight motion and the screw motion between them, and the pole of the screw.
(() => {
  "use strict";
  const M = globalThis.course.motion,
    P = globalThis.course.parts,
    { COLOURS } = P;
  const OUTLINE = [
    [-0.5, -0.3],
    [0.5, -0.3],
    [0.75, 0],
    [0.5, 0.3],
    [-0.5, 0.3],
  ];
  const place = (pose, p) => M.move(M.planar(pose), [...p, 0]).slice(0, 2);

  P.toy("two_poses", "Two poses and two motions between them", (card, meta) => {
    const state = card.state({ start: [...meta.start], goal: [...meta.goal], s: 0.5 }),
      { half } = meta;
    const label = "Two poses, the motions between them and the pole";
    const plane = card.map({ half, step: half > 6 ? 2 : 1, label, proportion: 0.8 });
    [
      ["start", "Start", COLOURS.blue],
      ["goal", "Goal", COLOURS.orange],
    ].forEach(([name, title, colour]) => {
      const position = () => state[name].slice(0, 2);
      plane.handle({
        name: `${title}, position`,
        colour,
        at: position,
        moved: ([x, y]) => (state[name] = [x, y, state[name][2]]),
        describe: () => `${P.metres(position())}, ${P.degrees(state[name][2])}`,
      });
      plane.handle({
        name: `${title}, direction`,
        colour,
        small: true,
        at: () => place(state[name], [1.15, 0]),
        describe: () => P.degrees(state[name][2]),
        moved: ([x, y]) => {
          const [px, py, theta] = state[name];
          state[name][2] = theta + M.wrap(Math.atan2(y - py, x - px) - theta);
        },
      });
    });
    card.player("Play", card.share("Along the motion", state, "s"), 0.008);
    const words = card.words();

    return () => {
      const { start, goal, s } = state,
        twist = M.logPlanar(start, goal),
        pole = M.pole(start, twist);
      const straight = (t) => [
        ...M.add(start.slice(0, 2), M.add(goal, start, -1), t),
        start[2] + t * twist[0],
      ];
      const screw = (t) => M.expPlanar(start, M.scale(twist, t));
      const outline = (pose, colour, width, fill) =>
        plane.line(
          OUTLINE.map((p) => place(pose, p)),
          colour,
          width,
          { closed: true, fill },
        );
      plane.begin();
      if (pole)
        [start, goal].forEach((pose) =>
          plane.line([pole, pose], COLOURS.black, 1, { dash: [2, 4] }),
        );
      [
        [straight, COLOURS.grey, [8, 5]],
        [screw, COLOURS.crimson, []],
      ].forEach(([motion, colour, dash]) => {
        plane.line(M.sampled(60, motion), colour, 2, { dash });
        [1, 2, 3, 4].forEach((i) => outline(motion(i / 5), colour, 1));
        outline(motion(s), colour, 2, 0.22);
      });
      outline(start, COLOURS.blue, 2, 0.15);
      outline(goal, COLOURS.orange, 2, 0.15);
      const seen = pole && Math.abs(pole[0]) < half && Math.abs(pole[1]) < 0.8 * half;
      if (seen) {
        plane.dot(pole, COLOURS.black, 5);
        plane.text(M.add(pole, [0, 0.06 * half]), "pole", COLOURS.black);
      }
      plane.end();
      words.textContent = pole
        ? `The screw motion is a rotation by ${P.degrees(twist[0])} about the pole at (${P.list(pole)}) m` +
          `${seen ? "" : ", outside the picture"}. The straight motion has no fixed pole.`
        : "Both poses have the same orientation: the screw motion is a translation, along the same straight line; " +
          "its pole is infinitely far away.";
    };
  });
})();
