// The card of a toy: views beside each other, controls below, then what it says in words.
(() => {
  "use strict";
  const P = globalThis.course.parts;
  const MAX_HEIGHT = 638; // pixels, of a card: what a laptop's window shows of a page
  const MAX_ROUNDS = 3; // of making the views less high
  const LEAST_SHARE = 0.3; // of a view's full height

  /**
   * Make a toy known: course.kinds["toy:<name>"] starts it.
   * @param {string} name
   * @param {string | ((meta: object) => string)} title what it is, for screen readers
   * @param {(card: object, meta: object, kernel: object | null) => () => void} build lays the toy
   *   out in its card and returns the function that paints it, which is called again after every
   *   change of a control or a handle
   */
  P.toy = (name, title, build) => {
    globalThis.course.kinds[`toy:${name}`] = (host, meta, kernel) => {
      const words = typeof title === "function" ? title(meta) : title;
      let card = null; // the one on the page
      function begin(isAgain) {
        let paint = () => {};
        const draw = P.once(() => begun.fit(paint));
        const begun = makeCard(host, meta, words, draw, isAgain);
        paint = build(begun, meta, kernel);
        if (begun.canChange()) addStartAgain(begun);
        begun.fit(paint);
        card = begun;
      }
      /** The button builds the toy anew, without what it kept, the view of a scene included. */
      function addStartAgain(begun) {
        const button = begun.lastButton("Start again", () => {
          begun.end();
          delete meta.state;
          delete meta.camera;
          begin(true);
          host.querySelector("button.again").focus({ preventScroll: true });
        });
        button.classList.add("again");
      }
      begin(false);
      return () => card.end();
    };
  };

  function makeCard(host, meta, title, draw, isAgain) {
    P.useStyle();
    const root = P.element(
      "div",
      { class: "course-toy", role: "group", "aria-label": title },
      host,
    );
    const views = P.element("div", { class: "views" }, root);
    const controls = P.element("div", { class: "controls" }, root);
    const stages = [];
    const endings = [];
    let fittedWidth = 0; // of the card, to which its views were fitted last

    function keep(stage) {
      stages.push(stage);
      endings.push(() => stage.stop());
      return stage;
    }

    /** Paint, and make the views less high until all of the card is in one window. */
    function fit(paint) {
      if (fittedWidth !== root.clientWidth) {
        for (const stage of stages) stage.share = 1;
        for (const field of card.fields) field.style.minHeight = "";
      }
      fittedWidth = root.clientWidth;
      paint();
      keepHeights();
      for (let round = 0; round < MAX_ROUNDS; round++) {
        const isDragging = stages.some(({ held }) => held);
        if (isDragging || !shrinkViews()) return;
        paint();
      }
    }
    /** A field that once was high stays so at this width: what is below it does not move. */
    function keepHeights() {
      for (const field of card.fields) {
        // With its fractions: a whole number would let what is below move by a pixel.
        field.style.minHeight = `${field.getBoundingClientRect().height}px`;
      }
    }
    /**
     * What a reader has opened may make the card longer than the window: the views stay as they
     * are.
     */
    function openedHeight() {
      let height = 0;
      for (const part of controls.querySelectorAll("details[open]")) {
        height += part.offsetHeight - part.querySelector("summary").offsetHeight;
      }
      return height;
    }
    /** Return whether a view became less high. */
    function shrinkViews() {
      const excess = root.offsetHeight - openedHeight() - MAX_HEIGHT;
      const height = views.offsetHeight;
      if (excess <= 0 || !height) return false;
      let isChanged = false;
      for (const stage of stages) {
        const share = Math.max(LEAST_SHARE, (stage.share * (height - excess - 3)) / height);
        isChanged ||= share !== stage.share;
        stage.share = share;
      }
      return isChanged;
    }

    const card = {
      root,
      views,
      controls,
      fields: [], // in which the toy writes
      draw,
      fit,
      /**
       * What the toy keeps while it is off the page: `initial`, or what it was when it left. After
       * *Start again* the keys of `again` have other values than in `initial`.
       */
      state(initial, again = {}) {
        // A copy, because the model stays as it is.
        meta.state ??= structuredClone(isAgain ? { ...initial, ...again } : initial);
        return meta.state;
      },
      /** Whether a reader can change something other than the view of a scene. */
      canChange: () => Boolean(root.querySelector("input, button, .handle")),
      /** A function that asks the kernel; its newest answer is `answer` of the state. */
      asker(kernel) {
        const ask = P.asker(kernel, (answer) => {
          meta.state.answer = answer;
          draw();
        });
        return (question) => {
          meta.state.asked = Boolean(kernel);
          ask(question);
        };
      },
      plane: ({ parent = views, ...options }) =>
        keep(P.plane(parent, { redraw: draw, ...options })),
      map: ({ parent = views, ...options }) => keep(P.map(parent, { redraw: draw, ...options })),
      space: ({ parent = views, ...options }) =>
        keep(P.space(parent, { redraw: draw, meta, ...options })),
      armSpace: (azimuth = -1) => P.armSpace(card, meta, azimuth),
      /** Call act when the toy leaves the page. */
      atEnd(act) {
        endings.push(act);
      },
      end() {
        card.halt();
        for (const act of endings) act();
        root.remove();
      },
    };
    return Object.assign(card, P.controlsOf(card), P.animationOf(card));
  }
})();
