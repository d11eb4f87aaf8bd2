// Two wheels of a robot: their speeds, the pole about which the robot rotates, and its path.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { COLOURS } = globalThis.course.palette;
  const HALF = 0.65; // metres of the floor to both sides
  const CENTRE = [0.1, 0.2];
  const HEIGHT = 0.88; // of the picture, in widths
  const SECONDS = 6; // of the path
  const LARGEST = 0.5; // m/s, of a wheel
  const STEP = 0.05; // m/s, by which the sliders move
  const METRES_OF_SPEED = 0.5; // the length of the arrow of 1 m/s
  const SCALE_SPEED = 0.2; // m/s, of the arrow that is the scale
  const WHEEL = [0.07, 0.03]; // metres: its length and its width
  const HEAD = 0.035; // metres: the length of an arrow's head
  const SAMPLES = 80; // of a path
  const GOAL = -0.2; // metres: where the pole should be, to the right of the robot's middle

  const metresPerSecond = (v) => `${P.number(v)} m/s`;

  P.toy("wheels", "The two wheels of a robot and its pole", (card, meta) => {
    const { track } = meta;
    const state = card.state({ left: meta.left, right: meta.right, at: 0 });
    const plane = card.map({
      half: HALF,
      centre: CENTRE,
      step: 0.2,
      proportion: HEIGHT,
      label: "The robot, the speeds of its wheels, its pole and its path",
    });
    const limits = { min: -LARGEST, max: LARGEST, step: STEP };
    card.setting("Left wheel", state, "left", limits, metresPerSecond);
    card.setting("Right wheel", state, "right", limits, metresPerSecond);
    const timeLimits = { min: 0, max: SECONDS, step: 0.05 };
    const time = card.setting("Time", state, "at", timeLimits, (t) => `${P.number(t)} s`);
    card.player("Play", time, 1 / 360);
    const numbers = card.numbers();
    const words = card.words(EXAMPLES.map((speeds) => comment(...speeds, track)));
    const goal = card.goal(
      state,
      `drive backwards about a pole that is ${P.number(-GOAL)} m to the right of the robot's middle.`,
    );

    /** What moves with the robot: points of its frame, at its pose. */
    const toFloor = (pose) => (p) => M.move(M.planar(pose), [...p, 0]).slice(0, 2);

    function drawWheel(place, y, colour) {
      const [length, width] = WHEEL;
      const corners = [
        [-length / 2, y - width / 2],
        [length / 2, y - width / 2],
        [length / 2, y + width / 2],
        [-length / 2, y + width / 2],
      ];
      plane.line(corners.map(place), colour, 1.5, { closed: true, fill: 0.55 });
    }
    /** An arrow ahead, from a place of the robot beside its middle. */
    function drawSpeed(place, y, speed, colour, width = 3) {
      if (!speed) return;
      const length = METRES_OF_SPEED * speed;
      const head = Math.sign(speed) * Math.min(HEAD, Math.abs(length));
      plane.line([place([0, y]), place([length, y])], colour, width);
      const barbs = [
        [length - head, y + HEAD / 2],
        [length, y],
        [length - head, y - HEAD / 2],
      ];
      plane.line(barbs.map(place), colour, width);
    }
    /** How long an arrow is for a speed, at the upper right. */
    function drawScale() {
      const [x, y] = [CENTRE[0] + 0.5 * HALF, CENTRE[1] + 0.9 * HEIGHT * HALF];
      drawSpeed((p) => M.add([x, y], p), 0, SCALE_SPEED, COLOURS.black, 2);
      plane.text([x + 0.5 * METRES_OF_SPEED * SCALE_SPEED, y - 0.05], "0.2 m/s", COLOURS.black);
    }
    /** The pole, the line of the axle, and the line on which the tips of all arrows lie. */
    function drawPole(pole, place, half) {
      const { left, right } = state;
      const tips = [place([METRES_OF_SPEED * left, half]), place([METRES_OF_SPEED * right, -half])];
      plane.line([place([0, half]), pole, place([0, -half])], COLOURS.grey, 1);
      plane.line([tips[0], pole, tips[1]], COLOURS.grey, 1);
      plane.dot(pole, COLOURS.black, 5);
      // Beside a pole within the robot the word stands outside the robot.
      const away = Math.abs(pole[1]) < track ? track : 0.06;
      plane.text(M.add(pole, [0, pole[1] < 0 ? -away : away]), "pole", COLOURS.black);
    }

    return () => {
      const { left, right, at } = state;
      const half = track / 2;
      const twist = M.twistOfWheels(left, right, track);
      const pole = M.pole([0, 0, 0], twist);
      const poseAt = (t) => M.expPlanar([0, 0, 0], M.scale(twist, t));
      const place = toFloor(poseAt(at));
      plane.begin();
      for (const [y, colour] of [
        [half, COLOURS.blue],
        [-half, COLOURS.crimson],
        [0, COLOURS.grey],
      ]) {
        const path = M.sampled(SAMPLES, (share) => toFloor(poseAt(SECONDS * share))([0, y]));
        plane.line(path, colour, y ? 1.2 : 2, { dash: y ? [2, 4] : [] });
      }
      plane.robot(poseAt(at), 0.8 * half, COLOURS.grey);
      plane.line([place([0, half]), place([0, -half])], COLOURS.grey, 2);
      if (pole) drawPole(pole, place, half);
      drawWheel(place, half, COLOURS.blue);
      drawWheel(place, -half, COLOURS.crimson);
      drawSpeed(place, half, left, COLOURS.blue);
      drawSpeed(place, -half, right, COLOURS.crimson);
      drawSpeed(place, 0, (left + right) / 2, COLOURS.grey);
      drawScale();
      plane.end();
      numbers(
        `vₓ = (vᵣ + vₗ)/2 = ${P.number(twist[1])} m/s`,
        `ω = (vᵣ − vₗ)/b = ${P.number(twist[0])} rad/s`,
        pole ? `vₓ/ω = ${P.number(pole[1])} m` : "no pole",
      );
      words.textContent = comment(left, right, track);
      const isAtGoal = pole && Math.abs(pole[1] - GOAL) < 1e-6;
      goal(Boolean(isAtGoal && twist[1] < 0));
    };
  });

  // Speeds after which the sentence is long, for which room is kept.
  const EXAMPLES = [
    [0.45, 0.4],
    [0.3, -0.3],
    [0.3, 0.3],
    [-0.4, -0.45],
  ];

  /** What the robot does, in a sentence. */
  function comment(left, right, track) {
    const [omega, speed] = M.twistOfWheels(left, right, track);
    const pole = M.pole([0, 0, 0], [omega, speed, 0]);
    if (!pole) {
      if (!speed) return "Both wheels stand still.";
      const way = speed > 0 ? "ahead" : "backwards";
      return `Both wheels are equally fast, so the robot drives straight ${way}. There is no pole: it is infinitely far away.`;
    }
    const sense = omega > 0 ? "counterclockwise" : "clockwise";
    const distance = pole[1];
    if (Math.abs(distance) < 1e-9) {
      return `The wheels are equally fast in opposite directions. The pole is the robot's middle, and the robot rotates ${sense} on the spot.`;
    }
    const side = distance > 0 ? "left" : "right";
    const isSeen = Math.abs(distance - CENTRE[1]) < HEIGHT * HALF;
    const outside = isSeen ? "" : ", outside the picture";
    return (
      `The robot rotates ${sense} about the pole, ${P.number(Math.abs(distance))} m to the ` +
      `${side} of its middle${outside}. Each speed is proportional to the distance from the pole.`
    );
  }
})();
