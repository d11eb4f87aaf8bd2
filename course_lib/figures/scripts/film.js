// Plays a film of rigid bodies in a page, with as many frames as the machine can draw; it loops while it is visible. If
// the reader prefers reduced motion it does not start before Play is pressed. The data in layout.meta.course are
//     {"kind": "film", "scripts": ["motion", "film"],
//      "trace": 2,                  the number of the mesh3d trace that holds all moving bodies, at the first time
//      "counts": [140, 212, ...],   how many of its vertices belong to each body, in order
//      "times": [t0, t1, ...],      in seconds, and for each time and body a rotation vector and a position:
//      "rotations": [[[w1, w2, w3], ... a body], ... a time], "positions": likewise}
(() => {
  "use strict";
  window.course = window.course || { kinds: {} };

  function element(name, attributes, parent) {
    const made = document.createElement(name);
    Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, value));
    parent.append(made);
    return made;
  }

  window.course.kinds["film"] = (live, meta) => {
    const { exp, interpolate, inverse, times: product } = window.course.motion;
    const { times, counts, trace } = meta;
    const pose = (w, p) => exp([...w, 0, 0, 0]).map((row, i) => (i < 3 ? [...row.slice(0, 3), p[i]] : row));
    const poses = meta.rotations.map((bodies, i) => bodies.map((w, body) => pose(w, meta.positions[i][body])));
    // A figure that was removed from the page and is drawn again continues at the same time.
    const { x, y, z } = live.data[trace];
    meta.first = meta.first || { x: [...x], y: [...y], z: [...z] };
    meta.at = meta.at === undefined ? times[0] : meta.at;
    const last = times[times.length - 1];

    const bar = window.course.bar(live);
    const button = element("button", { type: "button" }, bar);
    const settings = { type: "range", min: 0, max: 200, step: 1, "aria-label": "Time" };
    const range = element("input", settings, bar);
    const label = element("span", { "aria-hidden": "true" }, bar);
    const seconds = () => times[0] + (Number(range.value) / 200) * (last - times[0]);

    function bodiesAt(t) {
      let i = times.findIndex((time) => time > t) - 1;
      if (i < 0) i = t < times[0] ? 0 : times.length - 2;
      const share = Math.min(1, Math.max(0, (t - times[i]) / (times[i + 1] - times[i])));
      return poses[i].map((from, body) => interpolate(from, poses[i + 1][body], share));
    }

    // The vertices of bodies that moved by T since the first time.
    function placed({ x, y, z }, moved) {
      const out = [0, 1, 2].map(() => new Array(x.length));
      let k = 0;
      counts.forEach((count, body) => {
        const T = moved[body];
        for (const end = k + count; k < end; k++) {
          for (let i = 0; i < 3; i++) out[i][k] = T[i][0] * x[k] + T[i][1] * y[k] + T[i][2] * z[k] + T[i][3];
        }
      });
      return out.map((row) => [row]);
    }

    let drawing = Promise.resolve();
    let wanted = null;
    // One at a time: while one is drawn, only the newest of those that come is kept.
    function show(t) {
      meta.at = t;
      range.value = Math.round((200 * (t - times[0])) / (last - times[0]));
      label.textContent = `time: ${t.toFixed(2)} s`;
      range.setAttribute("aria-valuetext", `${t.toFixed(2)} seconds`);
      const first = wanted === null;
      wanted = t;
      if (!first) return drawing;
      drawing = drawing.then(async () => {
        const now = wanted;
        wanted = null;
        if (stopped) return;
        const [x, y, z] = placed(meta.first, bodiesAt(now).map((T, body) => product(T, inverse(poses[0][body]))));
        await window.Plotly.restyle(live, { x, y, z }, [trace]);
      });
      return drawing;
    }

    let playing = null;
    let stopped = false;
    const nextFrame = () => new Promise((done) => requestAnimationFrame(done)); // none comes while the page is hidden
    function setPlaying(run) {
      playing = run;
      meta.plays = run !== null;
      button.textContent = run ? "Pause" : "Play";
    }
    async function play() {
      const run = {};
      setPlaying(run);
      let before = performance.now();
      while (playing === run) {
        const now = await nextFrame();
        const t = meta.at + Math.min(Math.max(now - before, 0), 250) / 1000; // after a pause of the page it goes on
        before = now;
        if (playing === run && isVisible) await show(t > last ? times[0] : t);
      }
    }
    button.addEventListener("click", () => (playing ? setPlaying(null) : play()));
    range.addEventListener("input", () => {
      setPlaying(null);
      show(seconds());
    });

    let isVisible = true;
    const watch = new IntersectionObserver((entries) => (isVisible = entries[entries.length - 1].isIntersecting));
    watch.observe(live);

    const still = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (meta.plays === undefined ? !still : meta.plays) play();
    else {
      setPlaying(null);
      show(meta.at);
    }
    return () => {
      stopped = true;
      playing = null;
      watch.disconnect();
      bar.replaceChildren();
    };
  };
})();
