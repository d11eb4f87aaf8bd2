// Vectors and matrices, for figures that move without a kernel. Vectors are arrays, matrices arrays
// of rows. Tests compare the functions of this folder with those of course_lib. Nothing here draws:
// it runs in a browser and in node.
globalThis.course = globalThis.course || { kinds: {} };
globalThis.course.motion = (() => {
  "use strict";
  const eye = (n) =>
    Array.from({ length: n }, (_, i) => Array.from({ length: n }, (_, j) => (i === j ? 1 : 0)));
  const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
  const norm = (a) => Math.hypot(...a);
  /** a + factor b */
  const add = (a, b, factor = 1) => a.map((x, i) => x + factor * b[i]);
  const subtract = (a, b) => a.map((x, i) => x - b[i]);
  const scale = (a, factor) => a.map((x) => factor * x);
  const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
  /** The unit vector along a; the zero vector stays. */
  const unit = (a) => scale(a, 1 / (norm(a) || 1));
  const transpose = (A) => A[0].map((_, j) => A.map((row) => row[j]));
  const times = (A, B) =>
    A.map((row) => B[0].map((_, j) => row.reduce((sum, x, k) => sum + x * B[k][j], 0)));
  const apply = (A, v) => A.map((row) => dot(row, v));
  /** The matrix of the cross product: hat(a) b = a x b. */
  const hat = ([x, y, z]) => [
    [0, -z, y],
    [z, 0, -x],
    [-y, x, 0],
  ];
  /** A function of a share, at the n + 1 ends of n equal steps from 0 to 1. */
  const sampled = (n, f) => Array.from({ length: n + 1 }, (_, i) => f(i / n));
  /** An angle from -pi to pi. */
  const wrap = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));

  /** Solve A x = b by elimination, with the largest entry of a column as its pivot. */
  function solve(A, b) {
    const n = b.length;
    const rows = A.map((row, i) => [...row, b[i]]);
    for (let k = 0; k < n; k++) {
      for (let i = k + 1; i < n; i++) {
        const isLarger = Math.abs(rows[i][k]) > Math.abs(rows[k][k]);
        if (isLarger) [rows[k], rows[i]] = [rows[i], rows[k]];
      }
      for (let i = k + 1; i < n; i++) {
        rows[i] = add(rows[i], rows[k], -rows[i][k] / rows[k][k]);
      }
    }
    const x = Array(n).fill(0);
    for (let i = n - 1; i >= 0; i--) {
      x[i] = (rows[i][n] - dot(rows[i].slice(0, n), x)) / rows[i][i];
    }
    return x;
  }

  /** The damped step J^T (J J^T + damping I)^-1 e. */
  function dampedStep(J, e, damping) {
    const A = times(J, transpose(J));
    for (let i = 0; i < A.length; i++) A[i][i] += damping;
    return apply(transpose(J), solve(A, e));
  }

  /** The coefficients c for which A c is nearest to y, by the normal equations. */
  const leastSquares = (A, y) => solve(times(transpose(A), A), apply(transpose(A), y));

  /**
   * Eigenvalues (descending) and unit eigenvectors of a symmetric matrix, by Jacobi's rotations:
   * each makes one entry off the diagonal zero, and after few sweeps all of them are.
   * @returns {{values: number[], vectors: number[][]}}
   */
  function eigen(symmetric) {
    const n = symmetric.length;
    const A = symmetric.map((row) => [...row]);
    const V = eye(n);
    for (let sweep = 0; sweep < 30; sweep++) {
      for (let p = 0; p < n; p++) {
        for (let r = p + 1; r < n; r++) rotateJacobi(A, V, p, r);
      }
    }
    const order = [...Array(n).keys()].sort((i, j) => A[j][j] - A[i][i]);
    return {
      values: order.map((i) => A[i][i]),
      vectors: order.map((i) => V.map((row) => row[i])),
    };
  }
  /** Rotate the axes p and r of A, and the columns of V with them, so that A[p][r] becomes 0. */
  function rotateJacobi(A, V, p, r) {
    if (Math.abs(A[p][r]) < 1e-300) return; // it is zero, and would only be divided by
    const theta = (A[r][r] - A[p][p]) / (2 * A[p][r]);
    // The smaller root t of t^2 + 2 theta t = 1, which is the tangent of the angle.
    const sign = theta < 0 ? -1 : 1;
    const t = sign / (Math.abs(theta) + Math.hypot(theta, 1));
    const c = 1 / Math.hypot(t, 1);
    const s = t * c;
    for (const row of [...A, ...V]) {
      const [x, y] = [row[p], row[r]];
      row[p] = c * x - s * y;
      row[r] = s * x + c * y;
    }
    const [rowP, rowR] = [A[p], A[r]];
    A[p] = add(scale(rowP, c), rowR, -s);
    A[r] = add(scale(rowP, s), rowR, c);
  }
  const singularValues = (J) =>
    eigen(times(J, transpose(J))).values.map((x) => Math.sqrt(Math.max(0, x)));

  return {
    eye,
    dot,
    norm,
    add,
    subtract,
    scale,
    cross,
    unit,
    transpose,
    times,
    apply,
    hat,
    sampled,
    wrap,
    solve,
    dampedStep,
    leastSquares,
    eigen,
    singularValues,
  };
})();
