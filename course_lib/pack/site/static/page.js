// Print in the light theme, whatever the screen shows.
(() => {
  "use strict";
  const page = document.documentElement;
  let themeOnScreen;
  window.addEventListener("beforeprint", () => {
    themeOnScreen = page.dataset.theme;
    page.dataset.theme = "light";
  });
  window.addEventListener("afterprint", () => {
    page.dataset.theme = themeOnScreen;
  });
})();

// Open what a link or a search leads into, sections and answers alike; not every browser does that
// unasked.
(() => {
  "use strict";
  /** Open all that an element is folded into, and itself. */
  function unfold(element) {
    let fold = element.closest("details");
    while (fold) {
      fold.open = true;
      fold = fold.parentElement.closest("details");
    }
  }
  function arrive() {
    const part = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    // A word that was searched for; Sphinx marks it soon after the page is there.
    const word = (part || document).querySelector("article .highlighted");
    if (!part && !word) return;
    unfold(word || part.querySelector(":scope > details") || part);
    (word || part).scrollIntoView();
  }
  window.addEventListener("hashchange", arrive);
  window.addEventListener("DOMContentLoaded", () => setTimeout(arrive, 50));
  // A link to the place where one is already changes no hash.
  document.addEventListener("click", ({ target }) => {
    const link = target.closest('a[href^="#"]');
    if (link?.hash && link.hash === location.hash) arrive();
  });
})();

// What is wider than the page can be scrolled by the keyboard too: a formula, a table, a line of
// code.
(() => {
  "use strict";
  const WIDE = ".math, pre, .pst-scrollable-table-container, .cell_output > .output";
  function makeReachable() {
    for (const part of document.querySelectorAll(WIDE)) {
      if (part.scrollWidth > part.clientWidth) part.tabIndex = 0;
      else part.removeAttribute("tabindex");
    }
  }
  window.addEventListener("load", makeReachable);
  window.addEventListener("resize", makeReachable);
  document.addEventListener("toggle", makeReachable, true); // folded content had no width
})();
