// The view of space is changed by dragging, by the arrow keys, by two fingers, and by the wheel
// once the figure has the focus. A body that can be taken is dragged instead.
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

  /**
   * @param {object} view the stage
   * @param {{azimuth: number, elevation: number, zoom: number}} camera is changed
   * @param {(pixel: number[]) => object | null} take the body at a pixel that can be dragged
   */
  P.moveCamera = (view, camera, take, redraw) => {
    const { canvas } = view;
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
        if (document.activeElement !== canvas) return; // the page scrolls
        event.preventDefault();
        zoom(Math.exp(-0.002 * event.deltaY));
      },
      { passive: false },
    );
    P.onKeys(canvas, (direction, { key }) => {
      if (direction) {
        rotate(...M.scale(direction, RADIANS_PER_KEY));
        return true;
      }
      if (key === "+" || key === "=") zoom(ZOOM_PER_KEY);
      else if (key === "-") zoom(1 / ZOOM_PER_KEY);
      else return false;
      return true;
    });
  };
})();
