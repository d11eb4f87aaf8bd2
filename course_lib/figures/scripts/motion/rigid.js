// Rigid motions: rotations, poses (4 x 4) and twists (w, v), in radians and metres, and unit
// quaternions.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const { dot, norm, add, subtract, scale, cross, unit, transpose, times, apply, hat, eye } = M;

  const pose = (R, p) => [...R.map((row, i) => [...row, p[i]]), [0, 0, 0, 1]];
  const rotationOf = (T) => T.slice(0, 3).map((row) => row.slice(0, 3));
  const positionOf = (T) => T.slice(0, 3).map((row) => row[3]);
  /** T p; written out, because a picture moves thousands of points. */
  const move = (T, p) =>
    [0, 1, 2].map((i) => T[i][0] * p[0] + T[i][1] * p[1] + T[i][2] * p[2] + T[i][3]);
  /** The pose (R^T, -R^T p). */
  function inverse(T) {
    const R = transpose(rotationOf(T));
    return pose(R, scale(apply(R, positionOf(T)), -1));
  }

  /**
   * The factors of the exponential, sin(a)/a, (1 - cos a)/a^2 and (a - sin a)/a^3. The second one
   * is written with a/2, because 1 - cos a loses digits; below 0.02 the closed form of the third
   * loses some too, and three terms of its series are exact.
   */
  function factors(angle) {
    const a2 = angle * angle;
    const half = angle / 2;
    const isTiny = angle < 1e-8;
    const first = isTiny ? 1 : Math.sin(angle) / angle;
    const second = isTiny ? 0.5 : 0.5 * (Math.sin(half) / half) ** 2;
    const series = 1 / 6 - a2 / 120 + (a2 * a2) / 5040;
    const third = angle < 0.02 ? series : (angle - Math.sin(angle)) / (a2 * angle);
    return [first, second, third];
  }
  /**
   * The exponential of a twist, a pose: with W = hat(w), R = I + a W + b W^2 (Rodrigues) and p = (I
   * + b W + c W^2) v, where a, b and c are the factors above.
   */
  function exp(twist) {
    const w = twist.slice(0, 3);
    const v = twist.slice(3);
    const [a, b, c] = factors(norm(w));
    const W = hat(w);
    const W2 = times(W, W);
    const R = eye(3).map((row, i) => row.map((x, j) => x + a * W[i][j] + b * W2[i][j]));
    return pose(R, add(add(v, apply(W, v), b), apply(W2, v), c));
  }
  /**
   * The rotation vector, at most pi long, of a rotation (3 x 3 or a pose). It goes through the
   * quaternion, whose digits do not get lost near pi.
   */
  function rotationVector(R) {
    const [[a, b, c], [d, e, f], [g, h, i]] = R;
    // 4 w^2, 4 x^2, 4 y^2, 4 z^2.
    const squares = [1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i];
    // Each row is the quaternion times four of its parts; the largest part loses the fewest digits.
    const rows = [
      [squares[0], h - f, c - g, d - b],
      [h - f, squares[1], b + d, c + g],
      [c - g, b + d, squares[2], f + h],
      [d - b, c + g, f + h, squares[3]],
    ];
    const row = rows[squares.indexOf(Math.max(...squares))];
    const sign = row[0] < 0 ? -1 : 1; // q and -q stand for R; w >= 0 is the shorter way
    const [w, ...xyz] = scale(unit(row), sign);
    const sine = norm(xyz);
    const stretch = sine < 1e-12 ? 2 / w : (2 * Math.atan2(sine, w)) / sine;
    return scale(xyz, stretch);
  }
  /**
   * The twist whose exponential is T: v = p - w x p/2 + d w x (w x p), with d = (1 - (a/2)
   * cot(a/2))/a^2.
   */
  function log(T) {
    const w = rotationVector(T);
    const p = positionOf(T);
    const angle = norm(w);
    const half = angle / 2;
    const wp = cross(w, p);
    const series = 1 / 12 + angle ** 2 / 720 + angle ** 4 / 30240;
    const d = angle < 0.02 ? series : (1 - half / Math.tan(half)) / angle ** 2;
    return [...w, ...add(add(p, wp, -0.5), cross(w, wp), d)];
  }
  /** From A to B along one screw: A at share 0, B at share 1. */
  const interpolate = (A, B, share) => times(A, exp(scale(log(times(inverse(A), B)), share)));
  const rotation = (axis, angle) => rotationOf(exp([...scale(axis, angle), 0, 0, 0]));
  /** The matrix (6 x 6) that takes a twist from frame b to frame a, given T_ab. */
  function adjoint(T) {
    const R = rotationOf(T);
    const pR = times(hat(positionOf(T)), R);
    return [...R.map((row) => [...row, 0, 0, 0]), ...R.map((row, i) => [...pR[i], ...row])];
  }
  /**
   * The error (rotation vector, translation) from the pose T to the pose target, along the axes of
   * the base.
   */
  const poseError = (T, target) => [
    ...rotationVector(times(rotationOf(target), transpose(rotationOf(T)))),
    ...subtract(positionOf(target), positionOf(T)),
  ];

  /** The quaternion (w, x, y, z) of an axis and an angle; 2 pi gives -1. */
  const quaternion = (axis, angle) => [Math.cos(angle / 2), ...scale(axis, Math.sin(angle / 2))];
  /** The product (a b - u.v, a v + b u + u x v) of two quaternions. */
  const multiply = ([a, ...u], [b, ...v]) => [
    a * b - dot(u, v),
    ...add(add(scale(v, a), scale(u, b)), cross(u, v)),
  ];

  Object.assign(M, {
    pose,
    rotationOf,
    positionOf,
    move,
    inverse,
    exp,
    rotationVector,
    log,
    interpolate,
    rotation,
    adjoint,
    poseError,
    quaternion,
    multiply,
  });
})();
