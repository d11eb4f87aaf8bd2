// Serial arms: {screws: n x 6, home: n + 1 poses}, the frames of the joints and of the end-effector
// at q = 0.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const { add, apply, norm, scale, subtract, times, transpose } = M;

  /**
   * The products of exponentials up to each joint, the identity first: where each body is, seen
   * from q = 0.
   */
  function bodies({ screws }, q) {
    const poses = [M.eye(4)];
    screws.forEach((screw, i) => {
      poses.push(times(poses[i], M.exp(scale(screw, q[i]))));
    });
    return poses;
  }
  /** The frames of the joints, each with its own rotation, and of the end-effector. */
  const frames = (arm, q, moved = bodies(arm, q)) =>
    arm.home.map((home, i) => times(moved[Math.min(i + 1, q.length)], home));

  /** The Jacobian (6 x n) of spatial twists: each screw, moved by the joints before it. */
  const spaceJacobian = (arm, q, moved = bodies(arm, q)) =>
    transpose(arm.screws.map((screw, i) => apply(M.adjoint(moved[i]), screw)));
  /**
   * Columns (omega, v), v the velocity of the end-effector's origin, along the axes of the base.
   */
  function geometricJacobian(arm, q) {
    const moved = bodies(arm, q);
    const end = times(moved.at(-1), arm.home.at(-1));
    const p = M.positionOf(end);
    const columns = transpose(spaceJacobian(arm, q, moved)).map((column) => {
      const omega = column.slice(0, 3);
      return [...omega, ...add(column.slice(3), M.cross(omega, p))];
    });
    return transpose(columns);
  }

  /**
   * Unit joint velocities that leave the end-effector at rest, for a 6 x 7 Jacobian; null at a
   * singularity.
   */
  function nullVector(J) {
    const { values, vectors } = M.eigen(times(transpose(J), J));
    const isSingular = values[5] <= 1e-10;
    return isSingular ? null : vectors[6];
  }

  /**
   * Joint angles within limits that reach a pose, or come nearest to it, by steps of damped least
   * squares. A step that does not lessen the error is not taken, and raises the damping: so they
   * come to rest out of reach, too.
   * @param {object} arm
   * @param {number[]} q where they start
   * @param {number[][]} target 4 x 4
   * @param {number[][]} limits n x 2
   */
  function reach(arm, q, target, limits, maxSteps = 200) {
    const errorAt = (angles) => M.poseError(frames(arm, angles).at(-1), target);
    const withinLimits = (angles) =>
      angles.map((angle, i) => Math.min(limits[i][1], Math.max(limits[i][0], angle)));
    let angles = q;
    let error = errorAt(q);
    let damping = 4e-4;
    let moved = 1;
    for (let k = 0; k < maxSteps; k++) {
      const isAtRest = norm(error) <= 1e-9 || moved <= 1e-6 || damping >= 1e4;
      if (isAtRest) break;
      // Of the first steps none is longer than 0.1 m, so that the arm does not jump to another
      // solution.
      const share = k < 15 ? Math.min(1, 0.1 / norm(error.slice(3))) : 1;
      const J = geometricJacobian(arm, angles);
      const step = M.dampedStep(J, scale(error, share), damping);
      const next = withinLimits(add(angles, step));
      const nextError = errorAt(next);
      if (norm(nextError) < norm(error)) {
        moved = norm(subtract(next, angles));
        angles = next;
        error = nextError;
        damping = Math.max(1e-5, damping / 3);
      } else {
        damping *= 9;
      }
    }
    return angles;
  }

  Object.assign(M, {
    bodies,
    frames,
    spaceJacobian,
    geometricJacobian,
    nullVector,
    reach,
  });
})();
