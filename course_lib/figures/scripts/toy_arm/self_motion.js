// The self-motion of an arm with seven joints: its configurations for one pose of the end-effector.
globalThis.course.arm = (() => {
  "use strict";
  const M = globalThis.course.motion;
  const STEP = 0.02; // radians along the null space
  const MAX_STEPS = 400; // to each side: an arm whose joints have no limits goes round and round
  const CORRECTIONS = 2; // of a step, back to where the end-effector was
  const DAMPING = 1e-9; // only against a division by zero

  /**
   * The configurations within the limits through `start`, in their order along the null space.
   * @returns {{q: number[][], target: number[][]}} target: the pose that they share
   */
  function selfMotion(arm, limits, start) {
    const target = M.frames(arm, start).at(-1);
    const isInside = (q) => q.every((x, i) => x >= limits[i][0] && x <= limits[i][1]);

    function corrected(q) {
      const J = M.geometricJacobian(arm, q);
      const error = M.poseError(M.frames(arm, q).at(-1), target);
      return M.add(q, M.dampedStep(J, error, DAMPING));
    }
    /** The null vector along the previous one; at first, the one whose first entry has the sign. */
    function direction(q, before, sign) {
      const v = M.nullVector(M.geometricJacobian(arm, q));
      if (!v) return null;
      const isOpposite = before ? M.dot(v, before) < 0 : sign * v[0] < 0;
      return isOpposite ? M.scale(v, -1) : v;
    }
    function oneSide(sign) {
      const path = [];
      let q = start;
      let before = null;
      while (path.length < MAX_STEPS) {
        before = direction(q, before, sign);
        if (!before) break; // a singularity, at which the path may fork
        q = M.add(q, before, STEP);
        for (let k = 0; k < CORRECTIONS; k++) q = corrected(q);
        if (!isInside(q)) break;
        path.push(q);
      }
      return path;
    }
    return { q: [...oneSide(-1).reverse(), start, ...oneSide(1)], target };
  }

  /** How far the elbow leans out of the vertical plane through shoulder and wrist, in radians. */
  function elbowAngle(arm, q) {
    const frames = M.frames(arm, q);
    const [shoulder, elbow, wrist] = [1, 3, 5].map((i) => M.positionOf(frames[i]));
    const axis = M.unit(M.subtract(wrist, shoulder));
    const side = M.unit(M.cross(axis, [0, 0, 1]));
    const lean = M.subtract(elbow, shoulder);
    return Math.atan2(M.dot(lean, side), M.dot(lean, M.cross(side, axis)));
  }

  return { selfMotion, elbowAngle };
})();
