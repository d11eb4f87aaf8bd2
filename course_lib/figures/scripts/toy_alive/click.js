// "click": two pictures of a mug with key points to click, and where the clicks say that the mug
// is. Pixels and depths are asked, and a pose is answered.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const S = globalThis.course.scene;
  const { FIGURES, credit } = globalThis.course.alive;
  const { COLOURS } = globalThis.course.palette;
  const TITLES = ["template's picture", "scene's picture"];
  const RIM = 50; // pixels around the mug
  const TABLE_LINE = 1 / 40; // metres between two lines on the table
  const TABLE_LINES = 10; // to each side
  const MUG = [214, 96, 86]; // red, green, blue, in full light
  const LIGHT = M.unit([0.3, -0.7, -0.6]); // in the camera's frame
  const CROSS = [
    [1, 1],
    [-1, 1],
  ];
  const JAWS = [
    [0, 0.04, 0],
    [0, 0.04, -0.04],
    [0, -0.04, -0.04],
    [0, -0.04, 0],
  ]; // metres, in the gripper's frame
  const WRIST = [
    [0, 0, -0.04],
    [0, 0, -0.07],
  ];

  /**
   * What a camera sees of a mug. A pixel is (u, -v), so that it points upwards as in the plane.
   * @param {{K: number[][], camera: number[][], mug: number[][], vertices: number[][], faces:
   *   number[][]}} sight K: the intrinsic matrix; camera and mug: poses
   */
  function cameraView({ K, camera, mug, vertices, faces }) {
    const [[fx, , cx], [, fy, cy]] = K;
    const fromMug = M.times(M.inverse(camera), mug);
    const toPixel = ([x, y, z]) => [(fx * x) / z + cx, -(fy * y) / z - cy];
    const rayAt = ([u, v]) => [(u - cx) / fx, (v - cy) / fy, 1];

    const seen = vertices.map((vertex) => M.move(fromMug, vertex));
    const triangles = faces.map((face) => face.map((k) => seen[k]));
    const tableNormal = M.transpose(M.rotationOf(fromMug))[2];
    const tableDistance = M.dot(tableNormal, M.positionOf(fromMug));

    /** What a depth camera measures at a pixel (u, v): the mug, or the table behind it. */
    function depth(pixel) {
      const ray = rayAt(pixel);
      const table = tableDistance / M.dot(tableNormal, ray);
      return Math.min(M.firstHit(ray, triangles), table);
    }
    /** The point at a pixel (u, v), seen from the world. */
    const point = (pixel) => M.move(camera, M.scale(rayAt(pixel), depth(pixel)));

    /** Ranges of the picture around the mug. */
    function ranges() {
      const [across, upwards] = M.transpose(seen.map(toPixel));
      const range = (values) => [Math.min(...values) - RIM, Math.max(...values) + RIM];
      return { x: range(across), y: range(upwards) };
    }
    return { fromMug, toPixel, depth, point, ranges, shaded: shade(triangles, toPixel) };
  }

  /**
   * The triangles that face the camera, farther ones first: [their corners' pixels, their light
   * from 0 to 1].
   */
  function shade(triangles, toPixel) {
    const normalOf = ([a, b, c]) => M.unit(M.cross(M.subtract(b, a), M.subtract(c, a)));
    // Three times that of the middle.
    const distanceOf = ([a, b, c]) => M.norm(M.add(M.add(a, b), c));
    const front = triangles.filter((triangle) => M.dot(normalOf(triangle), triangle[0]) < 0);
    front.sort((p, q) => distanceOf(q) - distanceOf(p));
    return front.map((triangle) => {
      const light = 0.55 + 0.45 * Math.max(0, M.dot(normalOf(triangle), LIGHT));
      return [triangle.map(toPixel), light];
    });
  }

  FIGURES.click = (card, meta, ask) => {
    const { cameras, mugs, grasp, spots } = meta;
    const { vertices, faces } = S.unpack(meta.solid);
    const state = card.state({
      clicks: structuredClone(meta.clicks),
      // Which ones the reader has clicked.
      own: meta.clicks.map((pixels) => pixels.map(() => false)),
      chosen: 0,
    });
    const views = cameras.map((camera, i) =>
      cameraView({ K: meta.K, camera, mug: mugs[i], vertices, faces }),
    );
    const planes = views.map((view, i) =>
      card.plane({
        ...view.ranges(),
        ticks: () => [],
        names: ["", ""],
        label: `Mug, ${TITLES[i]}`,
        proportion: 0.8,
      }),
    );

    function moved() {
      const depths = views.map(({ depth }, i) => state.clicks[i].map(depth));
      ask({ pixels: state.clicks, depths });
    }
    planes.forEach((plane, i) => {
      const { x, y } = views[i].ranges();
      function put([u, v]) {
        const inside = [P.clamp(u, ...x), P.clamp(v, ...y)];
        state.clicks[i][state.chosen] = [inside[0], -inside[1]];
        state.own[i][state.chosen] = true;
        moved();
      }
      addHandle(plane, i, put);
      P.onClick(plane, (pixel) => {
        put(pixel);
        chooseNext();
        card.draw();
      });
    });
    function addHandle(plane, i, put) {
      const clicked = () => state.clicks[i][state.chosen];
      plane.handle({
        name: `Point in the ${TITLES[i]}`,
        colour: COLOURS.blue,
        open: true,
        at: () => [clicked()[0], -clicked()[1]],
        moved: put,
        stride: 1,
        describe: () => `${state.chosen} at ${P.list(clicked(), 1)} pixels`,
      });
    }
    /** When a point is clicked in both pictures, the next one that is not comes. */
    function chooseNext() {
      const isClicked = (k) => state.own.every((points) => points[k]);
      if (!isClicked(state.chosen)) return;
      const next = state.own[0].findIndex((_, k) => !isClicked(k));
      if (next < 0) return;
      state.chosen = next;
      slider.set(next);
    }

    const last = spots.length - 1;
    const limits = { min: 0, max: last, step: 1 };
    const slider = card.setting(`Point to click, 0 to ${last}`, state, "chosen", limits, String);
    const numbers = card.numbers();
    const words = card.words();
    moved();

    function drawTable(plane, place) {
      for (let k = -TABLE_LINES; k <= TABLE_LINES; k++) {
        const along = [
          [k, -TABLE_LINES],
          [k, TABLE_LINES],
        ];
        const across = along.map(([x, y]) => [y, x]);
        for (const line of [along, across]) {
          const ends = line.map(([x, y]) => place([x * TABLE_LINE, y * TABLE_LINE, 0]));
          plane.line(ends, COLOURS.lines, 1);
        }
      }
    }
    function drawMug(plane, { fromMug, toPixel, shaded }) {
      const place = (p) => toPixel(M.move(fromMug, p));
      drawTable(plane, place);
      for (const [pixels, light] of shaded) {
        const colour = `rgb(${MUG.map((channel) => Math.round(channel * light))})`;
        plane.line(pixels, colour, 0.6, { closed: true, fill: 1 });
      }
      for (const spot of spots) plane.dot(place(spot), COLOURS.spot, 4);
    }
    /** The mug where the pose says that it is, as a net, and the gripper that would grasp it. */
    function drawPose(plane, { toPixel }, pose, grip) {
      const toCamera = M.inverse(cameras[1]);
      const pixelOf = (p) => toPixel(M.move(toCamera, p));
      const net = vertices.map((vertex) => pixelOf(M.move(pose, vertex)));
      for (const face of faces) {
        const triangle = face.map((k) => net[k]);
        if (isInFront(triangle)) plane.line(triangle, COLOURS.blue, 0.5, { closed: true });
      }
      for (const part of [JAWS, WRIST]) {
        const pixels = part.map((p) => pixelOf(M.move(grip, p)));
        plane.line(pixels, COLOURS.green, 3);
      }
    }
    function drawClicks(plane, i) {
      state.clicks[i].forEach(([u, v], k) => {
        const pixel = [u, -v];
        const colour = state.own[i][k] ? COLOURS.blue : COLOURS.purple;
        for (const arm of CROSS) {
          plane.line([M.add(pixel, arm, 5), M.add(pixel, arm, -5)], colour, 1.5);
        }
        plane.text(M.add(pixel, [15, 9]), String(k));
      });
    }

    return () => {
      const [model, scene] = views.map(({ point }, i) => state.clicks[i].map(point));
      const pose = state.answer?.value || M.register(model, scene);
      const grip = M.times(pose, grasp);
      planes.forEach((plane, i) => {
        plane.begin();
        drawMug(plane, views[i]);
        if (i === 1) drawPose(plane, views[i], pose, grip);
        drawClicks(plane, i);
        plane.end();
      });

      const residuals = model.map((p, k) => M.norm(M.subtract(M.move(pose, p), scene[k])));
      const millimetres = residuals.map((metres) => 1000 * metres);
      const rootMeanSquare = M.norm(millimetres) / Math.sqrt(millimetres.length);
      const miss = M.norm(M.subtract(M.positionOf(pose), M.positionOf(mugs[1])));
      numbers(
        ["<span>T<sub>wm</sub> =</span>", P.matrix(pose)],
        `residuals: ${P.list(millimetres, 1)} mm\n` + `grasp at ${P.list(M.positionOf(grip), 3)} m`,
      );
      const comment =
        `Click point ${state.chosen} in both pictures. Residual ${P.number(rootMeanSquare, 1)} ` +
        `mm (root mean square). The pose, blue, is ${P.number(1000 * miss, 1)} mm from the mug.`;
      words.textContent = credit(state, comment, comment);
    };
  };

  /** Whether the corners of a triangle in a plane follow each other counterclockwise. */
  function isInFront([[ax, ay], [bx, by], [cx, cy]]) {
    return (bx - ax) * (cy - ay) - (cx - ax) * (by - ay) > 0;
  }
})();
