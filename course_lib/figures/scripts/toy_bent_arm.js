// The bent arm: q2 over the distance r of the tip is a root at the workspace's edge, and the square of q2 is smooth.
(() => {
  "use strict";
  const M = globalThis.course.motion, P = globalThis.course.parts, { COLOURS } = P;
  const LENGTHS = [1, 1], NEAR = 1.2, REACH = 2, SAMPLES = 41;
  const ALL = M.sampled(200, (s) => REACH - (REACH - NEAR) * (1 - s) ** 2);
  const bend = (r) => 2 * Math.acos(Math.min(1, r / REACH));

  P.toy("bent_arm", "The bent arm", (card, meta) => {
    const state = card.state({ at: [...meta.at], width: meta.width, degree: 1, sign: 1 });
    const plane = card.map({ half: 1.08 * REACH, label: "The arm, and its elbow on the other side" });
    plane.handle({
      name: "Tip", colour: COLOURS.blue, at: () => state.at,
      moved: (p) => { place(p); reach.set(M.norm(state.at)); },
      describe: () => `${P.metres(state.at)}, bent by ${P.degrees(bent())}`,
    });
    const parent = P.element("div", { class: "charts" }, card.views);
    const chart = (name, about, y, marks) => card.plane({
      x: [NEAR, REACH], y, ticks: [[1.2, 1.4, 1.6, 1.8, 2].map((r) => [r, r.toFixed(1)]), marks], margin: true, parent,
      names: ["distance r (m)", name], label: `${about} over the distance of the tip`, proportion: 0.55,
    });
    const quarter = Math.PI / 2;
    const angle = chart("q₂", "The bend q₂", [-2, 2], [[-quarter, "−90°"], [0, "0°"], [quarter, "90°"]]);
    const square = chart("q₂² (rad²)", "The square of q₂", [0, 4], [0, 2, 4]);
    const reach = card.range("Distance r", { min: NEAR, max: REACH, step: 0.01, value: M.norm(state.at) },
      (r) => P.metres([r]), (r) => place(M.scale(state.at, r / M.norm(state.at))));
    card.setting("Width of the cells", state, "width", { min: 0.05, max: 0.8, step: 0.05 }, (h) => P.metres([h]));
    card.setting("Degree", state, "degree", { min: 1, max: 3, step: 1 }, (n) => ["line", "parabola", "cubic"][n - 1]);
    card.button("Other elbow", () => (state.sign = -state.sign));
    const numbers = card.numbers(), words = card.words();

    const bent = () => state.sign * bend(M.norm(state.at));
    // The handle stays in the ring whose distances the charts show.
    function place(p) {
      const r = M.norm(p);
      state.at = r ? M.scale(p, Math.min(REACH, Math.max(NEAR, r)) / r) : [NEAR, 0];
    }
    function drawArm() {
      const direction = Math.atan2(state.at[1], state.at[0]);
      const put = (q2) => M.planarPoints(LENGTHS, [direction - q2 / 2, q2]), arm = put(bent());
      plane.begin();
      plane.line(P.circle(REACH), COLOURS.grey, 1);
      plane.line(put(-bent()), COLOURS.steel, 2.5, { dash: [2, 6] });
      plane.line(arm.slice(0, 2), COLOURS.dark, 7);
      plane.line(arm.slice(1), COLOURS.link, 6);
      plane.dot(arm[1], COLOURS.dark, 5);
      plane.end();
    }
    return () => {
      drawArm();
      // Cells are counted from the edge inwards, so that one of them touches it.
      const r = Math.min(REACH, M.norm(state.at)), h = state.width, inwards = Math.min(REACH - r, REACH - NEAR) / h;
      const k = Math.max(0, Math.ceil(inwards - 1e-9) - 1), to = REACH - k * h, from = Math.max(NEAR, to - h);
      const found = M.bendFits(from, to, state.degree, SAMPLES);
      const over = (values, sign = 1) => found.r.map((x, i) => [x, sign * values[i]]);
      const plot = (chart, [low, high], known, fits, at) => {
        chart.begin();
        chart.line([[from, low], [to, low], [to, high], [from, high]], COLOURS.grey, 0, { closed: true, fill: 0.2 });
        known.forEach((points) => chart.line(points, COLOURS.steel, 2));
        fits.forEach(([points, colour, dash]) => chart.line(points, colour, 2.5, { dash }));
        chart.dot([r, at], COLOURS.black, 4.5, { hollow: true });
        chart.end();
      };
      plot(angle, [-2, 2], [1, -1].map((sign) => ALL.map((x) => [x, sign * bend(x)])), [
        [over(found.direct, state.sign), COLOURS.crimson], [over(found.rooted, state.sign), COLOURS.blue, [6, 4]],
      ], bent());
      const fit = [[over(found.square), COLOURS.blue, [6, 4]]];
      plot(square, [0, 4], [ALL.map((x) => [x, bend(x) ** 2])], fit, bent() ** 2);
      const off = ({ angle, tip }) => `${P.degrees(angle, 2)} off, tip ${P.number(1000 * tip, 2)} mm`;
      numbers("At most, in this cell:", `q₂, solid red: ${off(found.directError)}`,
        `q₂², dashed blue: ${off(found.rootedError)}`);
      words.textContent = `Cell from ${P.number(from)} to ${P.number(to)} m. `
        + (k ? "Here q₂ and its square are both smooth. "
          : "This cell touches the edge of the workspace, where q₂ has a vertical tangent. ")
        + `q₂ = ${P.degrees(bent())}, q₂² = ${P.number(bent() ** 2)} rad² for both elbows.`;
    };
  });
})();
