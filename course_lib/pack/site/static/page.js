// Print in the light theme, whatever the screen shows.
(() => {
  "use strict";
  const page = document.documentElement;
  let shown;
  window.addEventListener("beforeprint", () => {
    shown = page.dataset.theme;
    page.dataset.theme = "light";
  });
  window.addEventListener("afterprint", () => (page.dataset.theme = shown));
})();

// Open what a link or a search leads into, sections and answers alike; not every browser does that by itself.
(() => {
  "use strict";
  const unfold = (part) => {
    for (let e = part && part.closest("details"); e; e = e.parentElement.closest("details"))
      e.open = true;
  };
  const arrive = () => {
    const part = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const found = (part || document).querySelector("article .highlighted"); // by Sphinx, soon after the page is there
    if (!part && !found) return;
    unfold(found || part.querySelector(":scope > details") || part);
    (found || part).scrollIntoView();
  };
  window.addEventListener("hashchange", arrive);
  window.addEventListener("DOMContentLoaded", () => setTimeout(arrive, 50));
  // A link to the place where one is already changes no hash.
  document.addEventListener("click", ({ target }) => {
    const link = target.closest('a[href^="#"]');
    if (link && link.hash === location.hash && link.hash) arrive();
  });
})();

// What is wider than the page can be scrolled by the keyboard too: a formula, a table, a line of code.
(() => {
  "use strict";
  const WIDE = ".math, pre, .pst-scrollable-table-container, .cell_output > .output";
  const reach = () =>
    document.querySelectorAll(WIDE).forEach((part) => {
      if (part.scrollWidth > part.clientWidth) part.tabIndex = 0;
      else part.removeAttribute("tabindex");
    });
  window.addEventListener("load", reach);
  window.addEventListener("resize", reach);
  document.addEventListener("toggle", reach, true); // folded content had no width
})();
