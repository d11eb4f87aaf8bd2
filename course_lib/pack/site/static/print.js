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
