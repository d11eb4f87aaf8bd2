// Draws the figures whose data stand in the page. Those of plotly are drawn when they come near the window, in the room
// that the page reserves (see prepare.py), and removed when they are far: a browser holds only some 3D figures at a
// time (16 on a desktop, 8 on a phone). What plotly does not draw, a toy, is drawn once.
//
// Figures with a script of their own. A plotly figure whose `layout.meta.course` is
//     {"kind": "toy:arm", "scripts": ["motion", "scene", "toys", "toy_arm"], "plotly": false, ...}
// makes its page load course_lib/figures/scripts/motion.js and the others, in this order, before this file. They
// are classic scripts (a browser refuses modules from file://); without "scripts" the one loaded is named as the
// kind, up to a colon ("toy:arm" -> toy.js). A script says what starts a kind of figure:
//     window.course = window.course || { kinds: {} };
//     window.course.kinds["toy:arm"] = (live, meta) => stop;
// It is called each time that the figure is drawn, with
//     live    the <div> in which plotly has drawn the figure, or an empty one if meta.plotly is false
//     meta    layout.meta.course
// and returns a function that stops all it began and removes all it added (or nothing): the figure is then far
// away, or about to be drawn in the colours of the other theme. What it keeps in `meta` is there the next time.
// Controls go into window.course.bar(live), a row below the figure that is emptied at every start; they need names
// (aria-label) and work from the keyboard. Without scripts, and in print, the still picture is shown.
(() => {
  "use strict";
  const NEAR = "600px 0px";
  // Its buttons are at the right edge, clear of titles and legends, while a mouse is over the figure; not on a phone.
  const NARROW = 520; // pixels, as site.css has it
  const CONFIG = {
    responsive: true,
    displaylogo: false,
    showSendToCloud: false,
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

  let webgl = null; // asked once, for each question makes a context
  const hasWebGL = () => (webgl = webgl || [Boolean(document.createElement("canvas").getContext("webgl"))])[0];

  function recolour(node, map) {
    if (Array.isArray(node) && typeof node[node.length - 1] === "number") return; // coordinates
    Object.entries(node).forEach(([key, value]) => {
      if (typeof value === "string") node[key] = map.get(value.toLowerCase()) || value;
      else if (value && typeof value === "object" && key !== "meta") recolour(value, map);
    });
  }

  function element(name, attributes, parent) {
    const made = document.createElement(name);
    Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, value));
    parent.append(made);
    return made;
  }

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
    for (let i = 0; i < letters.length; i++) packed[i] = letters.charCodeAt(i); // Uint8Array.from is slow
    const bytes = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    const url = URL.createObjectURL(await new Response(bytes).blob());
    await addScript(url);
    URL.revokeObjectURL(url);
    delete window.course.plotly;
  }

  function setUp(box) {
    const live = box.querySelector(".plotly-live"), byPlotly = !("withoutPlotly" in box.dataset);
    const { data, layout = {}, frames = [] } = JSON.parse(box.querySelector("script").textContent);
    const meta = layout.meta && layout.meta.course;
    const start = meta && window.course.kinds[meta.kind];
    const modebar = { orientation: "v", bgcolor: "rgba(0,0,0,0)" };
    Object.assign(layout, { modebar, autosize: true, width: undefined, height: undefined }); // those of its <div>
    let stop = null, isDrawn = false, inDark = false;

    async function draw() {
      if (isDrawn) return;
      isDrawn = true;
      try {
        const recolours = isDark() !== inDark;
        inDark = isDark();
        if (byPlotly) {
          if (layout.scene && !hasWebGL()) throw Error("this browser draws nothing in space (no WebGL)");
          await loadPlotly();
          if (recolours) [data, layout, frames].forEach((part) => recolour(part, inDark ? TO_DARK : TO_LIGHT));
          await window.Plotly.newPlot(live, { data, layout, frames, config: CONFIG });
        }
        if (start) stop = start(live, meta);
        box.classList.add("drawn");
      } catch (error) { // it remains a still picture, until it comes near again
        console.warn(error);
        letGo();
      }
    }
    // Plotly keeps camera and zoom in the layout it was given, so that they are still there next time.
    function letGo() {
      if (!isDrawn) return;
      isDrawn = false;
      box.classList.remove("drawn");
      if (stop) stop();
      stop = null;
      if (byPlotly && window.Plotly) window.Plotly.purge(live);
      live.replaceChildren();
    }

    // One after the other, because a reader may scroll faster than figures are drawn.
    let near = false, work = Promise.resolve();
    const come = (isNear) => {
      near = isNear;
      return (work = work.then(() => (near ? draw() : byPlotly && letGo())));
    };
    const changeTheme = () => (work = work.then(() => isDrawn && isDark() !== inDark && (letGo(), draw())));
    return { come, changeTheme };
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
  const figureOf = (box) => figures.get(box) || figures.set(box, setUp(box)).get(box);
  const watch = new IntersectionObserver((entries) => entries.forEach(({ target, isIntersecting }) => {
    if (isIntersecting || figures.has(target)) figureOf(target).come(isIntersecting);
  }), { rootMargin: NEAR });
  new MutationObserver(() => figures.forEach(({ changeTheme }) => changeTheme())).observe(document.documentElement, {
    attributeFilter: ["data-theme"],
  });

  // Without its own script, a figure that plotly does not draw remains a still picture.
  const boxes = [...document.querySelectorAll(".plotly-figure")];
  const toys = boxes.filter((box) => "withoutPlotly" in box.dataset && box.dataset.kind in window.course.kinds);
  boxes.filter((box) => !("withoutPlotly" in box.dataset) || toys.includes(box)).forEach((box) => watch.observe(box));

  // A toy has its height once it is drawn: one after the other when the page is loaded and the browser is idle, those
  // near the window first, and the others not all at once.
  const idle = window.requestIdleCallback || ((work) => setTimeout(work, 50));
  async function drawNext() {
    const far = (box) => Math.abs(box.getBoundingClientRect().top);
    const [next] = toys.filter((box) => box.checkVisibility()).sort((a, b) => far(a) - far(b)); // folded: no size yet
    if (!next) return;
    toys.splice(toys.indexOf(next), 1);
    const pause = far(next) < 2 * window.innerHeight ? 0 : 700;
    await new Promise((done) => setTimeout(done, pause));
    await figureOf(next).come(true);
    idle(drawNext);
  }
  window.addEventListener("load", () => idle(drawNext));
  document.addEventListener("toggle", () => idle(drawNext), true);
})();
