// Bodies in space that are dragged: which one is below the pointer, and by what angle it rotates.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  // The cosine between an axis and the line of sight below which an axis counts as seen from the
  // side: there the plane in which the body rotates is seen from its edge, and pixels in it would
  // mean too much.
  const FROM_THE_SIDE = 0.4;
  const LEAST_LEVER = 80; // pixels: a body near its axis rotates by 1 rad in so many

  /**
   * The nearest body with a grip at a pixel.
   * @param {object[]} meshes those that space has listed
   * @param {number[]} pixel
   * @param {object} view toPixels, fromPixels, distance, radius, size, and the position of the eye
   * @returns {object | null} its grip, the pixel, and follow(pixel) -> the angle to which it was
   *   dragged
   */
  P.takeBody = (meshes, pixel, view) => {
    let nearest = null;
    for (const { mesh, poses, grip } of meshes) {
      if (!grip) continue;
      const grips = poses.map((_, body) => grip(body));
      const hit = hitMesh(mesh, poses, grips, pixel, view);
      if (hit && (!nearest || hit.distance < nearest.distance)) nearest = hit;
    }
    if (!nearest) return null;
    const follow = follower(nearest.grip, nearest.point, pixel, view);
    return { ...nearest.grip, pixel, follow };
  };

  /**
   * The nearest point of a mesh at a pixel, on a body that has a grip: {distance, grip, point}, or
   * null.
   */
  function hitMesh({ vertices, faces, bodies }, poses, grips, pixel, { toPixels, distance }) {
    const points = vertices.map((vertex, i) =>
      grips[bodies[i]] ? M.move(poses[bodies[i]], vertex) : null,
    );
    const corners = points.map((p) => p && { pixel: toPixels(p), distance: distance(p) });
    let nearest = null;
    for (const face of faces) {
      if (!corners[face[0]]) continue;
      const [a, b, c] = face.map((i) => corners[i]);
      const shares = barycentric(a.pixel, b.pixel, c.pixel, pixel);
      if (!shares) continue;
      const faceDistance = M.dot(shares, [a.distance, b.distance, c.distance]);
      if (nearest && faceDistance >= nearest.distance) continue;
      const point = M.apply(M.transpose(face.map((i) => points[i])), shares);
      nearest = { distance: faceDistance, grip: grips[bodies[face[0]]], point };
    }
    return nearest;
  }

  /**
   * The shares of a triangle's corners in a pixel; null if it lies elsewhere, or the triangle faces
   * away.
   */
  function barycentric(a, b, c, pixel) {
    // Twice the area of the triangle of two corners and the pixel; y points down, so it is negative
    // from the front.
    const area = ([ux, uy], [vx, vy]) => (vx - ux) * (pixel[1] - uy) - (vy - uy) * (pixel[0] - ux);
    const areas = [area(b, c), area(c, a), area(a, b)];
    const whole = areas[0] + areas[1] + areas[2];
    if (whole >= 0) return null;
    if (areas.some((part) => part > 0)) return null;
    return M.scale(areas, 1 / whole);
  }

  /**
   * A function from a pixel to the angle about a grip's axis that brings the point there which was
   * taken at the pixel `from`; about an axis that is seen from the side, pixels across it count.
   */
  function follower({ at, axis, angle }, point, from, view) {
    const { toPixels, fromPixels, distance, radius, size, eye } = view;
    const foot = M.add(at, axis, M.dot(M.subtract(point, at), axis)); // of the point, on the axis
    const arm = M.subtract(point, foot);
    const towardsEye = M.unit(M.subtract(eye, point));
    const isFromTheSide = Math.abs(M.dot(axis, towardsEye)) < FROM_THE_SIDE;
    if (isFromTheSide || M.norm(arm) < 0.01 * radius) {
      const beside = M.add(point, M.cross(axis, towardsEye), 1e-3 * radius);
      const across = M.unit(M.subtract(toPixels(beside), toPixels(point)));
      const lever = Math.max(LEAST_LEVER, (M.norm(arm) * size) / distance(point));
      return (pixel) => angle + M.dot(M.subtract(pixel, from), across) / lever;
    }
    let rotated = 0; // followed from pixel to pixel, so that it may exceed half a revolution
    return (pixel) => {
      const ray = M.subtract(fromPixels(pixel, point), eye);
      // To the plane of rotation.
      const length = M.dot(M.subtract(foot, eye), axis) / M.dot(ray, axis);
      const hit = M.subtract(M.add(eye, ray, length), foot);
      rotated += M.wrap(M.angleAbout(axis, arm, hit) - rotated);
      return angle + rotated;
    };
  }
})();
