// Bodies as meshes: {vertices, faces, colours (an index of the palette for each face), bodies (the
// index of the body that each vertex belongs to)}. The bodies of a mesh move by their poses.
globalThis.course.scene = (() => {
  "use strict";
  const M = globalThis.course.motion;
  const { COLOURS } = globalThis.course.palette;

  /** A mesh of one colour that is one body. */
  const mesh = (vertices, faces, colour, body = 0) => ({
    vertices,
    faces,
    colours: faces.map(() => colour),
    bodies: vertices.map(() => body),
  });

  /**
   * Revolve a profile of (radius, height) about the z axis of a pose; a closed profile makes a
   * torus.
   * @param {{body?: number, n?: number, closed?: boolean}} options n: steps around
   */
  function lathe(T, profile, colour, { body = 0, n = 24, closed = false } = {}) {
    const vertices = profile.flatMap(([radius, height]) =>
      Array.from({ length: n }, (_, k) => {
        const angle = (2 * Math.PI * k) / n;
        return M.move(T, [radius * Math.cos(angle), radius * Math.sin(angle), height]);
      }),
    );
    const index = (i, k) => (i % profile.length) * n + (k % n);
    const bands = closed ? profile.length : profile.length - 1;
    const faces = [];
    for (let i = 0; i < bands; i++) {
      for (let k = 0; k < n; k++) {
        const opposite = index(i + 1, k + 1);
        faces.push([index(i, k), index(i, k + 1), opposite]);
        faces.push([index(i, k), opposite, index(i + 1, k)]);
      }
    }
    return mesh(vertices, faces, colour, body);
  }

  /** A box between two opposite corners. */
  function box([lowX, lowY, lowZ], [highX, highY, highZ], colour) {
    const vertices = [lowZ, highZ].flatMap((z) => [
      [lowX, lowY, z],
      [highX, lowY, z],
      [highX, highY, z],
      [lowX, highY, z],
    ]);
    const sides = [
      [0, 3, 2, 1],
      [4, 5, 6, 7],
      [0, 1, 5, 4],
      [1, 2, 6, 5],
      [2, 3, 7, 6],
      [3, 0, 4, 7],
    ];
    const faces = sides.flatMap(([a, b, c, d]) => [
      [a, b, c],
      [a, c, d],
    ]);
    return mesh(vertices, faces, colour);
  }

  /** A flat ring around the z axis of a pose, of an outer radius. */
  function ring(T, radius, width, colour) {
    const section = [
      [radius - width, -width],
      [radius, -width],
      [radius, width],
      [radius - width, width],
    ];
    return lathe(T, section, colour, { n: 64, closed: true });
  }

  /** A unit ball, of n steps around. */
  function ball(n = 24) {
    const meridian = Array.from({ length: n / 2 + 1 }, (_, i) => {
      const angle = (2 * Math.PI * i) / n;
      return [Math.sin(angle), -Math.cos(angle)];
    });
    return lathe(M.eye(4), meridian, 0, { n });
  }

  function join(meshes) {
    const faces = [];
    let first = 0; // the number of a mesh's first vertex
    for (const part of meshes) {
      const offset = first;
      faces.push(...part.faces.map((face) => face.map((i) => i + offset)));
      first += part.vertices.length;
    }
    const all = (name) => meshes.flatMap((part) => part[name]);
    return { vertices: all("vertices"), faces, colours: all("colours"), bodies: all("bodies") };
  }

  // Along z from 0 to 1: the shaft is body 0, the head body 1, each to be scaled by its pose.
  const SHAFT = [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ];
  const HEAD = [
    [0, 0],
    [1, 0],
    [0, 1],
  ];
  const arrow = join([
    lathe(M.eye(4), SHAFT, 0, { n: 14 }),
    lathe(M.eye(4), HEAD, 0, { body: 1, n: 18 }),
  ]);
  const DISC = [
    [1, 0],
    [0, 0],
  ];
  const disc = lathe(M.eye(4), DISC, 0, { n: 64 });

  // A small aircraft, nose along x, wings along y: it looks different in every orientation.
  const { white, aluminium, blue, green, red, amber } = COLOURS;
  const PALETTE = [white, aluminium, blue, green, red, amber];
  const FUSELAGE = [
    [0, -0.8],
    [0.07, -0.75],
    [0.13, -0.5],
    [0.16, -0.2],
    [0.17, 0.2],
    [0.14, 0.5],
    [0.08, 0.75],
    [0, 0.85],
  ];
  const ALONG_X = M.pose(M.rotation([0, 1, 0], Math.PI / 2), [0, 0, 0]);
  const aircraft = join([
    lathe(ALONG_X, FUSELAGE, 0, { n: 28 }),
    box([-0.2, -0.85, -0.03], [0.2, 0.85, 0.03], 2), // wings
    box([-0.78, -0.3, -0.02], [-0.55, 0.3, 0.02], 2), // tail plane
    box([-0.78, -0.02, 0.04], [-0.55, 0.02, 0.38], 4), // fin
  ]);

  /** A model as Python packs it (course_lib.figures.toys.toy.solid): whole numbers in base64. */
  function unpack({ vertices, faces, colours, bodies, palette }) {
    const tenthsOfMillimetres = numbersOf(vertices, Int16Array);
    return {
      vertices: triples(tenthsOfMillimetres.map((x) => x / 1e4)),
      faces: triples(numbersOf(faces, Uint16Array)),
      colours: numbersOf(colours, Uint8Array),
      bodies: numbersOf(bodies, Uint8Array),
      palette,
    };
  }
  function numbersOf(base64, Kind) {
    const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    return Array.from(new Kind(bytes.buffer));
  }
  const triples = (flat) =>
    Array.from({ length: flat.length / 3 }, (_, i) => flat.slice(3 * i, 3 * i + 3));

  return { mesh, lathe, box, ring, ball, join, arrow, disc, aircraft, PALETTE, unpack };
})();
