// Figures that call the student's own function. What is dragged is a question; in a live notebook the function answers
// it, one question at a time, the newest first; if it raises or there is no kernel, the library's function answers.
// meta.figure says which: "reach" (a pose, joint angles), "fly" (two orientations, the motion between them), "table"
// (a position, joint angles of a planar arm with two links, beside the true ones), "drive" (velocities, poses) or
// "click" (pixels and depths in two pictures of a mug, its pose).
(() => {
  "use strict";
  const M = globalThis.course.motion,
    P = globalThis.course.parts,
    S = globalThis.course.scene,
    { COLOURS, rad } = P;
  const mm = (x) => `${P.number(1000 * x, x < 1 ? 1 : 0)} mm`;
  // What a figure says of whose answer it shows; `own` is what it found out about it.
  const said = ({ answer, asked }, own, library) =>
    answer && answer.value
      ? `Answered by ${answer.whose}. ${own}`
      : answer
        ? `${answer.problem} The library's answer is shown. ${library}`
        : asked
          ? "Your function has not answered yet; the library's answer is shown."
          : library;

  // ---- a target, and an arm that reaches for it ----

  function reach(card, meta, ask) {
    const { arm, limits, size, goal, starts } = meta,
      n = arm.screws.length,
      view = card.armSpace();
    const state = card.state({
      q: meta.q,
      all: starts,
      chosen: 1,
      at: M.positionOf(goal),
      rotated: [0, 0, 0],
    });
    let room = [-1, 1].flatMap((s) => M.eye(3).map((e) => M.add(state.at, e, 0.15 * s * size))); // to begin dragging
    const target = () => {
      const zyx = [
        [0, 0, 1],
        [0, 1, 0],
        [1, 0, 0],
      ].map((axis, i) => M.rotation(axis, state.rotated[i] * rad));
      return M.pose(M.times(zyx.reduce(M.times), M.rotationOf(goal)), state.at);
    };
    // Several solutions of the library: each is followed on its own, and shown if it reaches the target.
    const error = (q, T) => M.poseError(M.frames(arm, q)[n], T),
      off = (q, T) => M.norm(error(q, T));
    const solved = (q, T, most) =>
      M.reach(
        arm,
        q,
        T,
        limits.map(() => [-Infinity, Infinity]),
        most,
      );
    const differ = (q, p) => q.some((x, i) => Math.abs(M.wrap(x - p[i])) > 0.01);
    const library = (T) => {
      if (!starts) return [state.q];
      const found = state.all.filter(
        (q, i) => off(q, T) < 1e-3 && state.all.slice(0, i).every((p) => differ(q, p)),
      );
      return found.length ? found : [state.all[0]];
    };
    const moved = () => {
      const T = target(),
        [last] = state.all || [];
      if (starts) {
        state.all = starts.map((start, i) => {
          const q = solved(state.all[i], T, 60);
          return off(q, T) < 1e-3 ? q : solved(start, T, 60);
        });
        if (state.all.every((q) => off(q, T) > 1e-3)) state.all[0] = solved(last, T);
      } else state.q = M.reach(arm, state.q, T, limits);
      ask({ target: T });
    };
    // The target stays above the floor and little farther from the base than the arm reaches.
    const near = (p) =>
      M.scale([p[0], p[1], Math.max(p[2], meta.ground)], Math.min(1, (1.15 * size) / M.norm(p)));
    view.handle({
      name: "Target",
      colour: COLOURS.blue,
      at: () => state.at,
      moved: (p) => {
        state.at = near(p);
        moved();
      },
    });
    ["z", "y", "x"].forEach((axis, i) => {
      const options = { min: -180, max: 180, step: 1, value: state.rotated[i] };
      card.range(`Rotate about ${axis}`, options, P.inDegrees, (x) => {
        state.rotated[i] = x;
        moved();
      });
    });
    if (starts) {
      const between = (x) => [...new Set([Math.floor(x), Math.ceil(x)])].join(" to ");
      const limits = { min: 1, max: starts.length, step: 0.01, keys: 1 };
      const solution = card.setting("Solution", state, "chosen", limits, between);
      card.player("From one to the next", solution, 0.0025);
    }
    const numbers = card.numbers(),
      words = card.words();
    moved();
    return () => {
      const { answer } = state,
        theirs = (answer && answer.value) || [],
        T = target();
      const shown = theirs.length ? theirs : library(T);
      const many =
        shown.length === 1 ? "One solution." : `${shown.length} solutions, one of them solid.`;
      const chosen = Math.min(state.chosen, shown.length) - 1,
        i = Math.floor(chosen),
        part = chosen - i;
      const s = part ** 2 * (3 - 2 * part); // slow at both ends
      const first = s ? shown[i].map((x, k) => x + s * M.wrap(shown[i + 1][k] - x)) : shown[i];
      const drawn = [first, ...shown.filter((_, k) => s || k !== i)];
      view.begin();
      drawn.forEach((q) => view.stand(M.bodies(arm, q)));
      view.contain([state.at, ...room]);
      room = [];
      drawn.forEach((q, k) => view.arm(M.bodies(arm, q), { opacity: k ? 0.3 : 1, shadow: !k }));
      view.frame(T, 0.14 * size, { thick: 0.005 * size });
      view.frame(M.frames(arm, first)[n], 0.09 * size, { thick: 0.006 * size });
      view.end();
      numbers(
        ...shown.slice(0, 8).map((q, i) => {
          const off = M.norm(error(q, T).slice(3)),
            isOne = shown.length === 1;
          return (
            `${isOne ? "" : `${i + 1}: `}q = (${q.map((x) => P.degrees(x)).join(", ")})` +
            (isOne || off > 5e-5 ? `, ${mm(off)} from the target` : "")
          );
        }),
      );
      const count = theirs.length > 1 ? many : "";
      const none = answer && answer.value && !theirs.length;
      const isLost = off(shown[0], T) > 1e-3;
      const lost = isLost
        ? "Out of reach: the arm comes as near as it can."
        : starts
          ? many
          : "The target is within reach: the arm follows.";
      const more = (answer && answer.said) || "",
        both = [count, more].filter(Boolean).join(" ");
      words.textContent = none
        ? `No solution from ${answer.whose}. The arm is the library's${
            isLost ? ": out of reach, as near as it can come" : ", which finds one"
          }. ${more}`
        : said(state, both, lost);
    };
  }

  // ---- two orientations, and the motion between them ----

  function fly(card, meta, ask) {
    const SIZE = 0.85,
      NOSE = [0.85 * SIZE, 0, 0],
      WING = [0, 0.85 * SIZE, 0]; // as scene.js makes the aircraft
    const PLACES = [
        [-1.7, 0, 0],
        [1.7, 0, 0],
      ],
      state = card.state({ ends: meta.ends, s: 0.5 });
    const view = card.space({
      radius: 1.5,
      elevation: 0.3,
      azimuth: -1.2,
      proportion: 0.55,
      label: meta.title,
    });
    // The nose goes where it is dragged, by the shortest rotation; a wing tip rotates about the nose.
    [
      ["Start", COLOURS.blue],
      ["Goal", COLOURS.orange],
    ].forEach(([name, colour], i) => {
      [
        ["nose", NOSE],
        ["wing", WING],
      ].forEach(([part, tip], j) =>
        view.handle({
          name: `${name}, ${part}`,
          colour,
          small: j === 1,
          at: () => M.add(PLACES[i], M.apply(state.ends[i], tip)),
          describe: () => P.list(state.ends[i].flat()),
          moved: (p) => {
            const R = state.ends[i],
              nose = M.apply(R, [1, 0, 0]),
              from = M.apply(R, M.unit(tip));
            const to = M.unit(M.add(p, PLACES[i], -1));
            const axis = j ? nose : M.cross(from, to),
              sine = M.norm(axis);
            const angle = j ? M.angleAbout(nose, from, to) : Math.atan2(sine, M.dot(from, to));
            if (sine > 1e-9) state.ends[i] = M.times(M.rotation(M.unit(axis), angle), R);
            ask({ ends: state.ends });
          },
        }),
      );
    });
    card.player("Fly", card.share("Along the motion", state, "s"), 0.008);
    const numbers = card.numbers(),
      words = card.words();
    ask({ ends: state.ends });
    return () => {
      const { answer } = state,
        [A, B] = state.ends,
        [a, b] = state.ends.map((R) => M.pose(R, [0, 0, 0]));
      const library = (s) => M.rotationOf(M.interpolate(a, b, s)),
        theirs = answer && answer.value;
      const at = (s) => (theirs ? theirs[Math.round(s * (theirs.length - 1))] : library(s));
      const place = (s) => M.add(M.scale(PLACES[0], 1 - s), PLACES[1], s),
        put = (R, p) =>
          M.pose(
            R.map((row) => M.scale(row, SIZE)),
            p,
          );
      view.begin();
      view.contain([
        [-2.4, 0, 0.7],
        [2.4, 0, 0.7],
      ]);
      [
        [A, 0],
        [B, 1],
      ].forEach(([R, s]) => view.mesh(S.aircraft, [put(R, place(s))], S.PALETTE, { opacity: 0.4 }));
      view.mesh(S.aircraft, [put(at(state.s), place(state.s))], S.PALETTE);
      const trail = (motion, colour, look) =>
        [NOSE, WING].forEach((tip) =>
          view.line(
            M.sampled(40, (s) => M.add(place(s), M.apply(motion(s), tip))),
            colour,
            2,
            look,
          ),
        );
      if (theirs) trail(library, COLOURS.blue, { dash: [5, 5] });
      trail(at, COLOURS.crimson);
      view.end();
      const apart = (R, Q) => M.norm(M.rotationVector(M.times(M.transpose(R), Q)));
      const steps = Array.from({ length: 40 }, (_, k) => apart(at(k / 40), at((k + 1) / 40)));
      const whole = steps.reduce((x, y) => x + y, 0);
      numbers(
        ["R now =", P.matrix(at(state.s))],
        `the shortest rotation: ${P.degrees(apart(A, B), 1)}\n` +
          `this motion rotates by ${P.degrees(whole, 1)} in all`,
      );
      const off = theirs ? Math.max(...M.sampled(40, (s) => apart(at(s), library(s)))) : 0;
      const own =
        off < 1e-3
          ? "It agrees with the library."
          : `The library's motion, dashed, differs by up to ${P.degrees(off, 1)}.`;
      words.textContent = said(
        state,
        own,
        "Drag a nose or a wing tip; the library flies the shortest rotation.",
      );
    };
  }

  // ---- a position, and the answer of a table beside the true arm ----

  function table(card, meta, ask) {
    const { lengths } = meta,
      reach = lengths[0] + lengths[1];
    const stored = meta.stored && {
      at: M.transpose(meta.stored.at),
      q: M.transpose(meta.stored.q),
    };
    const state = card.state({ at: meta.at });
    const plane = card.map({ half: 1.15 * reach, label: meta.title, proportion: 0.9 });
    // On a page the query goes to the nearest of the positions for which the function was asked beforehand.
    const moved = (p) => {
      const far = stored && stored.at.map((at) => M.norm(M.add(at, p, -1)));
      state.at = stored ? stored.at[far.indexOf(Math.min(...far))] : p;
      ask({ at: state.at });
    };
    const steps = stored ? { stride: 0.1 } : {};
    plane.handle({ name: "Query", colour: COLOURS.blue, at: () => state.at, moved, ...steps });
    const numbers = card.numbers(),
      words = card.words();
    moved(state.at);
    return () => {
      const { answer } = state,
        truth = M.twoLink(lengths, state.at);
      const found = answer ? answer.value : stored && stored.q[stored.at.indexOf(state.at)];
      const q = found && found.length && found[0] !== null ? found : null,
        tip = q && M.planarPoints(lengths, q)[2];
      const arm = (q, colours, width) => {
        const points = M.planarPoints(lengths, q);
        [0, 1].forEach((k) => plane.line(points.slice(k, k + 2), colours[k], width - k));
        points.slice(0, 2).forEach((p) => plane.dot(p, COLOURS.dark, 4));
      };
      plane.begin();
      plane.line(P.circle(reach), COLOURS.grey, 1);
      const isOther = truth && q && q[1] < 0; // the other elbow
      const mirrored = isOther
        ? [2 * Math.atan2(state.at[1], state.at[0]) - truth[0], -truth[1]]
        : truth;
      if (mirrored) arm(mirrored, [COLOURS.blue, COLOURS.blue], 9);
      if (q) arm(q, [COLOURS.steel, COLOURS.link], 6);
      if (q) plane.line([state.at, tip], COLOURS.crimson, 2);
      if (q) plane.dot(tip, COLOURS.crimson, 5);
      plane.end();
      const degrees = (q) =>
        q ? `(${q.map((x) => P.degrees(x, 1)).join(", ")})` : "none: out of reach";
      numbers(`true, blue: q = ${degrees(mirrored)}`, `answer: q = ${q ? degrees(q) : "none"}`);
      const off = q
        ? `The tip is ${mm(M.norm(M.add(tip, state.at, -1)))} from the query.`
        : "It gives no answer here.";
      words.textContent = stored
        ? `${off} The blue arm is the true one; the query moves in steps of 10 cm.`
        : said(state, off, "The blue arm is the true one. Drag the query.");
    };
  }

  // ---- a robot to drive, and where its own log says that it is ----

  function drive(card, meta, ask) {
    const { half, centre, plan, exact, dock } = meta,
      RADIUS = 0.17,
      LONGEST = 90; // metres, seconds
    const state = card.state({ log: plan, dt: meta.dt, hidden: false });
    const held = new Set(); // of the directions below
    const plane = card.map({
      half: 1.12 * half,
      centre,
      label: `${meta.title}. Arrow keys drive the robot`,
      proportion: 0.72,
    });
    const DIRECTIONS = { ArrowUp: ["Ahead", 0.5, 0], ArrowDown: ["Back", -0.5, 0] };
    Object.assign(DIRECTIONS, { ArrowLeft: ["Left", 0, 0.9], ArrowRight: ["Right", 0, -0.9] });
    const inside = (at) =>
      [half, 0.72 * half].every((room, k) => Math.abs(at[k] - centre[k]) < room - RADIUS);
    const poses = (dt) => M.propagate([0, 0, 0], state.log, dt),
      last = (rows) => rows[rows.length - 1];
    const asked = () => ask({ plan: state.log, dt: state.dt });
    // Append some seconds to the log; the wall stops the robot, and its wheels.
    const advance = (seconds) => {
      const [v, omega] = [1, 2].map((k) =>
        [...held].reduce((sum, key) => sum + DIRECTIONS[key][k], 0),
      );
      const before = last(state.log),
        used = state.log.reduce((sum, pair) => sum + pair[1], 0);
      if ((!v && !omega) || used > LONGEST) return;
      if (v && !inside(M.expPlanar(last(poses(1).exact), [omega * seconds, v * seconds, 0])))
        return;
      const same = before && before[0][0] === v && before[0][2] === omega;
      state.log = same
        ? [...state.log.slice(0, -1), [before[0], before[1] + seconds]]
        : [...state.log, [[v, 0, omega], seconds]];
      asked();
    };
    let frame = null;
    const run = (then) => {
      frame = requestAnimationFrame((time) => {
        advance(Math.min(0.05, Math.max(0, (time - then) / 1000)));
        card.draw();
        if (held.size) run(time);
        else frame = null;
      });
    };
    const press = (key) => {
      if (held.has(key)) return;
      held.add(key);
      advance(0.05); // however short the press
      card.draw();
      if (frame === null) run(performance.now());
    };
    const release = () => {
      held.clear();
      asked();
      card.draw();
    };
    const { canvas } = plane;
    Object.assign(canvas.style, { cursor: "pointer" });
    canvas.tabIndex = 0;
    canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
    canvas.addEventListener("blur", release);
    canvas.addEventListener("keyup", (event) => {
      held.delete(event.key);
      if (!held.size) release();
    });
    P.onKeys(canvas, (direction, { key }) => {
      if (direction) press(key);
      return direction;
    });
    // A button drives as long as it is held; pressed by a key, for half a second.
    Object.entries(DIRECTIONS).forEach(([key, [name]]) => {
      const made = card.button(name, () => {});
      made.style.cssText =
        "min-height:44px;touch-action:none;user-select:none;-webkit-user-select:none";
      made.addEventListener("pointerdown", (event) => {
        made.setPointerCapture(event.pointerId);
        press(key);
      });
      P.onRelease(made, release);
      made.addEventListener("contextmenu", (event) => event.preventDefault());
      made.addEventListener("click", (event) => {
        if (event.detail) return;
        held.add(key);
        for (let k = 0; k < 10; k++) advance(0.05);
        release();
      });
    });
    card.button("Start again", () => {
      state.log = [];
      state.answer = null;
      asked();
    });
    card.checkbox("Hide the robot", state, "hidden");
    card.range(
      "Step dt",
      { min: -2, max: 0, step: 0.1, value: Math.log10(state.dt) },
      (x) => `${Number((10 ** x).toPrecision(2))} s`,
      (x) => {
        state.dt = 10 ** x;
        asked();
      },
    );
    const words = card.words();
    asked();
    card.atEnd(() => {
      held.clear();
      cancelAnimationFrame(frame);
    });
    return () => {
      const { answer } = state,
        truth = poses(0.05).exact,
        theirs = answer && answer.value;
      const ghost = theirs || poses(state.dt)[exact ? "exact" : "euler"],
        own = last(ghost);
      const sketch = (path, colour, dash) => {
        plane.line(path, colour, 2, { dash });
        plane.robot(last(path), RADIUS, colour);
      };
      plane.begin();
      plane.line(
        [
          [-1, -1],
          [1, -1],
          [1, 1],
          [-1, 1],
        ].map(([u, v]) => M.add(centre, [u * half, 0.72 * v * half])),
        COLOURS.grey,
        2,
        { closed: true },
      ); // the wall
      plane.line(P.circle(1.2 * RADIUS, dock), COLOURS.green, 4, { dash: [4, 6] });
      plane.text([dock[0], dock[1] - 0.4], "dock", COLOURS.green);
      if (!state.hidden) sketch(truth, COLOURS.blue, []);
      sketch(ghost, COLOURS.crimson, [7, 5]);
      if (ghost.length < 200) ghost.forEach((p) => plane.dot(p, COLOURS.crimson, 2.5));
      plane.end();
      const then = theirs ? last(M.propagate([0, 0, 0], answer.plan, 1).exact) : last(truth); // when it was asked
      const off = 100 * M.norm([own[0] - then[0], own[1] - then[1]]),
        rotated = Math.abs(M.wrap(own[2] - then[2]));
      const distance = `${P.number(off, off < 10 ? 1 : 0)} cm`;
      const far = `Red, where it believes it is, is ${distance} and ${P.degrees(rotated)} off.`;
      const here = state.hidden ? "Drive the red robot to the dock, then show the blue one." : far;
      words.textContent = said(state, here, here);
    };
  }

  // ---- two pictures of a mug with key points to click, and where the clicks say that it is ----

  function click(card, meta, ask) {
    const {
        K: [[fx, , cx], [, fy, cy]],
        cameras,
        mugs,
        grasp,
      } = meta,
      { vertices, faces } = S.unpack(meta.solid);
    const own = () => meta.clicks.map((each) => each.map(() => false)); // which ones the reader has clicked
    const start = () => ({ clicks: structuredClone(meta.clicks), own: own() });
    const state = card.state({ ...start(), chosen: 0 });
    const toPixel = ([x, y, z]) => [(fx * x) / z + cx, -(fy * y) / z - cy]; // upwards, as the plane has it
    const TITLES = ["template's picture", "scene's picture"],
      ARMS = [
        [1, 1],
        [-1, 1],
      ];
    const pictures = cameras.map((camera, i) => {
      const T = M.times(M.inverse(camera), mugs[i]),
        seen = vertices.map((v) => M.move(T, v)),
        flat = seen.map(toPixel);
      const triangles = faces.map((face) => face.map((k) => seen[k])),
        up = M.transpose(M.rotationOf(T))[2];
      const [x, y] = M.transpose(flat).map((all) => [Math.min(...all) - 50, Math.max(...all) + 50]);
      const normal = ([a, b, c]) => M.unit(M.cross(M.add(b, a, -1), M.add(c, a, -1)));
      // Far triangles first, those that face away left out, each with how much light it gets.
      const shown = triangles
        .filter((each) => M.dot(normal(each), each[0]) < 0)
        .sort(
          (p, q) =>
            M.norm(q.reduce((a, b) => M.add(a, b))) - M.norm(p.reduce((a, b) => M.add(a, b))),
        )
        .map((each) => [
          each.map(toPixel),
          0.55 + 0.45 * Math.max(0, M.dot(normal(each), M.unit([0.3, -0.7, -0.6]))),
        ]);
      const plane = card.plane({
        x,
        y,
        ticks: () => [],
        names: ["", ""],
        label: `Mug, ${TITLES[i]}`,
        proportion: 0.8,
      });
      // What a depth camera measures: the mug, or the table behind it.
      const rayAt = ([u, v]) => [(u - cx) / fx, (v - cy) / fy, 1];
      const depth = (pixel) =>
        Math.min(
          M.firstHit(rayAt(pixel), triangles),
          M.dot(up, M.positionOf(T)) / M.dot(up, rayAt(pixel)),
        );
      const point = (pixel) => M.move(camera, M.scale(rayAt(pixel), depth(pixel)));
      const put = ([u, v]) => {
        const inside = [
          [u, x],
          [v, y],
        ].map(([p, [low, high]]) => Math.min(high, Math.max(low, p)));
        state.clicks[i][state.chosen] = [inside[0], -inside[1]];
        state.own[i][state.chosen] = true;
        moved();
      };
      const at = () => [state.clicks[i][state.chosen][0], -state.clicks[i][state.chosen][1]];
      const handle = plane.handle({
        name: `Point in the ${TITLES[i]}`,
        colour: COLOURS.blue,
        at,
        moved: put,
        stride: 1,
        describe: () => `${state.chosen} at ${P.list(state.clicks[i][state.chosen], 1)} pixels`,
      });
      handle.style.background =
        "radial-gradient(transparent 7px,var(--colour) 7.5px 9.5px,transparent 10px)";
      let pressed = null;
      plane.box.addEventListener("pointerdown", ({ clientX, clientY }) => {
        pressed = [clientX, clientY];
      });
      plane.box.addEventListener("click", ({ clientX, clientY }) => {
        if (!pressed || M.norm(M.add(pressed, [clientX, clientY], -1)) > 4) return; // it was dragged
        const { left, top } = plane.box.getBoundingClientRect();
        put(plane.fromPixels([clientX - left, clientY - top]));
        const next = state.own[0].findIndex((_, k) => !state.own.every((each) => each[k]));
        if (state.own.every((each) => each[state.chosen]) && next >= 0)
          slider.set((state.chosen = next));
        card.draw();
      });
      return { plane, T, shown, depth, point };
    });
    const moved = () =>
      ask({
        pixels: state.clicks,
        depths: pictures.map(({ depth }, i) => state.clicks[i].map(depth)),
      });
    const last = meta.spots.length - 1,
      range = { min: 0, max: last, step: 1 };
    const slider = card.setting(`Point to click, 0 to ${last}`, state, "chosen", range, String);
    card.button("Take the shipped clicks", () => {
      Object.assign(state, start());
      moved();
    });
    const numbers = card.numbers(),
      words = card.words();
    moved();
    return () => {
      const [model, scene] = pictures.map(({ point }, i) => state.clicks[i].map(point)),
        { answer } = state;
      const found = (answer && answer.value) || M.register(model, scene),
        hold = M.times(found, grasp);
      const off = model.map((p, k) => M.norm(M.add(M.move(found, p), scene[k], -1)));
      pictures.forEach(({ plane, T, shown }, i) => {
        const place = (p) => toPixel(M.move(T, p));
        plane.begin();
        for (let k = -10; k <= 10; k++)
          [
            [
              [k, -10],
              [k, 10],
            ],
            [
              [-10, k],
              [10, k],
            ],
          ].forEach((ends) =>
            plane.line(
              ends.map(([x, y]) => place([x / 40, y / 40, 0])),
              COLOURS.lines,
              1,
            ),
          );
        shown.forEach(([points, light]) =>
          plane.line(points, `rgb(${[214, 96, 86].map((c) => Math.round(c * light))})`, 0.6, {
            closed: true,
            fill: 1,
          }),
        );
        meta.spots.forEach((p) => plane.dot(place(p), "#f4f5f6", 4));
        if (i) {
          const inCamera = (p) => toPixel(M.move(M.inverse(cameras[1]), p)),
            tip = (p) => inCamera(M.move(hold, p));
          const net = vertices.map((v) => inCamera(M.move(found, v))),
            side = ([[ax, ay], [bx, by], [cx, cy]]) =>
              (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
          faces
            .map((face) => face.map((k) => net[k]))
            .filter((each) => side(each) > 0)
            .forEach((each) => plane.line(each, COLOURS.blue, 0.5, { closed: true }));
          const jaws = [
            [0, 0.04, 0],
            [0, 0.04, -0.04],
            [0, -0.04, -0.04],
            [0, -0.04, 0],
          ];
          [
            jaws,
            [
              [0, 0, -0.04],
              [0, 0, -0.07],
            ],
          ].forEach((part) => plane.line(part.map(tip), COLOURS.green, 3));
        }
        state.clicks[i].forEach(([u, v], k) => {
          const at = [u, -v],
            look = state.own[i][k] ? COLOURS.blue : COLOURS.purple;
          ARMS.forEach((arm) => plane.line([M.add(at, arm, 5), M.add(at, arm, -5)], look, 1.5));
          plane.text(M.add(at, [15, 9]), String(k));
        });
        plane.end();
      });
      const rms = M.norm(off) / Math.sqrt(off.length);
      const far = M.norm(M.add(M.positionOf(found), M.positionOf(mugs[1]), -1));
      numbers(
        ["T_wm =", P.matrix(found)],
        `residuals: ${P.list(
          off.map((x) => 1000 * x),
          1,
        )} mm\n` + `grasp at ${P.list(M.positionOf(hold), 3)} m`,
      );
      const here =
        `Click point ${state.chosen} in both pictures. Residual ${P.number(1000 * rms, 1)} mm ` +
        `(root mean square). The pose, blue, is ${P.number(1000 * far, 1)} mm from the mug.`;
      words.textContent = said(state, here, here);
    };
  }

  const FIGURES = { reach, fly, table, drive, click };
  P.toy(
    "alive",
    (meta) => meta.title,
    (card, meta, kernel) => FIGURES[meta.figure](card, meta, card.asker(kernel)),
  );
})();
