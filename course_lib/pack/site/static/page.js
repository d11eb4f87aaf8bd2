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
  // The words that a link of the search names. Sphinx's script, which waits for the page, marks them
  // in the text. It would also read them from the address, but changes the address then, which
  // browsers refuse to pages in a folder.
  const words = new URLSearchParams(location.search).get("find") || "";
  if (words) localStorage.setItem("sphinx_highlight_terms", words);
  /** Mark the formulas that hold a word that was searched for. */
  function markFormulas() {
    for (const formula of document.querySelectorAll("article .math:has(math)")) {
      const mathml = formula.querySelector("math").textContent;
      // Without spaces, and without the signs for what is not printed, such as an applied function.
      const text = mathml.replace(/[\s\u2061-\u2064]/g, "").toLowerCase();
      const holds = (word) => word && text.includes(word);
      if (words.toLowerCase().split(/\s+/).some(holds)) formula.classList.add("highlighted");
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
  window.addEventListener("DOMContentLoaded", () => {
    if (words) markFormulas();
    setTimeout(arrive, 50);
  });
  // A link to the place where one is already changes no hash.
  document.addEventListener("click", ({ target }) => {
    const link = target.closest('a[href^="#"]');
    if (link?.hash && link.hash === location.hash) arrive();
  });
})();

// A formula that is a little too wide for its place is set smaller, because its end would be out of
// sight there. One that is much too wide keeps its size, and scrolls.
(() => {
  "use strict";
  const SMALLEST = 0.85; // of a formula's size: its indices are then as large as the smallest words
  const RIM = 2; // pixels, for widths are rounded
  function shrinkFormulas() {
    const formulas = [...document.querySelectorAll("article :is(div.math, .math.wide)")];
    for (const { style } of formulas) style.fontSize = "";
    const isTooWide = ({ scrollWidth, clientWidth }) => scrollWidth > clientWidth;
    const shares = formulas.map((formula) =>
      isTooWide(formula) ? (formula.clientWidth - RIM) / formula.scrollWidth : 1,
    );
    formulas.forEach(({ style }, i) => {
      if (shares[i] >= SMALLEST && shares[i] < 1) style.fontSize = `${shares[i]}em`;
    });
  }
  window.addEventListener("load", shrinkFormulas);
  window.addEventListener("resize", shrinkFormulas);
  document.addEventListener("toggle", shrinkFormulas, true); // folded content had no width
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
