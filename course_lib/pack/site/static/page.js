// Paper is white: print in the light theme whatever the screen shows. And it cannot be opened: print what is folded shut.
(() => {
  "use strict";
  const page = document.documentElement;
  let shown, folded;
  window.addEventListener("beforeprint", () => {
    shown = page.dataset.theme;
    page.dataset.theme = "light";
    folded = document.querySelectorAll("details.hide:not([open])");
    folded.forEach((part) => (part.open = true));
  });
  window.addEventListener("afterprint", () => {
    page.dataset.theme = shown;
    folded.forEach((part) => (part.open = false));
  });
})();

// What is wider than the page can be scrolled by the keyboard too: a formula, a table, a line of code.
(() => {
  "use strict";
  const WIDE = ".math, pre, .pst-scrollable-table-container, .cell_output > .output, .plotly-figure";
  const reach = () =>
    document.querySelectorAll(WIDE).forEach((part) => {
      if (part.scrollWidth > part.clientWidth) part.tabIndex = 0;
      else part.removeAttribute("tabindex");
    });
  window.addEventListener("load", reach);
  window.addEventListener("resize", reach);
  document.addEventListener("toggle", reach, true); // what was folded shut had no width
})();
