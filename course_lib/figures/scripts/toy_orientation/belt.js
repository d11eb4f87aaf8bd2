// "belt": a belt between a wall and a box. One full rotation of the box cannot be undone by moving
// it around, two can.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const S = globalThis.course.scene;
  const { MODES, X, poseOf } = globalThis.course.orientation;
  const FIXED = M.eye(4);
  const HALF_WIDTH = 0.16;
  const LENGTH = 2.5;
  const START = [-1.35, 0, 0];
  const PIECES = 90;
  const [UPPER, LOWER] = [5, 2]; // colours of the belt's two sides, in the scene's palette
  const WALL = S.box([-1.5, -0.5, -0.5], [-1.36, 0.5, 0.5], 1);
  const BOX = S.box([0, -0.28, -0.18], [0.3, 0.28, 0.18], 0);
  const COMMENTS = {
    360:
      "One full rotation: the box looks as before, but the belt is twisted and q is −1. " +
      "Now move the box around.",
    "360 moved":
      "The twist has only changed its direction, and q is still −1: moving cannot undo one rotation.",
    720: "Two full rotations. Now move the box around, without rotating it, by the second slider.",
    "720 moved":
      "The belt is flat again, and the box was not rotated back: " +
      "two full rotations can be undone; q is +1.",
  };
  const FIRST_COMMENT = "Rotate the box by one and by two full rotations.";

  /**
   * The quaternion at a share s along a belt whose end was rotated about its length by `rotated`
   * degrees and was then moved around by a share u.
   *
   * One rotation leads from 1 to -1 on half a great circle, which can only be moved to the other
   * half. Two are a closed circle, which smaller and smaller circles through 1 take to a point.
   */
  function quaternionAlong(s, rotated, u) {
    if (u === 0) return M.quaternion(X, s * rotated * P.rad);
    if (rotated === 360) {
      const axis = [Math.cos(Math.PI * u), 0, Math.sin(Math.PI * u)];
      return M.quaternion(axis, 2 * Math.PI * s);
    }
    const phi = 2 * Math.PI * s; // along the circle
    const tilt = (u * Math.PI) / 2; // of the plane of the circle
    const cosine = Math.cos(tilt);
    const sine = Math.sin(tilt);
    return [
      sine * sine + cosine * cosine * Math.cos(phi),
      cosine * Math.sin(phi),
      sine * cosine * (1 - Math.cos(phi)),
      0,
    ];
  }
  function rotationOfQuaternion([w, ...xyz]) {
    return M.rotation(M.unit(xyz), 2 * Math.atan2(M.norm(xyz), w));
  }

  /**
   * The belt as a mesh, and the point at which it ends; each piece runs along the mean of two
   * orientations.
   */
  function beltOf(rotations) {
    const vertices = [];
    let p = START;
    rotations.forEach((R, i) => {
      if (i) {
        const along = M.unit(M.add(M.apply(rotations[i - 1], X), M.apply(R, X)));
        p = M.add(p, along, LENGTH / PIECES);
      }
      const side = M.apply(R, [0, HALF_WIDTH, 0]);
      vertices.push(M.add(p, side), M.subtract(p, side));
    });
    const faces = [];
    const colours = [];
    for (let a = 0; a < 2 * PIECES; a += 2) {
      faces.push([a, a + 1, a + 3], [a, a + 3, a + 2]);
      faces.push([a, a + 3, a + 1], [a, a + 2, a + 3]); // seen from below
      colours.push(UPPER, UPPER, LOWER, LOWER);
    }
    const bodies = vertices.map(() => 0);
    return { mesh: { vertices, faces, colours, bodies, fleeting: true }, end: p };
  }

  function build(card) {
    const state = card.state({ rotated: 360, share: 0 }); // degrees, and how far it is moved
    const view = card.space({
      radius: 1.1,
      centre: [0.05, 0, -0.25],
      proportion: 0.66,
      label: "A belt between a wall and a box",
      azimuth: -1.2,
      elevation: 0.4,
    });
    function rotateTo(rotated) {
      state.rotated = rotated;
      state.share = 0;
      moveRange.set(0);
    }
    const limits = { min: 0, max: 720, step: 5, value: state.rotated };
    const rotateRange = card.range("Rotate the box", limits, P.inDegrees, rotateTo);
    const moveRange = card.share("Move the box, without rotating it", state, "share");
    for (const angle of [0, 360, 720]) {
      card.button(`${angle}°`, () => {
        rotateRange.set(angle);
        rotateTo(angle);
      });
    }
    const numbers = card.numbers();
    const words = card.words(Object.values(COMMENTS));

    /** The box is rotated by dragging as long as it was not moved. */
    function gripAt(end) {
      if (state.share !== 0) return null;
      return {
        name: () => P.inDegrees(state.rotated),
        at: M.positionOf(end),
        axis: X,
        angle: state.rotated * P.rad,
        moved: (angle) => {
          const limited = P.clamp(angle / P.rad, 0, 720);
          rotateTo(5 * Math.round(limited / 5));
          rotateRange.set(state.rotated);
        },
      };
    }

    return () => {
      moveRange.input.disabled = state.rotated !== 360 && state.rotated !== 720;
      const quaternions = M.sampled(PIECES, (s) => quaternionAlong(s, state.rotated, state.share));
      const rotations = quaternions.map(rotationOfQuaternion);
      const belt = beltOf(rotations);
      const end = poseOf(rotations[PIECES], belt.end);
      view.begin();
      view.contain([...WALL.vertices, [1.75, 0, 0], M.move(end, [0.3, 0, 0.6])]);
      view.mesh(WALL, [FIXED], S.PALETTE);
      view.mesh(belt.mesh, [FIXED], S.PALETTE);
      view.mesh(BOX, [end], S.PALETTE, { grip: () => gripAt(end) });
      view.frame(end, 0.5, { above: false });
      view.end();
      numbers(`q of the box, followed along the belt: (${P.list(quaternions[PIECES], 3)})`);
      const key = state.share === 1 ? `${state.rotated} moved` : state.rotated;
      words.textContent = COMMENTS[key] ?? FIRST_COMMENT;
    };
  }

  MODES.belt = { title: "A belt: twice around", build };
})();
