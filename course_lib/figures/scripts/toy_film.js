// Films and stills. meta.times are those of the stored positions; between them bodies move along screws in space, and
// corners along lines in the plane. A film begins by itself, unless the reader prefers reduced motion, plays while it is
// in view, and begins again at its end.
(() => {
  "use strict";
  const M = globalThis.course.motion,
    P = globalThis.course.parts,
    S = globalThis.course.scene,
    { COLOURS } = P;

  // The number of the last of the times before t, and the share of the way to the next.
  function place(times, t) {
    const next = times.findIndex((time) => time > t),
      i = next < 0 ? times.length - 1 : next - 1;
    return [i, next < 0 ? 0 : (t - times[i]) / (times[next] - times[i])];
  }
  // A range for the time and a button that plays, if there is more than one time; returns what holds the time.
  function player(card, meta, view) {
    const { times } = meta,
      last = times[times.length - 1],
      still = meta.at !== undefined;
    const reduced = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const state = card.state({ at: meta.at || 0, plays: last > 0 && !reduced && !still });
    if (!last || still) return state;
    const limits = { min: 0, max: last, step: 0.01 };
    const time = card.setting("Time", state, "at", limits, (t) => `${P.number(t)} s`);
    time.input.addEventListener("input", () => play(false));
    const button = card.button("", () => play(!state.plays));
    let before = null,
      isVisible = true,
      frame = null;
    const step = (now) => {
      frame = requestAnimationFrame(step);
      const passed = Math.min(now - (before || now), 250) / 1000; // after a pause of the page it goes on
      before = now;
      if (!isVisible || view.held) return;
      state.at = state.at >= last ? 0 : Math.min(last, state.at + passed);
      time.set(state.at);
      card.draw();
    };
    const play = (plays) => {
      state.plays = plays;
      button.textContent = plays ? "Pause" : "Play";
      cancelAnimationFrame(frame);
      before = null;
      if (plays) frame = requestAnimationFrame(step);
    };
    const watch = new IntersectionObserver(
      (entries) => (isVisible = entries[entries.length - 1].isIntersecting),
    );
    watch.observe(view.box);
    card.atEnd(() => {
      cancelAnimationFrame(frame);
      watch.disconnect();
    });
    play(state.plays);
    return state;
  }

  // meta.rotations and meta.positions hold, for each time and each body, a rotation vector and a position in millimetres.
  function inSpace(card, meta) {
    const { times, centre, azimuth, elevation, title: label, floor } = meta,
      last = times[times.length - 1];
    const solid = S.unpack(meta.solid),
      pale = meta.pale && S.unpack(meta.pale);
    const poses = meta.rotations.map((bodies, i) =>
      bodies.map((w, k) =>
        M.pose(M.rotationOf(M.exp([...w, 0, 0, 0])), M.scale(meta.positions[i][k], 1e-3)),
      ),
    );
    const at = (t) => {
      const [i, share] = place(times, t);
      return poses[i].map((from, k) =>
        share ? M.interpolate(from, poses[i + 1][k], share) : from,
      );
    };
    const view = card.space({
      radius: meta.radius,
      centre,
      azimuth,
      elevation,
      label,
      proportion: meta.proportion,
    });
    const state = player(card, meta, view);
    // What is in the picture: the bodies at some of the times, the paths and the words.
    const some = solid.vertices.map((_, i) => i).filter((i) => i % 5 === 0);
    const seen =
      meta.near ||
      M.sampled(last ? 12 : 1, (s) => at(s * last)).flatMap((now) =>
        some.map((i) => M.move(now[solid.bodies[i]], solid.vertices[i])),
      );
    if (!meta.near)
      seen.push(
        ...meta.paths.flatMap(([points]) => points.filter((p) => p[0] !== null)),
        ...meta.words.map(([, p]) => p),
      );
    if (pale) seen.push(...pale.vertices.map((p, i) => M.move(poses[0][pale.bodies[i]], p)));
    return () => {
      view.begin();
      view.contain(seen);
      if (floor) view.floor(floor[3], floor[2], floor[3] > 1 ? 0.5 : 0.2, floor.slice(0, 2));
      view.mesh(solid, at(state.at), solid.palette, { shadow: Boolean(floor) });
      if (pale) view.mesh(pale, at(state.at), pale.palette, { opacity: 0.35 });
      meta.paths.forEach(([points, colour, dash]) =>
        view.line(
          points.map((p) => (p[0] === null ? null : p)),
          colour,
          2.5,
          { dash },
        ),
      );
      meta.words.forEach(([word, p, colour]) => view.text(p, word, colour));
      view.end();
    };
  }

  // meta.shapes holds the corners of each thing that moves at each time; meta.still lines and dots.
  function inThePlane(card, meta) {
    const { times, half, centre, proportion, closed, title: label } = meta;
    const plane = card.map({ half, centre, proportion, label, step: half > 6 ? 2 : 1 }),
      state = player(card, meta, plane);
    return () => {
      const [i, share] = place(times, state.at);
      plane.begin();
      meta.still.forEach(([points, colour, dash]) =>
        points.length > 1
          ? plane.line(points, colour, 2, { dash })
          : plane.dot(points[0], colour, 6),
      );
      meta.shapes.forEach((corners) => {
        const now = corners[i].map((p, k) =>
          share ? M.add(p, M.add(corners[i + 1][k], p, -1), share) : p,
        );
        plane.line(now, COLOURS.crimson, closed ? 2.5 : 7, closed ? { closed, fill: 0.25 } : {});
        if (!closed) now.forEach((p) => plane.dot(p, COLOURS.crimson, 5.5, { hollow: true }));
      });
      plane.end();
    };
  }

  P.toy(
    "film",
    ({ title }) => title,
    (card, meta) => (meta.shapes ? inThePlane : inSpace)(card, meta),
  );
})();
