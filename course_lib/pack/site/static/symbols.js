// The meanings of a formula's symbols: under the pointer, on a tap, and in a list that a button
// opens. The page holds them, hidden, and each formula names its symbols.
(() => {
  "use strict";
  const glossary = document.getElementById("course-symbols");
  if (!glossary) return;
  const WAIT = 350; // milliseconds for which the pointer rests before anything is shown
  const meanings = new Map();
  for (const line of glossary.children) {
    for (const name of line.dataset.names.split(" ")) {
      meanings.set(name, [...(meanings.get(name) || []), line]);
    }
  }

  /** Return the lines of the glossary that a formula's symbols have. */
  function linesOf(formula) {
    const symbols = formula.dataset.symbols.split(" ");
    // Of "k_1|k" the first name counts that the glossary knows.
    const names = symbols.map((symbol) => symbol.split("|").find((name) => meanings.has(name)));
    return [...new Set(names.flatMap((name) => meanings.get(name) || []))];
  }

  function listOf(lines) {
    const list = document.createElement("dl");
    list.append(...lines.map((line) => line.cloneNode(true)));
    return list;
  }

  const note = document.createElement("div");
  note.className = "symbols-note";
  note.hidden = true;
  document.body.append(note);
  let shownFor = null;
  let timer = 0;

  function show(formula) {
    const lines = linesOf(formula);
    hide();
    if (!lines.length) return;
    shownFor = formula;
    note.replaceChildren(listOf(lines));
    note.hidden = false;
    const place = formula.getBoundingClientRect();
    const room = document.documentElement.clientWidth - note.offsetWidth - 8;
    const isBelow = place.bottom + note.offsetHeight + 8 < window.innerHeight;
    const top = isBelow ? place.bottom + 4 : place.top - note.offsetHeight - 4;
    note.style.left = `${window.scrollX + Math.max(8, Math.min(place.left, room))}px`;
    note.style.top = `${window.scrollY + top}px`;
  }
  function hide() {
    clearTimeout(timer);
    note.hidden = true;
    shownFor = null;
  }
  function later(work) {
    clearTimeout(timer);
    timer = setTimeout(work, WAIT);
  }

  const formulaAt = (target) => target.closest?.("article .math[data-symbols]");
  document.addEventListener("pointerover", ({ target, pointerType }) => {
    if (pointerType !== "mouse") return;
    const formula = formulaAt(target);
    if (note.contains(target) || (formula && formula === shownFor)) clearTimeout(timer);
    else if (formula) later(() => show(formula));
    else if (note.hidden) clearTimeout(timer);
    else later(hide);
  });
  document.addEventListener("click", ({ target }) => {
    // What is pressed for another purpose says nothing of symbols.
    const formula = target.closest("a, button, summary") ? null : formulaAt(target);
    if (formula && formula !== shownFor) show(formula);
    else if (!note.contains(target)) hide();
  });
  document.addEventListener("keydown", ({ key }) => {
    if (key === "Escape") hide();
  });

  // All symbols of the page, for readers who use a keyboard or a screen reader, and on a phone.
  const list = document.createElement("dialog");
  list.className = "symbols-list";
  list.setAttribute("aria-labelledby", "symbols-title");
  const title = document.createElement("h2");
  title.id = "symbols-title";
  title.textContent = "Symbols on this page";
  const close = document.createElement("button");
  close.type = "button";
  close.className = "btn symbols-close";
  close.textContent = "Close";
  close.addEventListener("click", () => list.close());
  list.addEventListener("click", ({ target }) => {
    if (target === list) list.close(); // beside it
  });
  list.append(close, title, listOf([...glossary.children]));
  document.body.append(list);

  const button = document.createElement("button");
  button.type = "button";
  button.className = "btn symbols-button";
  button.textContent = "Symbols";
  button.setAttribute("aria-haspopup", "dialog");
  button.addEventListener("click", () => list.showModal());
  document.querySelector(".article-header-buttons")?.prepend(button);
})();
