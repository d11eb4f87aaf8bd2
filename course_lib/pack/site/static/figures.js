// Draws the figures whose data stand in the page, each when it comes near the window. A browser holds
// only some 3D figures at a time (16 on a desktop, 8 on a phone), so those far away are removed.
//
// Figures with a script of their own. A plotly figure whose `layout.meta.course` is
//     {"kind": "film", "scripts": ["motion", "film"], ...}
// makes its page load course_lib/figures/scripts/motion.js and film.js, in this order, before this file. They
// are classic scripts (a browser refuses modules from file://); without "scripts" the one loaded is named as the
// kind, up to a colon ("toy:arm" -> toy.js). A script says what starts a kind of figure:
//     window.course = window.course || { kinds: {} };
//     window.course.kinds["film"] = (live, meta) => stop;
// It is called each time that the figure comes near the window, with
//     live    the <div> in which plotly has drawn the figure, or an empty one if meta.plotly is false
//     meta    layout.meta.course
// and returns a function that stops all it began and removes all it added (or nothing): the figure is then far
// away, or about to be drawn again. What it keeps in `meta` is there the next time. Controls go into
// window.course.bar(live), a row below the figure that is emptied at every start; they need names
// (aria-label) and work from the keyboard. A figure with `meta.plotly: false` is not drawn by plotly, and is no
// reason to load it. Without scripts, and in print, the still picture is shown.
(() => {
  "use strict";
  const NEAR = "600px 0px";
  const PLAYER = 52; // the height of a film's button and range, as site.css has it
  // Plotly's size for a figure that states none.
  const [WIDTH, HEIGHT] = [700, 450];
  // Its buttons are at the right edge, clear of titles and legends, while a mouse is over the figure; not on a phone.
  const NARROW = 520;
  const CONFIG = {
    responsive: true,
    displaylogo: false,
    displayModeBar: window.innerWidth > NARROW ? "hover" : false,
    modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d", "zoomIn2d", "zoomOut2d", "resetCameraLastSave3d"],
  };

  // In the dark theme a live figure is drawn in that theme's colours: dark colours become light, strong ones a little
  // lighter. Each colour has one partner, so that the inverse map restores it.
  const IN_DARK = {
    white: "#1b1f24", "#222222": "#e7eaee", "#dddddd": "#3c444d", "#8a8a8a": "#a3abb3", "#6b7177": "#b3bac1",
    "#0072B2": "#56a8de", "#009E73": "#33c79c", "#D55E00": "#f0863a", "#b2182b": "#f2667a", "#7a1fa2": "#cf9ae6",
    "#eceef1": "#39414a", "#6b727b": "#14171b", "#c3c8ce": "#626c77", "#ececec": "#565f69",
  };
  const TO_DARK = new Map(Object.entries(IN_DARK).map(([light, dark]) => [light.toLowerCase(), dark]));
  const TO_LIGHT = new Map(Object.entries(IN_DARK).map(([light, dark]) => [dark, light]));
  const isDark = () => document.documentElement.dataset.theme === "dark";

  function recolour(node, map) {
    if (Array.isArray(node) && typeof node[node.length - 1] === "number") return; // coordinates
    Object.entries(node).forEach(([key, value]) => {
      if (typeof value === "string") node[key] = map.get(value.toLowerCase()) || value;
      else if (value && typeof value === "object" && key !== "meta") recolour(value, map);
    });
  }

  // On a phone, scenes that are side by side are stacked, each with its title.
  function stack(layout, meant) {
    const scenes = Object.keys(layout).filter((key) => /^scene\d*$/.test(key));
    const spans = scenes.map((key) => (layout[key].domain && layout[key].domain.x) || [0, 1]);
    if (scenes.length < 2 || new Set(spans.map(([from]) => from)).size < scenes.length) return meant;
    const order = scenes.map((_, i) => i).sort((a, b) => spans[a][0] - spans[b][0]);
    const n = scenes.length, title = 0.12 / n;
    const top = (i) => 1 - order.indexOf(i) / n - title;
    (layout.annotations || []).forEach((words) => {
      const i = spans.findIndex(([from, to]) => words.x >= from && words.x <= to);
      if (words.xref !== "paper" || words.yref !== "paper" || i < 0) return;
      const [from, to] = spans[i];
      words.x = (words.x - from) / (to - from);
      words.y = words.y >= 0.9 ? top(i) : top(i) - (1 - words.y) * (1 / n - title);
    });
    scenes.forEach((key, i) => (layout[key].domain = { x: [0, 1], y: [top(i) - 1 / n + title, top(i)] }));
    return { width: meant.width / n, height: n * meant.height };
  }

  // Plotly's own play button and slider take no keyboard focus; HTML ones replace them.
  const does = (method) => (control) => {
    const steps = control.steps || control.buttons || [];
    return steps.length > 0 && steps.every((s) => s.method === method);
  };
  const drivesFrames = does("animate");

  function takeOwnControls(layout) {
    const menus = layout.updatemenus || [];
    const sliders = layout.sliders || [];
    layout.updatemenus = menus.filter((menu) => !drivesFrames(menu));
    layout.sliders = sliders.filter((slider) => !drivesFrames(slider));
    // The space that they took below the picture, in pixels.
    const room = (layout.meta && layout.meta.controls) || 0;
    if (room && layout.sliders.length === 0) {
      layout.margin.b -= room;
      layout.height -= room;
    }
    return {
      button: menus.filter(drivesFrames).flatMap((menu) => menu.buttons)[0],
      slider: sliders.find(drivesFrames),
    };
  }

  function element(name, attributes, parent) {
    const made = document.createElement(name);
    Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, value));
    parent.append(made);
    return made;
  }

  const usesPlotly = (meta) => !meta || meta.plotly !== false;

  function addScript(url) {
    return new Promise((done, failed) => {
      const script = element("script", { src: url }, document.head);
      script.addEventListener("load", done);
      script.addEventListener("error", failed);
    });
  }

  // plotly.js is larger than everything else. It is loaded, compressed, when the first figure that needs it comes near.
  const OWN_URL = document.currentScript.src;
  let plotly = null;
  const loadPlotly = () => (plotly = plotly || unpackPlotly());
  async function unpackPlotly() {
    await addScript(new URL("plotly.packed.js", OWN_URL));
    const letters = atob(window.course.plotly);
    const packed = new Uint8Array(letters.length);
    for (let i = 0; i < letters.length; i++) packed[i] = letters.charCodeAt(i); // Uint8Array.from takes ten times as long
    const bytes = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    const url = URL.createObjectURL(await new Response(bytes).blob());
    await addScript(url);
    URL.revokeObjectURL(url);
    delete window.course.plotly;
  }

  // A play button and a range for a figure with frames.
  function addPlayer(box, live, figure, own) {
    const settings = own.button && own.button.args && own.button.args[1];
    const duration = (settings && settings.frame && settings.frame.duration) || 50;
    figure.frames.forEach((frame, i) => (frame.name = String(frame.name ?? i)));
    const steps = (own.slider && own.slider.steps) || [];
    const labels = figure.frames.map((frame) => {
      const step = steps.find((s) => String(s.args[0][0]) === frame.name);
      return (step && step.label) || frame.name;
    });
    const before = (own.slider && own.slider.currentvalue && own.slider.currentvalue.prefix) || "";

    const bar = element("div", { class: "plotly-player" }, box);
    const button = element("button", { type: "button" }, bar);
    const last = figure.frames.length - 1;
    const range = element("input", { type: "range", min: 0, max: last, value: 0, "aria-label": "Frame" }, bar);
    const label = element("span", { "aria-hidden": "true" }, bar);
    let playing = null; // the current run: a pause ends it, and playing again begins another

    function setPlaying(run) {
      playing = run;
      button.textContent = run ? "Pause" : "Play";
    }
    function show() {
      const i = Number(range.value);
      label.textContent = before + labels[i];
      range.setAttribute("aria-valuetext", label.textContent);
      const atOnce = { mode: "immediate", frame: { duration: 0, redraw: true }, transition: { duration: 0 } };
      // Rejected if the next frame is requested before; that is intended.
      return window.Plotly.animate(live, [figure.frames[i].name], atOnce).catch(() => {});
    }
    async function play() {
      if (Number(range.value) === last) range.value = 0;
      const run = {};
      setPlaying(run);
      while (playing === run && Number(range.value) < last) {
        const started = performance.now();
        range.value = Number(range.value) + 1;
        await show();
        await new Promise((done) => setTimeout(done, duration - (performance.now() - started)));
      }
      if (playing === run) setPlaying(null);
    }
    button.addEventListener("click", () => (playing ? setPlaying(null) : play()));
    range.addEventListener("input", () => {
      setPlaying(null);
      show();
    });
    setPlaying(null);
    return { show, stop: () => setPlaying(null) };
  }

  // A scene in 3D is drawn to the scale of its height: on a narrow page its sides would be cut off. So
  // the figure is made lower there, until every scene has its original shape, or is a square.
  function fittingHeight(layout, meant, width) {
    const scenes = Object.keys(layout).filter((key) => /^scene\d*$/.test(key));
    const heights = scenes.map((key) => {
      const { x = [0, 1], y = [0, 1] } = layout[key].domain || {};
      const shape = (x[1] - x[0]) / (y[1] - y[0]);
      return (width * shape) / Math.min(1, (meant.width * shape) / meant.height);
    });
    // A square in the plane stays a square.
    if (layout.yaxis && layout.yaxis.scaleanchor && !layout.xaxis2) {
      const { l = 80, r = 80, t = 100, b = 80 } = layout.margin || {}; // plotly's own
      heights.push(width - l - r + t + b);
    }
    return Math.min(meant.height, ...heights);
  }

  function setUp(box) {
    const live = box.querySelector(".plotly-live");
    const figure = JSON.parse(box.querySelector("script").textContent);
    figure.layout = figure.layout || {};
    const own = takeOwnControls(figure.layout);
    let meant = { width: figure.layout.width || WIDTH, height: figure.layout.height || HEIGHT };
    if (box.clientWidth < NARROW) meant = stack(figure.layout, meant);
    figure.layout.modebar = { orientation: "v", bgcolor: "rgba(0,0,0,0)" };
    // A width set for paper would not fit a phone.
    delete figure.layout.width;
    figure.layout.autosize = true;
    const meta = figure.layout.meta && figure.layout.meta.course;
    const start = meta && window.course && window.course.kinds[meta.kind];
    const player = !start && figure.frames && figure.frames.length ? addPlayer(box, live, figure, own) : null;
    let stop = null, isPlot = false;

    let keptAt = null;
    const keepHeight = (height) => { // otherwise the text would jump
      box.style.minHeight = `${height}px`;
      keptAt = box.clientWidth;
    };
    const isDrawn = () => box.classList.contains("drawn");
    const fit = () => fittingHeight(figure.layout, meant, box.clientWidth);

    async function draw() {
      try {
        await drawLive();
      } catch (error) { // it remains a still picture, until it comes near again
        console.warn(error);
        letGo();
      }
    }
    async function drawLive() {
      if (usesPlotly(meta)) await loadPlotly();
      box.classList.add("drawn");
      figure.layout.height = fit();
      if (isDark() !== inDark) {
        inDark = isDark();
        // A figure that plotly does not draw takes care of its own colours.
        const parts = usesPlotly(meta) ? [figure.data, figure.layout, figure.frames || []] : [];
        parts.forEach((part) => recolour(part, inDark ? TO_DARK : TO_LIGHT));
      }
      const { data, layout, frames } = figure;
      const width = box.clientWidth;
      if (usesPlotly(meta)) await window.Plotly.newPlot(live, { data, layout, frames, config: CONFIG });
      isPlot = usesPlotly(meta);
      if (box.clientWidth !== width) await fitAgain();
      box.style.minHeight = "";
      if (player) await player.show();
      if (start) stop = start(live, meta);
    }
    // Plotly keeps camera and zoom in the layout it was given, so that they are still there next time.
    function letGo() {
      if (player) player.stop();
      keepHeight(box.offsetHeight);
      if (stop) stop();
      stop = null;
      if (isPlot) window.Plotly.purge(live);
      isPlot = false;
      live.replaceChildren();
      box.classList.remove("drawn");
    }
    const fitAgain = () => {
      if (!isDrawn() && box.clientWidth !== keptAt) box.style.minHeight = "";
      else if (isPlot) return window.Plotly.relayout(live, { height: fit() }); // not while it is being drawn
    };
    window.addEventListener("resize", fitAgain);

    // One after the other, because a reader may scroll faster than figures are drawn.
    let near = false;
    let inDark = false;
    let work = Promise.resolve();
    const come = (isNear) => {
      near = isNear;
      work = work.then(() => (near && !isDrawn() ? draw() : !near && isDrawn() && letGo()));
    };
    const changeTheme = () => {
      if (isDrawn()) work = work.then(() => isDark() !== inDark && isDrawn() && (letGo(), draw()));
    };
    // Reserve the space of the live figure while the reader is elsewhere.
    const reserve = () => (work = work.then(async () => {
      if (isDrawn()) return;
      if (usesPlotly(meta)) return keepHeight(fit() + ("moves" in box.dataset ? PLAYER : 0));
      await draw();
      if (!near) letGo();
    }));
    return { come, changeTheme, reserve };
  }

  // What the scripts of figures may use (see the top of this file).
  window.course = window.course || { kinds: {} };
  window.course.bar = (live) => {
    const box = live.closest(".plotly-figure");
    const bar = box.querySelector(".plotly-player") || element("div", { class: "plotly-player" }, box);
    bar.replaceChildren();
    return bar;
  };

  const figures = new Map();
  const watch = new IntersectionObserver(
    (entries) => entries.forEach(({ target, isIntersecting }) => {
      if (isIntersecting && !figures.has(target)) figures.set(target, setUp(target));
      if (figures.has(target)) figures.get(target).come(isIntersecting);
    }),
    { rootMargin: NEAR },
  );
  new MutationObserver(() => figures.forEach(({ changeTheme }) => changeTheme())).observe(document.documentElement, {
    attributeFilter: ["data-theme"],
  });

  // Without its own script, a figure that plotly does not draw remains a still picture.
  const canBeDrawn = (box) => box.dataset.kind in window.course.kinds || !("withoutPlotly" in box.dataset);
  const boxes = [...document.querySelectorAll(".plotly-figure")].filter(canBeDrawn);
  boxes.forEach((box) => watch.observe(box));

  // When the page is loaded and the browser is idle: one figure after the other.
  const idle = window.requestIdleCallback || ((work) => setTimeout(work, 50));
  async function reserveNext() {
    const next = boxes.findIndex((each) => each.checkVisibility()); // what is folded has no size yet
    if (next < 0) return;
    const [box] = boxes.splice(next, 1);
    if (!figures.has(box)) figures.set(box, setUp(box));
    await figures.get(box).reserve();
    idle(reserveNext);
  }
  window.addEventListener("load", () => idle(reserveNext));
  document.addEventListener("toggle", () => idle(reserveNext), true);
})();
