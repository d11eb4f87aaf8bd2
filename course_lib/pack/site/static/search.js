// The search: sections that hold all words of a question, each with its heading and a line of
// context. Words are found as they are written, symbols and numbers too: SO(3), θ, 0.1222.
(() => {
  "use strict";
  const CONTEXT = 90; // characters on each side of the first hit in a section
  const FEWER = [
    [/ices$/, "i(?:x|ces)"], // matrices, matrix
    [/ies$/, "(?:y|ies)"], // velocities, velocity
    [/([^s])s$/, "$1s?"], // rotations, rotation
  ];

  /** Return the pattern of a word of the question: from the beginning of a word or a number on. */
  function patternOf(word) {
    let pattern = word.replace(/[\\^$.*+?()[\]{}|/]/g, "\\$&");
    if (/^\p{L}{4,}$/u.test(word)) {
      const rule = FEWER.find(([ending]) => ending.test(word));
      if (rule) pattern = word.replace(...rule);
    }
    // Thousands may be set apart: 50,000 and 50000 are the same number.
    if (/^\d/.test(word)) {
      pattern = pattern.replace(/(\d),(?=\d)/g, "$1").replace(/(\d)(?=\d)/g, "$1[,\u2009\u202f]?");
    }
    if (/^\p{L}/u.test(word)) return new RegExp(`(?<!\\p{L})${pattern}`, "giu");
    if (/^\d/.test(word)) return new RegExp(`(?<![\\d.])${pattern}`, "giu");
    return new RegExp(pattern, "giu");
  }

  function judge(section, patterns) {
    const hits = patterns.map((pattern) => [...section.text.matchAll(pattern)]);
    let words = 0;
    let score = 0;
    patterns.forEach((pattern, number) => {
      const inTitle = section.title.search(pattern) >= 0;
      const inPage = section.page.search(pattern) >= 0;
      if (hits[number].length || inTitle) words += 1;
      score += 20 * inTitle + 10 * inPage + Math.min(hits[number].length, 8);
    });
    return { section, hits: hits.flat(), words, score };
  }

  function lineOf(text, hits) {
    const line = document.createElement("p");
    const first = Math.min(...hits.map(({ index }) => index));
    const begin = Math.max(0, text.lastIndexOf(" ", Math.max(0, first - CONTEXT)) + 1);
    const space = text.indexOf(" ", first + CONTEXT);
    const end = space < 0 ? text.length : space;
    let from = begin;
    line.append(begin ? "… " : "");
    for (const hit of hits.sort((a, b) => a.index - b.index)) {
      const until = hit.index + hit[0].length;
      if (hit.index < from || until > end) continue;
      const mark = document.createElement("mark");
      mark.textContent = hit[0];
      line.append(text.slice(from, hit.index), mark);
      from = until;
    }
    line.append(text.slice(from, end), end < text.length ? " …" : "");
    return line;
  }

  function itemOf({ section, hits }) {
    const item = document.createElement("li");
    const link = document.createElement("a");
    const [page, anchor] = section.link.split("#");
    // What is marked on the page is what was found there, as it is written there.
    const found = [...new Set(hits.map(([words]) => words.toLowerCase()))].slice(0, 8);
    const query = found.length ? `?${new URLSearchParams({ find: found.join(" ") })}` : "";
    link.href = `${page}${query}${anchor ? `#${anchor}` : ""}`;
    link.textContent =
      section.title === section.page ? section.page : `${section.page} › ${section.title}`;
    item.append(link);
    if (hits.length) item.append(lineOf(section.text, hits));
    return item;
  }

  function search(question) {
    const patterns = question.split(/\s+/).filter(Boolean).map(patternOf);
    const judged = window.courseSections.map((section) => judge(section, patterns));
    const most = Math.max(...judged.map(({ words }) => words));
    const found = most ? judged.filter(({ words }) => words === most) : [];
    found.sort((a, b) => b.score - a.score);
    document.getElementById("search-results").replaceChildren(...found.map(itemOf));
    let summary = `${found.length} ${found.length === 1 ? "section" : "sections"}`;
    if (!found.length) summary = "No page holds these words. Try fewer letters, or another word.";
    else if (most < patterns.length) summary += `, with ${most} of the ${patterns.length} words`;
    document.getElementById("search-summary").textContent = summary;
  }

  const field = document.querySelector(".bd-search-container form.bd-search input");
  const question = (new URLSearchParams(location.search).get("q") || "").trim();
  field.value = question;
  field.focus();
  if (question) search(question);
})();
