// "table": a position, and the answer of a table beside the true arm with two links. A position is
// asked, and joint angles are answered. A page holds the answers for a grid of positions.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { FIGURES, credit } = globalThis.course.alive;
  const { COLOURS } = globalThis.course.palette;
  const STORED_STRIDE = 0.1; // metres between two stored positions

  const inDegrees = (q) => `(${q.map((angle) => P.degrees(angle, 1)).join(", ")})`;

  FIGURES.table = (card, meta, ask) => {
    const { lengths } = meta;
    const reach = lengths[0] + lengths[1];
    const stored = meta.stored && {
      positions: M.transpose(meta.stored.at),
      angles: M.transpose(meta.stored.q),
    };
    const state = card.state({ at: meta.at });
    const plane = card.map({ half: 1.15 * reach, label: meta.title, proportion: 0.9 });

    /**
     * On a page the query goes to the nearest of the positions for which the function was asked
     * beforehand.
     */
    function nearestStored(p) {
      const distances = stored.positions.map((position) => M.norm(M.subtract(position, p)));
      return stored.positions[distances.indexOf(Math.min(...distances))];
    }
    function moved(p) {
      state.at = stored ? nearestStored(p) : p;
      ask({ at: state.at });
    }
    const steps = stored ? { stride: STORED_STRIDE } : {};
    plane.handle({ name: "Query", colour: COLOURS.blue, at: () => state.at, moved, ...steps });
    const numbers = card.numbers();
    const words = card.words();
    moved(state.at);

    /** The joint angles that the function answered; null if it gave none. */
    function answeredAngles() {
      const { answer } = state;
      const storedAngles = stored?.angles[stored.positions.indexOf(state.at)];
      const angles = answer ? answer.value : storedAngles;
      const isGiven = angles?.length && angles[0] !== null;
      return isGiven ? angles : null;
    }
    /** The true joint angles, with the elbow on the side of the answer's; null out of reach. */
    function trueAngles(answered) {
      const angles = M.twoLink(lengths, state.at);
      const isOtherElbow = angles && answered?.[1] < 0;
      if (!isOtherElbow) return angles;
      // The arm is mirrored in the line from the base to the query.
      const [x, y] = state.at;
      return [2 * Math.atan2(y, x) - angles[0], -angles[1]];
    }
    function drawArm(q, colours, width) {
      const points = M.planarPoints(lengths, q);
      plane.line(points.slice(0, 2), colours[0], width);
      plane.line(points.slice(1), colours[1], width - 1);
      for (const joint of points.slice(0, 2)) plane.dot(joint, COLOURS.dark, 4);
    }

    return () => {
      const answered = answeredAngles();
      const truth = trueAngles(answered);
      const tip = answered && M.planarPoints(lengths, answered)[2];
      plane.begin();
      plane.line(P.circle(reach), COLOURS.grey, 1);
      if (truth) drawArm(truth, [COLOURS.blue, COLOURS.blue], 9);
      if (answered) {
        drawArm(answered, [COLOURS.steel, COLOURS.link], 6);
        plane.line([state.at, tip], COLOURS.crimson, 2);
        plane.dot(tip, COLOURS.crimson, 5);
      }
      plane.end();

      numbers(
        `true, blue: q = ${truth ? inDegrees(truth) : "none: out of reach"}`,
        `answer: q = ${answered ? inDegrees(answered) : "none"}`,
      );
      const miss = answered && P.millimetres(M.norm(M.subtract(tip, state.at)));
      const missed = answered ? `The tip is ${miss} from the query.` : "It gives no answer here.";
      words.textContent = stored
        ? `${missed} The blue arm is the true one; the query moves in steps of 10 cm.`
        : credit(state, missed, "The blue arm is the true one. Drag the query.");
    };
  };
})();
