// Toys of orientation, one of which meta.mode names; each is a file beside this one.
globalThis.course.orientation = (() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const S = globalThis.course.scene;
  const { COLOURS } = globalThis.course.palette;
  const MODES = {}; // {mode: {title, build(card) -> paint}}
  const ORIGIN = [0, 0, 0];
  const [X, Y, Z] = M.eye(3);

  const poseOf = (R, p = ORIGIN) => M.pose(R, p);

  /** The aircraft at the origin, of a size in its own lengths. */
  function drawAircraft(view, R, size, look) {
    const sized = R.map((row) => M.scale(row, size));
    view.mesh(S.aircraft, [poseOf(sized)], S.PALETTE, look);
  }
  /** The body's axes. */
  function drawAxes(view, R, length) {
    view.frame(poseOf(R), length, { above: false });
  }
  /** The axes of the room. */
  function drawFixedAxes(view) {
    const length = 1.15;
    [X, Y, Z].forEach((axis, k) => {
      view.line([ORIGIN, M.scale(axis, length)], COLOURS.grey, 1.5);
      view.text(M.scale(axis, 1.07 * length), "xyz"[k], COLOURS.grey);
    });
  }
  /** The lines of a card that show a rotation matrix and a quaternion. */
  const linesOf = (R, q) => [["R =", P.matrix(R)], `q = (${P.list(q, 3)}) as (w, x, y, z)`];

  /** Two views side by side, each below its label, which is HTML. */
  const pairOfViews = (card, labels) =>
    labels.map((label) => {
      const parent = P.element("div", { class: "half" }, card.views);
      const title = P.element("p", { style: "margin:0 0 .3rem;font-weight:600" }, parent);
      title.innerHTML = label;
      return card.space({ parent, radius: 1.25, label: title.textContent, proportion: 0.85 });
    });

  P.toy(
    "orientation",
    ({ mode }) => MODES[mode].title,
    (card, { mode }) => MODES[mode].build(card),
  );

  return {
    MODES,
    ORIGIN,
    X,
    Y,
    Z,
    poseOf,
    drawAircraft,
    drawAxes,
    drawFixedAxes,
    linesOf,
    pairOfViews,
  };
})();
