// A serial arm moved by its joints. meta.parts says what else there is: "axes", "ellipsoids", "singularity", "frames",
// "elbow". With a kernel (a live notebook) it is moved by the student's function, beside the library's where they differ.
(() => {
  "use strict";
  const K = globalThis.course.kinematics, P = globalThis.course.parts, S = globalThis.course.shapes, { COLOURS } = P;
  const GHOST = ["#56B4E9", "#56B4E9", "#56B4E9"], ELLIPSOIDS = ["#009E73", "#9b4f7f"];
  const BALL = S.ball(K.eye(4), 1, 0, 0, 18);

  globalThis.course.kinds["toy:arm"] = (host, meta, figure, kernel) => {
    const { arm, limits, names = [] } = meta, mesh = K.meshOf(figure.data[meta.trace], meta.counts, K.bodies(arm, meta.q)), 
      has = (part) => meta.parts.includes(part), n = arm.screws.length;
    const state = meta.state || (meta.state = { q: [...meta.q], axes: true, velocity: true, force: false, frames: has("frames") ? 0 : null });
    const card = P.card(host, meta.title);
    const view = P.space(card.views, { radius: meta.reach, centre: meta.centre, azimuth: -1.0, elevation: meta.elevation, label: meta.title, meta: state, redraw: () => schedule() });
    let answer = null, path = null, elbowRange = null;

    const joints = state.q.map((angle, i) => card.range(`Joint ${i + 1}`, {
      min: Math.ceil((180 / Math.PI) * limits[i][0]), max: Math.floor((180 / Math.PI) * limits[i][1]), step: 1, value: (180 / Math.PI) * angle,
    }, (x) => `${x}°`, (x) => { state.q[i] = (x * Math.PI) / 180; moved(); }));
    const showJoints = () => joints.forEach((joint, i) => joint.set(Math.round((180 / Math.PI) * state.q[i])));

    if (has("elbow")) {
      // The configurations of one pose of the gripper, as far as the joint limits allow: along the null space.
      const inside = (q) => q.every((x, i) => x >= limits[i][0] && x <= limits[i][1]);
      const oneWay = (target, sign) => {
        let q = [...state.q], before = null;
        const found = [];
        while (found.length < 400) {
          let v = K.nullVector(K.geometricJacobian(arm, q));
          if (!v) break;
          if (before ? K.dot(v, before) < 0 : sign * v[0] < 0) v = K.scale(v, -1);
          before = v;
          q = K.add(q, v, 0.02);
          for (let k = 0; k < 2; k++) { // back to where the gripper was
            const T = K.frames(arm, q)[n];
            q = K.add(q, K.dampedStep(K.geometricJacobian(arm, q), K.poseError(T, target), 1e-9));
          }
          if (!inside(q)) break;
          found.push(q);
        }
        return found;
      };
      const elbow = card.range("Elbow (gripper stays)", { min: 0, max: 1, step: 0.005, value: 0.5 }, () => `${P.degrees(Math.atan2(...elbowAt()), 0)}`, (x) => {
        if (!path) {
          const target = K.frames(arm, state.q)[n], back = oneWay(target, -1).reverse();
          path = { q: [...back, [...state.q], ...oneWay(target, 1)], target };
        }
        state.q = [...path.q[Math.round(x * (path.q.length - 1))]];
        showJoints();
        moved(true);
      });
      // How far the elbow leans out of the vertical plane through the wrist: sideways and upwards from their middle.
      function elbowAt() {
        const F = K.frames(arm, state.q), e = K.positionOf(F[3]), s = K.positionOf(F[1]), w = K.unit(K.add(K.positionOf(F[5]), s, -1));
        const d = K.add(e, s, -1), out = K.add(d, w, -K.dot(d, w)), side = K.unit(K.cross(w, [0, 0, 1]));
        return [K.dot(out, side), K.dot(out, K.cross(side, w))];
      }
      elbowRange = elbow;
    }
    if (has("singularity")) {
      card.range("Drive through a singularity", { min: -100, max: 100, step: 1, value: 100 }, (x) => `elbow ${Math.round(x * 0.9)}°`, (x) => {
        const a = (x / 100) * (Math.PI / 2);
        state.q = meta.q.map((q, i) => (i === 1 ? 0.5 : i === 3 ? -a : i === 5 ? 0.6 * a : 0));
        showJoints();
        moved();
      });
    }
    if (has("frames")) card.range("Frames shown", { min: 0, max: n + 1, step: 1, value: state.frames }, (k) => (k ? `up to ${names[k - 1]}` : "none"), (k) => { state.frames = k; schedule(); });
    if (has("axes")) card.tick("screw axes", state.axes, (on) => { state.axes = on; schedule(); });
    if (has("ellipsoids")) {
      card.tick("velocity ellipsoid (green)", state.velocity, (on) => { state.velocity = on; schedule(); });
      card.tick("force ellipsoid (purple)", state.force, (on) => { state.force = on; schedule(); });
    }
    card.button("Start again", () => { state.q = [...meta.q]; showJoints(); moved(); });
    const numbers = card.numbers(), words = card.words();

    let waiting = false, busy = false, again = false;
    // One question at a time; when the answer comes, the newest configuration is asked.
    function ask() {
      if (!kernel) return;
      if (busy) { again = true; return; }
      busy = true;
      kernel.ask({ q: state.q });
    }
    if (kernel) kernel.hear((message) => {
      answer = message;
      busy = false;
      if (again) { again = false; ask(); }
      schedule();
    });
    function moved(alongPath = false) {
      if (!alongPath) { path = null; if (elbowRange) elbowRange.set(0.5); }
      ask();
      schedule();
    }
    function schedule() {
      if (waiting) return;
      waiting = true;
      requestAnimationFrame(() => { waiting = false; draw(); });
    }

    function ellipsoid(p, A, size, colour) {
      const { values, vectors } = K.eigen(A), lengths = values.map((x) => size(Math.sqrt(Math.max(0, x))));
      const axes = K.dot(K.cross(vectors[0], vectors[1]), vectors[2]) < 0 ? [vectors[0], vectors[1], K.scale(vectors[2], -1)] : vectors;
      const T = K.pose(K.transpose(axes.map((axis, k) => K.scale(axis, lengths[k]))), p);
      view.mesh(BALL, [T], [colour], 0.4);
    }
    function draw() {
      const right = K.bodies(arm, state.q), F = K.frames(arm, state.q), T = F[n], p = K.positionOf(T);
      const theirs = answer && answer.bodies, shown = theirs || right;
      const gap = answer && answer.end ? Math.max(...answer.end.flat().map((x, k) => Math.abs(x - answer.right.flat()[k]))) : 0;
      const differs = Boolean(answer && (answer.problem || gap > 1e-6));
      view.begin();
      view.floor(0, meta.reach, meta.reach > 0.7 ? 0.2 : 0.1);
      view.shadow(shown.map((B, i) => K.move(B, arm.home[Math.min(i, n)].slice(0, 3).map((row) => row[3]))), 0.16 * meta.reach);
      view.mesh(mesh, shown, mesh.palette);
      if (differs) view.mesh(mesh, right, GHOST, 0.45);
      view.frame(K.pose(K.eye(3), [0, 0, 0]), 0.2 * meta.reach, { width: 2 });
      view.text([0, -0.07 * meta.reach, -0.03 * meta.reach], "s", COLOURS.black);
      view.frame(answer && answer.end ? answer.end : T, 0.18 * meta.reach);
      if (differs && answer.end) view.frame(T, 0.13 * meta.reach, { width: 1 });
      if (has("axes") && state.axes) arm.screws.forEach((screw, i) => {
        const B = right[i], at = K.move(B, K.positionOf(arm.home[i])), axis = K.apply(K.rotationOf(B), screw.slice(0, 3)), l = 0.22 * meta.reach;
        view.line([K.add(at, axis, -l), K.add(at, axis, l)], COLOURS.purple, 2, { dash: [6, 4], above: true });
        view.text(K.add(at, axis, (i % 2 ? 1.15 : -1.15) * l), String(i + 1), COLOURS.purple);
      });
      const J = K.geometricJacobian(arm, state.q), Jv = J.slice(3), A = K.times(Jv, K.transpose(Jv)), s = K.eigen(A).values.map((x) => Math.sqrt(Math.max(0, x)));
      const longest = 0.3 * meta.reach;
      if (has("ellipsoids") && state.velocity) ellipsoid(p, A, (x) => (longest * x) / meta.reach, ELLIPSOIDS[0]);
      if (has("ellipsoids") && state.force) ellipsoid(p, A, (x) => Math.min(2 * longest, 0.06 * meta.reach * meta.reach / Math.max(x, 1e-9)), ELLIPSOIDS[1]);
      if (state.frames) F.slice(0, state.frames).forEach((frame, k) => { view.frame(frame, 0.13 * meta.reach); view.text(K.add(K.positionOf(frame), [0.05 * meta.reach * (k % 2 ? 1 : -1), 0, 0.05 * meta.reach]), names[k]); });
      view.end();
      say({ T, s, J, gap, differs });
    }
    function say({ T, s, J, gap, differs }) {
      const lines = [`T_sb =\n${P.table(T, 3)}`];
      if (has("ellipsoids")) {
        const least = Math.sqrt(Math.max(0, K.eigen(K.times(J, K.transpose(J))).values[5]));
        lines.push(`singular values, translation only: ${s.map((x) => P.number(x, 3)).join(", ")} m\nleast singular value of the whole 6 x ${n} Jacobian: ${P.number(least, 4)}`);
      }
      if (state.frames && meta.rows && state.frames <= n) {
        const [a, alpha, d] = meta.rows[state.frames - 1];
        lines.push(`DH row ${state.frames} (modified): a = ${a} m, alpha = ${P.degrees(alpha)}, d = ${d} m, theta = joint ${state.frames} = ${P.degrees(state.q[state.frames - 1])}`);
      }
      if (path) {
        const e = K.poseError(T, path.target);
        lines.push(`the gripper moved by ${(1000 * K.norm(e.slice(3))).toFixed(6)} mm from where it was`);
      }
      numbers.textContent = lines.join("\n\n");
      if (!kernel) words.textContent = has("singularity") && s[2] < 0.05 ? `Near a singularity: the least singular value is ${P.number(s[2], 3)} m. To move the end-effector at 0.1 m/s along the ellipsoid's short axis the joints would need at least ${s[2] > 1e-4 ? P.number(0.1 / s[2], 1) + " rad/s" : "infinite speed"}.` : "";
      else if (!answer) words.textContent = "";
      else if (answer.problem) words.textContent = `${answer.whose}: ${answer.problem} The pale arm is where the library's forward kinematics puts it.`;
      else words.textContent = differs ? `Moved by ${answer.whose}. The pale blue arm is the library's; the end-effectors differ by ${P.number(gap, 3)} in their largest entry.`
        : `Moved by ${answer.whose}, which agrees with the library.`;
    }
    ask();
    draw();
    return () => { view.stop(); card.end(); };
  };
})();
