// Simple bodies as meshes {vertices, faces, colours, bodies} for the view of space in toys.js.
(() => {
  "use strict";
  const K = globalThis.course.kinematics;

  // Revolve a closed profile of (radius, height) about the z axis of a pose; a torus if the profile is a circle.
  function lathe(T, profile, colour, body = 0, n = 24, closed = false) {
    const vertices = [], faces = [], m = profile.length;
    profile.forEach(([r, h]) => {
      for (let k = 0; k < n; k++) {
        const t = (2 * Math.PI * k) / n;
        vertices.push(K.move(T, [r * Math.cos(t), r * Math.sin(t), h]));
      }
    });
    for (let i = 0; i + 1 < m + (closed ? 1 : 0); i++) {
      for (let k = 0; k < n; k++) {
        const a = i * n + k, b = i * n + ((k + 1) % n), c = ((i + 1) % m) * n + k, d = ((i + 1) % m) * n + ((k + 1) % n);
        faces.push([a, b, d], [a, d, c]);
      }
    }
    return { vertices, faces, colours: faces.map(() => colour), bodies: vertices.map(() => body) };
  }
  function box(T, [lx, ly, lz], [hx, hy, hz], colour, body = 0) {
    const vertices = [lz, hz].flatMap((z) => [[lx, ly, z], [hx, ly, z], [hx, hy, z], [lx, hy, z]]).map((p) => K.move(T, p));
    const faces = [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5], [2, 3, 7], [2, 7, 6], [3, 0, 4], [3, 4, 7]];
    return { vertices, faces, colours: faces.map(() => colour), bodies: vertices.map(() => body) };
  }
  // A flat ring of rectangular section about the z axis of a pose.
  const ring = (T, radius, width, colour, body = 0, n = 40) =>
    lathe(T, [[radius - width, -width], [radius, -width], [radius, width], [radius - width, width]], colour, body, n, true);
  const drum = (T, radius, half, colour, body = 0, n = 20) =>
    lathe(T, [[0, -half], [radius, -half], [radius, half], [0, half]], colour, body, n);
  const ball = (T, radius, colour, body = 0, n = 14) => {
    const rows = Math.round(n / 2);
    return lathe(T, Array.from({ length: rows + 1 }, (_, i) => [radius * Math.sin((Math.PI * i) / rows), -radius * Math.cos((Math.PI * i) / rows)]), colour, body, n);
  };
  function join(meshes) {
    const all = { vertices: [], faces: [], colours: [], bodies: [] };
    meshes.forEach((mesh) => {
      const first = all.vertices.length;
      all.vertices.push(...mesh.vertices);
      all.faces.push(...mesh.faces.map((face) => face.map((i) => i + first)));
      all.colours.push(...mesh.colours);
      all.bodies.push(...mesh.bodies);
    });
    return all;
  }
  globalThis.course.shapes = { lathe, box, ring, drum, ball, join };
})();
