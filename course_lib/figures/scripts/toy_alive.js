// Figures in which the student's own function lives. What is dragged is a question; in a live notebook the function
// answers it, one question at a time, the newest first; where it raises or there is no kernel, the library's does.
// meta.figure says which: "reach" (a target, joint angles), "fly" (two orientations, the motion between them), "table"
// (a position, joint angles of a planar arm with two links, beside the true ones) or "drive" (velocities, poses).
(() => {
  "use strict";
  const M = globalThis.course.motion, P = globalThis.course.parts, S = globalThis.course.scene, { COLOURS } = P;
  const rad = Math.PI / 180, mm = (x) => `${P.number(1000 * x, x < 1 ? 1 : 0)} mm`;
  // What a figure says of whose answer it shows; `own` is what it found out about it.
  const said = (answer, own, library) => (answer && answer.value ? `Answered by ${answer.whose}. ${own}`
    : answer ? `${answer.problem} The library's answer is shown. ${library}` : library);

  // ---- a target, and an arm that reaches for it ----

  function reach(card, meta, ask, state) {
    const { arm, limits, size, goal, starts } = meta, n = arm.screws.length, solid = S.unpack(meta.solid);
    const draw = P.once(() => paint()), isPose = goal.length === 4, flat = goal.length === 2;
    const now = state.now || (state.now = {
      q: meta.q, all: starts, turn: 1, at: isPose ? M.positionOf(goal) : [...goal, 0].slice(0, 3), rotated: [0, 0, 0],
    });
    const view = P.space(card.views, {
      radius: 0.1 * size, centre: meta.centre, azimuth: -1, elevation: flat ? 1.1 : meta.elevation, label: meta.title,
      meta: state, redraw: draw,
    });
    const target = () => {
      const turns = [[0, 0, 1], [0, 1, 0], [1, 0, 0]].map((axis, i) => M.rotation(axis, now.rotated[i] * rad));
      return isPose ? M.pose(M.times(turns.reduce(M.times), M.rotationOf(goal)), now.at) : now.at.slice(0, goal.length);
    };
    // Several solutions of the library: each is followed on its own, and shown where it gets to the target.
    const off = (q, T) => (isPose ? M.norm(M.poseError(M.frames(arm, q)[n], T)) : miss(q, T));
    const solved = (q, T) => M.reach(arm, q, flat ? [...T, 0] : T, {
      limits: limits.map(() => [-Infinity, Infinity]), steps: 60,
    });
    const differ = (q, p) => q.some((x, i) => Math.abs(M.wrap(x - p[i])) > 0.01);
    const library = (T) => {
      if (!starts) return [now.q];
      const found = now.all.filter((q, i) => off(q, T) < 1e-3 && now.all.slice(0, i).every((p) => differ(q, p)));
      return found.length ? found : [now.all[0]];
    };
    const moved = () => {
      const T = target();
      if (starts) now.all = starts.map((start, i) => {
        const q = solved(now.all[i], T);
        return off(q, T) < 1e-3 ? q : solved(start, T);
      });
      else now.q = M.reach(arm, now.q, flat ? [...T, 0] : T, { limits, steps: 60 });
      ask({ target: T });
      draw();
    };
    view.handle({
      name: "Target", colour: COLOURS.blue, at: () => now.at,
      moved: (p) => { now.at = flat ? view.onFloor(p) : p; moved(); },
    });
    if (isPose) ["z", "y", "x"].forEach((axis, i) => {
      const options = { min: -180, max: 180, step: 1, value: now.rotated[i] };
      card.range(`Rotate about ${axis}`, options, (x) => `${x}°`, (x) => { now.rotated[i] = x; moved(); });
    });
    if (starts) {
      const turn = card.range("Solution", { min: 1, max: starts.length, step: 0.01, value: now.turn }, (x) =>
        [...new Set([Math.floor(x), Math.ceil(x)])].join(" to "), (x) => { now.turn = x; draw(); });
      card.player("From one to the next", turn, 0.0025);
    }
    const numbers = card.numbers(), words = card.words();
    const miss = (q, T) => {
      const end = M.frames(arm, q)[n];
      return M.norm(M.add(M.positionOf(end), isPose ? M.positionOf(T) : now.at, -1));
    };
    function paint() {
      const { answer } = state, theirs = (answer && answer.value) || [], T = target();
      const shown = theirs.length ? theirs : library(T);
      const many = shown.length === 1 ? "One solution." : `${shown.length} solutions, one of them solid.`;
      const turn = Math.min(now.turn, shown.length) - 1, i = Math.floor(turn), s = (turn - i) ** 2 * (3 - 2 * (turn - i));
      const first = s ? shown[i].map((x, k) => x + s * M.wrap(shown[i + 1][k] - x)) : shown[i];
      const drawn = [first, ...shown.filter((_, k) => s || k !== i)];
      view.begin();
      drawn.forEach((q) => view.onStage(solid, M.bodies(arm, q), meta));
      view.contain([now.at]);
      drawn.forEach((q, k) => view.mesh(solid, M.bodies(arm, q), solid.palette, { opacity: k ? 0.3 : 1, shadow: !k }));
      if (isPose) view.frame(T, 0.14 * size, { thick: 0.005 * size });
      view.frame(M.frames(arm, first)[n], 0.09 * size, { thick: 0.006 * size });
      view.end();
      numbers(...shown.slice(0, 8).map((q, i) => `q${shown.length > 1 ? ` (${i + 1})` : ""} = (${q.map((x) =>
        P.degrees(x)).join(", ")}), ${mm(miss(q, T))} from the target`));
      const count = theirs.length > 1 ? many : "";
      const none = answer && answer.value && !theirs.length;
      const own = none ? "It finds no solution here; the library comes this near." : count;
      const lost = starts && off(shown[0], T) > 1e-3 ? "No solution here; the arm comes as near as it can." : many;
      const more = (answer && answer.said) || "", both = [own, more].filter(Boolean).join(" ");
      words.textContent = said(answer, both, starts ? lost : "Drag the target: the arm follows.");
    }
    moved();
    return { paint, draw, stop: () => view.stop() };
  }

  // ---- two orientations, and the motion between them ----

  function fly(card, meta, ask, state) {
    const draw = P.once(() => paint()), PLACES = [[-1.7, 0, 0], [1.7, 0, 0]];
    const now = state.now || (state.now = { ends: meta.ends, s: 0.5 });
    const view = P.space(card.views, {
      radius: 1.5, elevation: 0.3, azimuth: -1.2, proportion: 0.55, label: meta.title, meta: state, redraw: draw,
    });
    // The nose goes where it is dragged, by the shortest rotation; a wing tip rotates about the nose.
    [["Start", COLOURS.blue], ["Goal", COLOURS.green]].forEach(([name, colour], i) => {
      [["nose", [0.95, 0, 0]], ["wing", [0, 0.95, 0]]].forEach(([part, tip], j) => view.handle({
        name: `${name}, ${part}`, colour, small: j === 1, at: () => M.add(PLACES[i], M.apply(now.ends[i], tip)),
        describe: () => now.ends[i].flat().map((x) => P.number(x)).join(" "),
        moved: (p) => {
          const R = now.ends[i], nose = M.apply(R, [1, 0, 0]), from = M.apply(R, M.unit(tip));
          const to = M.unit(M.add(p, PLACES[i], -1));
          const axis = j ? nose : M.cross(from, to), sine = M.norm(axis);
          const angle = j ? M.angleAbout(nose, from, to) : Math.atan2(sine, M.dot(from, to));
          if (sine > 1e-9) now.ends[i] = M.times(M.rotation(M.unit(axis), angle), R);
          ask({ ends: now.ends });
          draw();
        },
      }));
    });
    const share = card.range("Along the motion", { min: 0, max: 1, step: 0.01, value: now.s },
      (x) => `${Math.round(100 * x)} %`, (x) => { now.s = x; draw(); });
    card.player("Fly", share, 0.008);
    const numbers = card.numbers(), words = card.words();
    function paint() {
      const { answer } = state, [A, B] = now.ends, [a, b] = now.ends.map((R) => M.pose(R, [0, 0, 0]));
      const library = (s) => M.rotationOf(M.interpolate(a, b, s)), theirs = answer && answer.value;
      const at = (s) => (theirs ? theirs[Math.round(s * (theirs.length - 1))] : library(s));
      const place = (s) => M.add(M.scale(PLACES[0], 1 - s), PLACES[1], s), put = (R, p) =>
        M.pose(R.map((row) => M.scale(row, 0.85)), p);
      view.begin();
      view.contain([[-2.4, 0, 0.7], [2.4, 0, 0.7]]);
      [[A, 0], [B, 1]].forEach(([R, s]) => view.mesh(S.aircraft, [put(R, place(s))], S.PALETTE, { opacity: 0.4 }));
      view.mesh(S.aircraft, [put(at(now.s), place(now.s))], S.PALETTE);
      const trail = (motion, colour, look) => [[0.85, 0, 0], [0, 0.8, 0]].forEach((tip) => view.line(Array.from(
        { length: 41 }, (_, k) => M.add(place(k / 40), M.apply(motion(k / 40), tip)),
      ), colour, 2, look));
      if (theirs) trail(library, COLOURS.blue, { dash: [5, 5] });
      trail(at, COLOURS.crimson);
      view.end();
      const apart = (R, Q) => M.norm(M.rotationVector(M.times(M.transpose(R), Q)));
      const steps = Array.from({ length: 40 }, (_, k) => apart(at(k / 40), at((k + 1) / 40)));
      const whole = steps.reduce((x, y) => x + y, 0);
      numbers(["R now =", P.matrix(at(now.s))], `the shortest rotation: ${P.degrees(apart(A, B), 1)}\n`
        + `this motion rotates by ${P.degrees(whole, 1)} in all`);
      const off = theirs ? Math.max(...Array.from({ length: 41 }, (_, k) => apart(at(k / 40), library(k / 40)))) : 0;
      const own = off < 1e-3 ? "It agrees with the library."
        : `The library's motion, dashed, differs by up to ${P.degrees(off, 1)}.`;
      words.textContent = said(answer, own, "Drag a nose or a wing tip; the library flies the shortest rotation.");
    }
    ask({ ends: now.ends });
    return { paint, draw, stop: () => view.stop() };
  }

  // ---- a position, and the answer of a table beside the true arm ----

  function table(card, meta, ask, state) {
    const { lengths, stored } = meta, draw = P.once(() => paint()), reach = lengths[0] + lengths[1];
    const now = state.now || (state.now = { at: meta.at });
    const plane = P.map(card.views, { half: 1.15 * reach, label: meta.title, proportion: 0.9, redraw: draw });
    plane.handle({
      name: "Query", colour: COLOURS.blue, at: () => now.at, moved: (p) => { now.at = p; ask({ at: p }); draw(); },
      describe: () => `${now.at.map((x) => P.number(x)).join(", ")} m`,
    });
    const numbers = card.numbers(), words = card.words();
    function paint() {
      const { answer } = state, truth = M.twoLink(lengths, now.at);
      let found = answer ? answer.value : null, from = now.at;
      if (!answer && stored) { // on a page: the answer to the nearest question that was asked beforehand
        const near = stored.at.map((p) => M.norm(M.add(p, now.at, -1))), k = near.indexOf(Math.min(...near));
        [found, from] = [stored.q[k], stored.at[k]];
      }
      const q = found && found.length ? found : null, tip = q && M.planarPoints(lengths, q)[2];
      const arm = (q, colours, width) => {
        const points = M.planarPoints(lengths, q);
        [0, 1].forEach((k) => plane.line(points.slice(k, k + 2), colours[k], width - k));
        points.slice(0, 2).forEach((p) => plane.dot(p, "#2f3338", 4));
      };
      plane.begin();
      plane.line(P.circle(reach), COLOURS.grey, 1);
      const turned = truth && q && q[1] < 0; // the other elbow
      const mirrored = turned ? [2 * Math.atan2(now.at[1], now.at[0]) - truth[0], -truth[1]] : truth;
      if (mirrored) arm(mirrored, [COLOURS.blue, COLOURS.blue], 9);
      if (q) arm(q, [COLOURS.steel, COLOURS.link], 6);
      if (from !== now.at) plane.dot(from, COLOURS.crimson, 4, { hollow: true });
      if (q) plane.line([from, tip], COLOURS.crimson, 2);
      if (q) plane.dot(tip, COLOURS.crimson, 5);
      plane.end();
      const degrees = (q) => (q ? `(${q.map((x) => P.degrees(x, 1)).join(", ")})` : "none: out of reach");
      numbers(`true: q = ${degrees(mirrored)}`, `answer: q = ${q ? degrees(q) : "none"}`);
      const off = q ? `The tip is ${mm(M.norm(M.add(tip, from, -1)))} from the query.` : "It gives no answer here.";
      words.textContent = answer || !stored ? said(answer, off, "The blue arm is the true one. Drag the query.")
        : `${off} The blue arm is the true one.`;
    }
    ask({ at: now.at });
    return { paint, draw, stop: () => plane.stop() };
  }

  // ---- a robot to drive, and where its own log says that it is ----

  function drive(card, meta, ask, state) {
    const { half, centre, plan, exact, dock } = meta, RADIUS = 0.17, LONGEST = 90, draw = P.once(() => paint());
    const now = state.now || (state.now = { log: plan, dt: meta.dt, hidden: false });
    const held = new Set(); // of the directions below
    const plane = P.map(card.views, {
      half, centre, label: `${meta.title}. Arrow keys drive the robot`, proportion: 0.72, redraw: draw,
    });
    const DIRECTIONS = { ArrowUp: ["Ahead", 0.5, 0], ArrowDown: ["Back", -0.5, 0] };
    Object.assign(DIRECTIONS, { ArrowLeft: ["Left", 0, 0.9], ArrowRight: ["Right", 0, -0.9] });
    const inside = (at) => [half, 0.72 * half].every((room, k) => Math.abs(at[k] - centre[k]) < room - RADIUS);
    const poses = (dt) => M.propagate([0, 0, 0], now.log, dt), last = (rows) => rows[rows.length - 1];
    const asked = () => ask({ plan: now.log, dt: now.dt });
    // Append some seconds to the log; the wall stops the robot, and its wheels.
    const advance = (seconds) => {
      const [v, omega] = [1, 2].map((k) => [...held].reduce((sum, key) => sum + DIRECTIONS[key][k], 0));
      const before = last(now.log), used = now.log.reduce((sum, pair) => sum + pair[1], 0);
      if ((!v && !omega) || used > LONGEST) return;
      if (v && !inside(M.expPlanar(last(poses(1).exact), [omega * seconds, v * seconds, 0]))) return;
      const same = before && before[0][0] === v && before[0][2] === omega;
      now.log = same ? [...now.log.slice(0, -1), [before[0], before[1] + seconds]]
        : [...now.log, [[v, 0, omega], seconds]];
      asked();
    };
    let frame = null;
    const run = (then) => {
      frame = requestAnimationFrame((time) => {
        advance(Math.min(0.05, Math.max(0, (time - then) / 1000)));
        draw();
        if (held.size) run(time);
        else frame = null;
      });
    };
    const press = (key) => {
      if (held.has(key)) return;
      held.add(key);
      advance(0.05); // however short the press
      draw();
      if (frame === null) run(performance.now());
    };
    const release = () => { held.clear(); asked(); draw(); };
    const { canvas } = plane;
    Object.assign(canvas.style, { cursor: "pointer" });
    canvas.tabIndex = 0;
    canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
    canvas.addEventListener("blur", release);
    canvas.addEventListener("keyup", (event) => { held.delete(event.key); if (!held.size) release(); });
    canvas.addEventListener("keydown", (event) => {
      if (!DIRECTIONS[event.key]) return;
      press(event.key);
      event.preventDefault();
      event.stopPropagation();
    });
    // A button drives as long as it is held; pressed by a key, for half a second.
    Object.entries(DIRECTIONS).forEach(([key, [name]]) => {
      const made = card.button(name, () => {});
      made.style.cssText = "min-height:44px;touch-action:none;user-select:none;-webkit-user-select:none";
      made.addEventListener("pointerdown", (event) => { made.setPointerCapture(event.pointerId); press(key); });
      ["pointerup", "pointercancel"].forEach((kind) => made.addEventListener(kind, release));
      made.addEventListener("contextmenu", (event) => event.preventDefault());
      made.addEventListener("click", (event) => {
        if (event.detail) return;
        held.add(key);
        for (let k = 0; k < 10; k++) advance(0.05);
        release();
      });
    });
    card.button("Start again", () => { now.log = []; state.answer = null; asked(); draw(); });
    card.tick("Hide the robot", now.hidden, (on) => { now.hidden = on; draw(); });
    card.range("Step dt", { min: 0.1, max: 1, step: 0.1, value: now.dt }, (x) => `${x.toFixed(1)} s`,
      (x) => { now.dt = x; asked(); draw(); });
    const words = card.words();
    function paint() {
      const { answer } = state, truth = poses(0.05).exact, theirs = answer && answer.value;
      const ghost = theirs || poses(now.dt)[exact ? "exact" : "euler"], own = last(ghost);
      const sketch = (path, [u, v, angle], colour, dash) => {
        plane.line(path, colour, 2, { dash });
        plane.line(P.circle(RADIUS, [u, v]), colour, 1.5, { closed: true, fill: 0.25 });
        plane.line([[u, v], [u + RADIUS * Math.cos(angle), v + RADIUS * Math.sin(angle)]], colour, 2);
      };
      plane.begin();
      plane.line(P.circle(1.2 * RADIUS, dock), COLOURS.green, 4, { dash: [4, 6] });
      plane.text([dock[0], dock[1] - 0.4], "dock", COLOURS.green);
      if (!now.hidden) sketch(truth, last(truth), COLOURS.blue, []);
      sketch(ghost, own, COLOURS.crimson, [7, 5]);
      if (ghost.length < 200) ghost.forEach((p) => plane.dot(p, COLOURS.crimson, 2.5));
      plane.end();
      const then = theirs ? last(M.propagate([0, 0, 0], answer.plan, 1).exact) : last(truth); // when it was asked
      const off = 100 * M.norm([own[0] - then[0], own[1] - then[1]]), rotated = Math.abs(M.wrap(own[2] - then[2]));
      const far = `Red, where it believes it is, is ${P.number(off, off < 10 ? 1 : 0)} cm and ${P.degrees(rotated)} off.`;
      const here = now.hidden ? "Drive the red robot to the dock, then show the blue one." : far;
      words.textContent = said(answer, here, here);
    }
    asked();
    return { paint, draw, stop: () => { held.clear(); cancelAnimationFrame(frame); plane.stop(); } };
  }

  const FIGURES = { reach, fly, table, drive };
  globalThis.course.kinds["toy:alive"] = (host, meta, kernel) => {
    const state = meta.state || (meta.state = { answer: null }), card = P.card(host, meta.title);
    let figure = null;
    const ask = P.asker(kernel, (answer) => { state.answer = answer; figure.draw(); });
    figure = FIGURES[meta.figure](card, meta, ask, state);
    figure.paint();
    return () => { figure.stop(); card.end(); };
  };
})();
