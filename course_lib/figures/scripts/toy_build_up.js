// A pose built up factor by factor: the product of exponentials, with each screw axis where it was and where it is now,
// and the column of the Jacobian that belongs to it.
(() => {
  "use strict";
  const M = globalThis.course.motion,
    P = globalThis.course.parts,
    { COLOURS, rad } = P;

  P.toy(
    "build_up",
    (meta) => meta.title,
    (card, meta) => {
      const { arm, limits, size } = meta,
        n = arm.screws.length,
        view = card.armSpace();
      const state = card.state({ q: [...meta.q], k: meta.start }),
        name = (k) => (k ? `${k} of ${n}` : "none");
      const factors = card.range(
        "Factors",
        { min: 0, max: n, step: 1, value: state.k },
        name,
        (k) => go(k),
      );
      const joint = () => Math.max(0, state.k - 1); // that of the last factor
      const options = { min: -180, max: 180, step: 1, value: Math.round(state.q[joint()] / rad) };
      const write = (x) => `${P.sub("q", joint() + 1)} = ${P.inDegrees(x)}`;
      const last = card.range("Angle of its joint", options, write, (x) => {
        const [low, high] = limits[joint()];
        state.q[joint()] = Math.min(high, Math.max(low, x * rad));
      });
      // The next factor grows from nothing to its full size.
      let grown = 1;
      function go(k) {
        const forwards = k === state.k + 1;
        state.k = k;
        grown = forwards ? 0 : 1;
        last.set(Math.round(state.q[joint()] / rad));
        card.run(() => (grown = Math.min(1, grown + 0.04)) < 1);
      }
      const step = (d) => () => {
        const k = Math.min(n, Math.max(0, state.k + d));
        factors.set(k);
        go(k);
      };
      card.button("Previous factor", step(-1));
      card.button("Next factor", step(1));
      const numbers = card.numbers();

      function axis(at, direction, colour, now) {
        const l = 0.17 * size,
          ends = [M.add(at, direction, -l), M.add(at, direction, l)];
        if (now) view.arrow(...ends, colour, { thick: 0.006 * size });
        else view.line(ends, colour, 1.5, { dash: [5, 5] });
        return ends[1];
      }
      return () => {
        const { k } = state,
          q = state.q.map((x, i) => (i < k - 1 ? x : i === k - 1 ? grown * x : 0));
        const moved = M.bodies(arm, q);
        view.begin();
        view.stand(moved);
        const dragged = view.joints(
          () => q,
          moved,
          (i, angle) => {
            state.q[i] = angle;
            if (i === joint()) last.set(Math.round(angle / rad));
          },
        );
        view.arm(moved, {
          opacity: 0.45,
          shadow: true,
          grip: (body) => body <= k && dragged.grip(body),
        });
        arm.screws.forEach((screw, i) => {
          const w = screw.slice(0, 3),
            p = M.positionOf(arm.home[i]);
          axis(p, w, COLOURS.grey, false);
          const colour = i === k - 1 ? COLOURS.crimson : COLOURS.purple;
          const end = axis(M.move(moved[i], p), M.apply(M.rotationOf(moved[i]), w), colour, true);
          view.text(end, String(i + 1), colour, 10);
        });
        const T = M.times(moved[n], arm.home[n]),
          J = M.spaceJacobian(arm, q, moved);
        view.frame(M.eye(4), 0.1 * size, { thick: 0.004 * size });
        view.frame(T, 0.1 * size, { thick: 0.006 * size });
        view.end();
        const product = arm.screws.map((_, i) => {
          const factor = `e<sup>[S<sub>${i + 1}</sub>]q<sub>${i + 1}</sub></sup>`;
          return i < k - 1
            ? factor
            : i === k - 1
              ? `<mark>${factor}</mark>`
              : `<span class="dim">${factor}</span>`;
        });
        numbers(
          [`<span>T = ${product.join(" ")} M =</span>`, P.matrix(T)],
          [`<span>J<sub>s</sub> =</span>`, P.matrix(J, { digits: 2, highlighted: k - 1 })],
          k
            ? `Column ${k} is the screw axis ${k} where it is now: the joints before it have moved it, the joint itself ` +
                "and those after it have not."
            : "All joints at 0: each axis is where it was, the columns are the screws.",
        );
      };
    },
  );
})();
