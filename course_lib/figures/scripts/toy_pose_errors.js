// A current pose and a target in the plane, and the linear part of three pose errors: those that
// belong to the space, the body and the geometric Jacobian.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { COLOURS } = globalThis.course.palette;
  const HALF = 1; // metres to both sides of the centre
  const CENTRE = [0.5, 0.28];
  const HEIGHT = 0.75; // of the picture, in widths
  const AXIS = 0.17; // metres: the length of a frame's axes
  const DIRECTION = 0.3; // metres from a frame to the handle of its direction
  const HEAD = 0.07; // metres: the length of an arrow's head
  const ERRORS = [
    { name: "space", colour: COLOURS.violet, isBeside: true },
    { name: "body", colour: COLOURS.crimson, isBeside: false },
    { name: "geometric", colour: COLOURS.black, isBeside: true },
  ];

  P.toy("pose_errors", "Three errors between two poses", (card, meta) => {
    const state = card.state({ now: [...meta.now], target: [...meta.target] });
    const plane = card.map({
      half: HALF,
      centre: CENTRE,
      step: 0.5,
      proportion: HEIGHT,
      label: "The base, the current pose, the target and three errors",
    });
    addHandles("now", "Now", COLOURS.blue);
    addHandles("target", "Target", COLOURS.green);
    const rotation = card.range(
      "Rotate the target",
      { min: -180, max: 180, step: 1, value: rotationOf(state) },
      P.inDegrees,
      (degrees) => {
        state.target[2] = state.now[2] + degrees * P.rad;
      },
    );
    const numbers = card.numbers();
    const words = card.words([comment([1, 1, 1])]);

    function addHandles(key, title, colour) {
      plane.poseHandles({
        title,
        colour,
        pose: () => state[key],
        ahead: () => ahead(state[key], DIRECTION),
        moved: (pose) => {
          state[key] = pose;
          rotation.set(rotationOf(state));
        },
      });
    }
    function drawFrame(pose, colour, name) {
      const [x, y, theta] = pose;
      plane.line([[x, y], ahead([x, y, theta + Math.PI / 2], AXIS)], colour, 1.5);
      plane.line([[x, y], ahead(pose, AXIS)], colour, 3.5);
      plane.text(ahead([x, y, theta - Math.PI / 2], 0.11), name, colour);
    }
    function drawArrow(from, arrow, { name, colour, isBeside }) {
      const length = M.norm(arrow);
      if (length < 1e-6) return;
      const to = M.add(from, arrow);
      const back = M.scale(arrow, -Math.min(HEAD, length) / length);
      const aside = M.scale([-back[1], back[0]], 0.5);
      plane.line([from, to], colour, 3);
      const barbs = [M.add(M.add(to, back), aside), to, M.subtract(M.add(to, back), aside)];
      plane.line(barbs, colour, 3);
      // Beside an arrow that ends in the target or may leave the picture, else beyond its tip.
      const [dx, dy] = M.scale(arrow, 1 / length);
      const place = isBeside
        ? M.add(M.add(from, [dx, dy], Math.min(0.35 * length, 0.4)), [-dy, dx], 0.12)
        : M.add(to, [dx, dy], 0.09);
      plane.text(place, name, colour);
    }

    return () => {
      const { now, target } = state;
      const { space, body, geometric } = M.planarErrors(now, target);
      const origin = now.slice(0, 2);
      const along = ([forwards, left]) =>
        M.add(ahead([0, 0, now[2]], forwards), ahead([0, 0, now[2] + Math.PI / 2], left));
      const arrows = [space.slice(1), along(body.slice(1)), geometric.slice(0, 2)];
      plane.begin();
      const arc = M.sampled(60, (share) => M.expPlanar(now, M.scale(body, share)).slice(0, 2));
      plane.line(arc, COLOURS.grey, 1.5, { dash: [4, 4] });
      drawFrame([0, 0, 0], COLOURS.grey, "base");
      drawFrame(now, COLOURS.blue, "now");
      drawFrame(target, COLOURS.green, "target");
      ERRORS.forEach((look, i) => {
        drawArrow(i ? origin : [0, 0], arrows[i], look);
      });
      plane.end();
      const linear = [space.slice(1), body.slice(1), geometric.slice(0, 2)];
      numbers(
        ...linear.map((v, i) => `${ERRORS[i].name}: v = (${P.list(v)}) m`),
        `all three: ${P.number(space[0])} rad about z`,
      );
      words.textContent = comment(arrows.map(M.norm));
    };
  });

  /** The point at a distance ahead of a pose. */
  const ahead = ([x, y, theta], distance) => [
    x + distance * Math.cos(theta),
    y + distance * Math.sin(theta),
  ];
  /** By how many degrees the target is rotated relative to the current pose. */
  const rotationOf = ({ now, target }) => M.wrap(target[2] - now[2]) / P.rad;

  function comment([space, body, geometric]) {
    return (
      `The arrows are ${P.number(space)} m (space), ${P.number(body)} m (body) and ` +
      `${P.number(geometric)} m (geometric) long. The body's arrow is tangent to the arc of the ` +
      "screw motion, dashed; only the geometric one ends at the target."
    );
  }
})();
