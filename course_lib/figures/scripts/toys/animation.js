// What moves without being dragged in a card, one motion at a time.
(() => {
  "use strict";
  const P = globalThis.course.parts;
  // With reduced motion, in which a motion that never ends would hold the page.
  const MAX_STEPS = 2000;

  /** @param {object} card with draw and button */
  P.animationOf = (card) => {
    let running = null; // an object that stands for the motion under way

    /**
     * Call step once a frame until it returns false or another run begins; with reduced motion all
     * at once.
     */
    function run(step) {
      halt();
      if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
        let steps = 0;
        while (steps < MAX_STEPS && step()) steps += 1;
        card.draw();
        return;
      }
      const motion = {};
      running = motion;
      function frame() {
        if (running !== motion) return;
        if (step()) requestAnimationFrame(frame);
        card.draw();
      }
      requestAnimationFrame(frame);
    }
    function halt() {
      running = null;
    }

    /**
     * A button that moves a range from its beginning to its end, by a share of it in each frame.
     */
    function player(label, { input }, share) {
      card.button(label, () => {
        const low = Number(input.min);
        const high = Number(input.max);
        let value = low;
        run(() => {
          value = Math.min(high, value + share * (high - low));
          input.value = value;
          input.dispatchEvent(new Event("input"));
          return value < high;
        });
      });
    }
    return { run, halt, player };
  };
})();
