// What all toys are made of: a card with rows of controls, and two kinds of stage to draw on, a plane and space, with
// words as HTML and handles that are dragged, or moved by the arrow keys. It is independent of the single toys.
globalThis.course.parts = (() => {
  "use strict";
  const M = globalThis.course.motion,
    S = globalThis.course.scene;
  // Toys name the colours of the light theme. IN_DARK has those of the dark theme, and AS_WORDS darker ones for words in
  // the light theme: lines have a contrast of at least 3 with the background, and words one of 4.5.
  const COLOURS = {
    blue: "#0072b2",
    orange: "#b87a00",
    green: "#009e73",
    purple: "#9b4f7f",
    red: "#d55e00",
    grey: "#6b7177",
    black: "#222222",
    crimson: "#b2182b",
    steel: "#7f8891",
    link: "#d96a12",
    ground: "#f7f8fa",
    grid: "#dde1e6",
    dark: "#2f3338",
    pale: "#56b4e9",
    floor: "#e9ecef",
    lines: "#c9ced4",
    shade: "#1a1f26",
  };
  const IN_DARK = {
    "#0072b2": "#56a8de",
    "#b87a00": "#e69f00",
    "#009e73": "#33c79c",
    "#9b4f7f": "#d08ab5",
    "#d55e00": "#f0863a",
    "#6b7177": "#b3bac1",
    "#222222": "#e7eaee",
    "#b2182b": "#f2667a",
    "#7f8891": "#8d959e",
    "#d96a12": "#f07818",
    "#f7f8fa": "#14171b",
    "#dde1e6": "#2a3037",
    "#2f3338": "#69727c",
    "#5b6168": "#7d858e",
    "#e4e7ea": "#4a535d",
    "#2166ac": "#4393d0",
    "#b01a2a": "#d6404f",
    "#e9ecef": "#2a3037",
    "#c9ced4": "#414a54",
    "#1a1f26": "#000000",
    "#7a1fa2": "#cf9ae6",
  };
  const AS_WORDS = { "#009e73": "#007a59", "#b87a00": "#8a5f00", "#d55e00": "#b84f00" };
  const isDark = () =>
    document.documentElement.dataset.theme === "dark" ||
    document.body.dataset.jpThemeLight === "false";
  const tint = (colour) => (isDark() && IN_DARK[colour.toLowerCase()]) || colour;
  const wordTint = (colour) => (!isDark() && AS_WORDS[colour.toLowerCase()]) || tint(colour);

  // Call change when the page (data-theme) or JupyterLab changes to its other theme; returns what ends that.
  function onTheme(change) {
    let before = isDark();
    const watch = new MutationObserver(() => {
      if (isDark() === before) return;
      before = isDark();
      change();
    });
    watch.observe(document.documentElement, { attributeFilter: ["data-theme"] });
    watch.observe(document.body, { attributeFilter: ["data-jp-theme-light"] });
    return () => watch.disconnect();
  }

  const STYLE = `.course-toy{--ground:#fff;--ink:#222;--edge:#555;--button:#f2f2f2;--pressed:#d9e8f3;
--numbers:#f2f4f6;color-scheme:light;box-sizing:border-box;max-width:760px;margin:0 auto;padding:.75rem;
background:var(--ground);color:var(--ink);font:14px/1.45 system-ui,sans-serif;border-radius:.25rem}
.course-stage,.course-toy{--stage:#f7f8fa;--focus:#0b5fff}
:is([data-theme=dark],[data-jp-theme-light=false]) .course-toy{--ground:#1b1f24;--ink:#e7eaee;--edge:#a3abb3;
--button:#39414a;--pressed:#1f4a66;--numbers:#14171b;color-scheme:dark}
:is([data-theme=dark],[data-jp-theme-light=false]) :is(.course-stage,.course-toy){--stage:#14171b;--focus:#6ea8ff}
.course-toy *,.course-stage *{box-sizing:border-box}
.course-toy .views{display:flex;flex-wrap:wrap;gap:.75rem}
.course-toy .views>*{flex:1 1 300px;min-width:0;max-width:100%}.course-toy .views>.half{flex-basis:140px}
.course-stage{position:relative;overflow:hidden;border-radius:.25rem}
.course-stage canvas{display:block;width:100%;background:var(--stage)}
.course-stage .word{position:absolute;left:0;top:0;pointer-events:none;font:600 14px/18px system-ui,sans-serif;
white-space:nowrap;text-shadow:0 0 3px var(--stage),0 0 3px var(--stage),0 0 2px var(--stage)}
.course-stage .handle{position:absolute;left:-22px;top:-22px;width:44px;height:44px;border-radius:50%;cursor:grab;
touch-action:none;outline:none;background:radial-gradient(var(--stage) 6px,var(--colour) 6.5px 9px,transparent 9.5px)}
.course-stage .handle.small{background:radial-gradient(var(--stage) 4px,var(--colour) 4.5px 6.5px,transparent 7px)}
.course-stage .handle:focus-visible{box-shadow:inset 0 0 0 3px var(--focus)}
.course-toy .controls{margin-top:.4rem}.course-toy summary{cursor:pointer;margin-top:.3rem}
.course-toy .settings{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(200px,45%),1fr));gap:.2rem 1.2rem}
.course-toy .setting{display:flex;flex-wrap:wrap;gap:0 .5rem;font-size:13px;align-content:end}
.course-toy .setting label{flex:1}.course-toy .setting input{flex:0 0 100%;min-width:0;margin:0;order:3}
.course-toy .setting output{font-variant-numeric:tabular-nums;white-space:nowrap;align-self:end}
.course-toy .buttons{display:flex;flex-wrap:wrap;gap:.4rem .8rem;margin-top:.4rem;align-items:center}
.course-toy button{font:inherit;padding:.2rem .7rem;border:1px solid var(--edge);border-radius:.25rem;
background:var(--button);color:inherit}
.course-toy .numbers{display:flex;flex-wrap:wrap;gap:.2rem 1.2rem;align-items:center;margin:.4rem 0 0;
padding:.3rem .7rem;font-size:13px;background:var(--numbers);border-radius:.25rem;font-variant-numeric:tabular-nums}
.course-toy .numbers>div{display:flex;flex-wrap:wrap;align-items:center;gap:.2rem .5rem;white-space:pre-line}
.course-toy .matrix{display:inline-grid;gap:0 .7em;padding:.1em .5em;text-align:right;border:solid var(--ink);
border-width:0 1.5px;border-radius:.6em;font:13px/1.45 system-ui,sans-serif}
.course-toy .matrix .chosen{background:var(--pressed);box-shadow:0 0 0 .2em var(--pressed)}
.course-toy .dim{opacity:.72}.course-toy mark{background:var(--pressed);color:inherit;padding:0 .15em}
.course-toy p{margin:.4rem 0 0}.course-toy :focus-visible,.course-stage canvas:focus-visible{
outline:3px solid var(--focus);outline-offset:-3px}
.course-toy .charts{display:flex;flex-direction:column;gap:.5rem}.course-toy .charts>*{flex:1;min-width:0}
@media(max-width:480px){.course-toy .setting input{min-height:1.6rem}.course-toy{padding:.5rem}
.course-toy .charts{flex-direction:row}.course-toy .numbers{padding:.3rem .4rem}.course-toy .matrix{font-size:12px;gap:0 .45em}}
@media(max-width:360px){.course-toy .matrix{font-size:11px;gap:0 .3em;padding:.1em .3em}}
@media print{.course-toy .controls{display:none}}`;

  function element(name, attributes, parent, text) {
    const made = document.createElement(name);
    Object.entries(attributes || {}).forEach(([key, value]) => made.setAttribute(key, value));
    if (text !== undefined) made.textContent = text;
    if (parent) parent.append(made);
    return made;
  }
  const rad = Math.PI / 180;
  const number = (x, digits = 2) =>
    x
      .toFixed(digits)
      .replace(/^-(0(\.0+)?)$/, "$1")
      .replace("-", "\u2212");
  // With a subscript: sub("q", 2). A power of ten: power(2e-7).
  const sub = (letter, index) =>
    letter + String(index).replace(/\d/g, (digit) => "₀₁₂₃₄₅₆₇₈₉"[digit]);
  function power(x) {
    const [digits, exponent] = x.toExponential(0).split("e");
    return `${digits}·10${exponent.replace("-", "⁻").replace(/[+\d]/g, (d) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[d] || "")}`;
  }
  const list = (values, digits) => values.map((x) => number(x, digits)).join(", ");
  const metres = (p) => `${list(p)} m`;
  const degrees = (angle, digits = 0) => `${number(angle / rad, digits)}°`;
  const inDegrees = (x) => `${number(x, 0)}°`; // of an angle in degrees
  const percent = (share) => `${Math.round(100 * share)} %`;
  const escape = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
  // HTML of a matrix, in which a column may be highlighted.
  function matrix(rows, { digits = 3, highlighted = -1 } = {}) {
    const words = rows.map((row) => row.map((x) => number(x, digits)));
    const cell = (x, j) => `<span${j === highlighted ? " class=chosen" : ""}>${x}</span>`;
    const cells = words.map((row) => row.map(cell).join(""));
    const look = `grid-template-columns:repeat(${rows[0].length},auto)`,
      spoken = words.map((row) => row.join(" "));
    return `<span class="matrix" role="img" aria-label="${spoken.join("; ")}" style="${look}">${cells.join("")}</span>`;
  }

  // A toy: course.kinds["toy:<name>"] starts it. build(card, meta, kernel) lays it out and returns the function that
  // paints it, which is called again after every change of a control or a handle. title may depend on meta.
  const toy = (name, title, build) =>
    (globalThis.course.kinds[`toy:${name}`] = (host, meta, kernel) => {
      const draw = once(() => made.fit(paint));
      const made = card(host, meta, typeof title === "function" ? title(meta) : title, draw);
      const paint = build(made, meta, kernel);
      made.fit(paint);
      return made.end;
    });

  const HIGHEST = 638,
    LOWEST = 130; // pixels: of a card, and of a stage in it
  // The card of a toy: views beside each other, controls below, then what it says in words. The views become less high
  // until all of it is in one window.
  function card(host, meta, title, draw) {
    useStyle();
    const root = element("div", { class: "course-toy", role: "group", "aria-label": title }, host);
    const views = element("div", { class: "views" }, root),
      controls = element("div", { class: "controls" }, root);
    const endings = [],
      stages = [],
      keep = (stage) => {
        endings.push(stage.stop);
        stages.push(stage);
        return stage;
      };
    let running = null,
      buttons = null,
      wide = 0,
      into = controls;
    const settings = () =>
      into.lastChild && into.lastChild.className === "settings"
        ? into.lastChild
        : element("div", { class: "settings" }, into);
    const inRow = () => (buttons = buttons || element("div", { class: "buttons" }, controls));
    const keepKeys = (input) =>
      input.addEventListener("keydown", (event) => event.stopPropagation()); // JupyterLab's
    const made = {
      views,
      controls,
      draw,
      fit(paint) {
        if (wide !== root.clientWidth) stages.forEach((stage) => (stage.share = 1));
        wide = root.clientWidth;
        paint();
        for (let k = 0; k < 3 && !stages.some(({ held }) => held); k++) {
          const over = root.offsetHeight - HIGHEST,
            high = views.offsetHeight,
            shares = stages.map((s) => s.share);
          if (over <= 0 || !high) break;
          stages.forEach(
            (stage) => (stage.share = Math.max(0.3, (stage.share * (high - over - 3)) / high)),
          );
          if (stages.every((stage, i) => stage.share === shares[i])) break;
          paint();
        }
      },
      // Ranges that `fill` makes are folded away.
      fold(label, fill) {
        const part = (into = element("details", {}, controls));
        element("summary", {}, part, label);
        fill();
        into = controls;
        keepKeys(part);
        part.addEventListener("toggle", () => {
          wide = 0;
          draw();
        });
      },
      // What the toy keeps while it is off the page.
      state: (initial) => meta.state || (meta.state = initial),
      // Returns a function that asks the kernel; its newest answer is `answer` of the state.
      asker(kernel) {
        const ask = asker(kernel, (answer) => {
          meta.state.answer = answer;
          draw();
        });
        return (question) => {
          meta.state.asked = Boolean(kernel);
          ask(question);
        };
      },
      plane: ({ parent = views, ...options }) => keep(plane(parent, { redraw: draw, ...options })),
      map: ({ parent = views, ...options }) => keep(map(parent, { redraw: draw, ...options })),
      space: ({ parent = views, ...options }) =>
        keep(space(parent, { redraw: draw, meta, ...options })),
      // Space around the arm that meta describes (arm_view in toys/arms.py), whose bodies are drawn at their poses.
      armSpace(azimuth = -1) {
        const { centre, elevation, size, title: label } = meta,
          solid = S.unpack(meta.solid);
        const view = made.space({ radius: 0.1 * size, centre, azimuth, elevation, label });
        return Object.assign(view, {
          arm(poses, { colour, ...look }) {
            view.mesh(solid, poses, colour ? solid.palette.map(() => colour) : solid.palette, look);
          },
          // For `look`: each link is dragged about its joint's axis; moved(joint, angle) is called, within the limits.
          joints: (q, poses, moved) => ({
            grip: (body) =>
              body && {
                name: () => `joint ${body}: ${degrees(q()[body - 1])}`,
                at: M.move(poses[body - 1], M.positionOf(meta.arm.home[body - 1])),
                axis: M.apply(M.rotationOf(poses[body - 1]), meta.arm.screws[body - 1].slice(0, 3)),
                angle: q()[body - 1],
                moved: (angle) => {
                  const [low, high] = meta.limits[body - 1];
                  moved(body - 1, Math.min(high, Math.max(low, angle)));
                },
              },
          }),
          // Go as far away as the arm and further points need, and draw the floor below it.
          stand(poses, also = []) {
            const few = solid.vertices.filter((_, i) => i % 9 === 0);
            view.contain([...also, ...few.map((v, i) => M.move(poses[solid.bodies[9 * i]], v))]);
            view.floor(meta.floor, meta.ground, size > 2 ? 0.5 : 0.2);
          },
        });
      },
      // A labelled range. write(value) -> words; change(value) is called while it moves. An arrow key moves it by a
      // step, or to the next multiple of `keys`.
      range(label, { value, keys, ...limits }, write, change) {
        const row = element("div", { class: "setting" }, settings()),
          text = element("label", {}, row, `${label} `);
        const input = element("input", { type: "range", ...limits }, row),
          output = element("output", {}, row);
        text.htmlFor = input.id = `toy-${Math.random().toString(36).slice(2)}`;
        const show = () => {
          output.textContent = write(Number(input.value));
          input.setAttribute("aria-valuetext", output.textContent);
        };
        input.value = value;
        input.addEventListener("input", () => {
          change(Number(input.value));
          show();
          draw();
        });
        keepKeys(input);
        if (keys)
          onKeys(input, (direction) => {
            if (!direction) return false;
            const [d] = direction.filter(Boolean),
              x = Number(input.value) / keys;
            input.value = keys * (d > 0 ? Math.floor(x + 1) : Math.ceil(x - 1));
            input.dispatchEvent(new Event("input"));
            return true;
          });
        show();
        return {
          input,
          set: (x) => {
            input.value = x;
            show();
          },
        };
      },
      // A range that sets state[key].
      setting: (label, state, key, limits, write) =>
        made.range(label, { value: state[key], ...limits }, write, (x) => (state[key] = x)),
      angle: (label, state, key, min, max) =>
        made.setting(label, state, key, { min, max, step: 1 }, inDegrees),
      share: (label, state, key) =>
        made.setting(label, state, key, { min: 0, max: 1, step: 0.01 }, percent),
      button(label, press) {
        const button = element("button", { type: "button" }, inRow(), label);
        button.addEventListener("click", () => {
          press();
          draw();
        });
        keepKeys(button);
        return button;
      },
      // A checkbox that sets state[key].
      checkbox(label, state, key) {
        const text = element("label", {}, inRow()),
          input = element("input", { type: "checkbox" }, text);
        input.checked = Boolean(state[key]);
        text.append(` ${label}`);
        input.addEventListener("change", () => {
          state[key] = input.checked;
          draw();
        });
        keepKeys(input);
      },
      // A field that shows lines: plain text, or lists of text and matrices (HTML of `matrix`).
      numbers() {
        const field = element("div", { class: "numbers" }, controls);
        const html = (part) => (part.startsWith("<") ? part : `<span>${escape(part)}</span>`);
        const row = (line) => `<div>${[line].flat().map(html).join("")}</div>`;
        return (...lines) => (field.innerHTML = lines.map(row).join(""));
      },
      words: () => element("p", { role: "status" }, controls),
      // Call step once a frame until it returns false or another run begins; with reduced motion all at once.
      run(step) {
        made.halt();
        if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
          for (let k = 0; k < 2000 && step(); k++);
          return draw();
        }
        const own = (running = {});
        const frame = () => {
          if (running !== own) return;
          if (step()) requestAnimationFrame(frame);
          draw();
        };
        requestAnimationFrame(frame);
      },
      halt: () => (running = null),
      // A button that moves a range from its beginning to its end, by a share of it in each frame.
      player(label, { input }, share) {
        made.button(label, () => {
          const [low, high] = [Number(input.min), Number(input.max)];
          let x = low;
          made.run(() => {
            input.value = x = Math.min(high, x + share * (high - low));
            input.dispatchEvent(new Event("input"));
            return x < high;
          });
        });
      },
      atEnd: (act) => endings.push(act),
      end() {
        made.halt();
        endings.forEach((act) => act());
        root.remove();
      },
    };
    return made;
  }
  const useStyle = () =>
    document.getElementById("course-toy-style") ||
    element("style", { id: "course-toy-style" }, document.head, STYLE);

  // Call draw at most once a frame.
  function once(draw) {
    let waiting = false;
    return () => {
      if (waiting) return;
      waiting = true;
      requestAnimationFrame(() => {
        waiting = false;
        draw();
      });
    };
  }

  // A function that asks the kernel: one question at a time, and of those that come meanwhile only the newest.
  function asker(kernel, onAnswer) {
    if (!kernel) return () => {};
    let busy = false,
      next = null;
    const ask = (question) => {
      if (busy) return void (next = question);
      busy = true;
      kernel.ask(question);
    };
    kernel.onAnswer((answer) => {
      busy = false;
      onAnswer(answer);
      const waiting = next;
      next = null;
      if (waiting) ask(waiting);
    });
    return ask;
  }

  // ---- a stage: a canvas with words and handles above it ----

  // Call act(direction of an arrow key, event) for each key; the page does not get those for which it returns true.
  const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  const onKeys = (node, act) =>
    node.addEventListener("keydown", (event) => {
      if (!act(ARROWS[event.key], event)) return;
      event.preventDefault();
      event.stopPropagation();
    });
  const onRelease = (node, act) =>
    ["pointerup", "pointercancel"].forEach((kind) => node.addEventListener(kind, act));

  const ASIDE = [
    [0, 0],
    [0, -1],
    [0, 1],
    [1, 0],
    [-1, 0],
    [1, -1],
    [-1, -1],
    [1, 1],
    [-1, 1],
    [0, -2],
    [0, 2],
  ];
  function stage(parent, { label, proportion, redraw, attributes = {} }) {
    useStyle();
    const box = element("div", { class: "course-stage" }, parent);
    const canvas = element(
      "canvas",
      { role: "img", "aria-label": label.replace(/\.$/, ""), ...attributes },
      box,
    );
    const context = canvas.getContext("2d"),
      pool = [],
      handles = [];
    let words = [];
    const made = {
      box,
      canvas,
      context,
      width: 300,
      height: 240,
      dense: 1,
      share: 1,
      begin() {
        made.dense = Math.min(window.devicePixelRatio || 1, 2);
        made.width = box.clientWidth || 300;
        const high = made.width * proportion;
        made.height = Math.round(Math.max(Math.min(high, LOWEST), made.share * high));
        canvas.style.height = `${made.height}px`;
        const size = [made.width, made.height].map((x) => Math.round(x * made.dense));
        if (canvas.width !== size[0] || canvas.height !== size[1])
          [canvas.width, canvas.height] = size;
        words = [];
      },
      // Words near a point (pixels), moved aside if they would cover others.
      word(at, text, colour = COLOURS.black) {
        words.push({ at, text, colour });
      },
      end() {
        const taken = [];
        words.forEach(({ at, text, colour }, i) => {
          const node =
            pool[i] || (pool[i] = element("span", { class: "word", "aria-hidden": "true" }, box));
          if (node.textContent !== text) node.textContent = text;
          const [w, h] = [node.offsetWidth || 8 * text.length, 18];
          const between = (low, x, high) => Math.min(high, Math.max(low, x));
          const covers = ([x, y]) =>
            taken.some((t) => Math.abs(t.x - x) < (t.w + w) / 2 && Math.abs(t.y - y) < h);
          const places = ASIDE.map(([dx, dy]) => [
            between(w / 2, at[0] + w * dx, made.width - w / 2),
            between(h / 2, at[1] + h * dy, made.height - h / 2),
          ]);
          const [x, y] = places.find((p) => !covers(p)) || places[0];
          taken.push({ x, y, w });
          node.style.transform = `translate(${x - w / 2}px,${y - h / 2}px)`;
          node.style.color = wordTint(colour);
        });
        pool.splice(words.length).forEach((node) => node.remove());
        handles.forEach((place) => place());
      },
      // A handle to drag, or to move by the arrow keys (Shift: larger steps). at() -> its position; moved(position) is
      // called with another, `stride` is a step of the keys; toPixels and fromPixels are the stage's.
      handle({ name, colour, small, at, moved, describe, stride }, toPixels, fromPixels, step) {
        const node = element(
          "div",
          {
            class: `handle${small ? " small" : ""}`,
            tabindex: 0,
            role: "application",
            "aria-roledescription": "handle",
          },
          box,
        );
        let grip = null;
        const place = () => {
          const [x, y] = toPixels(at());
          node.style.transform = `translate(${x}px,${y}px)`;
          node.style.setProperty("--colour", tint(colour));
          node.setAttribute("aria-label", `${name}: ${describe ? describe() : metres(at())}`);
        };
        const change = (position) => {
          moved(position);
          place();
          redraw();
        };
        const where = (event) => {
          const { left, top } = box.getBoundingClientRect();
          return [event.clientX - left, event.clientY - top];
        };
        node.addEventListener("pointerdown", (event) => {
          node.setPointerCapture(event.pointerId);
          made.held = true;
          grip = M.add(toPixels(at()).slice(0, 2), where(event), -1);
          node.focus({ preventScroll: true });
          event.preventDefault();
        });
        node.addEventListener("pointermove", (event) => {
          if (!grip) return;
          const [x, y] = M.add(where(event), grip);
          const inside = [
            Math.min(made.width, Math.max(0, x)),
            Math.min(made.height, Math.max(0, y)),
          ];
          change(fromPixels(inside, at()));
        });
        onRelease(node, () => {
          made.held = false;
          grip = null;
          redraw();
        });
        onKeys(node, (direction, { shiftKey }) => {
          if (direction) change(step(at(), M.scale(direction, (shiftKey ? 5 : 1) * stride)));
          return direction;
        });
        handles.push(place);
        return node;
      },
      stop() {
        watch.disconnect();
        box.remove();
      },
    };
    const watch = new ResizeObserver(
      () => box.isConnected && box.clientWidth !== made.width && redraw(),
    );
    watch.observe(box);
    return made;
  }

  // ---- the plane ----

  // A part of the plane, y upwards, with a grid: x and y are its ranges, ticks numbers or [number, words], names those
  // of the axes. With `margin` it is a chart, whose words stand outside.
  function plane(parent, { x, y, ticks, names, label, redraw, proportion, margin }) {
    let [[x0, x1], [y0, y1]] = [x, y],
      across,
      upwards;
    const [left, below] = margin ? [48, 38] : [0, 0],
      top = margin ? 8 : 0;
    const made = stage(parent, { label, redraw, proportion: proportion || (y1 - y0) / (x1 - x0) });
    const { context, begin, end, handle } = made;
    const named = (tick) =>
      Array.isArray(tick) ? tick : [tick, number(tick, Number.isInteger(tick) ? 0 : 1)];
    const isMap = typeof ticks === "function",
      stride = (x1 - x0) / 120;
    // A map has one scale in both directions, and fills what is left of its stage.
    function measure() {
      if (isMap) {
        const scale = Math.min(made.width / (x[1] - x[0]), made.height / (y[1] - y[0])),
          around = ([low, high], pixels) =>
            [-1, 1].map((s) => (low + high) / 2 + (s * pixels) / (2 * scale));
        [[x0, x1], [y0, y1]] = [around(x, made.width), around(y, made.height)];
      }
      [across, upwards] = (isMap ? [ticks(x0, x1), ticks(y0, y1)] : ticks).map((each) =>
        each.map(named),
      );
    }
    const wide = () => made.width - left - (margin ? 10 : 0),
      high = () => made.height - below - top;
    const toPixels = ([u, v]) => [
      left + (wide() * (u - x0)) / (x1 - x0),
      top + (high() * (y1 - v)) / (y1 - y0),
    ];
    const fromPixels = ([u, v]) => [
      x0 + ((u - left) / wide()) * (x1 - x0),
      y1 - ((v - top) / high()) * (y1 - y0),
    ];
    const write = (words, [u, v], align, bold = "") => {
      context.fillStyle = tint(COLOURS.grey);
      context.font = `${bold}12px system-ui,sans-serif`;
      context.textAlign = align;
      context.fillText(words, u, v);
    };
    return Object.assign(made, {
      begin() {
        begin();
        measure();
        context.setTransform(made.dense, 0, 0, made.dense, 0, 0);
        context.clearRect(0, 0, made.width, made.height);
        Object.assign(context, { lineCap: "round", lineJoin: "round" });
        across.forEach(([u, words]) => {
          made.line(
            [
              [u, y0],
              [u, y1],
            ],
            COLOURS.grid,
            1,
          );
          const at = toPixels([u, y0])[0];
          const isFree = margin || (at > 30 && at < made.width - 50);
          if (isFree) write(words, [at, made.height - (margin ? 22 : 5)], "center");
        });
        upwards.forEach(([v, words]) => {
          made.line(
            [
              [x0, v],
              [x1, v],
            ],
            COLOURS.grid,
            1,
          );
          const at = toPixels([x0, v])[1];
          const isFree = margin || (at > 30 && at < made.height - 20);
          if (isFree) write(words, [margin ? left - 6 : 5, at + 4], margin ? "right" : "left");
        });
        write(
          names[0],
          [margin ? left + wide() / 2 : made.width - 5, made.height - 5],
          margin ? "center" : "right",
        );
        write(
          names[1],
          margin ? [left + wide() - 4, top + 13] : [5, 15],
          margin ? "right" : "left",
          "600 ",
        );
        if (margin)
          made.line(
            [
              [x0, y1],
              [x0, y0],
              [x1, y0],
            ],
            COLOURS.grey,
            1,
          );
        context.save();
        context.beginPath();
        context.rect(left, 0, made.width, made.height - below);
        context.clip();
      },
      end() {
        context.restore();
        end();
      },
      // Width in pixels. fill: how opaque the area is that it encloses.
      line(points, colour, width = 2, { dash = [], closed, fill } = {}) {
        context.beginPath();
        points.forEach((p, i) => context[i ? "lineTo" : "moveTo"](...toPixels(p)));
        if (closed) context.closePath();
        Object.assign(context, {
          strokeStyle: tint(colour),
          fillStyle: tint(colour),
          lineWidth: width,
        });
        context.setLineDash(dash);
        if (width) context.stroke();
        context.globalAlpha = fill || 1;
        if (fill) context.fill();
        context.globalAlpha = 1;
      },
      dot(p, colour, radius = 4, { hollow } = {}) {
        context.beginPath();
        context.arc(...toPixels(p), radius, 0, 7);
        context.fillStyle = tint(hollow ? COLOURS.ground : colour);
        Object.assign(context, { strokeStyle: tint(colour), lineWidth: 2 });
        context.setLineDash([]);
        context.fill();
        if (hollow) context.stroke();
      },
      text: (p, words, colour) => made.word(toPixels(p), words, colour),
      fromPixels,
      // A round robot at a pose (x, y, theta), with a line to its front.
      robot([u, v, theta], radius, colour) {
        made.line(circle(radius, [u, v]), colour, 1.5, { closed: true, fill: 0.25 });
        made.line(
          [
            [u, v],
            [u + radius * Math.cos(theta), v + radius * Math.sin(theta)],
          ],
          colour,
          2,
        );
      },
      handle: (options) => handle({ stride, ...options }, toPixels, fromPixels, M.add),
    });
  }
  // A map in metres around a centre, with lines every `step`; it shows `half` to both sides, and up and down that
  // times the proportion.
  function map(parent, { half, centre = [0, 0], step = 1, proportion = 1, ...options }) {
    const ranges = centre.map((c, i) => [
      c - half * (i ? proportion : 1),
      c + half * (i ? proportion : 1),
    ]);
    const ticks = (low, high) =>
      Array.from(
        { length: Math.floor(high / step) - Math.ceil(low / step) + 1 },
        (_, i) => (Math.ceil(low / step) + i) * step,
      );
    return plane(parent, {
      x: ranges[0],
      y: ranges[1],
      ticks,
      names: ["x (m)", "y (m)"],
      ...options,
    });
  }
  const circle = (radius, [x, y] = [0, 0]) =>
    M.sampled(90, (s) => [
      x + radius * Math.cos(2 * Math.PI * s),
      y + radius * Math.sin(2 * Math.PI * s),
    ]);

  // ---- space ----

  // Space around a centre, as far as a radius. The view is kept in `meta`.
  function space(parent, options) {
    const {
      centre = [0, 0, 0],
      azimuth = -0.9,
      elevation = 0.35,
      label,
      meta,
      proportion = 0.75,
      redraw,
    } = options;
    if (!S.start()) throw Error("this browser draws nothing in space (no WebGL 2)");
    const keys = "Arrow keys look from another side, plus and minus come nearer and go farther.";
    const made = stage(parent, {
      label: `${label.replace(/\.$/, "")}. ${keys}`,
      proportion,
      redraw,
      attributes: { tabindex: 0, style: "touch-action:pan-y;cursor:move" },
    });
    const camera = meta.camera || (meta.camera = { azimuth, elevation, zoom: 1 });
    const FAR = 5; // the distance of the eye, in radii
    let { radius } = options,
      fitted = radius,
      right,
      up,
      eye,
      size,
      meshes,
      lines,
      floor;
    function aim() {
      const { azimuth: a, elevation: b } = camera;
      eye = [Math.cos(b) * Math.cos(a), Math.cos(b) * Math.sin(a), Math.sin(b)]; // the direction to it
      right = [-Math.sin(a), Math.cos(a), 0];
      up = M.cross(eye, right);
      radius = fitted / camera.zoom;
      size = 0.49 * Math.min(made.width, made.height) * FAR;
    }
    const away = (p) => FAR * radius - M.dot(M.add(p, centre, -1), eye);
    const toPixels = (p) => {
      const d = M.add(p, centre, -1),
        s = size / away(p);
      return [made.width / 2 + s * M.dot(d, right), made.height / 2 - s * M.dot(d, up)];
    };
    const fromPixels = ([x, y], p) => {
      // in the plane through p that faces the eye
      const [x0, y0] = toPixels(p),
        s = away(p) / size;
      return M.add(M.add(p, right, s * (x - x0)), up, -s * (y - y0));
    };
    function matrixOf() {
      const far = FAR * radius,
        [near, limit] = [0.3 * far, 4 * far],
        a = (limit + near) / (limit - near);
      const row = (e, s, rest = 0) => [...M.scale(e, s), rest - s * M.dot(e, centre)];
      const depth = row(eye, -1, far);
      return [
        row(right, (2 * size) / made.width),
        row(up, (2 * size) / made.height),
        depth.map((x, i) => a * x - (i === 3 ? (2 * limit * near) / (limit - near) : 0)),
        depth,
      ];
    }
    const { begin, end, handle, stop } = made,
      layerOf = (above) => (above ? "above" : "space");
    Object.assign(made, {
      begin() {
        begin();
        aim();
        [meshes, lines, floor] = [[], [], null];
      },
      // grip(body) -> {name, at, axis, angle, moved}: dragged, the body rotates about an axis, and moved(angle) is called.
      mesh(mesh, poses, palette, { opacity = 1, shadow = opacity === 1, above, least, grip } = {}) {
        const far = away(M.move(poses[poses.length - 1], mesh.vertices[0]));
        const tints = palette.map(tint);
        meshes.push({
          mesh,
          poses,
          palette: tints,
          opacity,
          shadow,
          least,
          far,
          layer: layerOf(above),
          grip,
        });
      },
      // A line through points, of a width in pixels; null interrupts it.
      line(points, colour, width = 2, { dash = [], above, layer = layerOf(above) } = {}) {
        const view = matrixOf(),
          ribbon = [];
        let far = 0;
        points.forEach((q, i) => {
          const p = points[i - 1];
          if (!p || !q) return void (far = 0);
          const [[ax, ay], [bx, by]] = [p, q].map(toPixels),
            l = Math.hypot(bx - ax, by - ay) || 1;
          const [za, zb] = [p, q].map((at) => {
            const at4 = [...at, 1];
            return M.dot(view[2], at4) / M.dot(view[3], at4) - 2e-4;
          });
          const [nx, ny] = [(-(by - ay) / l) * (width / 2), ((bx - ax) / l) * (width / 2)];
          const a = [
            [ax + nx, ay + ny, za, far],
            [ax - nx, ay - ny, za, far],
          ];
          far += l;
          const b = [
            [bx + nx, by + ny, zb, far],
            [bx - nx, by - ny, zb, far],
          ];
          ribbon.push(...a[0], ...a[1], ...b[0], ...b[0], ...a[1], ...b[1]);
        });
        lines.push({ ribbon, colour: tint(colour), dash, layer });
      },
      arrow(from, to, colour, { thick = 0.018 * fitted, ...look } = {}) {
        const d = M.add(to, from, -1),
          l = M.norm(d),
          z = M.scale(d, 1 / (l || 1)),
          head = Math.min(5 * thick, 0.5 * l);
        if (l < 1e-9) return;
        const x = M.unit(M.cross(Math.abs(z[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0], z)),
          y = M.cross(z, x);
        const part = (r, length, at) =>
          M.pose(M.transpose([M.scale(x, r), M.scale(y, r), M.scale(z, length)]), at);
        const poses = [part(thick, l - head, from), part(2.4 * thick, head, M.add(to, z, -head))];
        made.mesh(S.arrow, poses, [colour], { shadow: false, least: 0.75, ...look });
      },
      // The axes of a frame: orange (as the red of this palette looks), green and blue.
      frame(T, length, { thick, above = true } = {}) {
        const p = M.positionOf(T);
        [COLOURS.red, COLOURS.green, COLOURS.blue].forEach((colour, k) =>
          made.arrow(
            p,
            M.add(
              p,
              T.slice(0, 3).map((row) => row[k]),
              length,
            ),
            colour,
            { thick, above },
          ),
        );
      },
      ball: (p, r, colour, look) => made.mesh(BALL, [sized(r, p)], [colour], look),
      text: (p, words, colour, lift = 0) =>
        made.word(M.add(toPixels(p), [0, -lift]), words, colour),
      floor(half, height = 0, step = 0.2, [x, y] = [0, 0]) {
        const T = sized(half, [x, y, height]),
          palette = [tint(COLOURS.floor)];
        const shade = tint(COLOURS.shade),
          darkness = isDark() ? 0.5 : 0.2;
        floor = {
          mesh: S.disc,
          poses: [T],
          palette,
          opacity: 1,
          least: 1,
          height,
          shade,
          darkness,
        };
        const grid = [],
          n = Math.floor(half / step);
        for (let k = -n; k <= n; k++) {
          const t = k * step,
            e = Math.sqrt(Math.max(0, half * half - t * t));
          grid.push([x + t, y - e, height], [x + t, y + e, height], null);
          grid.push([x - e, y + t, height], [x + e, y + t, height], null);
        }
        made.line(grid, COLOURS.lines, 1, { layer: "floor" });
      },
      // Go as far away as is needed to have these points in the picture.
      contain(points) {
        if (made.held) return; // by a handle, below which nothing moves away
        const out = (p) => {
          const [x, y] = toPixels(p);
          return Math.max(Math.abs(x / made.width - 0.5), Math.abs(y / made.height - 0.5)) > 0.44;
        };
        for (let k = 0; k < 90 && points.some(out); k++, aim()) fitted *= 1.03;
      },
      end() {
        const { context, width, height, dense } = made,
          at = M.add(centre, eye, FAR * radius);
        if (made.held && made.held.name)
          made.word(M.add(made.held.pixel, [0, -24]), made.held.name());
        S.draw(
          context,
          { width, height, dense, view: matrixOf(), eye: at, floor, meshes, lines },
          redraw,
        );
        end();
      },
      handle: (options) =>
        handle({ stride: fitted / 60, ...options }, toPixels, fromPixels, (p, [dx, dy]) =>
          M.add(M.add(p, right, dx), up, dy),
        ),
      stop() {
        S.redraws.delete(redraw);
        stop();
      },
    });
    // The nearest body with a grip at a pixel, and what follows the pointer from there; null if there is none.
    function take(pixel) {
      let best = null;
      (meshes || [])
        .filter((each) => each.grip)
        .forEach(({ mesh, poses, grip }) => {
          const grips = poses.map((_, body) => grip(body)),
            { vertices, faces, bodies } = mesh;
          const seen = vertices.map((v, i) => grips[bodies[i]] && M.move(poses[bodies[i]], v));
          const flat = seen.map((p) => p && [...toPixels(p), away(p)]);
          faces.forEach(([a, b, c]) => {
            if (!flat[a]) return;
            const [A, B, C] = [flat[a], flat[b], flat[c]],
              side = ([ux, uy], [vx, vy]) =>
                (vx - ux) * (pixel[1] - uy) - (vy - uy) * (pixel[0] - ux);
            const areas = [side(B, C), side(C, A), side(A, B)],
              whole = areas[0] + areas[1] + areas[2];
            if (whole >= 0 || areas.some((area) => area > 0)) return; // it faces away, or is elsewhere
            const shares = M.scale(areas, 1 / whole),
              far = shares[0] * A[2] + shares[1] * B[2] + shares[2] * C[2];
            if (best && far >= best.far) return;
            best = {
              far,
              grip: grips[bodies[a]],
              point: M.apply(M.transpose([seen[a], seen[b], seen[c]]), shares),
            };
          });
        });
      return best && { ...best.grip, pixel, follow: follower(best.grip, best.point, pixel) };
    }
    // pixel -> the angle about the axis that brings a point there, or that many pixels across an axis seen from the side.
    function follower({ at, axis, angle }, point, from) {
      const foot = M.add(at, axis, M.dot(M.add(point, at, -1), axis)),
        arm = M.add(point, foot, -1);
      const place = M.add(centre, eye, FAR * radius),
        towards = M.unit(M.add(place, point, -1));
      if (Math.abs(M.dot(axis, towards)) < 0.4 || M.norm(arm) < 0.01 * radius) {
        const d = M.unit(
          M.add(toPixels(M.add(point, M.cross(axis, towards), 1e-3 * radius)), toPixels(point), -1),
        );
        const lever = Math.max(80, (M.norm(arm) * size) / away(point));
        return (pixel) => angle + M.dot(M.add(pixel, from, -1), d) / lever;
      }
      let rotated = 0;
      return (pixel) => {
        const ray = M.add(fromPixels(pixel, point), place, -1);
        const hit = M.add(
          M.add(place, ray, M.dot(M.add(foot, place, -1), axis) / M.dot(ray, axis)),
          foot,
          -1,
        );
        rotated += M.wrap(M.angleAbout(axis, arm, hit) - rotated);
        return angle + rotated;
      };
    }
    S.redraws.add(redraw);
    moveCamera(made, camera, take, redraw);
    aim();
    return made;
  }
  const BALL = S.ball(),
    sized = (r, p) =>
      M.pose(
        [
          [r, 0, 0],
          [0, r, 0],
          [0, 0, r],
        ],
        p,
      );

  // Change the view by dragging, by the arrow keys, by two fingers, and by the wheel once the figure has the focus. A
  // body that can be taken is dragged instead.
  function moveCamera(made, camera, take, redraw) {
    const fingers = new Map(),
      { canvas } = made,
      where = ({ clientX, clientY }) => {
        const { left, top } = canvas.getBoundingClientRect();
        return [clientX - left, clientY - top];
      };
    // What is taken at the pointer, or for a finger a few pixels beside it.
    const near = (event, far) =>
      [
        [0, 0],
        [far, 0],
        [-far, 0],
        [0, far],
        [0, -far],
      ]
        .slice(0, far ? 5 : 1)
        .reduce((found, beside) => found || take(M.add(where(event), beside)), null);
    const rotate = (da, de) => {
      camera.azimuth += da;
      camera.elevation = Math.min(1.5, Math.max(-0.3, camera.elevation + de));
      redraw();
    };
    const zoom = (factor) => {
      camera.zoom = Math.min(6, Math.max(0.4, camera.zoom * factor));
      redraw();
    };
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      if (!fingers.size && !made.held)
        made.held = near(event, event.pointerType === "touch" ? 14 : 0);
      if (!made.held) fingers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    // A finger on a body scrolls no page.
    canvas.addEventListener(
      "touchstart",
      (event) => {
        if (near(event.touches[0], 14)) event.preventDefault();
      },
      { passive: false },
    );
    let over = null;
    const point = once(() => (canvas.style.cursor = over && take(over) ? "grab" : "move"));
    canvas.addEventListener("pointermove", (event) => {
      if (made.held) {
        made.held.pixel = where(event);
        made.held.moved(made.held.follow(made.held.pixel));
        return redraw();
      }
      if (!fingers.size && event.pointerType === "mouse") {
        over = where(event);
        point();
      }
      const before = fingers.get(event.pointerId),
        now = [event.clientX, event.clientY];
      if (!before) return;
      const other = [...fingers].find(([id]) => id !== event.pointerId);
      if (other)
        zoom(M.norm(M.add(now, other[1], -1)) / (M.norm(M.add(before, other[1], -1)) || 1));
      else rotate(-0.01 * (now[0] - before[0]), 0.01 * (now[1] - before[1]));
      fingers.set(event.pointerId, now);
    });
    onRelease(canvas, (event) => {
      fingers.delete(event.pointerId);
      if (made.held) redraw();
      made.held = null;
    });
    canvas.addEventListener(
      "wheel",
      (event) => {
        if (document.activeElement !== canvas) return; // the page scrolls
        event.preventDefault();
        zoom(Math.exp(-0.002 * event.deltaY));
      },
      { passive: false },
    );
    onKeys(canvas, (direction, { key }) => {
      const factor = { "+": 1.1, "=": 1.1, "-": 1 / 1.1 }[key];
      if (direction) rotate(...M.scale(direction, 0.1));
      else if (factor) zoom(factor);
      return direction || factor;
    });
  }

  return {
    COLOURS,
    tint,
    wordTint,
    onTheme,
    element,
    rad,
    number,
    list,
    metres,
    degrees,
    percent,
    matrix,
    toy,
    onKeys,
    onRelease,
    once,
    circle,
    space,
    sub,
    power,
    inDegrees,
  };
})();
