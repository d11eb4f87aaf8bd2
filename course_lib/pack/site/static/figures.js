// Starts the toys whose data stand in the page, each in the room that its still picture held. Those
// near the window come first; one that failed is tried again when it comes near.
//
// A toy's data are {"kind": "toy:arm", "scripts": ["motion", "scene", "toys", "toy_arm"], ...}: its
// page loads figures/motion.js and the others, in this order, before this file; each is a file or a
// folder of course_lib/figures/scripts. They are classic scripts (a browser refuses modules from
// file://). A script says what starts a kind of figure:
//     window.course = window.course || { kinds: {} };
//     window.course.kinds["toy:arm"] = (live, meta) => stop;
// It is called with an empty <div> and the data, and once more when the page changes to the other
// theme. It returns a function that stops all it began and removes all it added (or nothing). What
// it keeps in `meta` is there the next time. Without scripts, and in print, the still picture is
// shown.
(() => {
  "use strict";
  const NEAR = "600px 0px"; // around the window
  const PAUSE = 700; // milliseconds between two toys that are far from it
  const isDark = () => document.documentElement.dataset.theme === "dark";

  function setUp(box) {
    const live = box.querySelector(".toy-live");
    const meta = JSON.parse(box.querySelector("script").textContent).layout.meta.course;
    let stop = null;
    let isDrawn = false;
    let inDark = false;

    function draw() {
      if (isDrawn) return;
      isDrawn = true;
      inDark = isDark();
      try {
        stop = window.course.kinds[meta.kind](live, meta);
        box.classList.add("drawn");
      } catch (error) {
        // it remains a still picture, until it comes near again
        console.warn(error);
        letGo();
      }
    }
    function letGo() {
      isDrawn = false;
      box.classList.remove("drawn");
      if (stop) stop();
      stop = null;
      live.replaceChildren();
    }
    function changeTheme() {
      if (!isDrawn || isDark() === inDark) return;
      letGo();
      draw();
    }
    return { draw, changeTheme };
  }

  window.course = window.course || { kinds: {} };
  const figures = new Map();
  function figureOf(box) {
    if (!figures.has(box)) figures.set(box, setUp(box));
    return figures.get(box);
  }
  const nearness = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        if (isIntersecting) figureOf(target).draw();
      }
    },
    { rootMargin: NEAR },
  );
  const theme = new MutationObserver(() => {
    for (const figure of figures.values()) figure.changeTheme();
  });
  theme.observe(document.documentElement, { attributeFilter: ["data-theme"] });

  // Without its own script a figure remains a still picture.
  const toys = [...document.querySelectorAll(".toy-figure")].filter(
    (box) => box.dataset.kind in window.course.kinds,
  );
  for (const box of toys) nearness.observe(box);

  // A toy has its height once it is drawn: one after the other when the page is loaded and the
  // browser is idle, those near the window first, and the others not all at once.
  const idle = window.requestIdleCallback || ((work) => setTimeout(work, 50));
  async function drawNext() {
    const distance = (box) => Math.abs(box.getBoundingClientRect().top);
    const visible = toys.filter((box) => box.checkVisibility()); // what is folded has no size yet
    visible.sort((a, b) => distance(a) - distance(b));
    const [next] = visible;
    if (!next) return;
    toys.splice(toys.indexOf(next), 1);
    const pause = distance(next) < 2 * window.innerHeight ? 0 : PAUSE;
    await new Promise((done) => setTimeout(done, pause));
    figureOf(next).draw();
    idle(drawNext);
  }
  window.addEventListener("load", () => idle(drawNext));
  document.addEventListener("toggle", () => idle(drawNext), true);
})();
