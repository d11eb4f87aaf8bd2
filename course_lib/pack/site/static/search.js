// Find the sections that contain all words, and show the sentence around the first one. The link opens the page at
// the section and marks the words. The sections are in sections.js, as [page, title, id, heading, text, whether on an error].
(() => {
  "use strict";
  const field = document.getElementById("search-words");
  const list = document.getElementById("search-results");
  const count = document.getElementById("search-count");
  const MOST = 60;

  const plain = (text) => text.toLowerCase().normalize("NFD").replace(/[\u0300-\u036f]/g, "");
  const times = (text, word) => text.split(word).length - 1;

  function find(words) {
    return window.courseSections
      .map(([page, title, id, heading, text, onErrors]) => {
        const [head, body] = [plain(heading), plain(text)];
        if (!words.every((word) => head.includes(word) || body.includes(word))) return null;
        const points = words.reduce((sum, word) => sum + 20 * times(head, word) + Math.min(10, times(body, word)), 0)
          - (onErrors ? 15 : 0); // what teaches a thing comes before an error about it
        return { page, title, id, heading, text, body, points };
      })
      .filter(Boolean)
      .sort((a, b) => b.points - a.points);
  }

  // The sentence around a word, or as much of it as can be read at a glance.
  function sentence(text, body, words) {
    const first = words.map((word) => body.indexOf(word)).find((place) => place >= 0);
    if (first === undefined || body.length !== text.length) return text.slice(0, 160).replace(/\s\S*$/, "");
    const before = Math.max(text.lastIndexOf(". ", first) + 1, first - 120, 0);
    const end = text.indexOf(". ", first);
    const whole = end < 0 ? text.length : end + 1, most = first + 140;
    const after = whole <= most ? whole : text.lastIndexOf(" ", most); // no word is cut
    const from = before && text[before - 1] !== "." ? text.indexOf(" ", before) + 1 : before;
    return (from && text[from - 1] !== "." && text[from - 2] !== "." ? "… " : "") + text.slice(from, after).trim()
      + (after < whole ? " …" : "");
  }

  function mark(parent, text, words) {
    const pattern = words.map((word) => word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")).join("|");
    text.split(new RegExp(`(${pattern})`, "i")).forEach((part, i) => {
      parent.append(i % 2 ? Object.assign(document.createElement("mark"), { textContent: part }) : part);
    });
  }

  function show() {
    const words = plain(field.value).split(/\s+/).filter((word) => word.length > 1);
    list.replaceChildren();
    const found = words.length ? find(words) : [];
    count.textContent = !words.length ? "" : found.length === 0 ? "No section holds all of these words."
      : found.length === 1 ? "One section." : `${found.length} sections${found.length > MOST ? `; the first ${MOST}:` : "."}`;
    found.slice(0, MOST).forEach((section) => {
      const item = document.createElement("li");
      const link = document.createElement("a");
      link.href = `${section.page}?mark=${encodeURIComponent(words.join(" "))}#${section.id}`;
      mark(link, section.heading === section.title ? section.title : `${section.title}: ${section.heading}`, words);
      const line = document.createElement("p");
      mark(line, sentence(section.text, section.body, words), words);
      item.append(link, line);
      list.append(item);
    });
  }

  field.value = new URLSearchParams(location.search).get("q") || "";
  field.addEventListener("input", show);
  field.form.addEventListener("submit", (event) => (event.preventDefault(), show()));
  field.focus();
  show();
})();
