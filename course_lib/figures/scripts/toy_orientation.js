// Orientation: axis and angle with R, q and Euler angles; three gimbal rings; two rotations in either order; a belt.
(() => {
  "use strict";
  const K = globalThis.course.kinematics, P = globalThis.course.parts, S = globalThis.course.shapes;
  const { COLOURS } = P, I = K.eye(4), NONE = [0, 0, 0];
  const PALETTE = ["#e8eaed", "#8d959e", "#0072B2", "#009E73", "#D55E00", "#E69F00"];
  const about = (axis, angle) => K.rotation(axis, angle), X = [1, 0, 0], Y = [0, 1, 0], Z = [0, 0, 1];
  const at = (R, p = NONE) => K.pose(R, p);

  // A small aircraft, nose along x, wings along y: every orientation of it looks different.
  const aircraft = (k) => {
    const along = at(about(Y, Math.PI / 2)), s = (profile) => profile.map((row) => row.map((x) => k * x));
    return S.join([
      S.lathe(along, s([[0, -0.8], [0.07, -0.75], [0.16, -0.2], [0.17, 0.3], [0.1, 0.7], [0, 0.85]]), 0, 0, 14),
      S.box(I, [-0.2 * k, -0.85 * k, -0.03 * k], [0.2 * k, 0.85 * k, 0.03 * k], 2),
      S.box(I, [-0.78 * k, -0.3 * k, -0.02 * k], [-0.55 * k, 0.3 * k, 0.02 * k], 2),
      S.box(I, [-0.78 * k, -0.02 * k, 0.04 * k], [-0.55 * k, 0.02 * k, 0.38 * k], 4),
    ]);
  };

  function report(R, q) {
    const e = K.toEuler(R), lock = Math.abs(Math.cos(e[1])) < 1e-6;
    const rows = P.table(R, 3).split("\n");
    return `R =  ${rows[0]}\n     ${rows[1]}\n     ${rows[2]}\n\nq =  (${q.map((x) => P.number(x, 3)).join(", ")})   as (w, x, y, z)\n\n` +
      `R = Rz(yaw) Ry(pitch) Rx(roll):  yaw ${P.degrees(e[0], 1)}, pitch ${P.degrees(e[1], 1)}, roll ${P.degrees(e[2], 1)}` +
      (lock ? "\n(pitch is ±90°: only the sum or difference of yaw and roll is determined)" : "");
  }

  // ---- axis and angle ----

  function axisAngle(card, meta) {
    const state = meta.axis || (meta.axis = { azimuth: 30, height: 40, angle: 60 });
    const plane = aircraft(0.95), rad = Math.PI / 180;
    const view = P.space(card.views, { radius: 1.35, label: "An aircraft rotated about an axis", meta: state, redraw: () => draw() });
    const range = (label, key, min, max) =>
      card.range(label, { min, max, step: 1, value: state[key] }, (x) => `${x}°`, (x) => { state[key] = x; draw(); });
    range("Axis: azimuth", "azimuth", -180, 180);
    range("Axis: elevation", "height", -90, 90);
    range("Angle", "angle", -360, 360);
    const numbers = card.numbers(), words = card.words();
    function draw() {
      const a = state.azimuth * rad, h = state.height * rad, angle = state.angle * rad;
      const axis = [Math.cos(h) * Math.cos(a), Math.cos(h) * Math.sin(a), Math.sin(h)], R = K.rotation(axis, angle);
      view.begin();
      view.frame(I, 1.2, { width: 1, above: false });
      [X, Y, Z].forEach((e, k) => view.text(K.scale(e, 1.28), "xyz"[k], COLOURS.grey));
      view.line([K.scale(axis, -1.25), NONE, K.scale(axis, 1.25)], COLOURS.purple, 3, { dash: [7, 5] });
      view.arrow(K.scale(axis, 1.0), K.scale(axis, 1.3), COLOURS.purple, 3, { above: true });
      view.mesh(plane, [at(R)], PALETTE);
      view.frame(at(R), 1.05);
      const wing = [0, 0.85 * 0.95, 0], arc = Array.from({ length: 41 }, (_, i) => K.apply(K.rotation(axis, (angle * i) / 40), wing));
      view.line(arc, COLOURS.crimson, 2);
      view.end();
      const q = K.quaternion(axis, angle);
      numbers.textContent = report(R, q);
      words.textContent = Math.abs(state.angle) === 360 ? "A full rotation: R is the identity again, but q is −1. Both q and −q stand for this orientation."
        : state.angle === 0 ? "No rotation: the axis does not matter." : `R rotates by ${state.angle}° about the dashed axis; the red arc is the path of a wing tip.`;
    }
    draw();
    return () => view.stop();
  }

  // ---- gimbals ----

  function gimbals(card, meta) {
    const state = meta.gimbals || (meta.gimbals = { yaw: 30, pitch: 20, roll: 10 }), rad = Math.PI / 180;
    const view = P.space(card.views, { radius: 1.62, label: "Three gimbal rings around an aircraft", meta: state, redraw: () => draw() });
    const outer = S.ring(at(about(Y, Math.PI / 2)), 1.36, 0.05, 3, 0, 48); // carried by yaw; pitch's pins along y
    const middle = S.ring(at(about(Z, 0)), 1.18, 0.05, 5, 0, 48); // carried by pitch; roll's pins along x
    const inner = S.ring(at(about(X, Math.PI / 2)), 1.0, 0.05, 4, 0, 48);
    const pin = (axis, r) => S.join([-1, 1].map((s) => S.drum(at(axis, K.apply(axis, [0, 0, s * r])), 0.035, 0.12, 1, 0, 10)));
    const outerPins = pin(about(X, -Math.PI / 2), 1.24), middlePins = pin(about(Y, Math.PI / 2), 1.06), stand = pin(about(Z, 0), 1.42);
    const plane = aircraft(0.8);
    const range = (label, key, min, max) =>
      card.range(label, { min, max, step: 1, value: state[key] }, (x) => `${x}°`, (x) => { state[key] = x; draw(); });
    const ranges = { yaw: range("Yaw (outer ring, about z)", "yaw", -180, 180), pitch: range("Pitch (middle ring)", "pitch", -90, 90), roll: range("Roll (inner ring)", "roll", -180, 180) };
    card.button("Drive into lock", () => {
      card.run(() => {
        state.pitch = Math.min(90, state.pitch + 1);
        ranges.pitch.set(state.pitch);
        return state.pitch < 90;
      }, draw);
    });
    card.button("Yaw +10°, roll +10°", () => {
      ["yaw", "roll"].forEach((key) => { state[key] = Math.min(180, state[key] + 10); ranges[key].set(state[key]); });
      draw();
    });
    const numbers = card.numbers(), words = card.words();
    function draw() {
      const A = about(Z, state.yaw * rad), B = K.times(A, about(Y, state.pitch * rad)), R = K.times(B, about(X, state.roll * rad));
      const yawAxis = Z, pitchAxis = K.apply(A, Y), rollAxis = K.apply(B, X);
      view.begin();
      view.mesh(S.join([stand]), [I], PALETTE);
      view.mesh(outer, [at(A)], PALETTE); view.mesh(outerPins, [at(A)], PALETTE);
      view.mesh(middle, [at(B)], PALETTE); view.mesh(middlePins, [at(B)], PALETTE);
      view.mesh(inner, [at(R)], PALETTE);
      view.mesh(plane, [at(R)], PALETTE);
      [[yawAxis, COLOURS.green, "yaw"], [pitchAxis, COLOURS.orange, "pitch"], [rollAxis, COLOURS.red, "roll"]].forEach(([axis, colour, name]) => {
        view.line([K.scale(axis, -1.45), K.scale(axis, 1.45)], colour, 2, { dash: [6, 4], above: true });
        view.text(K.scale(axis, name === "roll" ? -1.5 : 1.5), name, COLOURS.black);
      });
      view.end();
      const volume = Math.abs(K.dot(K.cross(yawAxis, pitchAxis), rollAxis)); // |det| of the three axes, = cos(pitch)
      const w = K.toEuler(R);
      numbers.textContent = report(R, K.multiply(K.multiply(K.quaternion(Z, state.yaw * rad), K.quaternion(Y, state.pitch * rad)), K.quaternion(X, state.roll * rad)));
      words.textContent = volume < 1e-6
        ? `Gimbal lock: the axes of yaw and roll are one line. Only their difference counts, ${P.degrees(w[0] === 0 && w[2] === 0 ? 0 : K.toEuler(R)[0])}; no ring rotates about the third direction any more.`
        : `The volume that the three axes span is ${P.number(volume, 3)} = cos(pitch). At 0 an axis is lost.`;
    }
    draw();
    return () => view.stop();
  }

  // ---- the order of two rotations ----

  function order(card, meta) {
    const state = meta.order || (meta.order = { time: 0, angle: 90 }), rad = Math.PI / 180, plane = aircraft(0.9);
    const views = ["Rz Rx: first about x, then about the fixed z", "Rx Rz: first about z, then about the fixed x"].map((label) => {
      const box = P.element("div", {}, card.views);
      P.element("p", { style: "margin:0 0 .3rem;font-weight:600" }, box, label);
      return P.space(box, { radius: 1.3, label, meta: state, shape: 0.85, redraw: () => draw() });
    });
    const time = card.range("Step", { min: 0, max: 2, step: 0.02, value: state.time }, (x) => (x <= 1 ? `first, ${Math.round(100 * x)} %` : `second, ${Math.round(100 * (x - 1))} %`), (x) => { state.time = x; draw(); });
    card.range("Both angles", { min: 0, max: 180, step: 1, value: state.angle }, (x) => `${x}°`, (x) => { state.angle = x; draw(); });
    card.button("Play", () => {
      state.time = 0;
      card.run(() => {
        state.time = Math.min(2, state.time + 0.015);
        time.set(state.time);
        return state.time < 2;
      }, draw);
    });
    const numbers = card.numbers();
    function draw() {
      if (views.length < 2) return; // the observer of the first comes before the second is there
      const a = state.angle * rad, first = a * Math.min(1, state.time), second = a * Math.max(0, state.time - 1);
      const both = [K.times(about(Z, second), about(X, first)), K.times(about(X, second), about(Z, first))];
      views.forEach((view, i) => {
        view.view.azimuth = state.view.azimuth;
        view.begin();
        view.frame(I, 1.15, { width: 1, above: false });
        [X, Y, Z].forEach((e, k) => view.text(K.scale(e, 1.22), "xyz"[k], COLOURS.grey));
        const axis = (state.time <= 1) === (i === 0) ? X : Z;
        view.line([K.scale(axis, -1.25), NONE, K.scale(axis, 1.25)], COLOURS.purple, 3, { dash: [7, 5] });
        view.mesh(plane, [at(both[i])], PALETTE);
        view.frame(at(both[i]), 1.0);
        view.end();
      });
      const between = K.times(K.transpose(both[0]), both[1]);
      const apart = Math.acos(Math.min(1, Math.max(-1, (between[0][0] + between[1][1] + between[2][2] - 1) / 2)));
      const left = P.table(both[0], 3).split("\n"), right = P.table(both[1], 3).split("\n");
      const head = numbers.clientWidth < 400 ? `now, above:\n${left.join("\n")}\n\nnow, below:\n${right.join("\n")}`
        : `now, left:                now, right:\n${left.map((row, i) => `${row}   ${right[i]}`).join("\n")}`;
      numbers.textContent = `${head}\n\nangle between the two orientations: ${P.degrees(apart, 1)}`;
    }
    draw();
    return () => views.forEach((view) => view.stop());
  }

  // ---- a belt ----

  const WIDTH = 0.16, PIECES = 90;
  // The quaternion at s along a belt whose end was rotated by `angle` about its length and which is unwound by u, 0 to 1.
  // Two full rotations are a closed loop of quaternions, a great circle; smaller and smaller circles through 1 take it to a point.
  function along(s, angle, u) {
    if (u === 0) return K.quaternion(X, s * angle);
    const t = (u * Math.PI) / 2, phi = 2 * Math.PI * s, c = Math.cos(t), n = Math.sin(t);
    return [n * n + c * c * Math.cos(phi), c * Math.sin(phi), n * c * (1 - Math.cos(phi)), 0];
  }
  function toMatrix([w, x, y, z]) {
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)], [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)], [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]];
  }

  function belt(card, meta) {
    const state = meta.belt || (meta.belt = { turn: 0, unwind: 0 }), rad = Math.PI / 180;
    const view = P.space(card.views, { radius: 1.28, centre: [0.05, 0, -0.3], shape: 0.72, label: "A belt between a wall and a box", meta: state, azimuth: -1.2, elevation: 0.4, redraw: () => draw() });
    const turn = card.range("Rotate the box", { min: 0, max: 720, step: 5, value: state.turn }, (x) => `${x}°`, (x) => { state.turn = x; if (x !== 720) { state.unwind = 0; unwind.set(0); } draw(); });
    const unwind = card.range("Move the box, without rotating it", { min: 0, max: 100, step: 1, value: 100 * state.unwind }, (x) => `${x} %`, (x) => { state.unwind = x / 100; draw(); });
    [0, 360, 720].forEach((value) => card.button(`${value}°`, () => { state.turn = value; state.unwind = 0; turn.set(value); unwind.set(0); draw(); }));
    const numbers = card.numbers(), words = card.words();
    function draw() {
      unwind.input.disabled = state.turn !== 720;
      const qs = Array.from({ length: PIECES + 1 }, (_, i) => along(i / PIECES, state.turn * rad, state.unwind)), Rs = qs.map(toMatrix);
      let p = [-1.35, 0, 0];
      const middle = [p];
      for (let i = 0; i < PIECES; i++) {
        const t = K.unit(K.add(K.apply(Rs[i], X), K.apply(Rs[i + 1], X)));
        middle.push((p = K.add(p, t, 2.5 / PIECES)));
      }
      const vertices = [], faces = [], colours = [];
      middle.forEach((m, i) => { const side = K.apply(Rs[i], [0, WIDTH, 0]); vertices.push(K.add(m, side), K.add(m, side, -1)); });
      for (let i = 0; i < PIECES; i++) {
        const a = 2 * i;
        faces.push([a, a + 1, a + 3], [a, a + 3, a + 2], [a, a + 3, a + 1], [a, a + 2, a + 3]); // both sides of the belt
        colours.push(5, 5, 2, 2);
      }
      view.begin();
      view.mesh(S.box(I, [-1.5, -0.5, -0.5], [-1.36, 0.5, 0.5], 1), [I], PALETTE);
      view.mesh({ vertices, faces, colours, bodies: vertices.map(() => 0) }, [I], PALETTE);
      const end = at(Rs[PIECES], middle[PIECES]);
      view.mesh(S.box(I, [0, -0.28, -0.18], [0.3, 0.28, 0.18], 0), [end], PALETTE);
      view.frame(end, 0.5);
      view.end();
      numbers.textContent = `q of the box, followed along the belt: (${qs[PIECES].map((x) => P.number(x, 3)).join(", ")})`;
      words.textContent = state.turn === 720
        ? state.unwind === 1 ? "The belt is flat again, and the box was never rotated back: two full rotations can be undone, and q is +1."
          : "Two full rotations. Now move the box around, without rotating it, by the second slider."
        : state.turn === 360 ? "One full rotation: the box looks as before, but the belt is twisted and q is −1. Moving the box alone cannot undo it."
          : "Rotate the box by one and by two full rotations.";
    }
    draw();
    return () => view.stop();
  }

  const MODES = { axis: ["Axis and angle", axisAngle], gimbals: ["Gimbal rings", gimbals], order: ["Rz Rx and Rx Rz", order], belt: ["A belt: twice around", belt] };
  globalThis.course.kinds["toy:orientation"] = (host, meta) => {
    let stop = null, card = null;
    const tabs = P.element("div", { class: "course-toy buttons", role: "group", "aria-label": "What to move", style: "display:flex;flex-wrap:wrap;gap:.5rem" }, host);
    const buttons = Object.entries(MODES).map(([name, [label]]) => {
      const button = P.element("button", { type: "button" }, tabs, label);
      button.addEventListener("click", () => show(name));
      return [name, button];
    });
    if (meta.modes && meta.modes.length === 1) tabs.remove();
    function show(name) {
      meta.mode = name;
      buttons.forEach(([other, button]) => button.setAttribute("aria-pressed", other === name));
      if (stop) stop();
      if (card) card.end();
      card = P.card(host, MODES[name][0]);
      stop = MODES[name][1](card, meta);
    }
    show(meta.mode || "axis");
    return () => { stop(); card.end(); tabs.remove(); };
  };
})();
