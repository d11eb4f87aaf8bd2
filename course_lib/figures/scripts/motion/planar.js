// The plane: poses are (x, y, theta), body twists (omega, vx, vy); and planar arms.
(() => {
  "use strict";
  const M = globalThis.course.motion;

  /** The pose (4 x 4) in the plane z = 0. */
  const planar = ([x, y, theta]) => M.pose(M.rotation([0, 0, 1], theta), [x, y, 0]);
  /** The body twist that leads from A to B in unit time. */
  const logPlanar = (A, B) => M.log(M.times(M.inverse(planar(A)), planar(B))).slice(2, 5);
  /** The pose to which a body twist leads from A in unit time. */
  function expPlanar(A, [omega, vx, vy]) {
    const moved = M.times(planar(A), M.exp([0, 0, omega, vx, vy, 0]));
    const [x, y] = M.positionOf(moved);
    return [x, y, A[2] + omega];
  }
  /**
   * The pole, in fixed coordinates: the point that a body twist at the pose A leaves at rest; null
   * for a translation.
   */
  function pole(A, [omega, vx, vy]) {
    if (Math.abs(omega) < 1e-9) return null;
    return M.move(planar(A), [-vy / omega, vx / omega, 0]).slice(0, 2);
  }

  /**
   * The body twist of a robot that faces x, from the speeds of its left and right wheels, which are
   * `track` metres apart.
   */
  const twistOfWheels = (left, right, track) => [(right - left) / track, (left + right) / 2, 0];

  /**
   * Three errors that lead from the pose A to B: those of the space and the body Jacobian, (omega,
   * vx, vy), and that of the geometric one, (vx, vy, omega).
   */
  function planarErrors(A, B) {
    const body = logPlanar(A, B);
    const [omega, vx, vy] = body;
    const [x, y, theta] = A;
    const [c, s] = [Math.cos(theta), Math.sin(theta)];
    // The velocity of the body's point at the origin.
    const space = [omega, c * vx - s * vy + omega * y, s * vx + c * vy - omega * x];
    return { space, body, geometric: [B[0] - x, B[1] - y, omega] };
  }

  /**
   * Dead reckoning.
   * @param {number[]} start a pose
   * @param {[number[], number][]} plan body velocities [[vx, vy, omega], seconds]
   * @param {number} dt seconds of a step; the last one of each part is what is left
   * @returns {{euler: number[][], exact: number[][]}} Euler's poses, and the exact ones, at the
   *   same times
   */
  function propagate(start, plan, dt) {
    const euler = [start];
    const exact = [start];
    for (const [[vx, vy, omega], seconds] of plan) {
      // The factor is for 2.1 / 0.3, which is slightly above 7 and would make an eighth step of no
      // length.
      const steps = Math.ceil((seconds / dt) * (1 - 1e-12));
      const from = exact.at(-1);
      for (let k = 1; k <= steps; k++) {
        const elapsed = k < steps ? k * dt : seconds;
        const h = elapsed - (k - 1) * dt;
        const [x, y, theta] = euler.at(-1);
        const c = Math.cos(theta);
        const s = Math.sin(theta);
        euler.push([x + h * (c * vx - s * vy), y + h * (s * vx + c * vy), theta + h * omega]);
        exact.push(expPlanar(from, [omega * elapsed, vx * elapsed, vy * elapsed]));
      }
    }
    return { euler, exact };
  }

  /**
   * The joints' positions of a planar arm with these link lengths, the base first and the tip last.
   */
  function planarPoints(lengths, q) {
    const points = [[0, 0]];
    let angle = 0;
    lengths.forEach((length, i) => {
      angle += q[i];
      points.push(M.add(points[i], [Math.cos(angle), Math.sin(angle)], length));
    });
    return points;
  }
  /**
   * The Jacobian (2 x n) of the tip: a joint moves it at right angles to the line from the joint to
   * the tip.
   */
  function planarJacobian(lengths, q) {
    const points = planarPoints(lengths, q);
    const [x, y] = points.at(-1);
    const joints = points.slice(0, -1);
    return [joints.map((joint) => joint[1] - y), joints.map((joint) => x - joint[0])];
  }
  /**
   * The joint angles of a planar arm at the start and after each of n damped least-squares steps
   * towards a target.
   */
  function dampedRun(lengths, start, target, alpha, eps, n) {
    const run = [start];
    for (let k = 0; k < n; k++) {
      const q = run[k];
      const error = M.subtract(target, planarPoints(lengths, q).at(-1));
      const step = M.dampedStep(planarJacobian(lengths, q), error, eps);
      run.push(M.add(q, step, alpha));
    }
    return run;
  }
  /**
   * The joint angles of a planar arm with two links that reach a point, with q2 >= 0; null out of
   * reach.
   */
  function twoLink([l1, l2], [x, y]) {
    // Of q2, by the law of cosines.
    const cosine = (x * x + y * y - l1 * l1 - l2 * l2) / (2 * l1 * l2);
    if (Math.abs(cosine) > 1) return null;
    const q2 = Math.acos(cosine);
    return [Math.atan2(y, x) - Math.atan2(l2 * Math.sin(q2), l1 + l2 * cosine), q2];
  }

  Object.assign(M, {
    planar,
    logPlanar,
    expPlanar,
    pole,
    twistOfWheels,
    planarErrors,
    propagate,
    planarPoints,
    planarJacobian,
    dampedRun,
    twoLink,
  });
})();
