// Print in the light theme, whatever the screen shows, and unfold everything for print.
(() => {
  "use strict";
  const page = document.documentElement;
  let shown, folded;
  window.addEventListener("beforeprint", () => {
    shown = page.dataset.theme;
    page.dataset.theme = "light";
    folded = document.querySelectorAll(".bd-article details:not([open])");
    folded.forEach((part) => (part.open = true));
  });
  window.addEventListener("afterprint", () => {
    page.dataset.theme = shown;
    folded.forEach((part) => (part.open = false));
  });
})();

// Open what a link or a search leads into, sections and answers alike; not every browser does that by itself.
(() => {
  "use strict";
  const unfold = (part) => {
    for (let e = part && part.closest("details"); e; e = e.parentElement.closest("details")) e.open = true;
  };
  const arrive = () => {
    const part = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!part) return;
    unfold(part.querySelector(":scope > details") || part);
    part.scrollIntoView();
  };
  window.course = window.course || { kinds: {} };
  window.course.unfold = unfold;
  window.addEventListener("hashchange", arrive);
  window.addEventListener("DOMContentLoaded", arrive);
  // A link to the place where one is already changes no hash.
  document.addEventListener("click", ({ target }) => {
    const link = target.closest('a[href^="#"]');
    if (link && link.hash === location.hash && link.hash) arrive();
  });
})();

// What is wider than the page can be scrolled by the keyboard too: a formula, a table, a line of code, a row of panels.
(() => {
  "use strict";
  const WIDE = ".math, pre, .pst-scrollable-table-container, .cell_output > .output, .plotly-figure, .panels";
  const reach = () =>
    document.querySelectorAll(WIDE).forEach((part) => {
      if (part.scrollWidth > part.clientWidth) part.tabIndex = 0;
      else part.removeAttribute("tabindex");
    });
  window.addEventListener("load", reach);
  window.addEventListener("resize", reach);
  document.addEventListener("toggle", reach, true); // folded content had no width
})();

// Mark the words of the search on the page that it leads to, in folded content too.
(() => {
  "use strict";
  const wanted = (new URLSearchParams(location.search).get("mark") || "").split(/\s+/).filter(Boolean);
  if (!wanted.length) return;
  const pattern = new RegExp(`(${wanted.map((word) => word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")).join("|")})`, "i");
  window.addEventListener("DOMContentLoaded", () => {
    const section = document.getElementById(decodeURIComponent(location.hash.slice(1))) || document.querySelector("article");
    const walk = document.createTreeWalker(section, NodeFilter.SHOW_TEXT, (node) =>
      pattern.test(node.data) && !node.parentElement.closest("script, style, svg, summary:not(.more), .math, .plotly-figure")
        ? NodeFilter.FILTER_ACCEPT
        : NodeFilter.FILTER_REJECT);
    const found = [];
    while (walk.nextNode()) found.push(walk.currentNode);
    found.forEach((node) => {
      const parts = node.data.split(pattern).map((part, i) =>
        i % 2 ? Object.assign(document.createElement("mark"), { textContent: part }) : part);
      window.course.unfold(node.parentElement);
      node.replaceWith(...parts);
    });
    const first = section.querySelector("mark");
    if (first) first.scrollIntoView({ block: "center" });
  });
})();
