// "reach": a target, and an arm that reaches for it. A pose is asked, and joint angles are
// answered, none or several.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { FIGURES, credit } = globalThis.course.alive;
  const { COLOURS } = globalThis.course.palette;
  // The norm of a pose error, in metres and radians, below which an arm stands at the target.
  const REACHED = 1e-3;
  const APART = 0.01; // radians between two solutions, in one joint at least
  const SHOWN_MISS = 5e-5; // metres: what is written as 0.1 mm or more
  const MAX_LINES = 8;
  const STEPS_A_MOVE = 60; // of each solution, while the target moves
  const WITHIN_REACH = "The target is within reach: the arm follows.";
  const OUT_OF_REACH = "Out of reach: the arm comes as near as it can.";
  const ZYX = [
    [0, 0, 1],
    [0, 1, 0],
    [1, 0, 0],
  ];

  /**
   * The library's solutions: each is followed on its own while the target moves, and shown if it
   * reaches it.
   */
  function libraryOf({ arm, limits, starts }, state) {
    const noLimits = limits.map(() => [-Infinity, Infinity]);
    const error = (q, T) => M.poseError(M.frames(arm, q).at(-1), T);
    const miss = (q, T) => M.norm(error(q, T));
    const isAt = (q, T) => miss(q, T) < REACHED;
    const areApart = (q, p) => q.some((angle, i) => Math.abs(M.wrap(angle - p[i])) > APART);
    /**
     * A solution near q, its angles from -180 to 180 degrees: steps that are far too long, as after
     * a fast move of the target, would add up to several revolutions.
     */
    const solve = (q, T, steps) => M.reach(arm, q, T, noLimits, steps).map(M.wrap);

    /** Follow the target to T. */
    function follow(T) {
      if (!starts) {
        state.q = M.reach(arm, state.q, T, limits);
        return;
      }
      const followed = [];
      // Two that ran together would remain together.
      const isAnother = (q) => isAt(q, T) && followed.every((p) => !p || areApart(q, p));
      for (const earlier of state.all) {
        const q = solve(earlier, T, STEPS_A_MOVE);
        followed.push(isAnother(q) ? q : null);
      }
      for (const start of starts) {
        const lost = followed.indexOf(null);
        if (lost < 0) break;
        const q = solve(start, T, STEPS_A_MOVE);
        if (isAnother(q)) followed[lost] = q;
      }
      // A solution that is lost remains where it was, so that it is found when the target is back.
      state.all = followed.map((q, i) => q ?? state.all[i]);
      const isOutOfReach = followed.every((q) => q === null);
      const nearest = state.nearest ?? state.all[0];
      state.nearest = isOutOfReach ? solve(nearest, T) : null;
    }
    /** The solutions for T, or what comes nearest to it. */
    function solutions(T) {
      if (!starts) return [state.q];
      const different = state.all.filter((q, i) => {
        const earlier = state.all.slice(0, i);
        return isAt(q, T) && earlier.every((p) => areApart(q, p));
      });
      return different.length ? different : [state.nearest ?? state.all[0]];
    }
    return { error, miss, follow, solutions };
  }

  FIGURES.reach = (card, meta, ask) => {
    const { arm, size, goal, starts } = meta;
    const view = card.armSpace();
    const initial = () => ({
      q: meta.q,
      all: starts,
      nearest: null, // the angles out of reach
      chosen: 1,
      at: M.positionOf(goal),
      rotated: [0, 0, 0],
    });
    const state = card.state(initial());
    const library = libraryOf(meta, state);
    // Room to begin dragging, in the first picture.
    const sides = [-1, 1].flatMap((sign) => M.eye(3).map((axis) => M.scale(axis, sign)));
    let room = sides.map((side) => M.add(state.at, side, 0.15 * size));

    function target() {
      const rotations = ZYX.map((axis, i) => M.rotation(axis, state.rotated[i] * P.rad));
      const R = M.times(rotations.reduce(M.times), M.rotationOf(goal));
      return M.pose(R, state.at);
    }
    function moved() {
      const T = target();
      library.follow(T);
      ask({ target: T });
    }
    /** The target stays above the floor and little farther from the base than the arm reaches. */
    function near([x, y, z]) {
      const p = [x, y, Math.max(z, meta.ground)];
      return M.scale(p, Math.min(1, (1.15 * size) / M.norm(p)));
    }

    view.handle({
      name: "Target",
      colour: COLOURS.blue,
      at: () => state.at,
      moved: (p) => {
        state.at = near(p);
        moved();
      },
    });
    for (const [i, axis] of ["z", "y", "x"].entries()) {
      const limits = { min: -180, max: 180, step: 1, value: state.rotated[i] };
      card.range(`Rotate about ${axis}`, limits, P.inDegrees, (angle) => {
        state.rotated[i] = angle;
        moved();
      });
    }
    if (starts) addSolutionRange(card, state, starts.length);
    const numbers = card.numbers();
    const words = card.words([OUT_OF_REACH, WITHIN_REACH]);
    moved();

    /**
     * The joint angles in the picture: the chosen solution, or a share of the way from it to the
     * next, and the others.
     */
    function drawnOf(shown) {
      const chosen = Math.min(state.chosen, shown.length) - 1;
      const i = Math.floor(chosen);
      const share = chosen - i;
      if (!share) return [shown[i], ...shown.filter((_, k) => k !== i)];
      const smooth = share ** 2 * (3 - 2 * share); // slow at both ends
      const between = shown[i].map((angle, k) => angle + smooth * M.wrap(shown[i + 1][k] - angle));
      return [between, ...shown];
    }
    function drawArms(T, drawn) {
      const poses = drawn.map((q) => M.bodies(arm, q));
      view.begin();
      for (const bodies of poses) view.stand(bodies);
      view.contain([state.at, ...room]);
      room = [];
      poses.forEach((bodies, k) => {
        const isSolid = k === 0;
        view.arm(bodies, { opacity: isSolid ? 1 : 0.3, shadow: isSolid });
      });
      view.frame(T, 0.14 * size, { thick: 0.005 * size });
      view.frame(M.frames(arm, drawn[0]).at(-1), 0.09 * size, { thick: 0.006 * size });
      view.end();
    }
    function lineOf(q, i, T, isOne) {
      const miss = M.norm(library.error(q, T).slice(3));
      const number = isOne ? "" : `${i + 1}: `;
      const angles = q.map((angle) => P.degrees(angle)).join(", ");
      const isMissSaid = isOne || miss > SHOWN_MISS;
      const missed = isMissSaid ? `, ${P.millimetres(miss)} from the target` : "";
      return `${number}q = (${angles})${missed}`;
    }

    return () => {
      const { answer } = state;
      const T = target();
      const answered = answer?.value ?? [];
      const shown = answered.length ? answered : library.solutions(T);
      drawArms(T, drawnOf(shown));
      const isOne = shown.length === 1;
      numbers(...shown.slice(0, MAX_LINES).map((q, i) => lineOf(q, i, T, isOne)));
      const isOutOfReach = library.miss(shown[0], T) > REACHED;
      words.textContent = comment({ state, shown, isOutOfReach, starts });
    };
  };

  /** A range from solution to solution, and a button that goes through all of them. */
  function addSolutionRange(card, state, count) {
    const limits = { min: 1, max: count, step: 0.01, keys: 1 };
    const write = (x) => {
      const [low, high] = [Math.floor(x), Math.ceil(x)];
      return low === high ? String(low) : `${low} to ${high}`;
    };
    const solution = card.setting("Solution", state, "chosen", limits, write);
    card.player("From one to the next", solution, 0.0025);
  }

  function comment({ state, shown, isOutOfReach, starts }) {
    const { answer } = state;
    const more = answer?.said || "";
    const isRefused = answer?.value && !answer.value.length;
    if (isRefused) {
      const arm = isOutOfReach ? ": out of reach, as near as it can come" : ", which finds one";
      return `No solution from ${answer.whose}. The arm is the library's${arm}. ${more}`;
    }
    const count =
      shown.length === 1 ? "One solution." : `${shown.length} solutions, one of them solid.`;
    const hasSeveral = answer?.value?.length > 1;
    const ofAnswer = [hasSeveral ? count : "", more].filter(Boolean).join(" ");
    let ofLibrary = WITHIN_REACH;
    if (starts) ofLibrary = count;
    if (isOutOfReach) ofLibrary = OUT_OF_REACH;
    return credit(state, ofAnswer, ofLibrary);
  }
})();
