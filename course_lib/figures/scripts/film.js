// Plays a film of rigid bodies in a page, with as many frames as the machine can draw; it loops while it is visible. If
// the reader prefers reduced motion it does not start before Play is pressed. The data in layout.meta.course are
//     {"kind": "film", "scripts": ["motion", "film"],
//      "trace": 2,                  the number of the mesh3d trace that holds all moving bodies, at the first time
//      "counts": [140, 212, ...],   how many of its vertices belong to each body, in order
//      "times": [0, t1, ...],       in seconds, and for each time and body a rotation vector and a position:
//      "rotations": [[[w1, w2, w3], ... a body], ... a time], "positions": likewise}
(() => {
  "use strict";
  window.course.kinds["film"] = (live, meta) => {
    const { exp, interpolate, inverse, move, pose, rotationOf, times: product, transpose } = window.course.motion;
    const { times, counts, trace } = meta;
    const poses = meta.rotations.map((bodies, i) => bodies.map((w, body) =>
      pose(rotationOf(exp([...w, 0, 0, 0])), meta.positions[i][body])));
    const bodyOf = counts.flatMap((count, body) => Array(count).fill(body)); // of each vertex
    // A figure that was removed from the page and is drawn again continues at the same time.
    const { x, y, z } = live.data[trace];
    meta.first = meta.first || { x: [...x], y: [...y], z: [...z] };
    meta.at = meta.at || 0;
    const last = times[times.length - 1];

    const bar = window.course.bar(live);
    bar.innerHTML = `<button type="button"></button><input type="range" min="0" max="200" aria-label="Time">
      <span aria-hidden="true"></span>`;
    const [button, range, label] = bar.children;

    // The vertices at a time, as plotly's x, y and z: bodies move along screws from one of their poses to the next.
    function verticesAt(t) {
      const next = times.findIndex((time) => time > t), i = (next < 0 ? times.length - 1 : next) - 1;
      const share = (t - times[i]) / (times[i + 1] - times[i]), { x, y, z } = meta.first;
      const moved = poses[i].map((from, body) =>
        product(interpolate(from, poses[i + 1][body], share), inverse(poses[0][body])));
      return transpose(bodyOf.map((body, k) => move(moved[body], [x[k], y[k], z[k]])));
    }

    let drawing = Promise.resolve();
    let waiting = false;
    // One at a time: while one is drawn, only the newest of those that come is kept.
    function show(t) {
      meta.at = t;
      range.value = Math.round((200 * t) / last);
      label.textContent = `time: ${t.toFixed(2)} s`;
      range.setAttribute("aria-valuetext", `${t.toFixed(2)} seconds`);
      if (waiting) return drawing;
      waiting = true;
      drawing = drawing.then(() => {
        waiting = false;
        if (stopped) return null;
        const [x, y, z] = verticesAt(meta.at).map((row) => [row]);
        return window.Plotly.restyle(live, { x, y, z }, [trace]);
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
        if (playing === run && isVisible) await show(t > last ? 0 : t);
      }
    }
    button.addEventListener("click", () => (playing ? setPlaying(null) : play()));
    range.addEventListener("input", () => {
      setPlaying(null);
      show((range.value / 200) * last);
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
