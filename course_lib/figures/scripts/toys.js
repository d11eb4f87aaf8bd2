// What all toys are made of: a card with rows of controls, a plane (SVG) whose handles follow pointer and arrow keys,
// a view of bodies in space (canvas). Nothing here knows any toy, and nothing needs plotly.
(() => {
  "use strict";
  const K = globalThis.course.kinematics, NS = "http://www.w3.org/2000/svg";
  // Toys name the colours of the light theme. Those that would be lost on the dark ground have a partner there, and words
  // on the light one a darker one, so that lines keep a contrast of 3 to their ground and words one of 4.5.
  const COLOURS = { blue: "#0072b2", orange: "#b87a00", green: "#009e73", purple: "#9b4f7f", red: "#d55e00", grey: "#6b7177",
    black: "#222222", crimson: "#b2182b", steel: "#7f8891", link: "#d96a12", ground: "#f7f8fa", grid: "#dde1e6" };
  const IN_DARK = {
    "#0072b2": "#56a8de", "#b87a00": "#e69f00", "#009e73": "#33c79c", "#9b4f7f": "#d08ab5", "#d55e00": "#f0863a", "#6b7177": "#b3bac1",
    "#222222": "#e7eaee", "#b2182b": "#f2667a", "#7f8891": "#8d959e", "#d96a12": "#f07818", "#f7f8fa": "#14171b", "#dde1e6": "#2a3037",
    "#444444": "#b9c0c7", "#555555": "#a3abb3", "#999999": "#8a929a", "#ffffff": "#14171b", "#0b5fff": "#6ea8ff",
    "#2f3338": "#69727c", "#5b6168": "#7d858e", "#e4e7ea": "#4a535d", "#2166ac": "#4393d0", "#b01a2a": "#d6404f",
  };
  const AS_WORDS = { "#009e73": "#007a59", "#b87a00": "#8a5f00", "#d55e00": "#b84f00" };
  const isDark = () => document.documentElement.dataset.theme === "dark" || document.body.dataset.jpThemeLight === "false";
  const tint = (colour) => (isDark() && IN_DARK[colour.toLowerCase()]) || colour;
  const wordTint = (colour) => (!isDark() && AS_WORDS[colour.toLowerCase()]) || tint(colour);

  // Call change when the page (data-theme) or JupyterLab goes over to its other theme; returns what ends that.
  function onTheme(change) {
    let before = isDark();
    const watch = new MutationObserver(() => { if (isDark() !== before) { before = isDark(); change(); } });
    watch.observe(document.documentElement, { attributeFilter: ["data-theme"] });
    watch.observe(document.body, { attributeFilter: ["data-jp-theme-light"] });
    return () => watch.disconnect();
  }

  const STYLE = `.course-toy{--ground:#fff;--stage:#f7f8fa;--ink:#222;--edge:#555;--button:#f2f2f2;--pressed:#d9e8f3;--chosen:#0072b2;--numbers:#f2f4f6;
--focus:#0b5fff;color-scheme:light;box-sizing:border-box;max-width:720px;margin:0;padding:.75rem;background:var(--ground);color:var(--ink);
font:14px/1.45 system-ui,sans-serif;border-radius:.25rem}
:is([data-theme=dark],[data-jp-theme-light=false]) .course-toy{--ground:#1b1f24;--stage:#14171b;--ink:#e7eaee;--edge:#a3abb3;--button:#39414a;
--pressed:#1f4a66;--chosen:#56a8de;--numbers:#14171b;--focus:#6ea8ff;color-scheme:dark}
.course-toy *{box-sizing:border-box}
.course-toy .views{display:flex;flex-wrap:wrap;gap:.75rem}.course-toy .views>*{flex:1 1 300px;min-width:0;max-width:100%}
.course-toy svg,.course-toy canvas{display:block;width:100%;background:var(--stage);border-radius:.25rem}
.course-toy .setting{display:flex;align-items:center;gap:.6rem;margin-top:.35rem}
.course-toy .setting label{flex:0 0 9.5em}.course-toy .setting input[type=range]{flex:1 1 4rem;min-width:4rem;margin:0}
.course-toy .setting output{flex:0 0 6em;text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
.course-toy .buttons{display:flex;flex-wrap:wrap;gap:.5rem 1rem;margin-top:.5rem;align-items:center}
.course-toy button{font:inherit;padding:.2rem .7rem;border:1px solid var(--edge);border-radius:.25rem;background:var(--button);color:inherit}
.course-toy button[aria-pressed=true]{background:var(--pressed);border-color:var(--chosen)}
.course-toy pre{margin:.5rem 0 0;padding:.4rem .6rem;background:var(--numbers);color:inherit;border:0;border-radius:.25rem;
white-space:pre-wrap;font:13px/1.5 ui-monospace,Consolas,monospace}
.course-toy p{margin:.4rem 0 0}.course-toy :focus-visible{outline:3px solid var(--focus);outline-offset:2px}
.course-toy .handle{cursor:grab;touch-action:none;outline:none}.course-toy .handle .ring{opacity:0}
.course-toy .handle:focus .ring{opacity:1}
@media(max-width:480px){.course-toy .setting{flex-wrap:wrap;gap:.1rem .6rem}.course-toy .setting label{flex:1 1 55%}
.course-toy .setting input[type=range]{flex:1 1 100%;order:3;min-height:1.6rem}}`;

  function element(name, attributes, parent, text) {
    const made = document.createElement(name);
    Object.entries(attributes || {}).forEach(([key, value]) => made.setAttribute(key, value));
    if (text !== undefined) made.textContent = text;
    if (parent) parent.append(made);
    return made;
  }
  function shape(name, attributes, parent, text) {
    const made = document.createElementNS(NS, name);
    set(made, attributes);
    if (text !== undefined) made.textContent = text;
    parent.append(made);
    return made;
  }
  const set = (node, attributes) => Object.entries(attributes).forEach(([key, value]) =>
    node.setAttribute(key, key === "fill" && node.tagName === "text" ? wordTint(value) : key === "fill" || key === "stroke" ? tint(value) : value));
  const degrees = (angle, digits = 0) => `${((180 / Math.PI) * angle).toFixed(digits).replace(/^-(0(\.0+)?)$/, "$1")}°`;
  const number = (x, digits = 2) => x.toFixed(digits).replace(/^-(0(\.0+)?)$/, "$1");
  const signed = (x, digits = 3) => number(x, digits).padStart(digits + 4);
  const table = (rows, digits) => rows.map((row) => row.map((x) => signed(x, digits)).join(" ")).join("\n");

  // The card of a toy: views beside each other, controls below, then what it says in words.
  function card(host, name) {
    const root = element("div", { class: "course-toy", role: "group", "aria-label": name }, host);
    element("style", {}, root, STYLE);
    const views = element("div", { class: "views" }, root), controls = element("div", {}, root);
    let buttons = null;
    const loops = new Set();
    return {
      root, views, controls,
      // A labelled range. write(value) -> words; change(value) is called while it moves.
      range(label, { min, max, step, value }, write, change) {
        const row = element("div", { class: "setting" }, controls), text = element("label", {}, row, label);
        const input = element("input", { type: "range", min, max, step }, row), output = element("output", {}, row);
        text.append(" ");
        input.id = `toy-${Math.random().toString(36).slice(2)}`;
        text.htmlFor = input.id;
        const show = () => {
          output.textContent = write(Number(input.value));
          input.setAttribute("aria-valuetext", output.textContent);
        };
        input.value = value;
        input.addEventListener("input", () => { change(Number(input.value)); show(); }); // words may follow from the change
        // JupyterLab's own keys (arrows between cells) are not for who moves a range.
        input.addEventListener("keydown", (event) => event.stopPropagation());
        show();
        return { input, row, set: (x) => { input.value = x; show(); }, get: () => Number(input.value) };
      },
      button(label, press) {
        buttons = buttons || element("div", { class: "buttons" }, controls);
        const made = element("button", { type: "button" }, buttons, label);
        made.addEventListener("click", () => press(made));
        made.addEventListener("keydown", (event) => event.stopPropagation());
        return made;
      },
      tick(label, checked, change) {
        buttons = buttons || element("div", { class: "buttons" }, controls);
        const text = element("label", {}, buttons), input = element("input", { type: "checkbox" }, text);
        input.checked = checked;
        text.append(` ${label}`);
        input.addEventListener("change", () => change(input.checked));
        return input;
      },
      newRow() { buttons = null; },
      numbers: () => element("pre", { "aria-live": "off" }, controls),
      words: () => element("p", { role: "status" }, controls),
      // Call step once a frame until it returns false; for those who prefer less motion all at once, without pictures.
      run(step, draw) {
        if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
          for (let k = 0; k < 2000 && step(); k++);
          draw();
          return () => {};
        }
        const loop = { on: true };
        loops.add(loop);
        const frame = () => {
          if (!loop.on) return;
          const more = step();
          draw();
          if (more) requestAnimationFrame(frame);
          else loop.on = false;
        };
        requestAnimationFrame(frame);
        return () => (loop.on = false);
      },
      end() { loops.forEach((loop) => (loop.on = false)); root.remove(); },
    };
  }

  // A square of the plane, y upwards, with a grid and its axes' numbers. Returns drawing and handles.
  function plane(parent, { half, centre = [0, 0], step = 1, unit = "m", label, height = 1 }) {
    const [cx, cy] = centre, high = half * height;
    const svg = shape("svg", { viewBox: `${cx - half} ${-cy - high} ${2 * half} ${2 * high}`, role: "group", "aria-label": label }, parent);
    const up = shape("g", { transform: "scale(1,-1)" }, svg), grid = shape("g", { class: "grid", stroke: COLOURS.grid, "stroke-width": half * 0.004 }, up);
    const texts = shape("g", { "font-size": half * 0.062, fill: "#555555", "aria-hidden": "true" }, svg);
    for (let t = Math.ceil((cx - half) / step) * step; t <= cx + half + 1e-9; t += step) {
      shape("path", { d: `M${t},${cy - high}V${cy + high}` }, grid);
      if (t - cx > -0.9 * half && t - cx < 0.8 * half) shape("text", { x: t, y: -cy + high - half * 0.02, "text-anchor": "middle" }, texts, number(t, step < 1 ? 1 : 0));
    }
    for (let t = Math.ceil((cy - high) / step) * step; t <= cy + high + 1e-9; t += step) {
      shape("path", { d: `M${cx - half},${t}H${cx + half}` }, grid);
      if (Math.abs(t - cy) < 0.88 * high) shape("text", { x: cx - half + half * 0.015, y: -t + half * 0.02 }, texts, number(t, step < 1 ? 1 : 0));
    }
    shape("text", { x: cx + half * 0.98, y: -cy + high - half * 0.02, "text-anchor": "end" }, texts, `x (${unit})`);
    shape("text", { x: cx - half + half * 0.015, y: -cy - high + half * 0.07 }, texts, `y (${unit})`);
    const path = (points, closed) => points.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(5)},${y.toFixed(5)}`).join("") + (closed ? "Z" : "");
    const look = (colour, width = 1, extra = {}) => ({ fill: "none", stroke: colour, "stroke-width": width * half * 0.012, "stroke-linecap": "round", "stroke-linejoin": "round", ...extra });
    const where = (event) => {
      const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(up.getScreenCTM().inverse());
      return [p.x, p.y];
    };
    return {
      svg, up, half, where,
      line(colour, width, extra) {
        const made = shape("path", look(colour, width, extra), up);
        return { node: made, set: (points, closed) => made.setAttribute("d", points.length ? path(points, closed) : "") };
      },
      dot(colour, radius = 1, extra = {}) {
        const made = shape("circle", { r: radius * half * 0.02, fill: colour, ...extra }, up);
        return { node: made, set: (p) => p ? set(made, { cx: p[0], cy: p[1], visibility: "visible" }) : made.setAttribute("visibility", "hidden") };
      },
      text(colour, size = 1) {
        const made = shape("text", { fill: colour, "font-size": size * half * 0.075, "text-anchor": "middle", style: "paint-order:stroke;stroke:var(--stage);stroke-width:" + half * 0.02 }, svg);
        return { node: made, set: (p, words) => { if (p) set(made, { x: p[0], y: -p[1] }); made.textContent = words; } };
      },
      // Something to take by the hand: drag it, or focus it and use the arrow keys (with Shift: larger steps).
      // `turned(d)`, if given, is called by the keys [ and ] and by its own small handle.
      handle({ name, colour, radius = 2.4, stride = half / 60, moved, describe, keys = {} }) {
        const group = shape("g", { class: "handle", tabindex: 0, role: "application", "aria-roledescription": "handle", "aria-label": name }, up);
        shape("circle", { class: "ring", r: (radius + 1.6) * half * 0.02, fill: "none", stroke: "#0b5fff", "stroke-width": half * 0.015 }, group);
        shape("circle", { r: Math.max(radius * 1.8, 4.5) * half * 0.02, fill: colour, "fill-opacity": 0.12 }, group); // wide enough for a thumb
        shape("circle", { r: radius * half * 0.02, fill: "#ffffff", stroke: colour, "stroke-width": half * 0.014 }, group);
        let at = [0, 0], grip = null;
        const clamp = ([x, y]) => [Math.min(cx + half, Math.max(cx - half, x)), Math.min(cy + high, Math.max(cy - high, y))];
        const say = () => group.setAttribute("aria-label", `${name}: ${describe ? describe() : at.map((x) => number(x)).join(", ")}`);
        const go = (p) => { moved(clamp(p)); say(); };
        group.addEventListener("pointerdown", (event) => {
          group.setPointerCapture(event.pointerId);
          const p = where(event);
          grip = [at[0] - p[0], at[1] - p[1]];
          event.preventDefault();
          group.focus({ preventScroll: true });
        });
        group.addEventListener("pointermove", (event) => { if (grip) go(K.add(where(event), grip)); });
        ["pointerup", "pointercancel"].forEach((kind) => group.addEventListener(kind, () => (grip = null)));
        group.addEventListener("keydown", (event) => {
          const d = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
          if (d) go(K.add(at, d, (event.shiftKey ? 5 : 1) * stride));
          else if (keys[event.key]) { keys[event.key](); say(); }
          else return;
          event.preventDefault();
          event.stopPropagation();
        });
        return { node: group, set: (p) => { at = p; set(group, { transform: `translate(${p[0]} ${p[1]})` }); say(); } };
      },
    };
  }

  // ---- space ----

  const rgb = (colour) => [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));
  const LIGHT = K.unit([0.45, -0.55, 0.85]);

  // A view of space on a canvas: faces are sorted from far to near, which is enough for robots and rings, needs no
  // graphics card and none of the few WebGL contexts of a page. Drag it or use the arrow keys to look from elsewhere.
  function space(parent, { radius, centre = [0, 0, 0], azimuth = -0.9, elevation = 0.35, label, meta, shape: proportion = 0.8, redraw }) {
    const canvas = element("canvas", { tabindex: 0, role: "img", "aria-label": `${label.replace(/\.$/, "")}. Arrow keys look from another side.`, style: "touch-action:pan-y;cursor:move" }, parent);
    const view = meta.view || (meta.view = { azimuth, elevation });
    const context = canvas.getContext("2d");
    let items = [], eyeX, eyeY, eyeZ, size = 300, tall = 240;
    function aim() {
      const { azimuth: a, elevation: b } = view;
      eyeZ = [Math.cos(b) * Math.cos(a), Math.cos(b) * Math.sin(a), Math.sin(b)]; // towards the eye
      eyeX = [-Math.sin(a), Math.cos(a), 0];
      eyeY = K.cross(eyeZ, eyeX);
    }
    const FAR = 5; // the eye's distance in radii
    function project(p) {
      const x = p[0] - centre[0], y = p[1] - centre[1], w = p[2] - centre[2];
      const z = x * eyeZ[0] + y * eyeZ[1] + w * eyeZ[2], s = (0.49 * Math.min(size, tall) * FAR) / (FAR * radius - z);
      return [size / 2 + s * (x * eyeX[0] + y * eyeX[1]), tall / 2 - s * (x * eyeY[0] + y * eyeY[1] + w * eyeY[2]), z];
    }
    const put = (depth, paint) => items.push([depth, paint]);
    const api = {
      canvas, project, view,
      begin() {
        const box = canvas.clientWidth || 300, dense = Math.min(window.devicePixelRatio || 1, 2);
        size = box; tall = Math.round(box * proportion);
        canvas.style.height = `${tall}px`;
        if (canvas.width !== Math.round(box * dense)) { canvas.width = Math.round(box * dense); canvas.height = Math.round(tall * dense); }
        context.setTransform(dense, 0, 0, dense, 0, 0);
        context.clearRect(0, 0, size, tall);
        items = [];
        aim();
      },
      // Faces of a mesh {vertices, faces, colours (index of the palette for each face), bodies (of each vertex)}.
      mesh(mesh, poses, palette, opacity = 1) {
        const rows = poses.map((T) => T.slice(0, 3).flat()), tints = palette.map((colour) => rgb(tint(colour))), n = mesh.vertices.length;
        const at = new Array(n), flat = new Array(n);
        for (let i = 0; i < n; i++) { // written out: this is where the time goes
          const T = rows[mesh.bodies[i]], [x, y, z] = mesh.vertices[i];
          at[i] = [T[0] * x + T[1] * y + T[2] * z + T[3], T[4] * x + T[5] * y + T[6] * z + T[7], T[8] * x + T[9] * y + T[10] * z + T[11]];
          flat[i] = project(at[i]);
        }
        mesh.faces.forEach(([a, b, c], k) => {
          const A = flat[a], B = flat[b], C = flat[c];
          if ((B[0] - A[0]) * (C[1] - A[1]) - (B[1] - A[1]) * (C[0] - A[0]) >= 0) return; // seen from behind; y points down
          const [px, py, pz] = at[a], ux = at[b][0] - px, uy = at[b][1] - py, uz = at[b][2] - pz;
          const vx = at[c][0] - px, vy = at[c][1] - py, vz = at[c][2] - pz;
          const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx, m = Math.sqrt(nx * nx + ny * ny + nz * nz) || 1;
          const lit = Math.max(0, nx * LIGHT[0] + ny * LIGHT[1] + nz * LIGHT[2]), front = Math.max(0, nx * eyeZ[0] + ny * eyeZ[1] + nz * eyeZ[2]);
          const bright = 0.5 + (0.5 * lit + 0.08 * front) / m, [red, green, blue] = tints[mesh.colours[k]];
          put((A[2] + B[2] + C[2]) / 3, () => {
            context.globalAlpha = opacity;
            context.fillStyle = context.strokeStyle = `rgb(${Math.min(255, bright * red) | 0},${Math.min(255, bright * green) | 0},${Math.min(255, bright * blue) | 0})`;
            context.beginPath();
            context.moveTo(A[0], A[1]); context.lineTo(B[0], B[1]); context.lineTo(C[0], C[1]);
            context.closePath(); context.fill();
            if (opacity === 1) { context.lineWidth = 0.8; context.stroke(); } // closes the seams between faces
            context.globalAlpha = 1;
          });
        });
      },
      // A line through points, piece by piece, so that each piece hides behind what is before it.
      line(points, colour, width = 2, { dash = [], above = false } = {}) {
        const flat = points.map(project), shown = tint(colour);
        for (let i = 0; i + 1 < flat.length; i++) {
          const [A, B] = [flat[i], flat[i + 1]];
          put(above ? 1e9 : (A[2] + B[2]) / 2 + 0.001, () => {
            context.strokeStyle = shown; context.lineWidth = width; context.lineCap = "round"; context.setLineDash(dash);
            context.beginPath(); context.moveTo(A[0], A[1]); context.lineTo(B[0], B[1]); context.stroke(); context.setLineDash([]);
          });
        }
      },
      arrow(from, to, colour, width = 3, options) {
        const A = project(from), B = project(to), d = [B[0] - A[0], B[1] - A[1]], l = Math.hypot(...d), head = Math.min(11, l / 2);
        api.line([from, K.add(from, K.add(to, from, -1), l > head ? 1 - (0.8 * head) / l : 0.5)], colour, width, options);
        if (l < 2) return;
        const u = [d[0] / l, d[1] / l];
        put(options && options.above ? 1e9 : B[2] + 0.002, () => {
          context.fillStyle = tint(colour);
          context.beginPath();
          context.moveTo(B[0], B[1]);
          context.lineTo(B[0] - head * u[0] - 0.42 * head * u[1], B[1] - head * u[1] + 0.42 * head * u[0]);
          context.lineTo(B[0] - head * u[0] + 0.42 * head * u[1], B[1] - head * u[1] - 0.42 * head * u[0]);
          context.closePath(); context.fill();
        });
      },
      frame(T, length, { names = "", width = 3, above = true } = {}) {
        const p = K.positionOf(T);
        [COLOURS.red, COLOURS.green, COLOURS.blue].forEach((colour, k) => {
          const e = T.slice(0, 3).map((row) => row[k]);
          api.arrow(p, K.add(p, e, length), colour, width, { above });
        });
        if (names) api.text(K.add(p, [0, 0, -0.25 * length]), names, COLOURS.black);
      },
      text(p, words, colour = COLOURS.black, align = "center") {
        const A = project(p);
        put(2e9, () => {
          context.font = "600 13px system-ui, sans-serif"; context.textAlign = align;
          context.lineWidth = 3; context.strokeStyle = tint(COLOURS.ground); context.strokeText(words, A[0], A[1] + 4);
          context.fillStyle = wordTint(colour); context.fillText(words, A[0], A[1] + 4);
        });
      },
      floor(z, half, step) {
        for (let t = -half; t <= half + 1e-9; t += step) {
          const e = Math.sqrt(Math.max(0, half * half - t * t));
          [[[t, -e], [t, e]], [[-e, t], [e, t]]].forEach(([a, b]) => {
            const A = project([...a, z]), B = project([...b, z]);
            put(-1e9, () => { context.strokeStyle = "rgba(125,138,150,0.4)"; context.lineWidth = 1; context.beginPath(); context.moveTo(A[0], A[1]); context.lineTo(B[0], B[1]); context.stroke(); });
          });
        }
      },
      shadow(points, radius0) {
        points.forEach(([x, y, z]) => {
          const A = project([x, y, 0]), B = project(K.add([x, y, 0], eyeX, radius0 * (1 + 0.6 * z))), r = Math.max(2, B[0] - A[0]);
          put(-5e8, () => {
            context.save(); context.translate(A[0], A[1]); context.scale(1, Math.max(0.15, Math.sin(view.elevation)));
            const fade = context.createRadialGradient(0, 0, 0, 0, 0, r);
            const [shade, depth] = isDark() ? ["0,0,0", 0.5] : ["60,70,80", 0.16];
            fade.addColorStop(0, `rgba(${shade},${depth})`); fade.addColorStop(1, `rgba(${shade},0)`);
            context.fillStyle = fade; context.beginPath(); context.arc(0, 0, r, 0, 7); context.fill(); context.restore();
          });
        });
      },
      end() { items.sort((a, b) => a[0] - b[0]).forEach(([, paint]) => paint()); },
    };
    let last = null;
    const look = (da, de) => { view.azimuth += da; view.elevation = Math.min(1.5, Math.max(-0.3, view.elevation + de)); redraw(); };
    canvas.addEventListener("pointerdown", (event) => { last = [event.clientX, event.clientY]; canvas.setPointerCapture(event.pointerId); });
    canvas.addEventListener("pointermove", (event) => {
      if (!last) return;
      look(-0.01 * (event.clientX - last[0]), 0.01 * (event.clientY - last[1]));
      last = [event.clientX, event.clientY];
    });
    ["pointerup", "pointercancel"].forEach((kind) => canvas.addEventListener(kind, () => (last = null)));
    canvas.addEventListener("keydown", (event) => {
      const d = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
      if (!d) return;
      look(...d);
      event.preventDefault();
      event.stopPropagation();
    });
    const watch = new ResizeObserver(() => redraw());
    watch.observe(parent);
    api.stop = () => watch.disconnect();
    return api;
  }

  globalThis.course.parts = { COLOURS, tint, onTheme, element, shape, set, degrees, number, signed, table, card, plane, space };
})();
