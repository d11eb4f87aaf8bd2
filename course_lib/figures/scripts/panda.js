// The Panda of the home page: the reader turns the view, pulls the gripper, or moves joints by sliders. Until a hand
// comes it sways for a few seconds; it stands still for those who prefer less motion. What it draws stands in the page
// as JSON (see course_lib/pack/site/living.py), and stands there as a picture until this script runs.
(() => {
  "use strict";
  const K = globalThis.course.kinematics, P = globalThis.course.parts;
  const JOINTS = [["Base", 0], ["Shoulder", 1], ["Elbow", 3], ["Wrist", 5]];
  const SWAY = 4.8; // seconds
  const NEAR = 55; // pixels from the gripper within which a pointer takes hold of it

  const numbers = (text, Kind) => Array.from(new Kind(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer));
  const triples = (flat) => Array.from({ length: flat.length / 3 }, (_, i) => flat.slice(3 * i, 3 * i + 3));

  function start(host) {
    const model = JSON.parse(host.querySelector("script").textContent), still = host.querySelector("img");
    const { arm, limits } = model, n = arm.screws.length, q = [...model.q], meta = {};
    const mesh = {
      vertices: triples(numbers(model.vertices, Int16Array).map((x) => x / 1e4)),
      faces: triples(numbers(model.faces, Uint16Array)),
      colours: numbers(model.colours, Uint8Array),
      bodies: numbers(model.bodies, Uint8Array),
    };
    let waiting = false, held = null, swaying = null;
    const schedule = () => {
      if (waiting) return;
      waiting = true;
      requestAnimationFrame(() => { waiting = false; draw(); });
    };
    const stage = P.element("div", { class: "stage" }, host);
    const settings = { radius: model.radius, centre: model.centre, azimuth: model.azimuth, elevation: model.elevation, shape: model.shape };
    const view = P.space(stage, { ...settings, meta, label: still.alt, redraw: schedule });
    const panel = P.element("div", { class: "joints" }, host);
    const ranges = JOINTS.map(([name, joint]) => {
      const label = P.element("label", {}, panel, name), low = limits[joint][0], high = limits[joint][1];
      const input = P.element("input", { type: "range", min: low, max: high, step: 0.01 }, label);
      input.addEventListener("input", () => { rest(); q[joint] = Number(input.value); schedule(); });
      return () => {
        input.value = q[joint];
        input.setAttribute("aria-valuetext", P.degrees(q[joint]));
      };
    });
    const words = P.element("p", {}, host);
    still.remove();

    const gripper = () => {
      const T = K.frames(arm, q)[n];
      return K.move(T, [0, 0, 0.08]);
    };
    function draw() {
      view.begin();
      view.floor(0, model.floor, 0.2);
      view.mesh(mesh, K.bodies(arm, q), model.palette);
      view.end();
      ranges.forEach((show) => show());
      const [x, y, z] = gripper().map((value) => P.number(value, 2));
      words.textContent = `Drag the gripper, or rotate the view. The gripper is at x = ${x}, y = ${y}, z = ${z} m.`;
    }

    // ---- pulling the gripper: damped least squares, as in the course ----

    const rightAndUp = () => {
      const { azimuth: a, elevation: b } = view.view, right = [-Math.sin(a), Math.cos(a), 0];
      return [right, K.cross([Math.cos(b) * Math.cos(a), Math.cos(b) * Math.sin(a), Math.sin(b)], right)];
    };
    function pullTo(goal) {
      for (let k = 0; k < 8; k++) {
        const T = K.frames(arm, q)[n], J = K.geometricJacobian(arm, q);
        // The Jacobian is that of the flange; the gripper turns with it.
        const arms = K.apply(K.rotationOf(T), [0, 0, 0.08]);
        const Jv = K.transpose(K.transpose(J).map((column) => K.add(column.slice(3), K.cross(column.slice(0, 3), arms))));
        const error = K.add(goal, gripper(), -1), far = K.norm(error);
        if (far < 1e-4) return;
        const step = K.dampedStep(Jv, K.scale(error, Math.min(1, 0.1 / far)), 0.02);
        q.forEach((angle, i) => (q[i] = Math.min(limits[i][1], Math.max(limits[i][0], angle + step[i]))));
      }
    }
    const at = (event) => {
      const box = view.canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    const isNear = (point) => {
      const [x, y] = view.project(gripper());
      return Math.hypot(point[0] - x, point[1] - y) < NEAR;
    };
    const take = (event) => {
      rest();
      if (!isNear(at(event))) return;
      held = { from: at(event), gripper: gripper() };
      view.canvas.setPointerCapture(event.pointerId);
      event.stopImmediatePropagation(); // the view is not turned
    };
    const pull = (event) => {
      const [x, y] = at(event);
      if (!held) return void (view.canvas.style.cursor = isNear([x, y]) ? "grab" : "move");
      const [right, up] = rightAndUp(), [a, b] = [held.gripper, K.add(held.gripper, right, 0.1)].map(view.project);
      const metres = 0.1 / Math.hypot(b[0] - a[0], b[1] - a[1]);
      pullTo(K.add(K.add(held.gripper, right, metres * (x - held.from[0])), up, -metres * (y - held.from[1])));
      schedule();
      event.stopImmediatePropagation();
    };
    view.canvas.addEventListener("pointerdown", take, { capture: true });
    view.canvas.addEventListener("pointermove", pull, { capture: true });
    ["pointerup", "pointercancel"].forEach((kind) => view.canvas.addEventListener(kind, () => (held = null)));
    // On a phone a finger on the gripper pulls it, one beside it scrolls the page.
    view.canvas.addEventListener("touchstart", (event) => isNear(at(event.touches[0])) && event.preventDefault(), { passive: false });
    view.canvas.addEventListener("keydown", rest);

    // ---- a sign of life, until a hand comes ----

    function rest() { swaying = null; }
    function sway() {
      const run = (swaying = {}), begun = performance.now();
      const step = (now) => {
        const t = (now - begun) / 1000;
        if (swaying !== run || t > SWAY) return;
        const angle = (2 * Math.PI * t) / SWAY; // it ends where it began
        [[0, 0.35], [3, 0.2], [5, -0.25]].forEach(([joint, size]) => (q[joint] = model.q[joint] + size * Math.sin(angle)));
        schedule();
        requestAnimationFrame(step);
      };
      requestAnimationFrame(step);
    }
    draw();
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) sway();
  }
  document.querySelectorAll(".living").forEach(start);
})();
