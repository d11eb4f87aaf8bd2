// Space: a stage on which bodies, lines and words are seen in perspective.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const S = globalThis.course.scene;
  const P = globalThis.course.parts;
  const { COLOURS, tint, isDark } = globalThis.course.palette;
  const KEYS =
    "Arrow keys look from another side, plus and minus come nearer and go farther, Home goes back.";
  const EYE_DISTANCE = 5; // in radii of what is in the picture
  // Half of the picture's shorter side, less a rim, in sides: there a radius ends.
  const FILLED = 0.49;
  const NEAREST = 0.3; // depths that are drawn, in distances of the eye
  const FARTHEST = 4;
  // Lines lie this much nearer than the surfaces that they run along, in units of the depth buffer
  // (-1 to 1).
  const LINE_LIFT = 2e-4;
  const ARROW_LIGHT = 0.75; // arrows are seen from all sides
  const MAX_STEPS_BACK = 90;
  // Of the picture's width and height from its middle: what lies farther out is outside.
  const RIM = 0.44;
  const GRID_STEP = 0.2; // metres
  const BALL = S.ball();

  /** The pose that makes a unit ball or disc of radius r at p. */
  const sizedPose = (r, p) =>
    M.pose(
      M.eye(3).map((row) => M.scale(row, r)),
      p,
    );

  /**
   * Space around a centre, as far as a radius.
   * @param {Element} parent
   * @param {{centre?: number[], radius: number, azimuth?: number, elevation?: number, label:
   *   string, meta: object, proportion?: number, redraw: () => void}} options azimuth and elevation
   *   are those of the eye, at first; the view is kept in `meta`
   * @returns {object} the stage, with mesh, line, arrow, frame, ball, text, floor, contain and
   *   handle. Lengths are in metres, widths of lines in pixels.
   */
  P.space = (parent, options) => {
    const { centre = [0, 0, 0], azimuth = -0.9, elevation = 0.35, label, meta } = options;
    const { proportion = 0.75, redraw } = options;
    if (!S.start()) throw Error("this browser draws nothing in space (no WebGL 2)");
    const view = P.stage(parent, {
      label: `${label.replace(/\.$/, "")}. ${KEYS}`,
      proportion,
      redraw,
      attributes: { tabindex: 0, style: "touch-action:pan-y;cursor:move" },
    });
    const stage = { begin: view.begin, end: view.end, handle: view.handle, stop: view.stop };
    const start = { azimuth, elevation, zoom: 1 };
    meta.camera ??= { ...start };
    const { camera } = meta;

    let fittedRadius = options.radius; // what has to be in the picture at zoom 1
    let radius; // what is in the picture
    let right; // unit vectors of the picture
    let up;
    let eye; // the direction to the eye
    let size; // of a length at distance 1, in pixels
    let meshes = [];
    let lines = [];
    let floor = null;

    function aim() {
      const { azimuth: a, elevation: e } = camera;
      eye = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
      right = [-Math.sin(a), Math.cos(a), 0];
      up = M.cross(eye, right);
      radius = fittedRadius / camera.zoom;
      size = FILLED * Math.min(view.width, view.height) * EYE_DISTANCE;
    }
    const distance = (p) => EYE_DISTANCE * radius - M.dot(M.subtract(p, centre), eye);
    function toPixels(p) {
      const fromCentre = M.subtract(p, centre);
      const scale = size / distance(p);
      return [
        view.width / 2 + scale * M.dot(fromCentre, right),
        view.height / 2 - scale * M.dot(fromCentre, up),
      ];
    }
    /** The point at a pixel, in the plane through p that faces the eye. */
    function fromPixels([x, y], p) {
      const [x0, y0] = toPixels(p);
      const scale = distance(p) / size;
      return M.add(M.add(p, right, scale * (x - x0)), up, -scale * (y - y0));
    }
    /**
     * The matrix (4 x 4) from a point to WebGL's coordinates, which are divided by the last one.
     */
    function viewMatrix() {
      const toCentre = EYE_DISTANCE * radius;
      const near = NEAREST * toCentre;
      const far = FARTHEST * toCentre;
      // axis . (p - centre) * scale + offset, as a row for (p, 1)
      const row = (axis, scale, offset = 0) => [
        ...M.scale(axis, scale),
        offset - scale * M.dot(axis, centre),
      ];
      const distanceRow = row(eye, -1, toCentre);
      // (a d + b) / d is -1 at the nearest and 1 at the farthest distance d.
      const a = (far + near) / (far - near);
      const b = (-2 * far * near) / (far - near);
      const depthRow = M.scale(distanceRow, a);
      depthRow[3] += b;
      return [
        row(right, (2 * size) / view.width),
        row(up, (2 * size) / view.height),
        depthRow,
        distanceRow,
      ];
    }
    const layerOf = (above) => (above ? "above" : "space");

    view.begin = () => {
      stage.begin();
      aim();
      meshes = [];
      lines = [];
      floor = null;
    };

    /**
     * A mesh whose bodies stand at poses.
     * @param {object} mesh as scene.js has it
     * @param {number[][][]} poses 4 x 4
     * @param {string[]} palette the colours of its faces
     * @param {{opacity?: number, shadow?: boolean, above?: boolean, least?: number, grip?:
     *   Function}} look above: in front of all that is not; least: the least light on it;
     *   grip(body) -> {name, at, axis, angle, moved} or null: when it is dragged, the body rotates
     *   about an axis, and moved(angle) is called
     */
    view.mesh = (mesh, poses, palette, look = {}) => {
      const { opacity = 1, shadow = opacity === 1, above, least, grip } = look;
      const distanceFromEye = distance(M.move(poses.at(-1), mesh.vertices[0]));
      const tinted = palette.map(tint);
      const layer = layerOf(above);
      meshes.push({
        mesh,
        poses,
        palette: tinted,
        opacity,
        shadow,
        least,
        distanceFromEye,
        layer,
        grip,
      });
    };

    /** A line through points, of a width in pixels; null interrupts it. */
    view.line = (points, colour, width = 2, look = {}) => {
      const { dash = [], above, layer = layerOf(above) } = look;
      const [, , depthRow, distanceRow] = viewMatrix();
      const depthOf = (p) => {
        const point = [...p, 1];
        return M.dot(depthRow, point) / M.dot(distanceRow, point) - LINE_LIFT;
      };
      const ribbon = [];
      let length = 0; // in pixels, for dashes
      points.forEach((end, i) => {
        const start = points[i - 1];
        if (!start || !end) {
          length = 0;
          return;
        }
        const [ax, ay] = toPixels(start);
        const [bx, by] = toPixels(end);
        const step = Math.hypot(bx - ax, by - ay);
        const half = width / 2 / (step || 1);
        const [nx, ny] = [-(by - ay) * half, (bx - ax) * half]; // across the line
        const aDepth = depthOf(start);
        const bDepth = depthOf(end);
        const a1 = [ax + nx, ay + ny, aDepth, length];
        const a2 = [ax - nx, ay - ny, aDepth, length];
        length += step || 1;
        const b1 = [bx + nx, by + ny, bDepth, length];
        const b2 = [bx - nx, by - ny, bDepth, length];
        ribbon.push(...a1, ...a2, ...b1, ...b1, ...a2, ...b2);
      });
      lines.push({ ribbon, colour: tint(colour), dash, layer });
    };

    /** An arrow whose shaft has the radius `thick`. */
    view.arrow = (from, to, colour, { thick = 0.018 * fittedRadius, ...look } = {}) => {
      const along = M.subtract(to, from);
      const length = M.norm(along);
      if (length < 1e-9) return;
      const z = M.scale(along, 1 / length);
      const head = Math.min(5 * thick, 0.5 * length);
      const beside = Math.abs(z[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]; // any that is not parallel to z
      const x = M.unit(M.cross(beside, z));
      const y = M.cross(z, x);
      const part = (partRadius, partLength, at) => {
        const columns = [M.scale(x, partRadius), M.scale(y, partRadius), M.scale(z, partLength)];
        return M.pose(M.transpose(columns), at);
      };
      const shaft = part(thick, length - head, from);
      const tip = part(2.4 * thick, head, M.add(to, z, -head));
      view.mesh(S.arrow, [shaft, tip], [colour], { shadow: false, least: ARROW_LIGHT, ...look });
    };

    /** The axes of a frame: x red, y green and z blue. */
    view.frame = (T, length, { thick, above = true } = {}) => {
      const origin = M.positionOf(T);
      const axes = M.transpose(M.rotationOf(T));
      [COLOURS.red, COLOURS.green, COLOURS.blue].forEach((colour, k) => {
        view.arrow(origin, M.add(origin, axes[k], length), colour, { thick, above });
      });
    };

    view.ball = (p, r, colour, look) => view.mesh(BALL, [sizedPose(r, p)], [colour], look);

    /** Words at a point, or `lift` pixels above it. */
    view.text = (p, words, colour, lift = 0) => {
      const [x, y] = toPixels(p);
      view.word([x, y - lift], words, colour);
    };

    /** A round floor of a radius at a height around (x, y), with a grid; shadows fall on it. */
    view.floor = (half, height = 0, step = GRID_STEP, [x, y] = [0, 0]) => {
      floor = {
        mesh: S.disc,
        poses: [sizedPose(half, [x, y, height])],
        palette: [tint(COLOURS.floor)],
        opacity: 1,
        least: 1,
        height,
        shade: tint(COLOURS.shade),
        darkness: isDark() ? 0.5 : 0.2,
      };
      const grid = [];
      const count = Math.floor(half / step);
      for (let k = -count; k <= count; k++) {
        const t = k * step;
        const reach = Math.sqrt(Math.max(0, half * half - t * t)); // as far as the floor's edge
        grid.push([x + t, y - reach, height], [x + t, y + reach, height], null);
        grid.push([x - reach, y + t, height], [x + reach, y + t, height], null);
      }
      view.line(grid, COLOURS.lines, 1, { layer: "floor" });
    };

    /** Go as far away as is needed to have these points in the picture. */
    view.contain = (points) => {
      if (view.held) return; // what is dragged stays below the pointer
      const isOutside = (p) => {
        const [x, y] = toPixels(p);
        const fromMiddle = [x / view.width - 0.5, y / view.height - 0.5].map(Math.abs);
        return Math.max(...fromMiddle) > RIM;
      };
      for (let k = 0; k < MAX_STEPS_BACK && points.some(isOutside); k++) {
        fittedRadius *= 1.03;
        aim();
      }
    };

    view.end = () => {
      const { context, width, height, dense, held } = view;
      if (held?.name) view.word(M.add(held.pixel, [0, -24]), held.name());
      const eyePosition = M.add(centre, eye, EYE_DISTANCE * radius);
      const picture = { width, height, dense, view: viewMatrix(), eye: eyePosition };
      S.draw(context, { ...picture, floor, meshes, lines }, redraw);
      stage.end();
    };

    const step = (p, [across, upwards]) => M.add(M.add(p, right, across), up, upwards);
    view.handle = (handleOptions) =>
      stage.handle({ stride: fittedRadius / 60, ...handleOptions }, { toPixels, fromPixels, step });

    view.stop = () => {
      S.redraws.delete(redraw);
      stage.stop();
    };

    const eyeView = () => ({
      toPixels,
      fromPixels,
      distance,
      radius,
      size,
      eye: M.add(centre, eye, EYE_DISTANCE * radius),
    });
    S.redraws.add(redraw);
    const take = (pixel) => P.takeBody(meshes, pixel, eyeView());
    P.moveCamera(view, camera, start, take, redraw);
    aim();
    return view;
  };
})();
