// Two planar poses to drag: the straight motion and the screw motion between them, and the pole of the screw.
(() => {
  "use strict";
  const K = globalThis.course.kinematics, P = globalThis.course.parts, { COLOURS } = P;
  const OUTLINE = [[-0.5, -0.3], [0.5, -0.3], [0.75, 0], [0.5, 0.3], [-0.5, 0.3]];
  const place = ([x, y, theta], p) => [x + Math.cos(theta) * p[0] - Math.sin(theta) * p[1], y + Math.sin(theta) * p[0] + Math.cos(theta) * p[1]];

  globalThis.course.kinds["toy:two_poses"] = (host, meta) => {
    const state = meta.state || (meta.state = { start: [...meta.start], goal: [...meta.goal], s: 0.5 });
    const half = meta.half, card = P.card(host, "Two poses and two motions between them");
    const plane = P.plane(card.views, { half, step: half > 6 ? 2 : 1, label: "Two poses, the motions between them and the pole", height: 0.8 });
    const spokes = ["start", "goal"].map(() => plane.line(COLOURS.purple, 0.6, { "stroke-dasharray": half * 0.03 }));
    const paths = [plane.line(COLOURS.grey, 1.2, { "stroke-dasharray": half * 0.04 }), plane.line(COLOURS.crimson, 1.6)];
    const ghosts = [0, 1].map((k) => Array.from({ length: 4 }, () => plane.line(k ? COLOURS.crimson : COLOURS.grey, 0.4)));
    const bodies = [plane.line(COLOURS.blue, 1.4, { fill: COLOURS.blue, "fill-opacity": 0.15 }), plane.line(COLOURS.green, 1.4, { fill: COLOURS.green, "fill-opacity": 0.15 })];
    const moving = [plane.line(COLOURS.grey, 1.4, { fill: COLOURS.grey, "fill-opacity": 0.2 }), plane.line(COLOURS.crimson, 1.4, { fill: COLOURS.crimson, "fill-opacity": 0.25 })];
    const pole = plane.dot(COLOURS.purple, 1.5), poleName = plane.text(COLOURS.purple);
    const handles = ["start", "goal"].flatMap((name, i) => {
      const colour = i ? COLOURS.green : COLOURS.blue, title = i ? "Goal" : "Start";
      const turn = (d) => () => { state[name][2] += d; draw(); };
      return [
        plane.handle({
          name: `${title}, position`, colour, moved: ([x, y]) => { state[name] = [x, y, state[name][2]]; draw(); }, describe: () => say(state[name]),
          keys: { "[": turn(Math.PI / 36), "]": turn(-Math.PI / 36) },
        }),
        plane.handle({
          name: `${title}, direction`, colour, radius: 1.5,
          moved: ([x, y]) => {
            const [px, py, theta] = state[name], angle = Math.atan2(y - py, x - px), turned = angle - theta;
            state[name] = [px, py, theta + Math.atan2(Math.sin(turned), Math.cos(turned))];
            draw();
          },
          describe: () => P.degrees(state[name][2]),
        }),
      ];
    });
    const share = card.range("Along the motion", { min: 0, max: 1, step: 0.01, value: state.s }, (x) => `${Math.round(100 * x)} %`, (x) => { state.s = x; draw(); });
    let halt = null;
    card.button("Play", () => {
      if (halt) halt();
      state.s = 0;
      halt = card.run(() => { state.s = Math.min(1, state.s + 0.008); share.set(state.s); return state.s < 1; }, draw);
    });
    const words = card.words();
    const say = ([x, y, theta]) => `${P.number(x)}, ${P.number(y)} m, ${P.degrees(theta)}`;

    function draw() {
      const { start, goal, s } = state, twist = K.logPlanar(start, goal), c = K.pole(start, twist);
      const turn = twist[0];
      const straight = (t) => [start[0] + t * (goal[0] - start[0]), start[1] + t * (goal[1] - start[1]), start[2] + t * turn];
      const screw = (t) => K.expPlanar(start, K.scale(twist, t));
      const ts = Array.from({ length: 61 }, (_, i) => i / 60);
      [straight, screw].forEach((motion, k) => {
        paths[k].set(ts.map(motion));
        ghosts[k].forEach((ghost, i) => ghost.set(OUTLINE.map((p) => place(motion((i + 1) / 5), p)), true));
        moving[k].set(OUTLINE.map((p) => place(motion(s), p)), true);
      });
      [start, goal].forEach((pose, i) => {
        bodies[i].set(OUTLINE.map((p) => place(pose, p)), true);
        handles[2 * i].set(pose.slice(0, 2));
        handles[2 * i + 1].set(place(pose, [1.15, 0]));
        spokes[i].set(c ? [c, pose] : []);
      });
      const seen = c && Math.abs(c[0]) < half && Math.abs(c[1]) < 0.8 * half;
      pole.set(c);
      poleName.set(c && [c[0], c[1] + half * 0.05], seen ? "pole" : "");
      words.textContent = c
        ? `The screw motion is a rotation by ${P.degrees(turn)} about the pole at (${P.number(c[0])}, ${P.number(c[1])}) m${seen ? "" : ", outside the picture"}. The straight motion has no fixed pole.`
        : "Both poses have the same orientation: the screw motion is a translation, along the same straight line; its pole is infinitely far away.";
    }
    draw();
    return () => { if (halt) halt(); card.end(); };
  };
})();
