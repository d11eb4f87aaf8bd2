// Space around an arm, which its links' bodies and a floor below it fill.
(() => {
  "use strict";
  const M = globalThis.course.motion;
  const S = globalThis.course.scene;
  const P = globalThis.course.parts;
  const EVERY = 9; // so many vertices apart a few of them stand for all when the view is fitted

  /**
   * Space around the arm that meta describes (arm_view in toys/arms.py).
   * @param {object} card
   * @param {object} meta arm, limits, solid, centre, size, elevation, floor, ground, title
   * @param {number} azimuth of the eye, at first
   */
  P.armSpace = (card, meta, azimuth) => {
    const { arm, limits, centre, elevation, size, title } = meta;
    const solid = S.unpack(meta.solid);
    const view = card.space({ radius: 0.1 * size, centre, azimuth, elevation, label: title });

    /** Draw the bodies at their poses, all in one colour if one is given. */
    view.arm = (poses, { colour, ...look }) => {
      const palette = colour ? solid.palette.map(() => colour) : solid.palette;
      view.mesh(solid, poses, palette, look);
    };

    /**
     * The grips for the look of `arm`: each link is dragged about its joint's axis.
     * @param {() => number[]} q the joint angles now
     * @param {number[][][]} poses of the bodies
     * @param {(joint: number, angle: number) => void} moved is called with an angle within the
     *   limits
     */
    view.joints = (q, poses, moved) => {
      function grip(body) {
        if (!body) return null; // the base
        const joint = body - 1;
        const pose = poses[joint];
        return {
          name: () => `joint ${body}: ${P.degrees(q()[joint])}`,
          at: M.move(pose, M.positionOf(arm.home[joint])),
          axis: M.apply(M.rotationOf(pose), arm.screws[joint].slice(0, 3)),
          angle: q()[joint],
          moved: (angle) => moved(joint, P.clamp(angle, ...limits[joint])),
        };
      }
      return { grip };
    };

    /** Go as far away as the arm and further points need, and draw the floor below it. */
    view.stand = (poses, furtherPoints = []) => {
      const few = solid.vertices.filter((_, i) => i % EVERY === 0);
      const seen = few.map((vertex, i) => M.move(poses[solid.bodies[EVERY * i]], vertex));
      view.contain([...furtherPoints, ...seen]);
      view.floor(meta.floor, meta.ground, size > 2 ? 0.5 : 0.2);
    };
    return view;
  };
})();
