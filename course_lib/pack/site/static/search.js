// Find the sections that contain all words, and show the sentence around the first one. The link opens the page at
// the section, where Sphinx marks the words. The sections are in sections.js, each as
// [page, title, id, heading, text, whether on an error].
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
        return { page, title, id, heading, text, points };
      })
      .filter(Boolean)
      .sort((a, b) => b.points - a.points);
  }

  // The sentence with the first of the words in it, or as much of it as can be read at a glance.
  const SENTENCES = new Intl.Segmenter("en", { granularity: "sentence" }), LONGEST = 260;
  function sentence(text, words) {
    const sentences = [...SENTENCES.segment(text)].map((each) => each.segment.trim());
    const found = sentences.find((each) => words.some((word) => plain(each).includes(word))) || sentences[0] || "";
    if (found.length <= LONGEST) return found;
    const at = words.map((word) => plain(found).indexOf(word)).find((place) => place >= 0) || 0;
    const start = Math.max(0, at - 120), part = found.slice(start, start + LONGEST).replace(/\s\S*$/, " …");
    return start ? part.replace(/^\S*/, "…") : part; // no word is cut
  }

  function show() {
    const words = plain(field.value).split(/\s+/).filter((word) => word.length > 1);
    list.replaceChildren();
    const found = words.length ? find(words) : [];
    const more = found.length > MOST ? `; the first ${MOST}:` : ".";
    count.textContent = !words.length ? "" : found.length === 0 ? "No section holds all of these words."
      : found.length === 1 ? "One section." : `${found.length} sections${more}`;
    found.slice(0, MOST).forEach((section) => {
      const item = document.createElement("li");
      const link = document.createElement("a");
      link.href = `${section.page}?highlight=${encodeURIComponent(words.join(" "))}#${section.id}`;
      link.textContent = section.heading === section.title ? section.title : `${section.title}: ${section.heading}`;
      const line = document.createElement("p");
      line.textContent = sentence(section.text, words);
      item.append(link, line);
      list.append(item);
    });
    words.forEach((word) => _highlightText(list, word, "highlighted")); // Sphinx's
  }

  field.value = new URLSearchParams(location.search).get("q") || "";
  field.addEventListener("input", show);
  field.form.addEventListener("submit", (event) => (event.preventDefault(), show()));
  field.focus();
  show();
})();
