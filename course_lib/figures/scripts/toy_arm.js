// A serial arm moved by its joints. meta.parts says what else there is: "axes", "ellipsoids", "singularity", "frames",
// "elbow". With a kernel (a live notebook) it is moved by the student's function, beside the library's if they differ.
(() => {
  "use strict";
  const M = globalThis.course.motion,
    P = globalThis.course.parts,
    S = globalThis.course.scene,
    { COLOURS, rad } = P;
  const BALL = S.ball(36);

  // The configurations of one pose of the end-effector within the joint limits: along the null space, to both sides.
  function selfMotion(arm, limits, start) {
    const n = start.length,
      target = M.frames(arm, start)[n];
    const inside = (q) => q.every((x, i) => x >= limits[i][0] && x <= limits[i][1]);
    const oneWay = (sign) => {
      const found = [];
      let q = start,
        before = null;
      while (found.length < 400) {
        let v = M.nullVector(M.geometricJacobian(arm, q));
        if (!v) break;
        if (before ? M.dot(v, before) < 0 : sign * v[0] < 0) v = M.scale(v, -1);
        before = v;
        q = M.add(q, v, 0.02);
        for (let k = 0; k < 2; k++) {
          // back to where the end-effector was
          const J = M.geometricJacobian(arm, q);
          q = M.add(q, M.dampedStep(J, M.poseError(M.frames(arm, q)[n], target), 1e-9));
        }
        if (!inside(q)) break;
        found.push(q);
      }
      return found;
    };
    return { q: [...oneWay(-1).reverse(), start, ...oneWay(1)], target };
  }

  P.toy(
    "arm",
    (meta) => meta.title,
    (card, meta, kernel) => {
      const { arm, limits, names, size } = meta,
        n = arm.screws.length,
        view = card.armSpace(-1.25);
      const has = (part) => meta.parts.includes(part);
      const state = card.state({
        q: [...meta.q],
        axes: true,
        velocity: true,
        force: false,
        frames: 0,
      });
      let path = null,
        elbow = null,
        joints = [];

      card.fold(
        "Joint angles",
        () =>
          (joints = state.q.map((angle, i) =>
            card.range(
              `Joint ${i + 1}`,
              {
                min: Math.ceil(limits[i][0] / rad),
                max: Math.floor(limits[i][1] / rad),
                step: 1,
                value: angle / rad,
              },
              P.inDegrees,
              (x) => {
                state.q[i] = x * rad;
                moved();
              },
            ),
          )),
      );
      const showJoints = () =>
        joints.forEach((joint, i) => joint.set(Math.round(state.q[i] / rad)));
      if (has("elbow")) {
        elbow = card.range(
          "Elbow (flange stays)",
          { min: 0, max: 1, step: 0.005, value: 0.5 },
          () => P.degrees(elbowAngle()),
          (x) => {
            path = path || selfMotion(arm, limits, [...state.q]);
            state.q = [...path.q[Math.round(x * (path.q.length - 1))]];
            showJoints();
            moved(true);
          },
        );
      }
      // How far the elbow leans out of the vertical plane through shoulder and wrist.
      function elbowAngle() {
        const F = M.frames(arm, state.q),
          [s, e, w] = [1, 3, 5].map((i) => M.positionOf(F[i]));
        const axis = M.unit(M.add(w, s, -1)),
          side = M.unit(M.cross(axis, [0, 0, 1])),
          d = M.add(e, s, -1);
        return Math.atan2(M.dot(d, side), M.dot(d, M.cross(side, axis)));
      }
      if (has("singularity")) {
        // of the elbow alone: joint 6 stays bent, else the wrist would be singular too
        const options = { min: -90, max: 90, step: 1, value: -Math.round(meta.q[3] / rad) };
        card.range(
          "Drive through a singularity",
          options,
          (x) => `elbow ${P.inDegrees(x)}`,
          (x) => {
            state.q = meta.q.map((q, i) => ({ 1: 0.5, 3: -x * rad, 5: q })[i] || 0);
            showJoints();
            moved();
          },
        );
      }
      if (has("frames")) {
        const write = (k) => (k ? `up to ${names[k - 1]}` : "none");
        card.setting("Frames shown", state, "frames", { min: 0, max: n + 1, step: 1 }, write);
      }
      if (has("axes")) card.checkbox("screw axes", state, "axes");
      if (has("ellipsoids")) {
        card.checkbox("velocity ellipsoid (green)", state, "velocity");
        card.checkbox("force ellipsoid (orange)", state, "force");
      }
      card.button("Start again", () => {
        state.q = [...meta.q];
        showJoints();
        moved();
      });
      const numbers = card.numbers(),
        words = card.words(),
        ask = card.asker(kernel);
      function moved(alongPath = false) {
        if (!alongPath) {
          path = null;
          if (elbow) elbow.set(0.5);
        }
        ask({ q: state.q });
      }

      function ellipsoid(p, A, length, colour) {
        const { values, vectors } = M.eigen(A),
          lengths = values.map((x) => length(Math.sqrt(Math.max(0, x))));
        if (M.dot(M.cross(vectors[0], vectors[1]), vectors[2]) < 0)
          vectors[2] = M.scale(vectors[2], -1);
        const axes = vectors.map((axis, k) => M.scale(axis, Math.max(lengths[k], 1e-4 * size)));
        view.mesh(BALL, [M.pose(M.transpose(axes), p)], [colour], { opacity: 0.45 });
      }
      function drawArm() {
        const right = M.bodies(arm, state.q),
          F = M.frames(arm, state.q, right),
          T = F[n],
          p = M.positionOf(T);
        const { answer } = state,
          theirs = answer && answer.value,
          bodies = (theirs && theirs.bodies) || right;
        const differs = Boolean(answer && !(answer.gap < 1e-6)); // null if there is no answer to compare
        const tips = M.eye(3).map((e) => M.move(T, M.scale(e, 0.1 * size))),
          l = 0.19 * size;
        const axes =
          !state.axes || !has("axes")
            ? []
            : arm.screws.map((screw, i) => [
                M.move(right[i], M.positionOf(arm.home[i])),
                M.apply(M.rotationOf(right[i]), screw.slice(0, 3)),
              ]);
        view.begin();
        view.stand(right, [...tips, ...axes.map(([at, axis]) => M.add(at, axis, 1.27 * l))]);
        const dragged = view.joints(
          () => state.q,
          bodies,
          (i, angle) => {
            state.q[i] = angle;
            showJoints();
            moved();
          },
        );
        view.arm(bodies, { opacity: state.frames ? 0.35 : 1, shadow: true, ...dragged });
        if (differs) view.arm(right, { opacity: 0.45, colour: COLOURS.pale });
        view.frame(M.eye(4), 0.12 * size, { thick: 0.004 * size });
        view.text([0, 0, -0.04 * size], "s");
        view.frame(theirs ? theirs.end : T, 0.1 * size, { thick: 0.006 * size });
        if (differs && theirs) view.frame(T, 0.07 * size, { thick: 0.004 * size });
        axes.forEach(([at, axis], i) => {
          view.line([M.add(at, axis, -l), M.add(at, axis, l)], COLOURS.purple, 2, {
            dash: [6, 4],
            above: true,
          });
          view.arrow(M.add(at, axis, l), M.add(at, axis, 1.15 * l), COLOURS.purple, {
            thick: 0.004 * size,
            above: true,
          });
          view.text(M.add(at, axis, 1.27 * l), String(i + 1), COLOURS.purple);
        });
        const J = M.geometricJacobian(arm, state.q),
          Jv = J.slice(3),
          A = M.times(Jv, M.transpose(Jv));
        if (has("ellipsoids") && state.velocity) ellipsoid(p, A, (x) => 0.17 * x, COLOURS.green);
        if (has("ellipsoids") && state.force) {
          ellipsoid(
            p,
            A,
            (x) => Math.min(0.35 * size, (0.02 * size * size) / Math.max(x, 1e-9)),
            COLOURS.orange,
          );
        }
        F.slice(0, state.frames).forEach((frame, k) => {
          view.frame(frame, 0.075 * size, { thick: 0.005 * size });
          view.text(M.add(M.positionOf(frame), [0, 0, 0.045 * size]), names[k]);
        });
        view.end();
        say(theirs ? theirs.end : T, M.singularValues(Jv), J, differs);
      }
      function say(T, s, J, differs) {
        const lines = [["<span>T<sub>sb</sub> =</span>", P.matrix(T)]],
          { answer } = state;
        if (has("ellipsoids")) {
          const least = P.number(M.singularValues(J)[5], 4);
          lines.push(
            `singular values, translation only: ${P.list(s, 3)} m\n` +
              `of the whole 6 x ${n} Jacobian the least: ${least}`,
          );
        }
        if (state.frames && meta.rows && state.frames <= n) {
          const k = state.frames,
            [a, alpha, d] = meta.rows[k - 1],
            theta = P.degrees(state.q[k - 1]);
          lines.push(
            `DH row ${k} (modified): a = ${P.number(a, 4)} m, α = ${P.degrees(alpha)}, d = ${d} m, ` +
              `θ = ${P.sub("q", k)} = ${theta}`,
          );
        }
        if (path) {
          const e = M.norm(M.poseError(T, path.target).slice(3));
          lines.push(`the flange moved by ${(1000 * e).toFixed(6)} mm from where it was`);
        }
        numbers(...lines);
        words.textContent = answer
          ? compared(answer, differs)
          : has("singularity") && s[2] < 0.05
            ? nearSingular(s[2])
            : "Drag a link: its joint rotates, and the other joint angles stay.";
      }
      const compared = ({ problem, whose, gap }, differs) =>
        problem
          ? `${problem} The library's forward kinematics moves the arm.`
          : differs
            ? `Moved by ${whose}. The pale blue arm is the library's; the end-effectors differ by ` +
              `${P.number(gap, 3)} in their largest entry.`
            : `Moved by ${whose}, which agrees with the library.`;
      const nearSingular = (s) =>
        `Near a singularity: the least singular value is ${P.number(s, 3)} m. To move the ` +
        `end-effector at 0.1 m/s along the ellipsoid's short axis the joints would need at least ` +
        `${s > 1e-4 ? `${P.number(0.1 / s, 1)} rad/s` : "infinite speed"}.`;
      ask({ q: state.q });
      return drawArm;
    },
  );
})();
