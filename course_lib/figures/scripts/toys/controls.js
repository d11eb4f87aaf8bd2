// The controls of a card: ranges, buttons, checkboxes, and fields in which a toy writes.
(() => {
  "use strict";
  const P = globalThis.course.parts;

  /**
   * @param {object} card whose `controls` is an element; card.draw() is called after every change
   * @returns {object} what makes controls, one method for each kind
   */
  P.controlsOf = (card) => {
    const { controls, draw } = card;
    let rangesGoTo = controls; // or the part that is folded away
    let buttonRow = null;

    /** The grid of ranges, a new one if something else came since. */
    function settings() {
      const last = rangesGoTo.lastChild;
      if (last?.className === "settings") return last;
      return P.element("div", { class: "settings" }, rangesGoTo);
    }
    function buttons() {
      buttonRow ??= P.element("div", { class: "buttons" }, controls);
      return buttonRow;
    }
    /** The row of buttons, above what the toy writes where there was none. */
    function lastButton(label, press) {
      buttons();
      const [firstField] = card.fields;
      if (buttonRow === controls.lastChild) controls.insertBefore(buttonRow, firstField ?? null);
      const node = P.element("button", { type: "button" }, buttonRow, label);
      node.addEventListener("click", press);
      P.keepKeys(node);
      return node;
    }

    /** Fold away the ranges that `fill` makes, below a line that opens them. */
    function fold(label, fill) {
      const part = P.element("details", {}, controls);
      P.element("summary", {}, part, label);
      rangesGoTo = part;
      fill();
      rangesGoTo = controls;
      P.keepKeys(part);
    }

    /**
     * A labelled range.
     * @param {{value: number, keys?: number, min: number, max: number, step: number}} limits an
     *   arrow key moves it by a step, or to the next multiple of `keys`
     * @param {(value: number) => string} write its value in words
     * @param {(value: number) => void} change is called while it moves
     * @returns {{input: HTMLInputElement, set: (value: number) => void}} set does not call `change`
     */
    function range(label, { value, keys, ...limits }, write, change) {
      const row = P.element("div", { class: "setting" }, settings());
      const text = P.element("label", {}, row, `${label} `);
      const input = P.element("input", { type: "range", ...limits }, row);
      const output = P.element("output", {}, row);
      input.id = `toy-${Math.random().toString(36).slice(2)}`; // for its label alone
      text.htmlFor = input.id;
      function show() {
        output.textContent = write(Number(input.value));
        input.setAttribute("aria-valuetext", output.textContent);
      }
      input.value = value;
      input.addEventListener("input", () => {
        change(Number(input.value));
        show();
        draw();
      });
      P.keepKeys(input);
      if (keys) stepByKeys(input, keys);
      show();
      function set(x) {
        input.value = x;
        show();
      }
      return { input, set };
    }
    function stepByKeys(input, step) {
      P.onKeys(input, (direction) => {
        if (!direction) return false;
        const isUpwards = direction[0] + direction[1] > 0;
        const steps = Number(input.value) / step;
        input.value = step * (isUpwards ? Math.floor(steps + 1) : Math.ceil(steps - 1));
        input.dispatchEvent(new Event("input"));
        return true;
      });
    }

    /** A range that sets state[key]. */
    function setting(label, state, key, limits, write) {
      return range(label, { value: state[key], ...limits }, write, (value) => {
        state[key] = value;
      });
    }
    /** A range of an angle in whole degrees. */
    function angle(label, state, key, min, max) {
      return setting(label, state, key, { min, max, step: 1 }, P.inDegrees);
    }
    /** A range from 0 to 1, in per cent. */
    function share(label, state, key) {
      return setting(label, state, key, { min: 0, max: 1, step: 0.01 }, P.percent);
    }

    function button(label, press) {
      const node = P.element("button", { type: "button" }, buttons(), label);
      node.addEventListener("click", () => {
        press();
        draw();
      });
      P.keepKeys(node);
      return node;
    }

    /** A checkbox that sets state[key]. */
    function checkbox(label, state, key) {
      const text = P.element("label", {}, buttons());
      const input = P.element("input", { type: "checkbox" }, text);
      input.checked = Boolean(state[key]);
      text.append(` ${label}`);
      input.addEventListener("change", () => {
        state[key] = input.checked;
        draw();
      });
      P.keepKeys(input);
    }

    /**
     * A field that shows lines.
     * @returns {(...lines: (string | string[])[]) => void} a line is plain text, or a list of text
     *   and HTML, which begins with "<"
     */
    function numbers() {
      const field = P.element("div", { class: "numbers" }, controls);
      card.fields.push(field);
      const toHtml = (part) => (part.startsWith("<") ? part : `<span>${P.escape(part)}</span>`);
      const toRow = (line) => `<div>${[line].flat().map(toHtml).join("")}</div>`;
      return (...lines) => {
        field.innerHTML = lines.map(toRow).join("");
      };
    }

    /**
     * A paragraph that screen readers announce when its text changes.
     * @param {string[]} texts some that it may show: there is room for the longest one from the
     *   beginning, so that nothing on the page moves when it comes
     */
    function words(texts = []) {
      const longest = texts.reduce((a, b) => (b.length > a.length ? b : a), "");
      const room = P.element("div", { class: "room", "data-longest": longest }, controls);
      card.fields.push(room);
      return P.element("p", { role: "status" }, room);
    }

    /**
     * A paragraph that names a goal, and ticks it from when it is reached until *Start again*.
     * @param {object} state of the toy
     * @param {string} sentence what to reach
     * @returns {(isThere: boolean) => void} is called with every picture
     */
    function goal(state, sentence) {
      const reached = `✓ Reached: ${sentence}`;
      const line = words([reached]);
      return (isThere) => {
        state.hasReachedGoal ||= isThere;
        line.textContent = state.hasReachedGoal ? reached : `Goal: ${sentence}`;
      };
    }

    return {
      fold,
      range,
      setting,
      angle,
      share,
      button,
      lastButton,
      checkbox,
      numbers,
      words,
      goal,
    };
  };
})();
