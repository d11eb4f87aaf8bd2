// Toys of orientation, one of which meta.mode names: axis and angle with R and q; three gimbal rings; two
// rotations in either order; an angular velocity in the room and in the body; a belt.
(() => {
  "use strict";
  const M = globalThis.course.motion,
    P = globalThis.course.parts,
    S = globalThis.course.scene,
    { COLOURS, rad } = P;
  const I = M.eye(4),
    NONE = [0, 0, 0],
    X = [1, 0, 0],
    Y = [0, 1, 0],
    Z = [0, 0, 1];
  const PALETTE = S.PALETTE,
    AIRCRAFT = S.aircraft;
  const at = (R, p = NONE) => M.pose(R, p),
    about = M.rotation;

  const sized = (k, R) => at(R.map((row) => M.scale(row, k)));
  function fixedAxes(view, length) {
    [X, Y, Z].forEach((e, k) => {
      view.line([NONE, M.scale(e, length)], COLOURS.grey, 1.5);
      view.text(M.scale(e, 1.07 * length), "xyz"[k], COLOURS.grey);
    });
  }
  const report = (R, q) => [["R =", P.matrix(R)], `q = (${P.list(q, 3)}) as (w, x, y, z)`];
  const pair = (card, labels) =>
    labels.map((label) => {
      // two views side by side
      const parent = P.element("div", { class: "half" }, card.views);
      P.element("p", { style: "margin:0 0 .3rem;font-weight:600" }, parent).innerHTML = label;
      return card.space({
        parent,
        radius: 1.25,
        label: label.replace(/<.*?>/g, ""),
        proportion: 0.85,
      });
    });

  // ---- axis and angle ----

  function axisAngle(card) {
    const state = card.state({ azimuth: 30, height: 40, angle: 60 });
    const view = card.space({ radius: 1.3, label: "An aircraft rotated about an axis" });
    const azimuth = card.angle("Axis: azimuth", state, "azimuth", -180, 180);
    const height = card.angle("Axis: elevation", state, "height", -90, 90);
    const angle = card.angle("Angle", state, "angle", -360, 360);
    const direction = () => {
      const [a, h] = [state.azimuth * rad, state.height * rad];
      return [Math.cos(h) * Math.cos(a), Math.cos(h) * Math.sin(a), Math.sin(h)];
    };
    view.handle({
      name: "Axis",
      colour: COLOURS.purple,
      at: () => M.scale(direction(), 1.3),
      describe: () =>
        `azimuth ${P.inDegrees(state.azimuth)}, elevation ${P.inDegrees(state.height)}`,
      moved: (p) => {
        const [x, y, z] = M.unit(p);
        azimuth.set((state.azimuth = Math.round(Math.atan2(y, x) / rad)));
        height.set((state.height = Math.round(Math.asin(Math.min(1, Math.max(-1, z))) / rad)));
      },
    });
    card.button("Reverse the axis", () => {
      azimuth.set((state.azimuth += state.azimuth > 0 ? -180 : 180));
      height.set((state.height = -state.height));
    });
    card.button("Reverse the angle", () => angle.set((state.angle = -state.angle)));
    const numbers = card.numbers(),
      words = card.words();
    return () => {
      const rotated = state.angle * rad,
        axis = direction(),
        R = about(axis, rotated),
        grip = () => ({
          name: () => P.inDegrees(state.angle),
          at: NONE,
          axis,
          angle: rotated,
          moved: (x) =>
            angle.set((state.angle = Math.round(Math.min(360, Math.max(-360, x / rad))))),
        });
      view.begin();
      fixedAxes(view, 1.15);
      view.line([M.scale(axis, -1.2), M.scale(axis, 1.05)], COLOURS.purple, 3, { dash: [7, 5] });
      view.arrow(M.scale(axis, 1.05), M.scale(axis, 1.3), COLOURS.purple);
      view.mesh(AIRCRAFT, [sized(0.95, R)], PALETTE, { grip });
      view.frame(at(R), 1.05, { above: false });
      view.line(
        M.sampled(60, (s) => M.apply(about(axis, rotated * s), [0, 0.81, 0])),
        COLOURS.crimson,
        3,
      );
      view.end();
      numbers(...report(R, M.quaternion(axis, rotated)));
      words.textContent =
        Math.abs(state.angle) === 360
          ? "A full rotation: R is the identity again, but q is −1. Both q and −q stand for this orientation."
          : state.angle === 0
            ? "No rotation: the axis does not matter."
            : `R rotates by ${P.inDegrees(state.angle)} about the dashed axis; the red arc is the path of a wing tip.`;
    };
  }

  // ---- gimbals ----

  const pins = (R, r) =>
    S.join(
      [-1, 1].map((s) =>
        S.lathe(
          at(R, M.apply(R, [0, 0, s * r])),
          [
            [0, -0.12],
            [0.035, -0.12],
            [0.035, 0.12],
            [0, 0.12],
          ],
          1,
        ),
      ),
    );
  const RINGS = [
    S.join([S.ring(at(about(Y, Math.PI / 2)), 1.36, 0.05, 3), pins(about(X, -Math.PI / 2), 1.24)]), // carried by yaw
    S.join([S.ring(I, 1.18, 0.05, 5), pins(about(Y, Math.PI / 2), 1.06)]), // carried by pitch
    S.ring(at(about(X, Math.PI / 2)), 1.0, 0.05, 4), // carried by roll
  ];
  const STAND = pins(about(Z, 0), 1.42);

  function gimbals(card) {
    const state = card.state({ yaw: 30, pitch: 20, roll: 10 });
    const view = card.space({
      radius: 1.6,
      label: "Three gimbal rings around an aircraft",
      proportion: 0.8,
    });
    const ranges = {
      yaw: card.angle("Yaw (outer ring, about z)", state, "yaw", -180, 180),
      pitch: card.angle("Pitch (middle ring)", state, "pitch", -90, 90),
      roll: card.angle("Roll (inner ring)", state, "roll", -180, 180),
    };
    const change = (key, x) => {
      state[key] = x;
      ranges[key].set(x);
    };
    [1, -1].forEach((sign) =>
      card.button(`Drive to ${sign > 0 ? "+" : "−"}90°`, () =>
        card.run(() => {
          change("pitch", sign * Math.min(90, sign * state.pitch + 1));
          return sign * state.pitch < 90;
        }),
      ),
    );
    const both = (roll) =>
      card.button(`Yaw +10°, roll ${roll > 0 ? "+" : "−"}10°`, () => {
        [
          ["yaw", 10],
          ["roll", roll],
        ].forEach(([key, d]) => change(key, Math.round(M.wrap((state[key] + d) * rad) / rad)));
      });
    both(10);
    both(-10);
    const numbers = card.numbers(),
      words = card.words();
    return () => {
      const A = about(Z, state.yaw * rad),
        B = M.times(A, about(Y, state.pitch * rad));
      const R = M.times(B, about(X, state.roll * rad)),
        axes = [Z, M.apply(A, Y), M.apply(B, X)];
      view.begin();
      view.mesh(STAND, [I], PALETTE);
      [
        [A, "yaw", 180],
        [B, "pitch", 90],
        [R, "roll", 180],
      ].forEach(([Q, key, most], k) => {
        const grip = () => ({
          name: () => `${key}: ${P.inDegrees(state[key])}`,
          at: NONE,
          axis: axes[k],
          angle: state[key] * rad,
          moved: (angle) =>
            change(
              key,
              Math.round(
                most === 180 ? M.wrap(angle) / rad : Math.min(most, Math.max(-most, angle / rad)),
              ),
            ),
        });
        view.mesh(RINGS[k], [at(Q)], PALETTE, { grip });
      });
      view.mesh(AIRCRAFT, [sized(0.8, R)], PALETTE);
      [
        ["yaw", COLOURS.green],
        ["pitch", COLOURS.orange],
        ["roll", COLOURS.red],
      ].forEach(([name, colour], k) => {
        view.line([M.scale(axes[k], -1.48), M.scale(axes[k], 1.48)], colour, 2, { dash: [6, 4] });
        view.text(M.scale(axes[k], name === "roll" ? -1.53 : 1.53), name);
      });
      const sign = Math.abs(state.pitch) === 90 ? Math.sign(state.pitch) : 0,
        lost = M.cross(axes[0], axes[1]);
      if (sign) {
        // about this direction no ring rotates any more
        view.arrow(NONE, M.scale(lost, 1.3), COLOURS.crimson, { above: true, thick: 0.03 });
        view.text(M.scale(lost, 1.42), "lost", COLOURS.crimson);
      }
      view.end();
      const factors = ["yaw", "pitch", "roll"].map((key, k) =>
        M.quaternion([Z, Y, X][k], state[key] * rad),
      );
      numbers(
        ...report(
          R,
          factors.reduce((product, each) => M.multiply(product, each)),
        ),
      );
      const [counts, yaw] = [1, -sign].map((k) =>
        P.degrees(M.wrap(k * (state.roll - sign * state.yaw) * rad)),
      );
      const what = sign > 0 ? "difference roll − yaw" : "sum roll + yaw",
        volume = Math.cos(state.pitch * rad);
      words.textContent = sign
        ? `Gimbal lock: the axes of yaw and roll are one line, and only the ${what} counts, ${counts}: yaw ${yaw}, roll 0° ` +
          "give the same orientation. No ring rotates about the red direction any more."
        : `The volume that the three axes span is ${P.number(volume, 3)} = cos(pitch). At 0 an axis is lost.`;
    };
  }

  // ---- the order of two rotations ----

  function order(card) {
    const state = card.state({ time: 2, angle: 90, own: false });
    const ZX = "R<sub>z</sub> R<sub>x</sub>",
      XZ = "R<sub>x</sub> R<sub>z</sub>";
    const views = pair(card, [ZX, XZ]);
    const write = (x) => (x <= 1 ? `first, ${P.percent(x)}` : `second, ${P.percent(x - 1)}`);
    const time = card.setting("Step", state, "time", { min: 0, max: 2, step: 0.02 }, write);
    card.angle("Both angles", state, "angle", 0, 180);
    card.checkbox("from the left: about the body's own axes", state, "own");
    card.player("Play", time, 0.0075);
    const numbers = card.numbers();
    return () => {
      const a = state.angle * rad,
        first = a * Math.min(1, state.time),
        second = a * Math.max(0, state.time - 1);
      const products = [
          [Z, X],
          [X, Z],
        ],
        [left, right] = state.own ? [first, second] : [second, first];
      const both = products.map(([L, K]) => M.times(about(L, left), about(K, right)));
      views.forEach((view, i) => {
        view.begin();
        fixedAxes(view, 1.15);
        const [L, K] = products[i],
          axis = state.time <= 1 === state.own ? L : M.apply(about(L, left), K);
        view.line([M.scale(axis, -1.2), M.scale(axis, 1.2)], COLOURS.purple, 3, { dash: [7, 5] });
        view.mesh(AIRCRAFT, [sized(0.9, both[i])], PALETTE);
        view.frame(at(both[i]), 1.0, { above: false });
        view.end();
      });
      const apart = M.norm(M.rotationVector(M.times(M.transpose(both[0]), both[1])));
      numbers(
        [`<span>${ZX} now:</span>`, P.matrix(both[0])],
        [`<span>${XZ} now:</span>`, P.matrix(both[1])],
        `angle between the two orientations: ${P.degrees(apart, 1)}`,
      );
    };
  }

  // ---- an angular velocity, in the room and in the body ----

  function velocity(card) {
    const state = card.state({ time: 0.12, tilt: -40, spin: 2 }),
      still = about(X, 0);
    const views = pair(card, ["In the room: ω in fixed axes", "In the body: ω in its own axes"]);
    const seconds = (x) => `${P.number(2 * Math.PI * x)} s`;
    const time = card.setting("Time", state, "time", { min: 0, max: 1, step: 0.005 }, seconds);
    card.angle("Tilt", state, "tilt", -90, 90);
    card.setting(
      "Rotation about its own x axis",
      state,
      "spin",
      { min: -2, max: 2, step: 1 },
      (x) => `${P.number(x, 0)} rad/s`,
    );
    card.player("Play", time, 0.003);
    const numbers = card.numbers();
    // About the fixed z axis at 1 rad/s, tilted, and about its own x axis.
    function motion(share) {
      const t = 2 * Math.PI * share,
        tilted = M.times(about(Z, t), about(Y, state.tilt * rad));
      const R = M.times(tilted, about(X, state.spin * t)),
        inRoom = M.add(Z, M.apply(tilted, X), state.spin);
      return { R, omegas: [inRoom, M.apply(M.transpose(R), inRoom)] };
    }
    return () => {
      const { R, omegas } = motion(state.time),
        length = 0.43; // of 1 rad/s
      const trail = M.sampled(120, (share) => motion(share).omegas);
      views.forEach((view, i) => {
        view.begin();
        if (i === 0) fixedAxes(view, 1.15);
        view.mesh(AIRCRAFT, [sized(0.8, i ? still : R)], PALETTE);
        view.frame(at(i ? still : R), 1.0, { above: false });
        view.line(
          trail.map((both) => M.scale(both[i], length)),
          COLOURS.crimson,
          2,
        );
        view.arrow(NONE, M.scale(omegas[i], length), COLOURS.purple, { above: true, thick: 0.03 });
        view.end();
      });
      numbers(
        ["R =", P.matrix(R)],
        `ω in the room: (${P.list(omegas[0])}) rad/s\n` +
          `ω in the body: (${P.list(omegas[1])}) rad/s`,
      );
    };
  }

  // ---- a belt ----

  const WIDTH = 0.16,
    PIECES = 90;
  // The quaternion at s along a belt whose end was rotated about its length and was then moved around by a share u. One
  // rotation leads from 1 to -1 on half a great circle, which can only be moved to the other half; two are a closed
  // circle, which smaller and smaller circles through 1 take to a point.
  function along(s, rotated, u) {
    if (u === 0) return M.quaternion(X, s * rotated * rad);
    if (rotated === 360)
      return M.quaternion([Math.cos(Math.PI * u), 0, Math.sin(Math.PI * u)], 2 * Math.PI * s);
    const t = (u * Math.PI) / 2,
      phi = 2 * Math.PI * s,
      c = Math.cos(t),
      n = Math.sin(t);
    return [n * n + c * c * Math.cos(phi), c * Math.sin(phi), n * c * (1 - Math.cos(phi)), 0];
  }
  const WALL = S.box([-1.5, -0.5, -0.5], [-1.36, 0.5, 0.5], 1),
    BOX = S.box([0, -0.28, -0.18], [0.3, 0.28, 0.18], 0);
  const SAID = {
    0: "Rotate the box by one and by two full rotations.",
    360: "One full rotation: the box looks as before, but the belt is twisted and q is −1. Now move the box around.",
    "360 moved":
      "The twist has only changed its direction, and q is still −1: moving cannot undo one rotation.",
    720: "Two full rotations. Now move the box around, without rotating it, by the second slider.",
    "720 moved":
      "The belt is flat again, and the box was not rotated back: two full rotations can be undone; q is +1.",
  };

  function belt(card) {
    const state = card.state({ rotated: 360, share: 0 }),
      view = card.space({
        radius: 1.1,
        centre: [0.05, 0, -0.25],
        proportion: 0.66,
        label: "A belt between a wall and a box",
        azimuth: -1.2,
        elevation: 0.4,
      });
    const change = (rotated) => {
      Object.assign(state, { rotated, share: 0 });
      move.set(0);
    };
    const options = { min: 0, max: 720, step: 5, value: state.rotated };
    const rotated = card.range("Rotate the box", options, P.inDegrees, change);
    const move = card.share("Move the box, without rotating it", state, "share");
    [0, 360, 720].forEach((value) =>
      card.button(`${value}°`, () => {
        rotated.set(value);
        change(value);
      }),
    );
    const numbers = card.numbers(),
      words = card.words();
    return () => {
      move.input.disabled = state.rotated !== 360 && state.rotated !== 720;
      const qs = M.sampled(PIECES, (s) => along(s, state.rotated, state.share));
      const axis = (q) => M.unit(q.slice(1)),
        angle = (q) => 2 * Math.atan2(M.norm(q.slice(1)), q[0]);
      const Rs = qs.map((q) => about(axis(q), angle(q))),
        vertices = [],
        faces = [],
        colours = [];
      let p = [-1.35, 0, 0];
      Rs.forEach((R, i) => {
        if (i) p = M.add(p, M.unit(M.add(M.apply(Rs[i - 1], X), M.apply(R, X))), 2.5 / PIECES);
        const side = M.apply(R, [0, WIDTH, 0]);
        vertices.push(M.add(p, side), M.add(p, side, -1));
      });
      for (let a = 0; a < 2 * PIECES; a += 2) {
        faces.push([a, a + 1, a + 3], [a, a + 3, a + 2], [a, a + 3, a + 1], [a, a + 2, a + 3]); // both sides
        colours.push(5, 5, 2, 2);
      }
      const end = at(Rs[PIECES], p);
      view.begin();
      view.contain([...WALL.vertices, [1.75, 0, 0], M.move(end, [0.3, 0, 0.6])]);
      view.mesh(WALL, [I], PALETTE);
      view.mesh(
        { vertices, faces, colours, bodies: vertices.map(() => 0), fleeting: true },
        [I],
        PALETTE,
      );
      view.mesh(BOX, [end], PALETTE, {
        grip: () =>
          state.share === 0 && {
            name: () => P.inDegrees(state.rotated),
            at: M.positionOf(end),
            axis: X,
            angle: state.rotated * rad,
            moved: (angle) => {
              change(5 * Math.round(Math.min(720, Math.max(0, angle / rad)) / 5));
              rotated.set(state.rotated);
            },
          },
      });
      view.frame(end, 0.5, { above: false });
      view.end();
      numbers(`q of the box, followed along the belt: (${P.list(qs[PIECES], 3)})`);
      words.textContent = SAID[`${state.rotated}${state.share === 1 ? " moved" : ""}`] || SAID[0];
    };
  }

  const MODES = {
    axis: ["Axis and angle", axisAngle],
    gimbals: ["Gimbal rings", gimbals],
    order: ["Rz Rx and Rx Rz", order],
    velocity: ["Angular velocity", velocity],
    belt: ["A belt: twice around", belt],
  };
  P.toy(
    "orientation",
    ({ mode }) => MODES[mode][0],
    (card, { mode }) => MODES[mode][1](card),
  );
})();
