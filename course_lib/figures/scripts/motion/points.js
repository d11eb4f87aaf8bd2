// Points in space: circles on a sphere, a ray and triangles, and the pose between two sets of
// points.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const { add, cross, dot, norm, scale, subtract, times, transpose } = M;

  /**
   * Where the circles of the unit vectors p1 about k1 and p2 about k2 meet: two points, one or
   * none.
   *
   * A point z = a k1 + b k2 + g n, n = k1 x k2, is on both circles if k1.z = k1.p1 and k2.z =
   * k2.p2, which gives a and b, and if it has the length 1, which gives g (Paden and Kahan's second
   * subproblem).
   */
  function meetings(k1, k2, p1, p2) {
    const c = dot(k1, k2);
    const h1 = dot(k1, p1);
    const h2 = dot(k2, p2);
    const n = cross(k1, k2);
    const n2 = dot(n, n);
    if (n2 < 1e-20) return []; // one axis, on which a and b cannot be told apart
    const a = (h1 - h2 * c) / n2;
    const b = (h2 - h1 * c) / n2;
    const rest = 1 - a * a - b * b - 2 * a * b * c; // g^2 n.n
    if (rest < -1e-12) return [];
    const foot = add(scale(k1, a), k2, b);
    const g = Math.sqrt(Math.max(0, rest) / n2);
    if (g < 1e-6) return [foot];
    return [add(foot, n, g), add(foot, n, -g)];
  }
  /** The angle about the unit axis k that takes p to q, both on one circle about it. */
  function angleAbout(k, p, q) {
    const sine = dot(k, cross(p, q));
    const cosine = dot(p, q) - dot(k, p) * dot(k, q);
    return Math.atan2(sine, cosine);
  }

  /**
   * How far a ray from the origin runs to the first of some triangles, in its own lengths; Infinity
   * if it meets none.
   */
  const firstHit = (ray, triangles) =>
    Math.min(...triangles.map((triangle) => hitTriangle(ray, triangle)));

  function hitTriangle(ray, [a, b, c]) {
    const normal = cross(subtract(b, a), subtract(c, a));
    const length = dot(normal, a) / dot(normal, ray);
    const p = scale(ray, length);
    const tolerance = 1e-9 * dot(normal, normal); // so that no gap is left between two triangles
    const edges = [
      [a, b],
      [b, c],
      [c, a],
    ];
    const isInside = edges.every(([from, to]) => {
      const side = cross(subtract(to, from), subtract(p, from));
      return dot(normal, side) >= -tolerance;
    });
    return isInside && length > 0 ? length : Infinity;
  }

  /**
   * The pose that moves points `from` nearest to points `to`, their partners, by least squares. The
   * quaternion of its rotation is the eigenvector of the largest eigenvalue of Horn's matrix (4 x
   * 4), made of S = sum a b^T.
   */
  function register(from, to) {
    const mean = (points) =>
      scale(
        points.reduce((sum, p) => add(sum, p)),
        1 / points.length,
      );
    const centred = (points) => points.map((p) => subtract(p, mean(points)));
    const S = times(transpose(centred(from)), centred(to));
    const trace = S[0][0] + S[1][1] + S[2][2];
    const skew = [S[1][2] - S[2][1], S[2][0] - S[0][2], S[0][1] - S[1][0]];
    const symmetric = M.eye(3).map((row, i) => row.map((x, j) => S[i][j] + S[j][i] - x * trace));
    const horn = [[trace, ...skew], ...symmetric.map((row, i) => [skew[i], ...row])];
    const [w, ...xyz] = M.eigen(horn).vectors[0];
    const R = M.rotation(M.unit(xyz), 2 * Math.atan2(norm(xyz), w));
    return M.pose(R, subtract(mean(to), M.apply(R, mean(from))));
  }

  Object.assign(M, { meetings, angleAbout, firstHit, register });
})();
