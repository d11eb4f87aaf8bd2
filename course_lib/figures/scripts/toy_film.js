// Films and stills. meta.times are those of the stored positions; between them bodies move along
// screws in space, and corners along lines in the plane. A film begins to play, unless the reader
// prefers reduced motion, plays while it is in view, and begins again at its end. A photograph of it
// (meta.photographed) also holds the moving bodies, translucent, at the times meta.ghosts.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const S = globalThis.course.scene;
  const { COLOURS, isDark, tint } = globalThis.course.palette;
  // Milliseconds: after a longer pause of the page a film goes on where it was.
  const MAX_PAUSE = 250;
  const EVERY = 5; // so many vertices apart a few of them stand for all when the view is fitted
  const PALE = { opacity: 0.35 };
  const GHOST = { opacity: 0.3, shadow: false };
  const FLAT_GHOST = 0.1; // how opaque the area of a ghost in the plane is
  const COLUMN = "display:flex;flex-direction:column;gap:.25rem";
  const LEGEND = "display:flex;flex-wrap:wrap;gap:.2rem 1rem";
  const SWATCH = "display:inline-block;width:.9em;height:.9em;margin-right:.35em;background:";
  const SIDE_BY_SIDE = 612; // pixels: room for the picture and the charts beside each other
  // The height of a chart over time, in widths, and that of the last one, which has numbers below.
  const CHART = { beside: 0.3, below: 0.2 };
  const LAST_CHART = { beside: 0.38, below: 0.29 };
  const FITTED_TIMES = 12; // of a film, when the view is fitted
  // On a phone a wide picture is drawn higher, because its words stay as large as they are.
  const NARROW = 480; // pixels
  const LEAST_PROPORTION = 0.65; // of a narrow picture, its height in widths

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
   * @returns {{state: {at: number}, seek: (t: number) => void}} state holds the time; seek stops and
   *   goes to another time
   */
  function addPlayer(card, { times, at, charts, start = 0 }, view) {
    const end = times.at(-1);
    const isStill = at !== undefined;
    const isReduced = matchMedia("(prefers-reduced-motion: reduce)").matches;
    // Beside charts it waits, because there the reader moves the time.
    const begins = end > 0 && !isReduced && !isStill && !charts;
    const state = card.state({ at: at ?? start, plays: begins });
    if (!end || isStill) return { state, seek: () => {} };

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
    function seek(t) {
      play(false);
      state.at = t;
      time.set(t);
      card.draw();
    }
    return { state, seek };
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

  /** The times of the ghosts that are drawn. */
  const ghostsOf = ({ photographed, ghosts = [] }) => (photographed ? ghosts : []);

  /** The part of a mesh that belongs to some of its bodies. */
  function partOf(solid, bodies) {
    const isKept = solid.faces.map(([i]) => bodies.includes(solid.bodies[i]));
    const faces = solid.faces.filter((_, k) => isKept[k]);
    const colours = solid.colours.filter((_, k) => isKept[k]);
    return { ...solid, faces, colours };
  }

  function filmInSpace(card, meta) {
    const { times, centre, radius, azimuth, elevation, title, floor } = meta;
    const solid = S.unpack(meta.solid);
    const pale = meta.pale && S.unpack(meta.pale);
    const poses = posesOf(meta);
    function posesAt(t) {
      const [i, share] = placeOf(times, t);
      if (!share) return poses[i];
      return poses[i].map((from, k) => M.interpolate(from, poses[i + 1][k], share));
    }
    const isBesideCharts = Boolean(meta.charts);
    function proportion() {
      const own = meta.proportion ?? 0.75;
      return view.width < NARROW && !isBesideCharts ? Math.max(own, LEAST_PROPORTION) : own;
    }
    const view = card.space({ radius, centre, azimuth, elevation, label: title, proportion });
    const charts = meta.charts ? chartsOf(card, meta) : null;
    const { state, seek } = addPlayer(card, meta, view);
    charts?.follow(state, seek);
    const seen = pointsToFit();
    const ghosts = ghostsOf(meta);
    const ghost = ghosts.length ? partOf(solid, meta.moving) : null;

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
      for (const t of ghosts) view.mesh(ghost, posesAt(t), solid.palette, GHOST);
      if (pale) view.mesh(pale, now, palePalette(), PALE);
      for (const [points, colour, dash] of meta.paths) {
        const path = points.map((p) => (isPoint(p) ? p : null));
        view.line(path, colour, 2.5, { dash });
      }
      for (const [body, colour, vectors] of meta.arrows ?? []) {
        const from = M.positionOf(now[body]);
        view.arrow(from, M.add(from, vectorAt(times, vectors, state.at)), colour);
      }
      for (const [word, p, colour] of meta.words) view.text(p, word, colour);
      view.end();
      charts?.draw();
    };
  }

  /** A list that is stored at each time, between two of them by straight lines. */
  function vectorAt(times, vectors, t) {
    const [i, share] = placeOf(times, t);
    if (!share) return vectors[i];
    return M.add(vectors[i], M.subtract(vectors[i + 1], vectors[i]), share);
  }

  // ---- charts over time ----

  /**
   * The charts beside a film, with one cursor, which a pointer drags.
   * @returns {{follow: Function, draw: () => void}} follow(state, seek): whose time the cursor
   *   shows, and what moves it
   */
  function chartsOf(card, { times, charts, timeTicks }) {
    const parent = P.element("div", { style: COLUMN }, card.views);
    const end = times.at(-1);
    const planes = charts.map(({ title, label, range, ticks }, i) => {
      const isLast = i === charts.length - 1;
      return card.plane({
        parent,
        x: [0, end],
        y: range,
        margin: true,
        proportion: () => {
          const { beside, below } = isLast ? LAST_CHART : CHART;
          return card.views.clientWidth < SIDE_BY_SIDE ? below : beside;
        },
        ticks: [isLast ? timeTicks : timeTicks.map((tick) => [tick, ""]), ticks],
        names: [isLast ? "time (s)" : "", `${title}: ${label}`],
        label: `${title}, ${label}, over time`,
      });
    });
    let state = null;
    let numbers = null;
    function follow(followed, seek) {
      state = followed;
      addLegend(card.controls, charts[0].curves);
      numbers = card.numbers();
      for (const plane of planes) {
        onDrag(plane, ([t]) => seek(P.clamp(t, 0, end)));
      }
    }
    function draw() {
      planes.forEach((plane, i) => {
        const { range, curves } = charts[i];
        plane.begin();
        for (const [, colour, values] of curves) {
          const points = values.map((value, k) => [times[k], value]);
          plane.line(points, colour, 2);
        }
        const cursor = range.map((value) => [state.at, value]);
        plane.line(cursor, COLOURS.black, 1.5);
        for (const [, colour, values] of curves) {
          plane.dot([state.at, vectorAt(times, asColumn(values), state.at)[0]], colour, 4);
        }
        plane.end();
      });
      const lines = charts.map(({ title, curves }) => {
        const values = curves.map(([, , column]) => vectorAt(times, asColumn(column), state.at)[0]);
        return `${title}: (${P.list(values, 3)})`;
      });
      numbers(...lines);
    }
    return { follow, draw };
  }
  const asColumn = (values) => values.map((value) => [value]);

  function addLegend(parent, curves) {
    const legend = P.element("p", { style: LEGEND }, parent);
    for (const [name, colour] of curves) {
      const item = P.element("span", {}, legend);
      P.element("span", { style: SWATCH + tint(colour) }, item);
      item.append(name);
    }
  }

  /** Call act with the place of a pointer that is pressed, and while it is dragged. */
  function onDrag(plane, act) {
    const { canvas } = plane;
    canvas.style.touchAction = "pan-y"; // a finger that moves up or down scrolls the page
    canvas.style.cursor = "ew-resize";
    let isHeld = false;
    const follow = (event) => act(plane.fromPixels(P.pixelOf(event, canvas)));
    canvas.addEventListener("pointerdown", (event) => {
      isHeld = true;
      canvas.setPointerCapture(event.pointerId);
      follow(event);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (isHeld) follow(event);
    });
    P.onRelease(canvas, () => {
      isHeld = false;
    });
  }

  // ---- in the plane ----

  /**
   * meta.shapes holds the corners of each thing that moves at each time, meta.colours a colour for
   * each, or nothing; meta.still holds lines and dots. With meta.names each thing has a map of its
   * own, beside the others, with its name above.
   */
  function filmInThePlane(card, meta) {
    const { times, names, title, half, centre, proportion } = meta;
    const wideStep = names ? 5 : 2;
    const step = half > 6 ? wideStep : 1;
    const options = { half, centre, proportion, step };
    const maps = names
      ? names.map((name) => mapWithName(card, name, { ...options, label: `${title}: ${name}` }))
      : [card.map({ ...options, label: title })];
    const { state } = addPlayer(card, meta, maps[0]);
    const ghosts = ghostsOf(meta);

    /** The corners of a thing that moves, at a time. */
    function cornersAt(number, t) {
      const [i, share] = placeOf(times, t);
      const corners = meta.shapes[number];
      return corners[i].map((p, k) => {
        if (!share) return p;
        return M.add(p, M.subtract(corners[i + 1][k], p), share);
      });
    }
    return () => {
      maps.forEach((plane, map) => {
        const things = names ? [map] : [...meta.shapes.keys()];
        plane.begin();
        for (const still of meta.still) {
          const isOfOther = names && (still[3] ?? map) !== map;
          if (!isOfOther) drawStill(plane, still);
        }
        const looks = things.map((number) => [number, meta.colours?.[number] ?? COLOURS.crimson]);
        for (const t of ghosts) {
          for (const [number, colour] of looks) {
            drawGhost(plane, cornersAt(number, t), colour, meta);
          }
        }
        for (const [number, colour] of looks) {
          drawMoving(plane, cornersAt(number, state.at), colour, meta);
        }
        plane.end();
      });
    };
  }

  /** A map below its name, side by side with others, also on a phone. */
  function mapWithName(card, name, options) {
    const parent = P.element("div", { class: "half" }, card.views);
    P.element("div", { style: "text-align:center;font-weight:600" }, parent, name);
    return card.map({ parent, ...options });
  }
  function drawStill(plane, [points, colour, dash]) {
    if (points.length > 1) plane.line(points, colour, 2, { dash });
    else plane.dot(points[0], colour, 6);
  }
  function drawMoving(plane, corners, colour, { closed }) {
    if (closed) {
      plane.line(corners, colour, 2.5, { closed, fill: 0.25 });
      return;
    }
    plane.line(corners, colour, 7);
    for (const joint of corners) plane.dot(joint, colour, 5.5, { hollow: true });
  }
  function drawGhost(plane, corners, colour, { closed }) {
    if (closed) plane.line(corners, colour, 1, { closed, fill: FLAT_GHOST });
    else plane.line(corners, colour, 1.5);
  }
})();
