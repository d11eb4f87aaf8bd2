// Figures that call the student's own function. What is dragged is a question; in a live notebook
// the function answers it, one question at a time, the newest first; if it raises or there is no
// kernel, the library's function answers. meta.figure names one of the figures, each of which is a
// file beside this one.
globalThis.course.alive = (() => {
  "use strict";
  const P = globalThis.course.parts;
  const FIGURES = {};

  /**
   * What a figure says of whose answer it shows.
   * @param {{answer?: object, asked?: boolean}} state of the card
   * @param {string} ofAnswer what the figure found out about the answer
   * @param {string} ofLibrary what it says where the library answers
   */
  function credit({ answer, asked }, ofAnswer, ofLibrary) {
    if (answer?.value) return `Answered by ${answer.whose}. ${ofAnswer}`;
    if (answer) return `${answer.problem} The library's answer is shown. ${ofLibrary}`;
    if (asked) return "Your function has not answered yet; the library's answer is shown.";
    return ofLibrary;
  }

  P.toy(
    "alive",
    (meta) => meta.title,
    (card, meta, kernel) => FIGURES[meta.figure](card, meta, card.asker(kernel)),
  );

  return { FIGURES, credit };
})();
