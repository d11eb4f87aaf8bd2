// The Panda of the home page: the reader rotates the view, drags the gripper, or moves joints by sliders. Its data are
// in the page as JSON (see course_lib/pack/site/living.py), as is the picture shown before.
(() => {
  "use strict";
  const M = globalThis.course.motion, P = globalThis.course.parts, S = globalThis.course.scene;
  const JOINTS = [["Base", 0], ["Shoulder", 1], ["Elbow", 3], ["Wrist", 5]], TIP = [0, 0, 0.08];

  function start(host) {
    const model = JSON.parse(host.querySelector("script").textContent), still = host.querySelector("img");
    const { arm, limits } = model, n = arm.screws.length, solid = S.unpack(model.solid), draw = P.once(() => paint());
    const stage = P.element("div", { class: "stage" }, host);
    let q = [...model.q];
    const gripper = () => M.move(M.frames(arm, q)[n], TIP);
    const view = P.space(stage, { ...model.view, meta: {}, label: still.alt.replace(/\.$/, ""), redraw: draw });
    view.handle({
      name: "Gripper", colour: P.COLOURS.blue, at: gripper,
      moved: (p) => (q = M.reach(arm, q, p, { tip: TIP, limits })),
    });
    const panel = P.element("div", { class: "joints" }, host);
    const ranges = JOINTS.map(([name, joint]) => {
      const label = P.element("label", {}, panel, name), [min, max] = limits[joint];
      const input = P.element("input", { type: "range", min, max, step: 0.01 }, label);
      input.addEventListener("input", () => { q[joint] = Number(input.value); draw(); });
      return () => {
        input.value = q[joint];
        input.setAttribute("aria-valuetext", P.degrees(q[joint]));
      };
    });
    const words = P.element("p", {}, host);
    still.remove();
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
    paint();
  }
  if (S.start()) document.querySelectorAll(".living").forEach(start);
})();
