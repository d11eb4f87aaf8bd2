// A stage: a canvas with words and handles above it. The plane and space are stages with a way to
// draw of their own.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const { COLOURS, tint, wordTint } = globalThis.course.palette;
  const LEAST_HEIGHT = 130; // pixels
  const WORD_HEIGHT = 18; // pixels, as in the style
  // Where a word moves if it would cover another, in its own widths and heights, the nearest first.
  const ASIDE = [
    [0, 0],
    [0, -1],
    [0, 1],
    [1, 0],
    [-1, 0],
    [1, -1],
    [-1, -1],
    [1, 1],
    [-1, 1],
    [0, -2],
    [0, 2],
  ];
  // A wide word stays above its place, or below it: beside it, it would seem to name a neighbour.
  const MAX_NARROW = 36; // pixels
  const ABOVE_OR_BELOW = [0, -1, -2, 1, 2].map((down) => [0, down]);
  const ASIDE_IF_WIDE = [...ABOVE_OR_BELOW, ...ASIDE.filter(([across]) => across !== 0)];

  /**
   * A stage in `parent`.
   * @param {{label: string, proportion: number | (() => number), redraw: () => void, attributes?:
   *   object}} options label: what it shows, for readers who do not see it; proportion: its height
   *   in widths, or a function that returns it; redraw is called when its width changes;
   *   attributes: of the canvas
   * @returns {object} width, height (pixels of the page), dense (dots a pixel), share (of its full
   *   height), held (whether something is dragged), begin, word, end, handle, stop
   */
  P.stage = (parent, { label, proportion, redraw, attributes = {} }) => {
    P.useStyle();
    const box = P.element("div", { class: "course-stage" }, parent);
    const spoken = label.replace(/\.$/, "");
    const canvas = P.element("canvas", { role: "img", "aria-label": spoken, ...attributes }, box);
    const context = canvas.getContext("2d");
    const placeHandles = [];
    const wordNodes = [];
    let words = [];

    const stage = { box, canvas, context, width: 300, height: 240, dense: 1, share: 1, held: null };

    /** Measure the stage, and forget the words of the picture before. */
    stage.begin = () => {
      stage.dense = Math.min(window.devicePixelRatio || 1, 2);
      stage.width = box.clientWidth || 300;
      const shape = typeof proportion === "function" ? proportion() : proportion;
      const fullHeight = stage.width * shape;
      const least = Math.min(fullHeight, LEAST_HEIGHT);
      stage.height = Math.round(Math.max(least, stage.share * fullHeight));
      canvas.style.height = `${stage.height}px`;
      const width = Math.round(stage.width * stage.dense);
      const height = Math.round(stage.height * stage.dense);
      // Setting the size clears the canvas, also to the same size.
      if (canvas.width !== width || canvas.height !== height) {
        canvas.width = width;
        canvas.height = height;
      }
      words = [];
    };

    /** Write words near a pixel; `end` moves them aside if they would cover others. */
    stage.word = (pixel, text, colour = COLOURS.black) => {
      words.push({ pixel, text, colour });
    };

    stage.end = () => {
      placeWords();
      for (const place of placeHandles) place();
    };

    function placeWords() {
      const taken = [];
      words.forEach(({ pixel, text, colour }, i) => {
        wordNodes[i] ??= P.element("span", { class: "word", "aria-hidden": "true" }, box);
        const node = wordNodes[i];
        if (node.textContent !== text) node.textContent = text;
        const width = node.offsetWidth || 8 * text.length;
        const [x, y] = freePlace(pixel, width, taken);
        taken.push({ x, y, width });
        node.style.transform = `translate(${x - width / 2}px,${y - WORD_HEIGHT / 2}px)`;
        node.style.color = wordTint(colour);
      });
      for (const node of wordNodes.splice(words.length)) node.remove();
    }

    /**
     * The centre of a word of a width: the nearest place to a pixel at which it covers no other, if
     * there is one.
     */
    function freePlace([x, y], width, taken) {
      const moves = width > MAX_NARROW ? ASIDE_IF_WIDE : ASIDE;
      const places = moves.map(([across, down]) => [
        P.clamp(x + width * across, width / 2, stage.width - width / 2),
        P.clamp(y + WORD_HEIGHT * down, WORD_HEIGHT / 2, stage.height - WORD_HEIGHT / 2),
      ]);
      const isFree = ([u, v]) =>
        taken.every((word) => {
          const isBeside = Math.abs(word.x - u) >= (word.width + width) / 2;
          return isBeside || Math.abs(word.y - v) >= WORD_HEIGHT;
        });
      return places.find(isFree) ?? places[0];
    }

    /**
     * A handle to drag, or to move by the arrow keys (Shift: five times as far).
     * @param {{name: string, colour: string, small?: boolean, open?: boolean, at: () => number[],
     *   moved: (position: number[]) => void, describe?: () => string, stride: number}} options at:
     *   its position; moved is called with another one; describe: where it is, in words; stride: a
     *   step of the keys; open: what lies below it is seen through it
     * @param {{toPixels: Function, fromPixels: Function, step: Function}} view toPixels(position)
     *   -> pixel; fromPixels(pixel, position before) -> position; step(position, [across, upwards])
     *   -> position
     */
    stage.handle = (options, { toPixels, fromPixels, step }) => {
      const { name, colour, small, open, at, moved, describe, stride } = options;
      const node = P.element("div", { class: "handle", tabindex: 0, role: "application" }, box);
      node.classList.toggle("small", Boolean(small));
      node.classList.toggle("open", Boolean(open));
      node.setAttribute("aria-roledescription", "handle");

      function place() {
        const [x, y] = toPixels(at());
        node.style.transform = `translate(${x}px,${y}px)`;
        node.style.setProperty("--colour", tint(colour));
        const position = describe ? describe() : P.metres(at());
        node.setAttribute("aria-label", `${name}: ${position}`);
      }
      function change(position) {
        moved(position);
        place();
        redraw();
      }

      let grip = null; // from the pointer to the handle's middle, while it is dragged
      node.addEventListener("pointerdown", (event) => {
        node.setPointerCapture(event.pointerId);
        stage.held = true;
        grip = M.subtract(toPixels(at()).slice(0, 2), P.pixelOf(event, box));
        node.focus({ preventScroll: true });
        event.preventDefault();
      });
      node.addEventListener("pointermove", (event) => {
        if (!grip) return;
        const [x, y] = M.add(P.pixelOf(event, box), grip);
        const inside = [P.clamp(x, 0, stage.width), P.clamp(y, 0, stage.height)];
        change(fromPixels(inside, at()));
      });
      P.onRelease(node, () => {
        stage.held = null;
        grip = null;
        redraw();
      });
      P.onKeys(node, (direction, { shiftKey }) => {
        if (!direction) return false;
        const length = shiftKey ? 5 * stride : stride;
        change(step(at(), M.scale(direction, length)));
        return true;
      });
      placeHandles.push(place);
      return node;
    };

    const observer = new ResizeObserver(() => {
      if (box.isConnected && box.clientWidth !== stage.width) redraw();
    });
    observer.observe(box);
    stage.stop = () => {
      observer.disconnect();
      box.remove();
    };
    return stage;
  };
})();
