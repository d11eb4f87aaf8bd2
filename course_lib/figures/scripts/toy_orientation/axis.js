// "axis": an axis and an angle, with the rotation matrix and the quaternion of both.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { MODES, ORIGIN, drawAircraft, drawAxes, drawFixedAxes, linesOf } =
    globalThis.course.orientation;
  const { COLOURS } = globalThis.course.palette;
  const WING_TIP = [0, 0.81, 0];
  const UPRIGHT = Math.cos(3 * P.rad); // from here on the nose counts as upright

  function build(card) {
    const state = card.state({ azimuth: 30, height: 40, angle: 60 }); // degrees
    const view = card.space({ radius: 1.3, label: "An aircraft rotated about an axis" });
    const azimuthRange = card.angle("Axis: azimuth", state, "azimuth", -180, 180);
    const heightRange = card.angle("Axis: elevation", state, "height", -90, 90);
    const angleRange = card.angle("Angle", state, "angle", -360, 360);

    function direction() {
      const azimuth = state.azimuth * P.rad;
      const height = state.height * P.rad;
      const across = Math.cos(height);
      return [across * Math.cos(azimuth), across * Math.sin(azimuth), Math.sin(height)];
    }
    function setDirection(azimuth, height) {
      state.azimuth = azimuth;
      state.height = height;
      azimuthRange.set(azimuth);
      heightRange.set(height);
    }
    function setAngle(angle) {
      state.angle = angle;
      angleRange.set(angle);
    }
    view.handle({
      name: "Axis",
      colour: COLOURS.purple,
      at: () => M.scale(direction(), 1.3),
      describe: () =>
        `azimuth ${P.inDegrees(state.azimuth)}, elevation ${P.inDegrees(state.height)}`,
      moved: (p) => {
        const [x, y, z] = M.unit(p);
        const azimuth = Math.atan2(y, x) / P.rad;
        const height = Math.asin(P.clamp(z, -1, 1)) / P.rad;
        setDirection(Math.round(azimuth), Math.round(height));
      },
    });
    card.button("Reverse the axis", () => {
      const opposite = state.azimuth > 0 ? state.azimuth - 180 : state.azimuth + 180;
      setDirection(opposite, -state.height);
    });
    card.button("Reverse the angle", () => setAngle(-state.angle));
    const numbers = card.numbers();
    const words = card.words([-360, -359].map(comment));
    const goal = card.goal(state, "point the nose straight up, along z, by one rotation.");

    return () => {
      const angle = state.angle * P.rad;
      const axis = direction();
      const R = M.rotation(axis, angle);
      const grip = () => ({
        name: () => P.inDegrees(state.angle),
        at: ORIGIN,
        axis,
        angle,
        moved: (dragged) => setAngle(Math.round(P.clamp(dragged / P.rad, -360, 360))),
      });
      view.begin();
      drawFixedAxes(view);
      view.line([M.scale(axis, -1.2), M.scale(axis, 1.05)], COLOURS.purple, 3, { dash: [7, 5] });
      view.arrow(M.scale(axis, 1.05), M.scale(axis, 1.3), COLOURS.purple);
      drawAircraft(view, R, 0.95, { grip });
      drawAxes(view, R, 1.05);
      const path = M.sampled(60, (share) => M.apply(M.rotation(axis, angle * share), WING_TIP));
      view.line(path, COLOURS.crimson, 3);
      view.end();
      numbers(...linesOf(R, M.quaternion(axis, angle)));
      words.textContent = comment(state.angle);
      const nose = M.apply(R, [1, 0, 0]);
      goal(nose[2] > UPRIGHT);
    };
  }

  function comment(angle) {
    if (Math.abs(angle) === 360) {
      return (
        "A full rotation: R is the identity again, but q is −1. " +
        "Both q and −q stand for this orientation."
      );
    }
    if (angle === 0) return "No rotation: the axis does not matter.";
    const degrees = P.inDegrees(angle);
    return `R rotates by ${degrees} about the dashed axis; the red arc is the path of a wing tip.`;
  }

  MODES.axis = { title: "Axis and angle", build };
})();
