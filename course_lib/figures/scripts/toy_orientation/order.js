// "order": two rotations in either order, side by side.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { MODES, X, Z, drawAircraft, drawAxes, drawFixedAxes, pairOfViews } =
    globalThis.course.orientation;
  const { COLOURS } = globalThis.course.palette;
  const PRODUCTS = [
    { label: "R<sub>z</sub> R<sub>x</sub>", axes: [Z, X] },
    { label: "R<sub>x</sub> R<sub>z</sub>", axes: [X, Z] },
  ];

  function build(card) {
    const state = card.state({ time: 2, angle: 90, own: false });
    const labels = PRODUCTS.map(({ label }) => label);
    const views = pairOfViews(card, labels);
    const write = (time) =>
      time <= 1 ? `first, ${P.percent(time)}` : `second, ${P.percent(time - 1)}`;
    const time = card.setting("Step", state, "time", { min: 0, max: 2, step: 0.02 }, write);
    card.angle("Both angles", state, "angle", 0, 180);
    card.checkbox("from the left: about the body's own axes", state, "own");
    card.player("Play", time, 0.0075);
    const numbers = card.numbers();

    /** The angles now of the left and the right factor: about own axes the left one comes first. */
    function angles() {
      const whole = state.angle * P.rad;
      const first = whole * Math.min(1, state.time);
      const second = whole * Math.max(0, state.time - 1);
      return state.own ? [first, second] : [second, first];
    }

    return () => {
      const [left, right] = angles();
      const isLeftMoving = state.time <= 1 === state.own;
      const orientations = PRODUCTS.map(({ axes: [leftAxis, rightAxis] }) =>
        M.times(M.rotation(leftAxis, left), M.rotation(rightAxis, right)),
      );
      views.forEach((view, i) => {
        const [leftAxis, rightAxis] = PRODUCTS[i].axes;
        const rightAxisNow = M.apply(M.rotation(leftAxis, left), rightAxis);
        const axis = isLeftMoving ? leftAxis : rightAxisNow;
        view.begin();
        drawFixedAxes(view);
        view.line([M.scale(axis, -1.2), M.scale(axis, 1.2)], COLOURS.purple, 3, { dash: [7, 5] });
        drawAircraft(view, orientations[i], 0.9);
        drawAxes(view, orientations[i], 1.0);
        view.end();
      });
      const between = M.times(M.transpose(orientations[0]), orientations[1]);
      const matrices = orientations.map((R, i) => [`<span>${labels[i]} now:</span>`, P.matrix(R)]);
      const angle = P.degrees(M.norm(M.rotationVector(between)), 1);
      numbers(...matrices, `angle between the two orientations: ${angle}`);
    };
  }

  MODES.order = { title: "Rz Rx and Rx Rz", build };
})();
