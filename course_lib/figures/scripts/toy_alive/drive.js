// "drive": a robot to drive, and where its own log says that it is. Body velocities are asked, and
// poses are answered.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { FIGURES, credit } = globalThis.course.alive;
  const { COLOURS } = globalThis.course.palette;
  const RADIUS = 0.17; // metres, of the robot
  const MAX_SECONDS = 90; // of a log
  const HEIGHT = 0.72; // of the room, in widths
  // Seconds: the longest step of the log, and what the shortest press of a key drives.
  const FRAME = 0.05;
  const TRUE_STEP = 0.05; // seconds between two points of the path
  const START = [0, 0, 0];
  const MAX_DOTS = 200;
  const CORNERS = [
    [-1, -1],
    [1, -1],
    [1, 1],
    [-1, 1],
  ];
  // Forward velocity (m/s) and angular velocity (rad/s) of a key, which has a button, too.
  const DIRECTIONS = {
    ArrowUp: { name: "Ahead", v: 0.5, omega: 0 },
    ArrowDown: { name: "Back", v: -0.5, omega: 0 },
    ArrowLeft: { name: "Left", v: 0, omega: 0.9 },
    ArrowRight: { name: "Right", v: 0, omega: -0.9 },
  };

  /**
   * The log of a robot that is driven: body velocities and for how long each.
   * @param {object} state its `log` is a list of [[vx, vy, omega], seconds]
   * @param {(position: number[]) => boolean} isInside whether the robot has room there
   */
  function logOf(state, isInside) {
    const truePoses = (dt = 1) => M.propagate(START, state.log, dt).exact;

    /**
     * Append some seconds at a velocity; the wall stops the robot, and its wheels.
     * @returns {boolean} whether the log has changed
     */
    function append(v, omega, seconds) {
      const driven = state.log.reduce((sum, part) => sum + part[1], 0);
      if ((!v && !omega) || driven > MAX_SECONDS) return false;
      const pose = truePoses().at(-1);
      const isAtWall = v && !isInside(M.expPlanar(pose, [omega * seconds, v * seconds, 0]));
      if (isAtWall) return false;
      const last = state.log.at(-1);
      const isSame = last && last[0][0] === v && last[0][2] === omega;
      if (isSame) {
        state.log = [...state.log.slice(0, -1), [last[0], last[1] + seconds]];
      } else {
        state.log = [...state.log, [[v, 0, omega], seconds]];
      }
      return true;
    }
    return { truePoses, append };
  }

  FIGURES.drive = (card, meta, ask) => {
    const { half, centre, plan, exact, dock } = meta;
    const state = card.state({ log: plan, dt: meta.dt, hidden: false }, { log: [] });
    const plane = card.map({
      half: 1.12 * half,
      centre,
      label: `${meta.title}. Arrow keys drive the robot`,
      proportion: HEIGHT,
    });
    const room = [half, HEIGHT * half];
    const isInside = (position) =>
      room.every((length, k) => Math.abs(position[k] - centre[k]) < length - RADIUS);
    const log = logOf(state, isInside);
    const askNow = () => ask({ plan: state.log, dt: state.dt });

    // ---- driving ----

    const held = new Set(); // keys of DIRECTIONS
    function advance(seconds) {
      const pressed = [...held].map((key) => DIRECTIONS[key]);
      const v = pressed.reduce((sum, direction) => sum + direction.v, 0);
      const omega = pressed.reduce((sum, direction) => sum + direction.omega, 0);
      if (log.append(v, omega, seconds)) askNow();
    }
    let frame = null;
    function driveOn(before) {
      frame = requestAnimationFrame((now) => {
        advance(P.clamp((now - before) / 1000, 0, FRAME));
        card.draw();
        if (held.size) driveOn(now);
        else frame = null;
      });
    }
    function press(key) {
      if (held.has(key)) return;
      held.add(key);
      advance(FRAME); // however short the press
      card.draw();
      if (frame === null) driveOn(performance.now());
    }
    function release() {
      held.clear();
      askNow();
      card.draw();
    }
    card.atEnd(() => {
      held.clear();
      cancelAnimationFrame(frame);
    });

    // Arrow keys drive wherever the focus is in the toy, for a press of a button takes it from the
    // picture; a range keeps its keys. Listeners of the capturing phase come before those of
    // buttons.
    const { canvas } = plane;
    const { root } = card;
    canvas.style.cursor = "pointer";
    canvas.tabIndex = 0;
    const focusPicture = () => canvas.focus({ preventScroll: true });
    canvas.addEventListener("pointerdown", focusPicture);
    root.addEventListener("click", () => {
      // Not every browser gives a button the focus that is clicked.
      if (!root.contains(document.activeElement)) focusPicture();
    });
    const isRange = (node) => node.type === "range";
    root.addEventListener(
      "keydown",
      (event) => {
        if (!(event.key in DIRECTIONS) || isRange(event.target)) return;
        event.preventDefault();
        event.stopPropagation();
        press(event.key);
      },
      { capture: true },
    );
    root.addEventListener("keyup", (event) => {
      if (!held.delete(event.key)) return;
      if (!held.size) release();
    });
    root.addEventListener("focusout", ({ relatedTarget }) => {
      if (held.size && !root.contains(relatedTarget)) release();
    });

    // ---- controls ----

    for (const key of Object.keys(DIRECTIONS)) addButton(key);
    card.checkbox("Hide the robot", state, "hidden");
    const dtLimits = { min: -2, max: 0, step: 0.1, value: Math.log10(state.dt) };
    const writeDt = (exponent) => `${Number((10 ** exponent).toPrecision(2))} s`;
    card.range("Step dt", dtLimits, writeDt, (exponent) => {
      state.dt = 10 ** exponent;
      askNow();
    });
    const words = card.words();
    askNow();

    /** A button drives as long as it is held; pressed by a key, for half a second. */
    function addButton(key) {
      const button = card.button(DIRECTIONS[key].name, () => {});
      button.classList.add("held");
      button.addEventListener("pointerdown", (event) => {
        button.setPointerCapture(event.pointerId);
        press(key);
      });
      P.onRelease(button, release);
      button.addEventListener("contextmenu", (event) => event.preventDefault());
      button.addEventListener("click", (event) => {
        if (event.detail) return; // by the pointer
        held.add(key);
        for (let k = 0; k < 10; k++) advance(FRAME);
        release();
      });
    }

    // ---- drawing ----

    /** The poses that the student's function, or the library's method, makes of the log. */
    function believedPoses() {
      if (state.answer?.value) return state.answer.value;
      const { euler, exact: exactPoses } = M.propagate(START, state.log, state.dt);
      return exact ? exactPoses : euler;
    }
    function drawRobot(path, colour, dash) {
      plane.line(path, colour, 2, { dash });
      plane.robot(path.at(-1), RADIUS, colour);
    }
    function drawRoom() {
      const wall = CORNERS.map(([u, v]) => M.add(centre, [u * room[0], v * room[1]]));
      plane.line(wall, COLOURS.grey, 2, { closed: true });
      plane.line(P.circle(1.2 * RADIUS, dock), COLOURS.green, 4, { dash: [4, 6] });
      plane.text([dock[0], dock[1] - 0.4], "dock", COLOURS.green);
    }
    /** Where the robot was when it was asked for the poses that are shown. */
    function truePoseThen() {
      const { answer } = state;
      if (!answer?.value) return log.truePoses(TRUE_STEP).at(-1);
      return M.propagate(START, answer.plan, 1).exact.at(-1);
    }

    return () => {
      const believed = believedPoses();
      plane.begin();
      drawRoom();
      if (!state.hidden) drawRobot(log.truePoses(TRUE_STEP), COLOURS.blue, []);
      drawRobot(believed, COLOURS.crimson, [7, 5]);
      if (believed.length < MAX_DOTS) {
        for (const pose of believed) plane.dot(pose, COLOURS.crimson, 2.5);
      }
      plane.end();

      const [x, y, theta] = truePoseThen();
      const [u, v, phi] = believed.at(-1);
      const centimetres = 100 * M.norm([u - x, v - y]);
      const distance = `${P.number(centimetres, centimetres < 10 ? 1 : 0)} cm`;
      const angle = P.degrees(Math.abs(M.wrap(phi - theta)));
      const comment = state.hidden
        ? "Drive the red robot to the dock, then show the blue one."
        : `Red, where it believes it is, is ${distance} and ${angle} off.`;
      words.textContent = credit(state, comment, comment);
    };
  };
})();
