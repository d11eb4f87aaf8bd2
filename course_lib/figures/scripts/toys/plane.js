// The plane: a stage with a grid, on which y points upwards.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { COLOURS, tint } = globalThis.course.palette;
  // Pixels around a chart for the words at its axes; a map writes them into the picture.
  const CHART_MARGINS = { left: 48, right: 16, top: 8, below: 38 };
  const BELOW_WITHOUT_NAME = 10; // pixels, below a chart whose axis has no name and no numbers
  const NO_MARGINS = { left: 0, right: 0, top: 0, below: 0 };
  const STEPS_ACROSS = 120; // of a handle, by the arrow keys

  /** A tick is a number, which is written with one decimal if it has any, or [number, words]. */
  function named(tick) {
    if (Array.isArray(tick)) return tick;
    return [tick, P.number(tick, Number.isInteger(tick) ? 0 : 1)];
  }

  /**
   * A part of the plane.
   * @param {Element} parent
   * @param {{x: number[], y: number[], ticks: Function | Array, names: string[], label: string,
   *   redraw: () => void, proportion?: number, margin?: boolean}} options x and y are its ranges,
   *   names those of the axes. ticks: for a chart those of both axes; a map's are a function of a
   *   range, because it fills what is left of its stage. With `margin` it is a chart, whose words
   *   stand outside.
   * @returns {object} the stage, with line, dot, text, robot and handle
   */
  P.plane = (parent, { x, y, ticks, names, label, redraw, proportion, margin }) => {
    const [width, height] = [x[1] - x[0], y[1] - y[0]];
    const plane = P.stage(parent, { label, redraw, proportion: proportion || height / width });
    const { context } = plane;
    const stage = { begin: plane.begin, end: plane.end, handle: plane.handle };
    const { left, right, top, ...margins } = margin ? CHART_MARGINS : NO_MARGINS;
    const below = margin && !names[0] ? BELOW_WITHOUT_NAME : margins.below;
    const isMap = typeof ticks === "function";
    let [[x0, x1], [y0, y1]] = [x, y];
    let ticksAcross = [];
    let ticksUpwards = [];

    // A map has one scale in both directions: the largest at which both ranges are in the picture.
    function measure() {
      if (!isMap) {
        [ticksAcross, ticksUpwards] = ticks.map((axis) => axis.map(named));
        return;
      }
      const scale = Math.min(plane.width / width, plane.height / height);
      const around = ([low, high], pixels) => {
        const middle = (low + high) / 2;
        const half = pixels / (2 * scale);
        return [middle - half, middle + half];
      };
      [x0, x1] = around(x, plane.width);
      [y0, y1] = around(y, plane.height);
      ticksAcross = ticks(x0, x1).map(named);
      ticksUpwards = ticks(y0, y1).map(named);
    }
    const innerWidth = () => plane.width - left - right;
    const innerHeight = () => plane.height - below - top;
    const toPixels = ([u, v]) => [
      left + (innerWidth() * (u - x0)) / (x1 - x0),
      top + (innerHeight() * (y1 - v)) / (y1 - y0),
    ];
    const fromPixels = ([u, v]) => [
      x0 + ((u - left) / innerWidth()) * (x1 - x0),
      y1 - ((v - top) / innerHeight()) * (y1 - y0),
    ];

    function write(words, [u, v], align, weight = "") {
      context.font = `${weight}12px system-ui,sans-serif`;
      context.textAlign = align;
      // A rim of the ground, so that no line of the grid runs through the words.
      context.strokeStyle = tint(COLOURS.ground);
      context.lineWidth = 4;
      context.setLineDash([]);
      context.strokeText(words, u, v);
      context.fillStyle = tint(COLOURS.grey);
      context.fillText(words, u, v);
    }
    function drawGrid() {
      for (const [u] of ticksAcross) {
        const ends = [
          [u, y0],
          [u, y1],
        ];
        plane.line(ends, COLOURS.grid, 1);
      }
      for (const [v] of ticksUpwards) {
        const ends = [
          [x0, v],
          [x1, v],
        ];
        plane.line(ends, COLOURS.grid, 1);
      }
    }
    function writeTicks() {
      for (const [u, words] of ticksAcross) {
        const [across] = toPixels([u, y0]);
        // In a map the corners hold the names of the axes.
        const isFree = margin || (across > 30 && across < plane.width - 50);
        const down = plane.height - (margin ? 22 : 5);
        if (isFree) write(words, [across, down], "center");
      }
      for (const [v, words] of ticksUpwards) {
        const down = toPixels([x0, v])[1];
        const isFree = margin || (down > 30 && down < plane.height - 20);
        if (!isFree) continue;
        if (margin) write(words, [left - 6, down + 4], "right");
        else write(words, [5, down + 4], "left");
      }
    }
    function writeNames() {
      const bottom = plane.height - 5;
      if (!margin) {
        write(names[0], [plane.width - 5, bottom], "right");
        write(names[1], [5, 15], "left", "600 ");
        return;
      }
      write(names[0], [left + innerWidth() / 2, bottom], "center");
      write(names[1], [left + innerWidth() - 4, top + 13], "right", "600 ");
      const axes = [
        [x0, y1],
        [x0, y0],
        [x1, y0],
      ];
      plane.line(axes, COLOURS.grey, 1);
    }

    function writeAxes() {
      writeTicks();
      writeNames();
    }

    plane.begin = () => {
      stage.begin();
      measure();
      context.setTransform(plane.dense, 0, 0, plane.dense, 0, 0);
      context.clearRect(0, 0, plane.width, plane.height);
      context.lineCap = "round";
      context.lineJoin = "round";
      drawGrid();
      if (margin) writeAxes();
      context.save();
      context.beginPath();
      context.rect(left, 0, plane.width, plane.height - below);
      context.clip();
    };
    plane.end = () => {
      context.restore();
      // The words of a map stand in the picture: what was drawn, a wall say, must not run through
      // them.
      if (!margin) writeAxes();
      stage.end();
    };

    /**
     * A line through points, `width` pixels wide; 0 draws none.
     * @param {{dash?: number[], closed?: boolean, fill?: number}} look fill: how opaque the area is
     *   that it encloses
     */
    plane.line = (points, colour, width = 2, { dash = [], closed, fill } = {}) => {
      context.beginPath();
      points.forEach((point, i) => {
        if (i === 0) context.moveTo(...toPixels(point));
        else context.lineTo(...toPixels(point));
      });
      if (closed) context.closePath();
      context.strokeStyle = tint(colour);
      context.fillStyle = tint(colour);
      context.lineWidth = width;
      context.setLineDash(dash);
      if (width) context.stroke();
      if (!fill) return;
      context.globalAlpha = fill;
      context.fill();
      context.globalAlpha = 1;
    };

    /** A dot of a radius in pixels. */
    plane.dot = (point, colour, radius = 4, { hollow } = {}) => {
      context.beginPath();
      context.arc(...toPixels(point), radius, 0, 2 * Math.PI);
      context.fillStyle = tint(hollow ? COLOURS.ground : colour);
      context.strokeStyle = tint(colour);
      context.lineWidth = 2;
      context.setLineDash([]);
      context.fill();
      if (hollow) context.stroke();
    };

    plane.text = (point, words, colour) => plane.word(toPixels(point), words, colour);
    plane.fromPixels = fromPixels;

    /** A round robot at a pose (x, y, theta), with a line to its front. */
    plane.robot = ([u, v, theta], radius, colour) => {
      const front = [u + radius * Math.cos(theta), v + radius * Math.sin(theta)];
      plane.line(P.circle(radius, [u, v]), colour, 1.5, { closed: true, fill: 0.25 });
      plane.line([[u, v], front], colour, 2);
    };

    const stride = width / STEPS_ACROSS;
    plane.handle = (options) =>
      stage.handle({ stride, ...options }, { toPixels, fromPixels, step: M.add });
    /**
     * The two handles of a pose (x, y, theta), for its position and its direction.
     * @param {{title: string, colour: string, pose: () => number[], ahead: () => number[],
     *   moved: (pose: number[]) => void}} options ahead: where the handle of the direction is
     */
    plane.poseHandles = ({ title, colour, pose, ahead, moved }) => {
      const position = () => pose().slice(0, 2);
      const angle = () => P.degrees(pose()[2]);
      plane.handle({
        name: `${title}, position`,
        colour,
        at: position,
        describe: () => `${P.metres(position())}, ${angle()}`,
        moved: ([x, y]) => moved([x, y, pose()[2]]),
      });
      plane.handle({
        name: `${title}, direction`,
        colour,
        small: true,
        at: ahead,
        describe: angle,
        moved: ([u, v]) => {
          const [x, y, theta] = pose();
          const change = M.wrap(Math.atan2(v - y, u - x) - theta);
          moved([x, y, theta + change]); // beyond half a revolution, too
        },
      });
    };
    return plane;
  };

  /**
   * A map in metres around a centre, with lines every `step`; it shows `half` to both sides, and up
   * and down that times the proportion.
   */
  P.map = (parent, { half, centre = [0, 0], step = 1, proportion = 1, ...options }) => {
    const [x, y] = centre;
    const halfHeight = half * proportion;
    function ticks(low, high) {
      const first = Math.ceil(low / step);
      const count = Math.floor(high / step) - first + 1;
      return Array.from({ length: count }, (_, i) => (first + i) * step);
    }
    return P.plane(parent, {
      x: [x - half, x + half],
      y: [y - halfHeight, y + halfHeight],
      ticks,
      names: ["x (m)", "y (m)"],
      ...options,
    });
  };

  /** Points of a circle, the first one once more at the end. */
  P.circle = (radius, [x, y] = [0, 0]) =>
    M.sampled(90, (share) => {
      const angle = 2 * Math.PI * share;
      return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
    });
})();
