// "velocity": an angular velocity, in the room and in the body.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { MODES, ORIGIN, X, Y, Z, drawAircraft, drawAxes, drawFixedAxes, pairOfViews } =
    globalThis.course.orientation;
  const { COLOURS } = globalThis.course.palette;
  const LABELS = ["In the room: ω in fixed axes", "In the body: ω in its own axes"];
  const PERIOD = 2 * Math.PI; // seconds: one revolution at 1 rad/s
  const ARROW = 0.43; // the length of 1 rad/s
  const STILL = M.eye(3);

  /** After a share of the period: R = Rz(t) Ry(tilt) Rx(spin t), and omega in both frames. */
  function motion({ tilt, spin }, share) {
    const t = PERIOD * share;
    const tilted = M.times(M.rotation(Z, t), M.rotation(Y, tilt * P.rad));
    const R = M.times(tilted, M.rotation(X, spin * t));
    const inRoom = M.add(Z, M.apply(tilted, X), spin);
    const inBody = M.apply(M.transpose(R), inRoom);
    return { R, omegas: [inRoom, inBody] };
  }

  function build(card) {
    const state = card.state({ time: 0.12, tilt: -40, spin: 2 });
    const views = pairOfViews(card, LABELS);
    const seconds = (share) => `${P.number(PERIOD * share)} s`;
    const speed = (spin) => `${P.number(spin, 0)} rad/s`;
    const timeLimits = { min: 0, max: 1, step: 0.005 };
    const spinLimits = { min: -2, max: 2, step: 1 };
    const time = card.setting("Time", state, "time", timeLimits, seconds);
    card.angle("Tilt", state, "tilt", -90, 90);
    card.setting("Rotation about its own x axis", state, "spin", spinLimits, speed);
    card.player("Play", time, 0.003);
    const numbers = card.numbers();

    return () => {
      const { R, omegas } = motion(state, state.time);
      const period = M.sampled(120, (share) => motion(state, share).omegas);
      views.forEach((view, i) => {
        const isRoom = i === 0;
        const shown = isRoom ? R : STILL;
        const path = period.map((both) => M.scale(both[i], ARROW));
        view.begin();
        if (isRoom) drawFixedAxes(view);
        drawAircraft(view, shown, 0.8);
        drawAxes(view, shown, 1.0);
        view.line(path, COLOURS.crimson, 2);
        const tip = M.scale(omegas[i], ARROW);
        view.arrow(ORIGIN, tip, COLOURS.purple, { above: true, thick: 0.03 });
        view.end();
      });
      const [inRoom, inBody] = omegas.map((omega) => P.list(omega));
      numbers(
        ["R =", P.matrix(R)],
        `ω in the room: (${inRoom}) rad/s\nω in the body: (${inBody}) rad/s`,
      );
    };
  }

  MODES.velocity = { title: "Angular velocity", build };
})();
