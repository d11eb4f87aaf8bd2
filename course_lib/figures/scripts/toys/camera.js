// The view of space is changed by dragging, by the arrow keys, by two fingers, and by the wheel,
// with Ctrl or once the figure has the focus: else the page scrolls. Home and a double click turn
// it back. A body that can be taken is dragged instead. The first figure that is met on a page says
// so.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const P = globalThis.course.parts;
  const RADIANS_PER_PIXEL = 0.01;
  const RADIANS_PER_KEY = 0.1;
  const ZOOM_PER_KEY = 1.1;
  // Elevations: a little from below, and almost from above, where azimuth still means something.
  const LOWEST = -0.3;
  const HIGHEST = 1.5;
  const ZOOMS = [0.4, 6];
  const FINGER = 14; // pixels beside a finger in which a body is looked for, too
  const ASIDE = [
    [0, 0],
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ];

  const HINTS = {
    mouse:
      "Drag the picture to turn it. The wheel zooms after a click, or with Ctrl. " +
      "A double click turns it back.",
    touch:
      "Drag sideways to turn the picture, and zoom with two fingers. Tap twice to turn it back.",
    keys: "Arrow keys turn the picture, plus and minus zoom, and Home turns it back.",
  };
  const HINT_TIME = 7000; // milliseconds
  let isHinted = false; // on this page

  /** Write once on a page, in a picture, how one rotates a picture with a device. */
  function showHint(box, device) {
    if (isHinted) return;
    isHinted = true;
    const hint = P.element("div", { class: "hint", "aria-hidden": "true" }, box, HINTS[device]);
    setTimeout(() => hint.remove(), HINT_TIME);
  }

  /**
   * @param {object} view the stage
   * @param {{azimuth: number, elevation: number, zoom: number}} camera is changed
   * @param {{azimuth: number, elevation: number, zoom: number}} start to which it can be rotated
   *   back
   * @param {(pixel: number[]) => object | null} take the body at a pixel that can be dragged
   */
  P.moveCamera = (view, camera, start, take, redraw) => {
    const { box, canvas } = view;
    const fingers = new Map(); // {pointerId: where it was last}

    function rotate(across, upwards) {
      camera.azimuth += across;
      camera.elevation = P.clamp(camera.elevation + upwards, LOWEST, HIGHEST);
      redraw();
    }
    function zoom(factor) {
      camera.zoom = P.clamp(camera.zoom * factor, ...ZOOMS);
      redraw();
    }
    function turnBack() {
      Object.assign(camera, start);
      redraw();
    }
    /** The body at the pointer; for a finger, also a few pixels beside it. */
    function bodyAt(event, isFinger) {
      const pixel = P.pixelOf(event, canvas);
      const directions = isFinger ? ASIDE : ASIDE.slice(0, 1);
      for (const direction of directions) {
        const body = take(M.add(pixel, direction, FINGER));
        if (body) return body;
      }
      return null;
    }

    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      if (event.pointerType === "touch") showHint(box, "touch");
      if (!fingers.size && !view.held) view.held = bodyAt(event, event.pointerType === "touch");
      if (!view.held) fingers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    // A finger on a body scrolls no page.
    canvas.addEventListener(
      "touchstart",
      (event) => {
        if (bodyAt(event.touches[0], true)) event.preventDefault();
      },
      { passive: false },
    );

    let hovered = null;
    const showCursor = P.once(() => {
      canvas.style.cursor = hovered && take(hovered) ? "grab" : "move";
    });
    canvas.addEventListener("pointermove", (event) => {
      if (view.held) {
        const { held } = view;
        held.pixel = P.pixelOf(event, canvas);
        held.moved(held.follow(held.pixel));
        redraw();
        return;
      }
      if (!fingers.size && event.pointerType === "mouse") {
        hovered = P.pixelOf(event, canvas);
        showCursor();
        showHint(box, "mouse");
      }
      moveFinger(event);
    });
    /** One finger, or the mouse, rotates the view, two change the distance. */
    function moveFinger({ pointerId, clientX, clientY }) {
      const before = fingers.get(pointerId);
      if (!before) return;
      const now = [clientX, clientY];
      const other = [...fingers].find(([id]) => id !== pointerId);
      if (other) {
        const apart = M.norm(M.subtract(now, other[1]));
        const apartBefore = M.norm(M.subtract(before, other[1])) || 1;
        zoom(apart / apartBefore);
      } else {
        const [across, down] = M.subtract(now, before);
        rotate(-RADIANS_PER_PIXEL * across, RADIANS_PER_PIXEL * down);
      }
      fingers.set(pointerId, now);
    }
    P.onRelease(canvas, (event) => {
      fingers.delete(event.pointerId);
      if (view.held) redraw();
      view.held = null;
    });

    canvas.addEventListener(
      "wheel",
      (event) => {
        const isMeant = event.ctrlKey || document.activeElement === canvas;
        if (!isMeant) return; // the page scrolls
        event.preventDefault();
        zoom(Math.exp(-0.002 * event.deltaY));
      },
      { passive: false },
    );
    canvas.addEventListener("dblclick", turnBack);
    canvas.addEventListener("focus", () => {
      if (canvas.matches(":focus-visible")) showHint(box, "keys");
    });
    P.onKeys(canvas, (direction, { key }) => {
      if (direction) {
        rotate(...M.scale(direction, RADIANS_PER_KEY));
        return true;
      }
      if (key === "+" || key === "=") zoom(ZOOM_PER_KEY);
      else if (key === "-") zoom(1 / ZOOM_PER_KEY);
      else if (key === "Home") turnBack();
      else return false;
      return true;
    });
  };
})();
