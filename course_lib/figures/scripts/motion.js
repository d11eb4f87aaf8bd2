// Rigid motions for the figures that move in a page without a kernel: poses, their exponentials and logarithms,
// the product of exponentials of an arm, and the vertices of bodies at their poses. No dependency, no drawing.
//
// What a figure brings along stands in `layout.meta.course`:
//
//     {"kind": "film" | "toy:<name>",      which script starts it: window.course.kinds[kind]
//      "scripts": ["motion", "film"],      the files of this folder that the page loads, in this order
//      "trace": 2,                         the number of the mesh3d trace that holds all moving bodies
//      "counts": [140, 212, ...],          how many of its vertices belong to each body, in order
//      ...}                                what the kind needs besides
//
// A film has "times": [t0, t1, ...] in seconds, and for each time and body a rotation vector and a position:
// "rotations": [[[w1, w2, w3], ... a body], ... a time] and "positions" likewise. The vertices in the trace are those
// at the first time, so that no second array of them is needed: `localVertices` takes them back to the frames of
// their bodies.
// A toy has its model instead, for example "screws": [[w, v], ...] for `chain`, whose poses are those of the bodies
// relative to where they are at q = 0, body 0 standing still.
//
// A pose is an array of 12 numbers: the rows of [R p]. A twist is (w, v), as in the Python library.
(() => {
  "use strict";
  const identity = () => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const sum = (...vectors) => [0, 1, 2].map((i) => vectors.reduce((s, [factor, v]) => s + factor * v[i], 0));

  // (1 - cos a)/a^2 and (a - sin a)/a^3. Below 0.02 the closed form of the second loses digits: two terms of its
  // series and the third are exact to the last one there.
  function factors(angle) {
    const a2 = angle * angle;
    const half = angle / 2;
    const b = angle < 1e-8 ? 0.5 : 0.5 * (Math.sin(half) / half) ** 2;
    const c = angle < 0.02 ? 1 / 6 - a2 / 120 + (a2 * a2) / 5040 : (angle - Math.sin(angle)) / (a2 * angle);
    return [b, c];
  }

  const sinc = (angle) => (angle < 1e-8 ? 1 : Math.sin(angle) / angle);

  // The pose that a twist leads to in unit time.
  function exp(twist) {
    const w = twist.slice(0, 3);
    const v = twist.slice(3, 6);
    const angle = Math.hypot(...w);
    const [b, c] = factors(angle);
    const a = sinc(angle);
    const T = identity();
    const W = [0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0];
    for (let i = 0; i < 3; i++) {
      for (let j = 0; j < 3; j++) {
        const square = w[i] * w[j] - (i === j ? angle * angle : 0); // of hat(w)
        T[4 * i + j] = (i === j ? 1 : 0) + a * W[3 * i + j] + b * square;
      }
    }
    const wv = cross(w, v);
    const p = sum([1, v], [b, wv], [c, cross(w, wv)]);
    [T[3], T[7], T[11]] = p;
    return T;
  }

  // The rotation vector of a pose, at most pi long. By the quaternion, so that it is exact near pi as well.
  function rotationVector(T) {
    const [a, b, c, , d, e, f, , g, h, i] = T;
    const squares = [1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i]; // 4 times those of w, x, y, z
    const k = squares.indexOf(Math.max(...squares));
    const rows = [
      [squares[0], h - f, c - g, d - b],
      [h - f, squares[1], b + d, c + g],
      [c - g, b + d, squares[2], f + h],
      [d - b, c + g, f + h, squares[3]],
    ];
    const length = Math.hypot(...rows[k]);
    const sign = rows[k][0] < 0 ? -1 : 1;
    const [w, x, y, z] = rows[k].map((value) => (sign * value) / length);
    const sine = Math.hypot(x, y, z);
    const scale = sine < 1e-12 ? 2 / w : (2 * Math.atan2(sine, w)) / sine;
    return [scale * x, scale * y, scale * z];
  }

  // The twist whose exponential is T.
  function log(T) {
    const w = rotationVector(T);
    const p = [T[3], T[7], T[11]];
    const angle = Math.hypot(...w);
    // v = p - w x p/2 + d w x (w x p), with d = (1 - (a/2) cot(a/2))/a^2
    const half = angle / 2;
    const d = angle < 0.02 ? 1 / 12 + angle ** 2 / 720 + angle ** 4 / 30240 : (1 - half / Math.tan(half)) / angle ** 2;
    const wp = cross(w, p);
    return [...w, ...sum([1, p], [-0.5, wp], [d, cross(w, wp)])];
  }

  function multiply(A, B) {
    const T = new Array(12);
    for (let i = 0; i < 12; i += 4) {
      for (let j = 0; j < 4; j++) {
        T[i + j] = A[i] * B[j] + A[i + 1] * B[4 + j] + A[i + 2] * B[8 + j] + (j === 3 ? A[i + 3] : 0);
      }
    }
    return T;
  }

  function inverse(T) {
    const [a, b, c, x, d, e, f, y, g, h, i, z] = T;
    return [a, d, g, -(a * x + d * y + g * z), b, e, h, -(b * x + e * y + h * z), c, f, i, -(c * x + f * y + i * z)];
  }

  const apply = (T, p) => [0, 4, 8].map((i) => T[i] * p[0] + T[i + 1] * p[1] + T[i + 2] * p[2] + T[i + 3]);

  // From A to B along one screw: at share 0 the first, at 1 the second.
  const interpolate = (A, B, share) => multiply(A, exp(log(multiply(inverse(A), B)).map((x) => share * x)));

  // The pose of a rotation vector and a position.
  function pose(w, p) {
    const T = exp([...w, 0, 0, 0]);
    [T[3], T[7], T[11]] = p;
    return T;
  }

  // The poses of an arm's bodies for joint angles q: the base's, then the products of exponentials up to each joint.
  function chain(screws, q) {
    const poses = [identity()];
    screws.forEach((screw, i) => poses.push(multiply(poses[i], exp(screw.map((x) => q[i] * x)))));
    return poses;
  }

  // The vertices {x, y, z} of bodies at `poses`, from those in the bodies' own frames.
  function placed({ x, y, z }, counts, poses) {
    const out = { x: new Array(x.length), y: new Array(x.length), z: new Array(x.length) };
    let k = 0;
    counts.forEach((count, body) => {
      const T = poses[body];
      for (const end = k + count; k < end; k++) {
        out.x[k] = T[0] * x[k] + T[1] * y[k] + T[2] * z[k] + T[3];
        out.y[k] = T[4] * x[k] + T[5] * y[k] + T[6] * z[k] + T[7];
        out.z[k] = T[8] * x[k] + T[9] * y[k] + T[10] * z[k] + T[11];
      }
    });
    return out;
  }

  // The other way round.
  const localVertices = (vertices, counts, poses) => placed(vertices, counts, poses.map(inverse));

  window.course = window.course || { kinds: {} };
  window.course.motion = {
    identity, dot, cross, exp, log, rotationVector, multiply, inverse, apply, interpolate, pose, chain, placed,
    localVertices,
  };
})();
