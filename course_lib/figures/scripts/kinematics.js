// The kinematics that the toys need on top of motion.js: rotations, planar motions, Jacobians, damped steps. Vectors are
// arrays, matrices arrays of rows, poses 4 x 4; radians and metres. The same functions as in course_lib (rotations, rigid,
// arms), with which tests compare them. Runs in a browser and in node.
globalThis.course = globalThis.course || { kinds: {} };
globalThis.course.kinematics = (() => {
  "use strict";
  const motion = globalThis.course.motion;
  const eye = (n) => Array.from({ length: n }, (_, i) => Array.from({ length: n }, (_, j) => (i === j ? 1 : 0)));
  const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
  const norm = (a) => Math.hypot(...a);
  const add = (a, b, s = 1) => a.map((x, i) => x + s * b[i]);
  const scale = (a, s) => a.map((x) => s * x);
  const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
  const unit = (a) => scale(a, 1 / norm(a));
  const transpose = (A) => A[0].map((_, j) => A.map((row) => row[j]));
  const times = (A, B) => A.map((row) => B[0].map((_, j) => row.reduce((sum, x, k) => sum + x * B[k][j], 0)));
  const apply = (A, v) => A.map((row) => dot(row, v));
  const hat = ([x, y, z]) => [[0, -z, y], [z, 0, -x], [-y, x, 0]];

  // ---- rotations ----

  const matrix = (T) => [T.slice(0, 4), T.slice(4, 8), T.slice(8, 12), [0, 0, 0, 1]]; // of the 12 numbers of motion.js
  const flat = (T) => T.slice(0, 3).flat();
  const rotation = (axis, angle) => rotationOf(matrix(motion.exp([...scale(axis, angle), 0, 0, 0])));
  // Unit quaternion (w, x, y, z) of an angle about a unit axis, not reduced: 2 pi gives -1.
  const quaternion = (axis, angle) => [Math.cos(angle / 2), ...scale(axis, Math.sin(angle / 2))];
  const multiply = ([a, ...u], [b, ...v]) => [a * b - dot(u, v), ...add(add(scale(v, a), scale(u, b)), cross(u, v))];
  // R = Rz(yaw) Ry(pitch) Rx(roll).
  const fromEuler = ([yaw, pitch, roll]) =>
    times(times(rotation([0, 0, 1], yaw), rotation([0, 1, 0], pitch)), rotation([1, 0, 0], roll));
  // (yaw, pitch, roll); where pitch is +-90 degrees only a sum is determined, and roll is 0.
  function toEuler(R) {
    const flat = Math.hypot(R[0][0], R[1][0]), pitch = Math.atan2(-R[2][0], flat);
    if (flat < 1e-9) return [Math.atan2(-R[0][1], R[1][1]), pitch, 0];
    return [Math.atan2(R[1][0], R[0][0]), pitch, Math.atan2(R[2][1], R[2][2])];
  }

  // ---- rigid motions ----

  const pose = (R, p) => [...R.map((row, i) => [...row, p[i]]), [0, 0, 0, 1]];
  const rotationOf = (T) => T.slice(0, 3).map((row) => row.slice(0, 3));
  const positionOf = (T) => T.slice(0, 3).map((row) => row[3]);
  const move = (T, p) => add(apply(rotationOf(T), p), positionOf(T));
  const inverse = (T) => matrix(motion.inverse(flat(T)));
  // Planar poses are (x, y, theta). The twist (omega, vx, vy) in the body's frame that leads from A to B in unit time.
  function logPlanar(A, B) {
    const turn = B[2] - A[2], omega = Math.atan2(Math.sin(turn), Math.cos(turn));
    const c = Math.cos(A[2]), s = Math.sin(A[2]), dx = B[0] - A[0], dy = B[1] - A[1];
    const p = [c * dx + s * dy, -s * dx + c * dy], h = omega / 2;
    const k = Math.abs(h) < 1e-4 ? 1 - h * h / 3 : h / Math.tan(h);
    return [omega, k * p[0] + h * p[1], -h * p[0] + k * p[1]];
  }
  // The planar pose reached from A by a constant body twist for unit time.
  function expPlanar(A, [omega, vx, vy]) {
    const small = Math.abs(omega) < 1e-4, a = small ? 1 - omega ** 2 / 6 : Math.sin(omega) / omega;
    const b = small ? omega / 2 : (2 * Math.sin(omega / 2) ** 2) / omega, c = Math.cos(A[2]), s = Math.sin(A[2]);
    const x = a * vx - b * vy, y = b * vx + a * vy;
    return [A[0] + c * x - s * y, A[1] + s * x + c * y, A[2] + omega];
  }
  // The pole, in fixed coordinates: the point that a body twist at the pose A leaves at rest; null for a translation.
  const pole = (A, [omega, vx, vy]) => {
    if (Math.abs(omega) < 1e-9) return null;
    const c = Math.cos(A[2]), s = Math.sin(A[2]), x = -vy / omega, y = vx / omega;
    return [A[0] + c * x - s * y, A[1] + s * x + c * y];
  };

  // Euler's poses of a plan of body velocities [[vx, vy, omega], seconds], and the exact ones, at the same times.
  function propagate(start, plan, dt) {
    const euler = [start], exact = [start];
    plan.forEach(([[vx, vy, omega], seconds]) => {
      const steps = Math.ceil((seconds / dt) * (1 - 1e-12)), from = exact[exact.length - 1];
      for (let k = 1; k <= steps; k++) {
        const elapsed = k < steps ? k * dt : seconds, h = elapsed - (k - 1) * dt;
        const [x, y, theta] = euler[euler.length - 1], c = Math.cos(theta), s = Math.sin(theta);
        euler.push([x + h * (c * vx - s * vy), y + h * (s * vx + c * vy), theta + h * omega]);
        exact.push(expPlanar(from, [omega * elapsed, vx * elapsed, vy * elapsed]));
      }
    });
    return { euler, exact };
  }
  // Where the circles of the unit vectors p1 about k1 and p2 about k2 meet: two points, one or none.
  function meetings(k1, k2, p1, p2) {
    const c = dot(k1, k2), h1 = dot(k1, p1), h2 = dot(k2, p2), n = cross(k1, k2), s2 = dot(n, n);
    if (s2 < 1e-20) return [];
    const a = (h1 - h2 * c) / s2, b = (h2 - h1 * c) / s2, rest = 1 - a * a - b * b - 2 * a * b * c;
    if (rest < -1e-12) return [];
    const foot = add(scale(k1, a), k2, b), g = Math.sqrt(Math.max(0, rest) / s2);
    return g < 1e-9 ? [foot] : [add(foot, n, g), add(foot, n, -g)];
  }
  // The angle about the unit axis k that takes p to q, both on one circle about it.
  const angleAbout = (k, p, q) => Math.atan2(dot(k, cross(p, q)), dot(p, q) - dot(k, p) * dot(k, q));

  // ---- serial arms: {screws: n x 6, home: n + 1 poses} ----

  // The poses that the product of exponentials gives each body: the base, then one after each joint.
  const bodies = (arm, q) => motion.chain(arm.screws, q).map(matrix);
  const frames = (arm, q) => {
    const moved = bodies(arm, q);
    return arm.home.map((M, i) => times(moved[Math.min(i + 1, q.length)], M));
  };
  // Columns (omega, v), the velocity of the end-effector's origin along the axes of the base.
  function geometricJacobian(arm, q) {
    const moved = bodies(arm, q), n = q.length, p = positionOf(times(moved[n], arm.home[n]));
    return transpose(arm.screws.map((S, i) => {
      const R = rotationOf(moved[i]), omega = apply(R, S.slice(0, 3));
      const v = add(apply(R, S.slice(3)), cross(positionOf(moved[i]), omega));
      return [...omega, ...add(v, cross(omega, p))];
    }));
  }
  // Joint positions of a planar arm with these link lengths, base first, and its 2 x n Jacobian.
  function planarPoints(lengths, q) {
    let angle = 0, at = [0, 0];
    return [at, ...lengths.map((l, i) => (angle += q[i], at = [at[0] + l * Math.cos(angle), at[1] + l * Math.sin(angle)]))];
  }
  function planarJacobian(lengths, q) {
    const P = planarPoints(lengths, q), [x, y] = P[lengths.length];
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
    const n = b.length, M = A.map((row, i) => [...row, b[i]]);
    for (let k = 0; k < n; k++) {
      const best = M.slice(k).reduce((top, row, i) => (Math.abs(row[k]) > Math.abs(M[top][k]) ? k + i : top), k);
      [M[k], M[best]] = [M[best], M[k]];
      for (let i = k + 1; i < n; i++) {
        const f = M[i][k] / M[k][k];
        for (let j = k; j <= n; j++) M[i][j] -= f * M[k][j];
      }
    }
    const x = Array(n).fill(0);
    for (let i = n - 1; i >= 0; i--) x[i] = (M[i][n] - dot(M[i].slice(0, n), x)) / M[i][i];
    return x;
  }
  // The damped step J^T (J J^T + damping I)^-1 e.
  function dampedStep(J, e, damping) {
    const A = times(J, transpose(J)).map((row, i) => row.map((x, j) => (i === j ? x + damping : x)));
    return apply(transpose(J), solve(A, e));
  }
  // The plane z = a + b x + c y nearest to points (x, y) with heights z: (a, b, c).
  function fitPlane(points, z) {
    const A = points.map(([x, y]) => [1, x, y]), At = transpose(A);
    return solve(times(At, A), apply(At, z));
  }
  // Coefficients, constant first, of the polynomial nearest to the values y at x.
  function fitPolynomial(x, y, degree) {
    const A = x.map((u) => Array.from({ length: degree + 1 }, (_, k) => u ** k)), At = transpose(A);
    return solve(times(At, A), apply(At, y));
  }
  // For an arm with two links of 1 m and n distances r of its tip in a cell: its bend q2 by a polynomial (direct), and by
  // the root of one for the square of q2 (rooted); the largest errors of q2, and of the tip, whose direction is exact.
  function bendFits(from, to, degree, n) {
    const u = Array.from({ length: n }, (_, i) => (2 * i) / (n - 1) - 1), r = u.map((t) => ((1 - t) * from + (1 + t) * to) / 2);
    const bend = r.map((x) => 2 * Math.acos(Math.min(1, x / 2)));
    const fit = (y) => { const c = fitPolynomial(u, y, degree); return u.map((t) => c.reduceRight((sum, each) => sum * t + each, 0)); };
    const direct = fit(bend), square = fit(bend.map((b) => b * b)), rooted = square.map((s) => Math.sqrt(Math.max(0, s)));
    const errors = (found) => ({
      angle: Math.max(...found.map((b, i) => Math.abs(b - bend[i]))),
      tip: Math.max(...found.map((b, i) => Math.abs(2 * Math.cos(b / 2) - r[i]))),
    });
    return { r, direct, square, rooted, directError: errors(direct), rootedError: errors(rooted) };
  }
  // Eigenvalues (descending) and unit eigenvectors of a symmetric matrix, by Jacobi's rotations.
  function eigen(A) {
    const n = A.length, M = A.map((row) => [...row]), V = eye(n);
    for (let sweep = 0; sweep < 30; sweep++) {
      for (let p = 0; p < n; p++) for (let r = p + 1; r < n; r++) {
        if (Math.abs(M[p][r]) < 1e-300) continue;
        const theta = (M[r][r] - M[p][p]) / (2 * M[p][r]);
        const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(theta, 1)), c = 1 / Math.hypot(t, 1), s = t * c;
        for (let k = 0; k < n; k++) [M[k][p], M[k][r]] = [c * M[k][p] - s * M[k][r], s * M[k][p] + c * M[k][r]];
        for (let k = 0; k < n; k++) [M[p][k], M[r][k]] = [c * M[p][k] - s * M[r][k], s * M[p][k] + c * M[r][k]];
        for (let k = 0; k < n; k++) [V[k][p], V[k][r]] = [c * V[k][p] - s * V[k][r], s * V[k][p] + c * V[k][r]];
      }
    }
    const order = [...Array(n).keys()].sort((i, j) => M[j][j] - M[i][i]);
    return { values: order.map((i) => M[i][i]), vectors: order.map((i) => V.map((row) => row[i])) };
  }
  // Unit joint velocities that leave the end-effector at rest, for a 6 x 7 Jacobian of full rank: signed minors.
  function nullVector(J) {
    const minor = (k) => {
      const M = J.map((row) => row.filter((_, j) => j !== k));
      let product = 1;
      for (let c = 0; c < M.length; c++) {
        const best = M.slice(c).reduce((top, row, i) => (Math.abs(row[c]) > Math.abs(M[top][c]) ? c + i : top), c);
        if (M[best][c] === 0) return 0;
        if (best !== c) { [M[c], M[best]] = [M[best], M[c]]; product = -product; }
        product *= M[c][c];
        for (let i = c + 1; i < M.length; i++) {
          const f = M[i][c] / M[c][c];
          for (let j = c; j < M.length; j++) M[i][j] -= f * M[c][j];
        }
      }
      return product;
    };
    const v = J[0].map((_, k) => (k % 2 ? -1 : 1) * minor(k)), size = norm(v);
    return size > 1e-12 ? scale(v, 1 / size) : null;
  }
  // The error (rotation vector, translation) from the pose T to the pose target, along the axes of the base.
  function poseError(T, target) {
    const R = times(rotationOf(target), transpose(rotationOf(T)));
    return [...motion.rotationVector(flat(pose(R, [0, 0, 0]))), ...add(positionOf(target), positionOf(T), -1)];
  }
  // The bodies of a plotly mesh (as course_lib.figures.solids draws them, at the poses `at`), each in its own frame at
  // q = 0: {vertices, faces, colours, bodies, palette}. counts: how many vertices each body has.
  function meshOf(trace, counts, at) {
    const sizes = { i1: Int8Array, u1: Uint8Array, i2: Int16Array, u2: Uint16Array, i4: Int32Array, u4: Uint32Array, f4: Float32Array, f8: Float64Array };
    const read = (values) => values.bdata // plotly packs numpy's arrays
      ? Array.from(new sizes[values.dtype](Uint8Array.from(atob(values.bdata), (letter) => letter.charCodeAt(0)).buffer)) : values;
    const [x, y, z, i, j, k, tints] = ["x", "y", "z", "i", "j", "k", "intensity"].map((name) => read(trace[name]));
    const own = motion.localVertices({ x, y, z }, counts, at.map(flat));
    return {
      vertices: own.x.map((value, n) => [value, own.y[n], own.z[n]]),
      faces: i.map((a, n) => [a, j[n], k[n]]),
      colours: i.map((a) => tints[a]),
      bodies: counts.flatMap((count, body) => Array(count).fill(body)),
      palette: trace.colorscale.filter((_, n) => n % 2).map(([, colour]) => colour),
    };
  }

  return {
    eye, dot, norm, add, scale, cross, unit, transpose, times, apply, hat, rotation, quaternion, multiply, fromEuler,
    toEuler, pose, rotationOf, positionOf, move, inverse, logPlanar, expPlanar, pole, propagate, meetings, angleAbout, bodies, frames,
   
    geometricJacobian, planarPoints, planarJacobian, twoLink, solve, dampedStep, fitPlane, fitPolynomial, bendFits, eigen, nullVector, poseError,
    meshOf,
  };
})();
