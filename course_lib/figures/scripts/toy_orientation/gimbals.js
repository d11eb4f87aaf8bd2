// "gimbals": three rings around an aircraft, for yaw, pitch and roll: R = Rz(yaw) Ry(pitch)
// Rx(roll).
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const S = globalThis.course.scene;
  const { MODES, ORIGIN, X, Y, Z, poseOf, drawAircraft, linesOf } = globalThis.course.orientation;
  const { COLOURS } = globalThis.course.palette;
  const FIXED = M.eye(4);
  const PIN = [
    [0, -0.12],
    [0.035, -0.12],
    [0.035, 0.12],
    [0, 0.12],
  ]; // radius and height
  const [METAL, GREEN, RED, AMBER] = [1, 3, 4, 5]; // of the scene's palette

  /** A pin at both ends of the z axis of R, at a distance. */
  function pins(R, distance) {
    const ends = [-1, 1].map((sign) => {
      const place = M.apply(R, [0, 0, sign * distance]);
      return S.lathe(poseOf(R, place), PIN, METAL);
    });
    return S.join(ends);
  }
  const quarter = (axis) => M.rotation(axis, Math.PI / 2);
  // What yaw, pitch and roll carry, each with the pins of the next ring.
  const OUTER = S.join([
    S.ring(poseOf(quarter(Y)), 1.36, 0.05, GREEN),
    pins(M.rotation(X, -Math.PI / 2), 1.24),
  ]);
  const MIDDLE = S.join([S.ring(FIXED, 1.18, 0.05, AMBER), pins(quarter(Y), 1.06)]);
  const INNER = S.ring(poseOf(quarter(X)), 1.0, 0.05, RED);
  const STAND = pins(M.eye(3), 1.42);
  const RINGS = [
    { key: "yaw", mesh: OUTER, max: 180, colour: COLOURS.green, wordAt: 1.53 },
    { key: "pitch", mesh: MIDDLE, max: 90, colour: COLOURS.orange, wordAt: 1.53 },
    { key: "roll", mesh: INNER, max: 180, colour: COLOURS.red, wordAt: -1.53 },
  ];

  function build(card) {
    const state = card.state({ yaw: 30, pitch: 20, roll: 10 }); // degrees
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
    function change(key, angle) {
      state[key] = angle;
      ranges[key].set(angle);
    }
    const wrapped = (angle) => Math.round(M.wrap(angle) / P.rad);

    function addDriveButton(sign) {
      card.button(`Drive to ${sign > 0 ? "+" : "−"}90°`, () => {
        card.run(() => {
          change("pitch", sign * Math.min(90, sign * state.pitch + 1));
          return sign * state.pitch < 90;
        });
      });
    }
    function addBothButton(roll) {
      card.button(`Yaw +10°, roll ${roll > 0 ? "+" : "−"}10°`, () => {
        change("yaw", wrapped((state.yaw + 10) * P.rad));
        change("roll", wrapped((state.roll + roll) * P.rad));
      });
    }
    addDriveButton(1);
    addDriveButton(-1);
    addBothButton(10);
    addBothButton(-10);
    const numbers = card.numbers();
    const words = card.words([lockComment({ yaw: 100, pitch: -90, roll: -10 })]);

    function drawRing({ key, mesh, max, colour, wordAt }, R, axis) {
      const grip = () => ({
        name: () => `${key}: ${P.inDegrees(state[key])}`,
        at: ORIGIN,
        axis,
        angle: state[key] * P.rad,
        moved: (angle) => {
          const isFree = max === 180;
          const limited = Math.round(P.clamp(angle / P.rad, -max, max));
          change(key, isFree ? wrapped(angle) : limited);
        },
      });
      view.mesh(mesh, [poseOf(R)], S.PALETTE, { grip });
      view.line([M.scale(axis, -1.48), M.scale(axis, 1.48)], colour, 2, { dash: [6, 4] });
      view.text(M.scale(axis, wordAt), key);
    }
    /** About this direction no ring rotates any more. */
    function drawLostAxis(axes) {
      const lost = M.cross(axes[0], axes[1]);
      view.arrow(ORIGIN, M.scale(lost, 1.3), COLOURS.crimson, { above: true, thick: 0.03 });
      view.text(M.scale(lost, 1.42), "lost", COLOURS.crimson);
    }

    return () => {
      const [yaw, pitch, roll] = RINGS.map(({ key }) => state[key] * P.rad);
      const outer = M.rotation(Z, yaw);
      const middle = M.times(outer, M.rotation(Y, pitch));
      const inner = M.times(middle, M.rotation(X, roll));
      const rotations = [outer, middle, inner];
      const axes = [Z, M.apply(outer, Y), M.apply(middle, X)];
      const isLocked = Math.abs(state.pitch) === 90;
      view.begin();
      view.mesh(STAND, [FIXED], S.PALETTE);
      RINGS.forEach((ring, k) => {
        drawRing(ring, rotations[k], axes[k]);
      });
      drawAircraft(view, inner, 0.8);
      if (isLocked) drawLostAxis(axes);
      view.end();
      const factors = [M.quaternion(Z, yaw), M.quaternion(Y, pitch), M.quaternion(X, roll)];
      numbers(...linesOf(inner, factors.reduce(M.multiply)));
      words.textContent = isLocked ? lockComment(state) : volumeComment(pitch);
    };
  }

  /** At 90° R depends on roll - yaw alone, at -90° on roll + yaw. */
  function lockComment({ yaw, pitch, roll }) {
    const sign = Math.sign(pitch);
    const what = sign > 0 ? "difference roll − yaw" : "sum roll + yaw";
    const counted = roll - sign * yaw;
    const [count, sameYaw] = [counted, -sign * counted].map((angle) =>
      P.degrees(M.wrap(angle * P.rad)),
    );
    return (
      "Gimbal lock: the axes of yaw and roll are one line, " +
      `and only the ${what} counts, ${count}: ` +
      `yaw ${sameYaw}, roll 0° give the same orientation. ` +
      "No ring rotates about the red direction any more."
    );
  }
  function volumeComment(pitch) {
    const volume = P.number(Math.cos(pitch), 3);
    return `The volume that the three axes span is ${volume} = cos(pitch). At 0 an axis is lost.`;
  }

  MODES.gimbals = { title: "Gimbal rings", build };
})();
