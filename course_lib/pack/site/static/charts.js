// Draws the charts whose data stand in the page, by plotly, and writes "The numbers" below each
// when a reader opens them. A chart is drawn when it comes near the window and let go when it is
// far: a browser holds few WebGL contexts (16 on a desktop, 8 on a phone), and what is far costs
// memory. Zoom and choice are there again when it comes back.
//
// plotly.js is much larger than a page, and starts in one piece that holds the page for a second or
// more. It comes from the site's own files when the first chart is no longer far, and only while the
// reader rests: whoever scrolls past sees the chart's picture, as do readers without scripts, and
// print. Colours follow the page's theme by a filter, in site.css.
(() => {
  "use strict";
  const NEAR = "800px 0px";
  const FAR = "3000px 0px";
  const NARROW = 520; // pixels, as site.css has it
  const NAME_LETTERS = 36; // of a line of a narrow legend, as prepare.py has it
  const MAX_ROWS = 2500; // of a table, for each series
  const OWN_URL = document.currentScript.src;

  let plotly = null;
  function loadPlotly() {
    plotly ??= new Promise((done, failed) => {
      const script = document.createElement("script");
      script.src = new URL("plotly.min.js", OWN_URL);
      script.addEventListener("load", done);
      script.addEventListener("error", () => {
        plotly = null; // the next chart tries again
        failed(Error("plotly.js could not be loaded"));
      });
      document.head.append(script);
    });
    return plotly;
  }

  // ---- rest ----

  const REST = 300; // milliseconds without input, after which a reader rests
  const idle = window.requestIdleCallback || ((work) => setTimeout(work, 50));
  let lastInput = -REST;
  for (const kind of ["scroll", "wheel", "touchmove", "pointerdown", "keydown"]) {
    const note = () => {
      lastInput = performance.now();
    };
    window.addEventListener(kind, note, { capture: true, passive: true });
  }
  /** Wait until the page is loaded, the reader rests and the browser has nothing else to do. */
  function rest() {
    return new Promise((done) => {
      function look() {
        const wait = lastInput + REST - performance.now();
        if (document.readyState !== "complete") window.addEventListener("load", look);
        else if (wait > 0) setTimeout(look, wait);
        else idle(() => done());
      }
      look();
    });
  }

  let webgl = null; // asked once, for each question makes a context
  function hasWebGL() {
    webgl ??= Boolean(document.createElement("canvas").getContext("webgl"));
    return webgl;
  }
  const needsWebGL = ({ type }) =>
    /gl$|3d$|^(cone|surface|isosurface|volume|streamtube|splom)$/.test(type);

  const plain = (words) => words.replace(/<[^>]*>/g, "");

  // ---- the layout on a narrow page ----

  const axisKey = (axis) => `${axis[0]}axis${axis.slice(1)}`;
  const isTouched = () => window.matchMedia("(pointer: coarse)").matches;

  /** The bottom and the height of one of several pictures below each other, in heights of all. */
  function placeBelow(number, count) {
    const gap = 0.28 / count;
    const height = (1 - gap * (count - 1)) / count;
    return { bottom: (count - 1 - number) * (height + gap), height };
  }

  /** Move pictures in space below each other, each with the words above it. */
  function stackScenes(layout) {
    const names = Object.keys(layout).filter((key) => /^scene\d*$/.test(key));
    if (names.length < 2) return;
    const onPaper = layout.annotations?.filter(({ yref }) => yref === "paper") ?? [];
    const before = onPaper.map(({ x }) => x);
    names.forEach((name, number) => {
      const { x = [0, 1], y = [0, 1] } = layout[name].domain ?? {};
      const { bottom, height } = placeBelow(number, names.length);
      layout[name].domain = { x: [0, 1], y: y.map((share) => bottom + share * height) };
      onPaper.forEach((words, i) => {
        if (before[i] < x[0] || before[i] >= x[1]) return;
        Object.assign(words, { x: 0.5, y: bottom + words.y * height });
      });
    });
  }

  // Panels stand below each other, as prepare.py reserved the room. The legend is below them, and
  // the colour bar above.
  function narrowed(layout) {
    const narrow = structuredClone(layout);
    const { panels = [], columns = 1 } = layout.meta ?? {};
    narrow.margin = { ...layout.margin, l: 48, r: 10 };
    narrow.legend = {
      ...layout.legend,
      orientation: "h",
      x: 0,
      y: 0,
      yref: "container",
      yanchor: "bottom",
    };
    if (columns > 1) {
      panels.forEach(([x, y], number) => {
        const { bottom, height } = placeBelow(number, panels.length);
        narrow[axisKey(x)].domain = [0, 1];
        narrow[axisKey(y)].domain = [Math.max(0, bottom), Math.min(1, bottom + height)];
      });
    }
    stackScenes(narrow);
    if (layout.coloraxis) {
      const bar = layout.coloraxis.colorbar ?? {};
      const { tickvals = [], ticktext = [] } = bar;
      const isKept = (_, i) =>
        i % Math.ceil((tickvals.length - 1) / 4) === 0 || i === tickvals.length - 1;
      narrow.coloraxis.colorbar = {
        ...bar,
        ...{ orientation: "h", x: 0.5, xanchor: "center", len: 1, thickness: 12, tickangle: 0 },
        ...{ y: 1, yref: "container", yanchor: "top", ypad: 24 },
        title: { text: "" }, // plotly would draw it over the bar
        ...(tickvals.length
          ? { tickvals: tickvals.filter(isKept), ticktext: ticktext.filter(isKept) }
          : {}),
      };
      const words = { text: bar.title?.text ?? "", font: { size: 12 } };
      const place = {
        x: 0.5,
        xanchor: "center",
        y: 1,
        yref: "container",
        yanchor: "top",
        pad: { t: 6 },
      };
      narrow.title ??= { ...words, ...place };
      narrow.margin.t = (layout.margin?.t ?? 30) + 55;
    }
    return narrow;
  }

  /** A series whose name continues on the next line of a narrow legend, which would cut it off. */
  function withFoldedName(series) {
    if (!series.name || plain(series.name).length <= NAME_LETTERS) return series;
    const lines = [""];
    for (const word of series.name.split(" ")) {
      const longer = `${lines.at(-1)} ${word}`.trim();
      if (plain(longer).length > NAME_LETTERS && lines.at(-1)) lines.push(word);
      else lines[lines.length - 1] = longer;
    }
    return { ...series, name: lines.join("<br>") };
  }

  // ---- a chart ----

  function setUp(box) {
    const live = box.querySelector(".chart-live");
    const figure = JSON.parse(box.querySelector("script").textContent);
    const layouts = new Map(); // wide and narrow: plotly keeps the zoom in the layout that it was given
    let isNear = false; // the window
    let isDrawn = false;
    let isNarrow = false;
    let work = Promise.resolve();

    function layoutFor(narrow) {
      if (!layouts.has(narrow)) {
        const own = { ...figure.layout, autosize: true };
        // Of a series of small dots the legend shows a dot that is as large as the others.
        own.legend = { ...own.legend, itemsizing: "constant" };
        delete own.width;
        delete own.height; // those of its <div>
        layouts.set(narrow, narrow ? narrowed(own) : own);
      }
      const layout = layouts.get(narrow);
      if (isTouched()) layout.dragmode = false; // a finger moves the page, and a tap shows the values
      return layout;
    }

    async function draw() {
      if (isDrawn) return;
      isDrawn = true;
      try {
        if (figure.data.some(needsWebGL) && !hasWebGL()) throw Error("this browser has no WebGL");
        await rest();
        await loadPlotly();
        if (!isNear) return letGo(); // the reader has scrolled past
        isNarrow = live.clientWidth < NARROW;
        const config = {
          ...figure.config,
          responsive: true,
          displayModeBar: isNarrow ? false : "hover",
        };
        const data = isNarrow ? figure.data.map(withFoldedName) : figure.data;
        const { frames = [] } = figure;
        await window.Plotly.newPlot(live, { data, layout: layoutFor(isNarrow), frames, config });
        box.classList.add("drawn");
      } catch (error) {
        // it remains a picture, until it comes near again
        console.warn(`A chart is not drawn: ${error.message}.`);
        letGo();
      }
    }

    function letGo() {
      if (!isDrawn) return;
      isDrawn = false;
      box.classList.remove("drawn");
      window.Plotly?.purge(live);
      live.replaceChildren();
    }

    function fit() {
      if (isDrawn && live.clientWidth && live.clientWidth < NARROW !== isNarrow) {
        letGo();
        return draw();
      }
    }

    // One after the other, because a reader may scroll faster than charts are drawn.
    const next = (step) => {
      work = work.then(step);
      return work;
    };
    function approach(isIntersecting) {
      isNear = isIntersecting;
      if (isNear) next(draw);
    }
    return { approach, letGo: () => next(letGo), fit: () => next(fit), figure };
  }

  const charts = new Map();
  function chartOf(box) {
    if (!charts.has(box)) charts.set(box, setUp(box));
    return charts.get(box);
  }

  function observe(margin, act) {
    const observer = new IntersectionObserver((entries) => entries.forEach(act), {
      rootMargin: margin,
    });
    for (const box of document.querySelectorAll(".chart-figure")) observer.observe(box);
  }
  observe(NEAR, ({ target, isIntersecting }) => {
    if (isIntersecting || charts.has(target)) chartOf(target).approach(isIntersecting);
  });
  observe(FAR, ({ target, isIntersecting }) => {
    if (isIntersecting)
      rest()
        .then(loadPlotly)
        .catch(() => {}); // a chart that is drawn says why
    else if (charts.has(target)) chartOf(target).letGo();
  });
  window.addEventListener("resize", () => {
    for (const { fit } of charts.values()) fit();
  });

  // ---- the numbers, for readers who use no pointer ----

  const MINUS = "\u2212";
  function written(value, digits) {
    if (value === null || value === undefined) return "";
    if (typeof value !== "number") return String(value);
    const text = digits ? String(Number(value.toPrecision(digits))) : String(value);
    return text.replace(/^-|e-/, (sign) => sign.replace("-", MINUS));
  }

  // What plotly's templates can name of a point: x, y, z and the numbers that belong to it.
  const FIELD = /%\{(\w+)(?:\[(\d+)\])?(?::\.(\d+)[^}]*)?\}/g;
  function filled(template, point) {
    const numberOf = (name, index) => (index === undefined ? point[name] : point[name]?.[index]);
    const isMissing = ([, name, index]) => (numberOf(name, index) ?? null) === null;
    if ([...template.matchAll(FIELD)].some(isMissing)) return ""; // no unit without a number
    return template.replace(FIELD, (_, name, index, digits) =>
      written(numberOf(name, index), Number(digits) || 0),
    );
  }

  function titleOf(layout, axis) {
    return layout[axisKey(axis)]?.title?.text ?? axis[0];
  }

  // The columns of a series' table are the lines that hover shows: {title, template}.
  function columnsOf(series, layout) {
    const [template] = (series.hovertemplate ?? "").split("<extra>");
    const columns = template
      .split("<br>")
      .filter((line) => line.includes("%{"))
      .map((line) => {
        const [, title, rest] = line.match(/^([^%]*?)(?:: | = )(.*)$/) ?? [null, null, line];
        return { title, template: rest };
      });
    for (const letter of ["z", "y", "x"]) {
      const axis = series[`${letter}axis`] ?? letter;
      const column = columns.find((c) => c.template.includes(`%{${letter}`));
      if (column) column.title ??= titleOf(layout, axis).replace(/ \([^()]*\)$/, "");
      const isMissing = !column && series[letter] && (letter !== "z" || !columns.length);
      if (
        isMissing &&
        !columns.some((c) => c.title === titleOf(layout, axis).replace(/ \([^()]*\)$/, ""))
      ) {
        columns.unshift({ title: titleOf(layout, axis), template: `%{${letter}:.4}` });
      }
    }
    return columns.map((column) => ({ ...column, title: column.title ?? "value" }));
  }

  function pointsOf(series) {
    if (Array.isArray(series.z?.[0])) {
      return series.z.flatMap((row, j) =>
        row.map((z, i) => ({
          x: series.x?.[i] ?? i,
          y: series.y?.[j] ?? j,
          z,
          customdata: series.customdata?.[j]?.[i],
        })),
      );
    }
    const values = series.y ?? series.x ?? series.values ?? [];
    return values.map((_, i) => ({
      x: series.x?.[i] ?? i,
      y: series.y?.[i],
      z: series.z?.[i],
      customdata: series.customdata?.[i],
    }));
  }

  function element(name, parent, text) {
    const made = document.createElement(name);
    if (text !== undefined) made.textContent = text;
    parent.append(made);
    return made;
  }

  let tableCount = 0;

  function addTable(place, series, layout) {
    if (series.hoverinfo === "skip") return; // what says nothing under the pointer is a drawing
    const points = pointsOf(series);
    const step = Math.ceil(points.length / MAX_ROWS);
    const columns = columnsOf(series, layout);
    if (!points.length || !columns.length) return;
    const frame = element("div", place);
    frame.className = "chart-table";
    frame.tabIndex = 0; // it is scrolled by the keyboard
    const panels = layout.meta?.panels ?? [];
    const panel = panels.findIndex(
      ([x, y]) => (series.xaxis ?? "x") === x && (series.yaxis ?? "y") === y,
    );
    const own = layout[series.scene]?.domain?.x; // of a picture in space
    const isOfScene = ({ yref, x }) => own && yref === "paper" && x >= own[0] && x < own[1];
    const isOfPanel = ({ yref }) => yref === `${panels[panel]?.[1]} domain`;
    const note = layout.annotations?.find(own ? isOfScene : isOfPanel);
    const names = new Set(
      [note?.text.replace("<br>", ", "), series.name].filter(Boolean).map(plain),
    );
    const name = [...names].join(": ") || "values";
    frame.setAttribute("role", "region");
    // Two series may have one name; a region needs one that no other region of the page has.
    tableCount += 1;
    frame.setAttribute("aria-label", `${name} (table ${tableCount})`);
    const table = element("table", frame);
    const some = step > 1 ? `, one in ${step} of ${points.length.toLocaleString("en")} points` : "";
    element("caption", table, name + some);
    const head = element("tr", element("thead", table));
    columns.forEach(({ title }) => {
      element("th", head, plain(title)).scope = "col";
    });
    const body = element("tbody", table);
    for (let i = 0; i < points.length; i += step) {
      const row = element("tr", body);
      for (const { template } of columns) {
        const value = template.replace(`, ${note?.text}`, ""); // the table's name has the panel
        element("td", row, plain(filled(value, points[i])));
      }
    }
  }

  document.querySelectorAll(".chart-numbers").forEach((details) => {
    details.hidden = false;
    details.addEventListener("toggle", () => {
      if (details.childElementCount > 1) return;
      const { figure } = chartOf(details.previousElementSibling);
      for (const series of figure.data) addTable(details, series, figure.layout);
    });
  });
})();
