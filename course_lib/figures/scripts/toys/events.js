// Frames, keys and pointers, and questions to the kernel.
(() => {
  "use strict";
  const P = globalThis.course.parts;

  /** A function that calls `draw` in the next frame, at most once a frame. */
  P.once = (draw) => {
    let isWaiting = false;
    return () => {
      if (isWaiting) return;
      isWaiting = true;
      requestAnimationFrame(() => {
        isWaiting = false;
        draw();
      });
    };
  };

  const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

  /**
   * Call act(direction, event) for each key that goes down, with the direction of an arrow key or
   * undefined. The page and JupyterLab do not get those keys for which it returns something true.
   */
  P.onKeys = (node, act) => {
    node.addEventListener("keydown", (event) => {
      if (!act(ARROWS[event.key], event)) return;
      event.preventDefault();
      event.stopPropagation();
    });
  };

  /** Whether JupyterLab runs the cell by this key, or saves the notebook. */
  const runsOrSaves = ({ key, shiftKey, ctrlKey, metaKey }) => {
    const isWithCtrl = ctrlKey || metaKey;
    return (key === "Enter" && (shiftKey || isWithCtrl)) || (key === "s" && isWithCtrl);
  };

  /**
   * Keep the keys that an input uses from JupyterLab, which would take them for commands. After a
   * slider was moved, Shift+Enter goes on to the next cell all the same.
   */
  P.keepKeys = (node) => {
    node.addEventListener("keydown", (event) => {
      if (!runsOrSaves(event)) event.stopPropagation();
    });
  };

  P.onRelease = (node, act) => {
    node.addEventListener("pointerup", act);
    node.addEventListener("pointercancel", act);
  };

  /** Where the pointer is, in pixels from the upper left corner of a node. */
  P.pixelOf = ({ clientX, clientY }, node) => {
    const { left, top } = node.getBoundingClientRect();
    return [clientX - left, clientY - top];
  };

  const MAX_TREMBLE = 4; // pixels between press and release of a click that is no drag

  /** Call act with the place in a plane of a click on it that was no drag. */
  P.onClick = (plane, act) => {
    let pressed = null;
    plane.box.addEventListener("pointerdown", ({ clientX, clientY }) => {
      pressed = [clientX, clientY];
    });
    plane.box.addEventListener("click", (event) => {
      if (!pressed) return;
      const way = Math.hypot(pressed[0] - event.clientX, pressed[1] - event.clientY);
      if (way > MAX_TREMBLE) return;
      act(plane.fromPixels(P.pixelOf(event, plane.box)));
    });
  };

  P.clamp = (x, low, high) => Math.min(high, Math.max(low, x));

  /**
   * A function that asks the kernel: one question at a time, and of those that come meanwhile only
   * the newest.
   * @param {{ask: (question: object) => void, onAnswer: (act: (answer: object) => void) => void} |
   *   null} kernel
   */
  P.asker = (kernel, onAnswer) => {
    if (!kernel) return () => {};
    let isBusy = false;
    let waiting = null;
    function ask(question) {
      if (isBusy) {
        waiting = question;
        return;
      }
      isBusy = true;
      kernel.ask(question);
    }
    kernel.onAnswer((answer) => {
      isBusy = false;
      onAnswer(answer);
      const question = waiting;
      waiting = null;
      if (question) ask(question);
    });
    return ask;
  };
})();
