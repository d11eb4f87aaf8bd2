// A serial arm moved by its joints. meta.parts says what else there is: "axes", "ellipsoids",
// "singularity", "frames", "elbow". With a kernel (a live notebook) it is moved by the student's
// function, beside the library's if they differ.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const S = globalThis.course.scene;
  const { selfMotion, elbowAngle } = globalThis.course.arm;
  const { COLOURS } = globalThis.course.palette;
  const BALL = S.ball(36);
  const AGREES = 1e-6; // the largest difference of two poses that count as equal
  const NEAR_SINGULAR = 0.05; // metres: the least singular value at which the words change
  const SPEED = 0.1; // m/s, the end-effector's in these words

  P.toy("arm", (meta) => meta.title, build);

  function build(card, meta, kernel) {
    const { arm, limits, names, size } = meta;
    const n = arm.screws.length;
    const frameNames = meta.frameNames ?? ["s", "b"]; // of the base and of the end-effector
    const view = card.armSpace(-1.25);
    const has = (part) => meta.parts.includes(part);
    const state = card.state({
      q: [...meta.q],
      axes: true,
      velocity: true,
      force: false,
      frames: 0,
    });

    // ---- controls ----

    let path = null; // the self-motion, while the elbow is moved
    let elbowRange = null;
    let jointRanges = [];
    card.fold("Joint angles", () => {
      jointRanges = state.q.map(addJointRange);
    });
    function addJointRange(angle, i) {
      const [low, high] = limits[i].map((limit) => limit / P.rad);
      const range = { min: Math.ceil(low), max: Math.floor(high), step: 1, value: angle / P.rad };
      return card.range(`Joint ${i + 1}`, range, P.inDegrees, (degrees) => {
        state.q[i] = degrees * P.rad;
        moved();
      });
    }
    function showJoints() {
      jointRanges.forEach((range, i) => {
        range.set(Math.round(state.q[i] / P.rad));
      });
    }
    if (has("elbow")) elbowRange = addElbowRange();
    if (has("singularity")) addSingularityRange();
    if (has("frames")) {
      const write = (k) => (k ? `up to ${names[k - 1]}` : "none");
      card.setting("Frames shown", state, "frames", { min: 0, max: n + 1, step: 1 }, write);
    }
    if (has("axes")) card.checkbox("screw axes", state, "axes");
    if (has("ellipsoids")) {
      card.checkbox("velocity ellipsoid (green)", state, "velocity");
      card.checkbox("force ellipsoid (orange)", state, "force");
    }
    const numbers = card.numbers();
    const words = card.words();
    const ask = card.asker(kernel);
    ask({ q: state.q });

    function addElbowRange() {
      const range = { min: 0, max: 1, step: 0.005, value: 0.5 };
      const write = () => P.degrees(elbowAngle(arm, state.q));
      return card.range("Elbow (flange stays)", range, write, (share) => {
        path ??= selfMotion(arm, limits, [...state.q]);
        state.q = [...path.q[Math.round(share * (path.q.length - 1))]];
        showJoints();
        ask({ q: state.q });
      });
    }
    /**
     * The singularity of the elbow alone: joint 6 stays bent, else the wrist would be singular too.
     */
    function addSingularityRange() {
      const range = { min: -90, max: 90, step: 1, value: -Math.round(meta.q[3] / P.rad) };
      const write = (degrees) => `elbow ${P.inDegrees(degrees)}`;
      card.range("Drive through a singularity", range, write, (degrees) => {
        state.q = meta.q.map(() => 0);
        state.q[1] = 0.5;
        state.q[3] = -degrees * P.rad;
        state.q[5] = meta.q[5];
        showJoints();
        moved();
      });
    }
    /** The joints were moved, and not along the self-motion, which begins anew from here. */
    function moved() {
      path = null;
      elbowRange?.set(0.5);
      ask({ q: state.q });
    }

    // ---- drawing ----

    /**
     * What the picture shows: the arm as the answer has it, or the library's where there is none.
     */
    function situation() {
      const { answer } = state;
      const bodies = M.bodies(arm, state.q); // the library's
      const frames = M.frames(arm, state.q, bodies);
      const answered = answer?.value;
      return {
        bodies,
        frames,
        end: frames[n],
        shownBodies: answered?.bodies ?? bodies,
        shownEnd: answered ? answered.end : frames[n],
        hasAnswer: Boolean(answered),
        // The gap is null if there is no answer to compare.
        differs: Boolean(answer && !(answer.gap < AGREES)),
        J: M.geometricJacobian(arm, state.q),
      };
    }
    /** The screw axes now: a point on each, and its direction. */
    function axesOf({ bodies }) {
      if (!state.axes || !has("axes")) return [];
      return arm.screws.map((screw, i) => ({
        point: M.move(bodies[i], M.positionOf(arm.home[i])),
        axis: M.apply(M.rotationOf(bodies[i]), screw.slice(0, 3)),
      }));
    }
    const half = 0.19 * size; // of the line of an axis
    function drawAxis({ point, axis }, i) {
      const along = (length) => M.add(point, axis, length);
      const look = { above: true };
      view.line([along(-half), along(half)], COLOURS.purple, 2, { dash: [6, 4], ...look });
      const thick = 0.004 * size;
      view.arrow(along(half), along(1.15 * half), COLOURS.purple, { thick, ...look });
      view.text(along(1.27 * half), String(i + 1), COLOURS.purple);
    }
    function drawEndFrames({ end, shownEnd, hasAnswer, differs }) {
      view.frame(shownEnd, 0.1 * size, { thick: 0.006 * size });
      if (differs && hasAnswer) view.frame(end, 0.07 * size, { thick: 0.004 * size });
    }
    /**
     * The ellipsoid x^T A^-1 x = 1, its axes with a length that is a function of the singular
     * value.
     */
    function drawEllipsoid(p, A, length, colour) {
      const { values, vectors } = M.eigen(A);
      const isLeftHanded = M.dot(M.cross(vectors[0], vectors[1]), vectors[2]) < 0;
      if (isLeftHanded) vectors[2] = M.scale(vectors[2], -1);
      const axes = vectors.map((vector, k) => {
        const singularValue = Math.sqrt(Math.max(0, values[k]));
        return M.scale(vector, Math.max(length(singularValue), 1e-4 * size));
      });
      view.mesh(BALL, [M.pose(M.transpose(axes), p)], [colour], { opacity: 0.45 });
    }
    function drawEllipsoids({ end, J }) {
      if (!has("ellipsoids")) return;
      const p = M.positionOf(end);
      const Jv = J.slice(3);
      const A = M.times(Jv, M.transpose(Jv));
      if (state.velocity) drawEllipsoid(p, A, (x) => 0.17 * x, COLOURS.green);
      if (!state.force) return;
      // Forces are the inverse; at a singularity their ellipsoid is longer than any picture.
      const max = 0.35 * size;
      const forceLength = (x) => Math.min(max, (0.02 * size * size) / Math.max(x, 1e-9));
      drawEllipsoid(p, A, forceLength, COLOURS.orange);
    }
    function drawFrame(frame, k) {
      view.frame(frame, 0.075 * size, { thick: 0.005 * size });
      // Frames that share an origin have different z axes. The label stands behind the origin,
      // since the next frame may stand before it; nothing stands before the end-effector.
      const along = k < n ? -0.05 * size : 0.1 * size;
      view.text(M.move(frame, [0, 0, along]), names[k]);
    }

    return () => {
      const now = situation();
      const axes = axesOf(now);
      const tips = M.eye(3).map((axis) => M.move(now.end, M.scale(axis, 0.1 * size)));
      const axisEnds = axes.map(({ point, axis }) => M.add(point, axis, 1.27 * half));
      view.begin();
      view.stand(now.bodies, [...tips, ...axisEnds]);
      const grips = view.joints(
        () => state.q,
        now.shownBodies,
        (joint, angle) => {
          state.q[joint] = angle;
          showJoints();
          moved();
        },
      );
      const opacity = state.frames ? 0.35 : 1;
      view.arm(now.shownBodies, { opacity, shadow: true, ...grips });
      if (now.differs) view.arm(now.bodies, { opacity: 0.45, colour: COLOURS.pale });
      view.frame(M.eye(4), 0.12 * size, { thick: 0.004 * size });
      view.text([0, 0, -0.04 * size], frameNames[0]);
      drawEndFrames(now);
      axes.forEach(drawAxis);
      drawEllipsoids(now);
      now.frames.slice(0, state.frames).forEach(drawFrame);
      view.end();
      numbers(...linesOf(now));
      words.textContent = comment(now);
    };

    // ---- words ----

    function linesOf({ shownEnd, J }) {
      const pose = `<span>T<sub>${P.escape(frameNames.join(""))}</sub> =</span>`;
      const lines = [[pose, P.matrix(shownEnd)]];
      if (has("ellipsoids")) {
        const translational = P.list(M.singularValues(J.slice(3)), 3);
        const least = P.number(M.singularValues(J)[5], 4);
        lines.push(
          `singular values, translation only: ${translational} m\n` +
            `of the whole 6 x ${n} Jacobian the least: ${least}`,
        );
      }
      const isRowShown = state.frames && meta.rows && state.frames <= n;
      if (isRowShown) lines.push(rowOf(state.frames));
      if (path) {
        const error = M.poseError(shownEnd, path.target).slice(3);
        const millimetres = 1000 * M.norm(error);
        lines.push(`the flange moved by ${millimetres.toFixed(6)} mm from where it was`);
      }
      return lines;
    }
    function rowOf(k) {
      const [a, alpha, d] = meta.rows[k - 1];
      const theta = P.degrees(state.q[k - 1]);
      return (
        `DH row ${k} (modified): a = ${P.number(a, 4)} m, α = ${P.degrees(alpha)}, d = ${d} m, ` +
        `θ = ${P.sub("q", k)} = ${theta}`
      );
    }
    function comment({ J, differs }) {
      if (state.answer) return answerComment(state.answer, differs);
      const least = M.singularValues(J.slice(3))[2];
      if (has("singularity") && least < NEAR_SINGULAR) return singularComment(least);
      return "Drag a link: its joint rotates, and the other joint angles stay.";
    }
  }

  function answerComment({ problem, whose, gap }, differs) {
    if (problem) return `${problem} The library's forward kinematics moves the arm.`;
    if (!differs) return `Moved by ${whose}, which agrees with the library.`;
    return (
      `Moved by ${whose}. The pale blue arm is the library's; the end-effectors differ by ` +
      `${P.number(gap, 3)} in their largest entry.`
    );
  }
  function singularComment(least) {
    const speed = least > 1e-4 ? `${P.number(SPEED / least, 1)} rad/s` : "infinite speed";
    return (
      `Near a singularity: the least singular value is ${P.number(least, 3)} m. To move the ` +
      `end-effector at ${SPEED} m/s along the ellipsoid's short axis the joints would need ` +
      `at least ${speed}.`
    );
  }
})();
