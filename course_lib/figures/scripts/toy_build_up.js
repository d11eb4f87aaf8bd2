// A pose built up factor by factor: the product of exponentials, with each screw axis where it was
// and where it is now, and the column of the Jacobian that belongs to it.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { COLOURS } = globalThis.course.palette;
  const GROWTH = 0.04; // of a new factor, a frame

  P.toy("build_up", (meta) => meta.title, build);

  function build(card, meta) {
    const { arm, limits, size } = meta;
    const n = arm.screws.length;
    const view = card.armSpace();
    const state = card.state({ q: [...meta.q], k: meta.start }); // k: how many factors there are
    let grown = 1; // the share of the last factor's angle
    const lastJoint = () => Math.max(0, state.k - 1);
    const degreesOfLast = () => Math.round(state.q[lastJoint()] / P.rad);

    const factorLimits = { min: 0, max: n, step: 1, value: state.k };
    const writeFactors = (k) => (k ? `${k} of ${n}` : "none");
    const factorRange = card.range("Factors", factorLimits, writeFactors, goTo);
    const angleLimits = { min: -180, max: 180, step: 1, value: degreesOfLast() };
    const writeAngle = (degrees) => `${P.sub("q", lastJoint() + 1)} = ${P.inDegrees(degrees)}`;
    const angleRange = card.range("Angle of its joint", angleLimits, writeAngle, (degrees) => {
      state.q[lastJoint()] = P.clamp(degrees * P.rad, ...limits[lastJoint()]);
    });

    /** The next factor grows from nothing to its full size; any other one is there at once. */
    function goTo(k) {
      const isNext = k === state.k + 1;
      state.k = k;
      grown = isNext ? 0 : 1;
      angleRange.set(degreesOfLast());
      card.run(() => {
        grown = Math.min(1, grown + GROWTH);
        return grown < 1;
      });
    }
    function goBy(change) {
      const k = P.clamp(state.k + change, 0, n);
      factorRange.set(k);
      goTo(k);
    }
    card.button("Previous factor", () => goBy(-1));
    card.button("Next factor", () => goBy(1));
    const numbers = card.numbers();

    /**
     * The joint angles so far: those of the factors that are there, and a share of the last one.
     */
    const anglesNow = () =>
      state.q.map((angle, i) => {
        if (i < state.k - 1) return angle;
        return i === state.k - 1 ? grown * angle : 0;
      });
    /** Both ends of the line of a screw axis. */
    function axisEnds(point, direction) {
      const length = 0.17 * size;
      return [M.add(point, direction, -length), M.add(point, direction, length)];
    }
    function drawAxis(screw, i, pose) {
      const direction = screw.slice(0, 3);
      const point = M.positionOf(arm.home[i]);
      view.line(axisEnds(point, direction), COLOURS.grey, 1.5, { dash: [5, 5] });
      const now = axisEnds(M.move(pose, point), M.apply(M.rotationOf(pose), direction));
      const colour = i === state.k - 1 ? COLOURS.crimson : COLOURS.purple;
      view.arrow(...now, colour, { thick: 0.006 * size });
      view.text(now[1], String(i + 1), colour, 10);
    }

    return () => {
      const { k } = state;
      const q = anglesNow();
      const poses = M.bodies(arm, q);
      view.begin();
      view.stand(poses);
      const { grip } = view.joints(
        () => q,
        poses,
        (joint, angle) => {
          state.q[joint] = angle;
          if (joint === lastJoint()) angleRange.set(Math.round(angle / P.rad));
        },
      );
      const gripOfMoved = (body) => (body <= k ? grip(body) : null);
      view.arm(poses, { opacity: 0.45, shadow: true, grip: gripOfMoved });
      arm.screws.forEach((screw, i) => {
        drawAxis(screw, i, poses[i]);
      });
      const T = M.times(poses[n], arm.home[n]);
      view.frame(M.eye(4), 0.1 * size, { thick: 0.004 * size });
      view.frame(T, 0.1 * size, { thick: 0.006 * size });
      view.end();

      const J = M.spaceJacobian(arm, q, poses);
      numbers(
        [`<span>T = ${productOf(n, k)} M =</span>`, P.matrix(T)],
        ["<span>J<sub>s</sub> =</span>", P.matrix(J, { digits: 2, highlighted: k - 1 })],
        comment(k),
      );
    };
  }

  /** HTML of the product of n factors: the k-th is marked, and those after it are dim. */
  function productOf(n, k) {
    const factors = Array.from({ length: n }, (_, i) => {
      const number = i + 1;
      const factor = `e<sup>[S<sub>${number}</sub>]q<sub>${number}</sub></sup>`;
      if (number < k) return factor;
      return number === k ? `<mark>${factor}</mark>` : `<span class="dim">${factor}</span>`;
    });
    return factors.join(" ");
  }
  function comment(k) {
    if (!k) return "All joints at 0: each axis is where it was, the columns are the screws.";
    return (
      `Column ${k} is the screw axis ${k} where it is now: the joints before it have moved it, ` +
      "the joint itself and those after it have not."
    );
  }
})();
