// Rigid motions, arms and a little linear algebra, for figures that move without a kernel. Vectors are arrays, matrices
// arrays of rows, poses 4 x 4; radians and metres; a twist is (w, v). Tests compare these functions with those of
// course_lib. No drawing; runs in a browser and in node.
globalThis.course = globalThis.course || { kinds: {} };
globalThis.course.motion = (() => {
  "use strict";
  const eye = (n) =>
    Array.from({ length: n }, (_, i) => Array.from({ length: n }, (_, j) => (i === j ? 1 : 0)));
  const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
  const norm = (a) => Math.hypot(...a);
  const add = (a, b, s = 1) => a.map((x, i) => x + s * b[i]);
  const scale = (a, s) => a.map((x) => s * x);
  const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
  const unit = (a) => scale(a, 1 / (norm(a) || 1));
  const transpose = (A) => A[0].map((_, j) => A.map((row) => row[j]));
  const times = (A, B) =>
    A.map((row) => B[0].map((_, j) => row.reduce((sum, x, k) => sum + x * B[k][j], 0)));
  const apply = (A, v) => A.map((row) => dot(row, v));
  const hat = ([x, y, z]) => [
    [0, -z, y],
    [z, 0, -x],
    [-y, x, 0],
  ];
  // A function of a share, at the n + 1 ends of n equal steps from 0 to 1.
  const sampled = (n, of) => Array.from({ length: n + 1 }, (_, i) => of(i / n));
  const wrap = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));

  // ---- rigid motions ----

  const pose = (R, p) => [...R.map((row, i) => [...row, p[i]]), [0, 0, 0, 1]];
  const rotationOf = (T) => T.slice(0, 3).map((row) => row.slice(0, 3));
  const positionOf = (T) => T.slice(0, 3).map((row) => row[3]);
  const move = (T, p) =>
    [0, 1, 2].map((i) => T[i][0] * p[0] + T[i][1] * p[1] + T[i][2] * p[2] + T[i][3]);
  const inverse = (T) => {
    const R = transpose(rotationOf(T));
    return pose(R, scale(apply(R, positionOf(T)), -1));
  };

  // sin(a)/a, (1 - cos a)/a^2 and (a - sin a)/a^3. Below 0.02 the closed form of the last loses digits, and three terms
  // of its series are exact.
  function factors(angle) {
    const a2 = angle * angle,
      half = angle / 2,
      tiny = angle < 1e-8;
    const c =
      angle < 0.02 ? 1 / 6 - a2 / 120 + (a2 * a2) / 5040 : (angle - Math.sin(angle)) / (a2 * angle);
    return [tiny ? 1 : Math.sin(angle) / angle, tiny ? 0.5 : 0.5 * (Math.sin(half) / half) ** 2, c];
  }
  // The exponential of a twist, a pose.
  function exp(twist) {
    const w = twist.slice(0, 3),
      v = twist.slice(3),
      [a, b, c] = factors(norm(w)),
      W = hat(w),
      W2 = times(W, W);
    const R = eye(3).map((row, i) => row.map((x, j) => x + a * W[i][j] + b * W2[i][j]));
    return pose(R, add(add(v, apply(W, v), b), apply(W2, v), c));
  }
  // The rotation vector of a rotation (3 x 3 or a pose), at most pi long; by the quaternion, so exact near pi too.
  function rotationVector(R) {
    const [[a, b, c], [d, e, f], [g, h, i]] = R;
    const squares = [1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i]; // 4 times those of w, x, y, z
    const rows = [
      [squares[0], h - f, c - g, d - b],
      [h - f, squares[1], b + d, c + g],
      [c - g, b + d, squares[2], f + h],
      [d - b, c + g, f + h, squares[3]],
    ];
    const row = rows[squares.indexOf(Math.max(...squares))];
    const [w, ...xyz] = scale(unit(row), row[0] < 0 ? -1 : 1),
      sine = norm(xyz);
    return scale(xyz, sine < 1e-12 ? 2 / w : (2 * Math.atan2(sine, w)) / sine);
  }
  // The twist whose exponential is T: v = p - w x p/2 + d w x (w x p), with d = (1 - (a/2) cot(a/2))/a^2.
  function log(T) {
    const w = rotationVector(T),
      p = positionOf(T),
      angle = norm(w),
      half = angle / 2,
      wp = cross(w, p);
    const d =
      angle < 0.02
        ? 1 / 12 + angle ** 2 / 720 + angle ** 4 / 30240
        : (1 - half / Math.tan(half)) / angle ** 2;
    return [...w, ...add(add(p, wp, -0.5), cross(w, wp), d)];
  }
  // From A to B along one screw: at share 0 the first, at 1 the second.
  const interpolate = (A, B, share) => times(A, exp(scale(log(times(inverse(A), B)), share)));
  const rotation = (axis, angle) => rotationOf(exp([...scale(axis, angle), 0, 0, 0]));
  // The matrix (6 x 6) that takes a twist from frame b to frame a, given T_ab.
  function adjoint(T) {
    const R = rotationOf(T),
      pR = times(hat(positionOf(T)), R);
    return [...R.map((row) => [...row, 0, 0, 0]), ...R.map((row, i) => [...pR[i], ...row])];
  }
  // The error (rotation vector, translation) from the pose T to the pose target, along the axes of the base.
  const poseError = (T, target) => [
    ...rotationVector(times(rotationOf(target), transpose(rotationOf(T)))),
    ...add(positionOf(target), positionOf(T), -1),
  ];

  // ---- quaternions (w, x, y, z) ----

  const quaternion = (axis, angle) => [Math.cos(angle / 2), ...scale(axis, Math.sin(angle / 2))]; // 2 pi gives -1
  const multiply = ([a, ...u], [b, ...v]) => [
    a * b - dot(u, v),
    ...add(add(scale(v, a), scale(u, b)), cross(u, v)),
  ];

  // ---- the plane: poses are (x, y, theta), body twists (omega, vx, vy) ----

  const planar = ([x, y, theta]) => pose(rotation([0, 0, 1], theta), [x, y, 0]);
  const logPlanar = (A, B) => log(times(inverse(planar(A)), planar(B))).slice(2, 5);
  const expPlanar = (A, [omega, vx, vy]) => {
    const [x, y] = positionOf(times(planar(A), exp([0, 0, omega, vx, vy, 0])));
    return [x, y, A[2] + omega];
  };
  // The pole, in fixed coordinates: the point that a body twist at the pose A leaves at rest; null for a translation.
  const pole = (A, [omega, vx, vy]) =>
    Math.abs(omega) < 1e-9 ? null : move(planar(A), [-vy / omega, vx / omega, 0]).slice(0, 2);
  // Euler's poses of a plan of body velocities [[vx, vy, omega], seconds], and the exact ones, at the same times.
  function propagate(start, plan, dt) {
    const euler = [start],
      exact = [start];
    plan.forEach(([[vx, vy, omega], seconds]) => {
      const steps = Math.ceil((seconds / dt) * (1 - 1e-12)),
        from = exact[exact.length - 1];
      for (let k = 1; k <= steps; k++) {
        const elapsed = k < steps ? k * dt : seconds,
          h = elapsed - (k - 1) * dt;
        const [x, y, theta] = euler[euler.length - 1],
          c = Math.cos(theta),
          s = Math.sin(theta);
        euler.push([x + h * (c * vx - s * vy), y + h * (s * vx + c * vy), theta + h * omega]);
        exact.push(expPlanar(from, [omega * elapsed, vx * elapsed, vy * elapsed]));
      }
    });
    return { euler, exact };
  }

  // ---- circles on a sphere ----

  // Where the circles of the unit vectors p1 about k1 and p2 about k2 meet: two points, one or none.
  function meetings(k1, k2, p1, p2) {
    const c = dot(k1, k2),
      h1 = dot(k1, p1),
      h2 = dot(k2, p2),
      n = cross(k1, k2),
      s2 = dot(n, n);
    if (s2 < 1e-20) return [];
    const a = (h1 - h2 * c) / s2,
      b = (h2 - h1 * c) / s2,
      rest = 1 - a * a - b * b - 2 * a * b * c;
    if (rest < -1e-12) return [];
    const foot = add(scale(k1, a), k2, b),
      g = Math.sqrt(Math.max(0, rest) / s2);
    return g < 1e-6 ? [foot] : [add(foot, n, g), add(foot, n, -g)];
  }
  // The angle about the unit axis k that takes p to q, both on one circle about it.
  const angleAbout = (k, p, q) =>
    Math.atan2(dot(k, cross(p, q)), dot(p, q) - dot(k, p) * dot(k, q));

  // ---- serial arms: {screws: n x 6, home: n + 1 poses} ----

  // The products of exponentials up to each joint, the identity first: where each body is, seen from q = 0.
  const bodies = ({ screws }, q) =>
    screws.reduce(
      (found, screw, i) => [...found, times(found[i], exp(scale(screw, q[i])))],
      [eye(4)],
    );
  const frames = (arm, q, moved = bodies(arm, q)) =>
    arm.home.map((M, i) => times(moved[Math.min(i + 1, q.length)], M));
  const spaceJacobian = (arm, q, moved = bodies(arm, q)) =>
    transpose(arm.screws.map((screw, i) => apply(adjoint(moved[i]), screw)));
  // Columns (omega, v), v the velocity of the end-effector's origin, along the axes of the base.
  function geometricJacobian(arm, q) {
    const moved = bodies(arm, q),
      p = positionOf(times(moved[q.length], arm.home[q.length]));
    return transpose(
      transpose(spaceJacobian(arm, q, moved)).map((column) => {
        const omega = column.slice(0, 3);
        return [...omega, ...add(column.slice(3), cross(omega, p))];
      }),
    );
  }
  // Joint positions of a planar arm with these link lengths, base first, and its 2 x n Jacobian.
  function planarPoints(lengths, q) {
    let angle = 0,
      [x, y] = [0, 0];
    return [
      [x, y],
      ...lengths.map((l, i) => {
        angle += q[i];
        return [(x += l * Math.cos(angle)), (y += l * Math.sin(angle))];
      }),
    ];
  }
  function planarJacobian(lengths, q) {
    const P = planarPoints(lengths, q),
      [x, y] = P[lengths.length];
    return [q.map((_, i) => P[i][1] - y), q.map((_, i) => x - P[i][0])];
  }
  // The joint angles of a planar arm with two links that reach a point, q2 >= 0; null out of reach.
  function twoLink([l1, l2], [x, y]) {
    const c = (x * x + y * y - l1 * l1 - l2 * l2) / (2 * l1 * l2);
    if (Math.abs(c) > 1) return null;
    const q2 = Math.acos(c);
    return [Math.atan2(y, x) - Math.atan2(l2 * Math.sin(q2), l1 + l2 * c), q2];
  }

  // ---- linear algebra ----

  // Solve A x = b by elimination with pivots.
  function solve(A, b) {
    const n = b.length,
      M = A.map((row, i) => [...row, b[i]]),
      x = Array(n).fill(0);
    for (let k = 0; k < n; k++) {
      for (let i = k + 1; i < n; i++)
        if (Math.abs(M[i][k]) > Math.abs(M[k][k])) [M[k], M[i]] = [M[i], M[k]];
      for (let i = k + 1; i < n; i++) M[i] = add(M[i], M[k], -M[i][k] / M[k][k]);
    }
    for (let i = n - 1; i >= 0; i--) x[i] = (M[i][n] - dot(M[i].slice(0, n), x)) / M[i][i];
    return x;
  }
  // The damped step J^T (J J^T + damping I)^-1 e.
  function dampedStep(J, e, damping) {
    const A = times(J, transpose(J)).map((row, i) =>
      row.map((x, j) => (i === j ? x + damping : x)),
    );
    return apply(transpose(J), solve(A, e));
  }
  // Coefficients c for which A c is nearest to y.
  const leastSquares = (A, y) => solve(times(transpose(A), A), apply(transpose(A), y));
  // The pose that moves points `from` nearest to points `to`, their partners, by least squares (Horn's quaternion).
  function register(from, to) {
    const mean = (points) =>
      scale(
        points.reduce((sum, p) => add(sum, p)),
        1 / points.length,
      );
    const [a, b] = [from, to].map((points) => points.map((p) => add(p, mean(points), -1)));
    const S = times(transpose(a), b),
      [u, v, w] = [
        [1, 2],
        [2, 0],
        [0, 1],
      ].map(([i, j]) => S[i][j] - S[j][i]);
    const trace = S[0][0] + S[1][1] + S[2][2];
    const N = eye(3).map((row, i) => row.map((x, j) => S[i][j] + S[j][i] - x * trace));
    const {
      vectors: [[c, ...axis]],
    } = eigen([[trace, u, v, w], ...N.map((row, i) => [[u, v, w][i], ...row])]);
    const R = rotation(unit(axis), 2 * Math.atan2(norm(axis), c));
    return pose(R, add(mean(to), apply(R, mean(from)), -1));
  }
  // How far a ray from the origin runs to the first of some triangles, in its own lengths; Infinity if it meets none.
  const firstHit = (ray, triangles) =>
    Math.min(
      ...triangles.map(([a, b, c]) => {
        const normal = cross(add(b, a, -1), add(c, a, -1)),
          t = dot(normal, a) / dot(normal, ray),
          p = scale(ray, t);
        const isInside = [
          [a, b],
          [b, c],
          [c, a],
        ].every(
          ([from, to]) =>
            dot(normal, cross(add(to, from, -1), add(p, from, -1))) >= -1e-9 * dot(normal, normal),
        ); // no gaps at edges
        return isInside && t > 0 ? t : Infinity;
      }),
    );
  // Eigenvalues (descending) and unit eigenvectors of a symmetric matrix, by Jacobi's rotations.
  function eigen(A) {
    const n = A.length,
      M = A.map((row) => [...row]),
      V = eye(n);
    for (let sweep = 0; sweep < 30; sweep++) {
      for (let p = 0; p < n; p++)
        for (let r = p + 1; r < n; r++) {
          if (Math.abs(M[p][r]) < 1e-300) continue;
          const theta = (M[r][r] - M[p][p]) / (2 * M[p][r]);
          const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(theta, 1)),
            c = 1 / Math.hypot(t, 1),
            s = t * c;
          const rotate = (row) =>
            ([row[p], row[r]] = [c * row[p] - s * row[r], s * row[p] + c * row[r]]);
          [...M, ...V].forEach(rotate);
          [M[p], M[r]] = [add(scale(M[p], c), M[r], -s), add(scale(M[p], s), M[r], c)];
        }
    }
    const order = [...Array(n).keys()].sort((i, j) => M[j][j] - M[i][i]);
    return { values: order.map((i) => M[i][i]), vectors: order.map((i) => V.map((row) => row[i])) };
  }
  const singularValues = (J) =>
    eigen(times(J, transpose(J))).values.map((x) => Math.sqrt(Math.max(0, x)));
  // Unit joint velocities that leave the end-effector at rest, for a 6 x 7 Jacobian; null at a singularity.
  function nullVector(J) {
    const { values, vectors } = eigen(times(transpose(J), J));
    return values[5] > 1e-10 ? vectors[6] : null;
  }
  // Joint angles within limits that reach a pose, or come nearest to it, by steps of damped least squares. A step that
  // does not lessen the error is not taken, and raises the damping: so they come to rest out of reach, too.
  function reach(arm, q, target, limits, most = 200) {
    const error = (x) => poseError(frames(arm, x)[x.length], target);
    let angles = q,
      e = error(q),
      damping = 4e-4,
      moved = 1;
    for (let k = 0; k < most && norm(e) > 1e-9 && moved > 1e-6 && damping < 1e4; k++) {
      const part = k < 15 ? Math.min(1, 0.1 / norm(e.slice(3))) : 1; // small steps first: no jump to another solution
      const step = dampedStep(geometricJacobian(arm, angles), scale(e, part), damping);
      const next = angles.map((x, i) =>
          Math.min(limits[i][1], Math.max(limits[i][0], x + step[i])),
        ),
        left = error(next);
      const isNearer = norm(left) < norm(e);
      if (isNearer) [moved, angles, e] = [norm(add(next, angles, -1)), next, left];
      damping = isNearer ? Math.max(1e-5, damping / 3) : 9 * damping;
    }
    return angles;
  }

  return {
    eye,
    dot,
    norm,
    add,
    scale,
    cross,
    unit,
    transpose,
    times,
    apply,
    sampled,
    wrap,
    pose,
    rotationOf,
    positionOf,
    move,
    inverse,
    exp,
    log,
    rotationVector,
    interpolate,
    rotation,
    poseError,
    quaternion,
    multiply,
    planar,
    logPlanar,
    expPlanar,
    pole,
    propagate,
    meetings,
    angleAbout,
    bodies,
    frames,
    spaceJacobian,
    geometricJacobian,
    planarPoints,
    planarJacobian,
    twoLink,
    dampedStep,
    leastSquares,
    eigen,
    register,
    firstHit,
    singularValues,
    nullVector,
    reach,
  };
})();
