// Films and stills. meta.times are those of the stored positions; between them bodies move along
// screws in space, and corners along lines in the plane. A film begins to play, unless the reader
// prefers reduced motion, plays while it is in view, and begins again at its end.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const S = globalThis.course.scene;
  const { COLOURS, isDark } = globalThis.course.palette;
  // Milliseconds: after a longer pause of the page a film goes on where it was.
  const MAX_PAUSE = 250;
  const EVERY = 5; // so many vertices apart a few of them stand for all when the view is fitted
  const PALE = { opacity: 0.35 };
  const FITTED_TIMES = 12; // of a film, when the view is fitted

  P.toy(
    "film",
    (meta) => meta.title,
    (card, meta) => (meta.shapes ? filmInThePlane(card, meta) : filmInSpace(card, meta)),
  );

  /** The number of the last of the times up to t, and the share of the way to the next. */
  function placeOf(times, t) {
    const next = times.findIndex((time) => time > t);
    if (next < 0) return [times.length - 1, 0];
    const before = times[next - 1];
    return [next - 1, (t - before) / (times[next] - before)];
  }

  /**
   * A range for the time and a button that plays, if there is more than one time. With `at` it is a
   * still.
   * @returns {{at: number}} holds the time
   */
  function addPlayer(card, { times, at }, view) {
    const end = times.at(-1);
    const isStill = at !== undefined;
    const isReduced = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const state = card.state({ at: at || 0, plays: end > 0 && !isReduced && !isStill });
    if (!end || isStill) return state;

    let before = null; // the time of the frame before
    let frame = null;
    let isVisible = true;
    function step(now) {
      frame = requestAnimationFrame(step);
      const passed = Math.min(now - (before ?? now), MAX_PAUSE) / 1000;
      before = now;
      if (!isVisible || view.held) return;
      state.at = state.at >= end ? 0 : Math.min(end, state.at + passed);
      time.set(state.at);
      card.draw();
    }
    function play(plays) {
      state.plays = plays;
      button.textContent = plays ? "Pause" : "Play";
      cancelAnimationFrame(frame);
      before = null;
      if (plays) frame = requestAnimationFrame(step);
    }
    const write = (t) => `${P.number(t)} s`;
    const time = card.setting("Time", state, "at", { min: 0, max: end, step: 0.01 }, write);
    time.input.addEventListener("input", () => play(false));
    const button = card.button("", () => play(!state.plays));
    const observer = new IntersectionObserver((entries) => {
      isVisible = entries.at(-1).isIntersecting;
    });
    observer.observe(view.box);
    card.atEnd(() => {
      cancelAnimationFrame(frame);
      observer.disconnect();
    });
    play(state.plays);
    return state;
  }

  // ---- in space ----

  /** The poses of the bodies at each time, from rotation vectors and positions in millimetres. */
  const posesOf = ({ rotations, positions }) =>
    rotations.map((bodies, i) =>
      bodies.map((w, k) => {
        const R = M.rotationOf(M.exp([...w, 0, 0, 0]));
        return M.pose(R, M.scale(positions[i][k], 1e-3));
      }),
    );
  /** A point of a path is [null, ...] where the path is interrupted. */
  const isPoint = (p) => p[0] !== null;

  function filmInSpace(card, meta) {
    const { times, centre, radius, azimuth, elevation, proportion, title, floor } = meta;
    const solid = S.unpack(meta.solid);
    const pale = meta.pale && S.unpack(meta.pale);
    const poses = posesOf(meta);
    function posesAt(t) {
      const [i, share] = placeOf(times, t);
      if (!share) return poses[i];
      return poses[i].map((from, k) => M.interpolate(from, poses[i + 1][k], share));
    }
    const view = card.space({ radius, centre, azimuth, elevation, label: title, proportion });
    const state = addPlayer(card, meta, view);
    const seen = pointsToFit();

    /** What is in the picture: the bodies at some of the times, the paths and the words. */
    function pointsToFit() {
      const paleVertices = pale ? pale.vertices : [];
      const palePoints = paleVertices.map((p, i) => M.move(poses[0][pale.bodies[i]], p));
      if (meta.near) return [...meta.near, ...palePoints];
      const end = times.at(-1);
      const some = [...solid.vertices.keys()].filter((i) => i % EVERY === 0);
      const fittedPoses = M.sampled(end ? FITTED_TIMES : 1, (share) => posesAt(share * end));
      const bodyPoints = fittedPoses.flatMap((now) =>
        some.map((i) => M.move(now[solid.bodies[i]], solid.vertices[i])),
      );
      const pathPoints = meta.paths.flatMap(([points]) => points.filter(isPoint));
      const wordPoints = meta.words.map(([, p]) => p);
      return [...bodyPoints, ...pathPoints, ...wordPoints, ...palePoints];
    }
    /** Amber that a dark ground is seen through looks brown: such a body is white there. */
    function palePalette() {
      if (!isDark()) return pale.palette;
      return pale.palette.map((colour) => (colour === COLOURS.amber ? COLOURS.white : colour));
    }
    function drawFloor() {
      const [x, y, height, half] = floor;
      view.floor(half, height, half > 1 ? 0.5 : 0.2, [x, y]);
    }

    return () => {
      view.begin();
      view.contain(seen);
      if (floor) drawFloor();
      const now = posesAt(state.at);
      view.mesh(solid, now, solid.palette, { shadow: Boolean(floor) });
      if (pale) view.mesh(pale, now, palePalette(), PALE);
      for (const [points, colour, dash] of meta.paths) {
        const path = points.map((p) => (isPoint(p) ? p : null));
        view.line(path, colour, 2.5, { dash });
      }
      for (const [word, p, colour] of meta.words) view.text(p, word, colour);
      view.end();
    };
  }

  // ---- in the plane ----

  /**
   * meta.shapes holds the corners of each thing that moves at each time, meta.colours a colour for
   * each, or nothing; meta.still holds lines and dots.
   */
  function filmInThePlane(card, meta) {
    const { times, half, centre, proportion, closed, title } = meta;
    const step = half > 6 ? 2 : 1;
    const plane = card.map({ half, centre, proportion, label: title, step });
    const state = addPlayer(card, meta, plane);

    function drawStill([points, colour, dash]) {
      if (points.length > 1) plane.line(points, colour, 2, { dash });
      else plane.dot(points[0], colour, 6);
    }
    function drawMoving(corners, number) {
      const colour = meta.colours?.[number] ?? COLOURS.crimson;
      const [i, share] = placeOf(times, state.at);
      const now = corners[i].map((p, k) => {
        if (!share) return p;
        return M.add(p, M.subtract(corners[i + 1][k], p), share);
      });
      if (closed) {
        plane.line(now, colour, 2.5, { closed, fill: 0.25 });
        return;
      }
      plane.line(now, colour, 7);
      for (const joint of now) plane.dot(joint, colour, 5.5, { hollow: true });
    }
    return () => {
      plane.begin();
      meta.still.forEach(drawStill);
      meta.shapes.forEach(drawMoving);
      plane.end();
    };
  }
})();
