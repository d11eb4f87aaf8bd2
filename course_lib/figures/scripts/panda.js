// The Panda of the home page: the reader turns the view, pulls the gripper, or moves joints by sliders. Until someone
// does it sways for a few seconds; it stands still for those who prefer less motion. What it draws stands in the page
// as JSON (see course_lib/pack/site/living.py), and a picture of it until this script runs.
(() => {
  "use strict";
  const M = globalThis.course.motion, P = globalThis.course.parts, S = globalThis.course.scene;
  const JOINTS = [["Base", 0], ["Shoulder", 1], ["Elbow", 3], ["Wrist", 5]], TIP = [0, 0, 0.08];
  const SWAY = 4.8; // seconds

  function start(host) {
    const model = JSON.parse(host.querySelector("script").textContent), still = host.querySelector("img");
    const { arm, limits } = model, n = arm.screws.length, solid = S.unpack(model.solid), draw = P.once(() => paint());
    const stage = P.element("div", { class: "stage" }, host);
    let q = [...model.q], swaying = true;
    const gripper = () => M.move(M.frames(arm, q)[n], TIP), rest = () => (swaying = false);
    const view = P.space(stage, { ...model.view, meta: {}, label: still.alt.replace(/\.$/, ""), redraw: draw });
    view.handle({
      name: "Gripper", colour: P.COLOURS.blue, at: gripper,
      moved: (p) => { rest(); q = M.reach(arm, q, p, { tip: TIP, limits }); draw(); },
    });
    const panel = P.element("div", { class: "joints" }, host);
    const ranges = JOINTS.map(([name, joint]) => {
      const label = P.element("label", {}, panel, name), [min, max] = limits[joint];
      const input = P.element("input", { type: "range", min, max, step: 0.01 }, label);
      input.addEventListener("input", () => { rest(); q[joint] = Number(input.value); draw(); });
      return () => {
        input.value = q[joint];
        input.setAttribute("aria-valuetext", P.degrees(q[joint]));
      };
    });
    const words = P.element("p", {}, host);
    still.remove();
    ["pointerdown", "keydown"].forEach((kind) => stage.addEventListener(kind, rest));
    P.onTheme(draw);

    function paint() {
      view.begin();
      view.floor(model.floor);
      view.mesh(solid, M.bodies(arm, q), solid.palette);
      view.end();
      ranges.forEach((show) => show());
      const [x, y, z] = gripper().map((value) => P.number(value));
      words.textContent = `Drag the gripper, or rotate the view. The gripper is at x = ${x}, y = ${y}, z = ${z} m.`;
    }
    // A slow motion that shows that the robot can be moved; it ends where it began.
    function sway() {
      const begun = performance.now();
      const step = (now) => {
        const t = Math.min(1, (now - begun) / 1000 / SWAY);
        if (!swaying) return;
        [[0, 0.35], [3, 0.2], [5, -0.25]].forEach(([joint, size]) =>
          (q[joint] = model.q[joint] + size * Math.sin(2 * Math.PI * t)));
        draw();
        if (t < 1) requestAnimationFrame(step);
      };
      requestAnimationFrame(step);
    }
    paint();
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) sway();
  }
  if (S.start()) document.querySelectorAll(".living").forEach(start);
})();
