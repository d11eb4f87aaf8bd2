"""The figures of notebook 5.

They show DH parameters, the Panda's frames by both conventions, the pick of a mug, and methods.

Each function returns a Picture, for `show`. Lengths are in metres, times in seconds, angles in
radians.
"""

import numpy as np

from course_lib import rigid
from course_lib.arms import panda
from course_lib.figures import charts
from course_lib.figures.digits import fixed, rounded_array
from course_lib.figures.display import Picture
from course_lib.figures.solids import (
    Model,
    Part,
    body_poses,
    link_poses,
    meshes,
    scene,
    shell,
    shells,
)
from course_lib.figures.solids.model import BLACK, MUG_RED, STEEL, X_RED, Y_GREEN, Z_BLUE
from course_lib.figures.style import BLACK as INK
from course_lib.figures.style import (
    BLUE,
    COLOURS,
    CRIMSON,
    GREEN,
    GREY,
    GRID_GREY,
    ORANGE,
    plane_figure,
)
from course_lib.figures.toys.film import beside, film, still
from course_lib.figures.toys.toy import Toy
from course_lib.lessons.panda_dh_ik.pick import IN_FLANGE
from course_lib.rotations import rot_x, rot_z

# Smaller errors are drawn at this value, because their digits are rounding errors, which differ
# between machines.
SMALLEST_ERROR = 1e-8
# Decimals of centimetres, shares of a bound and rad/s in charts. The last digits of joint angles
# differ between machines, and the numbers of a chart must not.
DECIMALS = 3
# The wrong matches of the notebook are shifted across this direction, so that their dashes are seen
# in full length and parallel.
_VIEW_OF_MATCHES = (0.47, 0.88, 0.45)
MAX_DRAWN_LAG = 6  # cm: a little more than v / K in the runs of the notebook


def through_the_table(q):
    """Return the Panda on its worktop, with its flange below the worktop.

    Parameters
    ----------
    q : array_like, shape (7,)
        Joint angles, in radians.

    Returns
    -------
    Picture
    """
    height = panda().fk(q)[2, 3]
    return _panda(
        q,
        scene.triad(7, panda().home[-1], 0.1),
        f"The Panda on a worktop. Its flange is {fixed(-100 * height, 0)} cm below the worktop.",
        "The arm bends down beside its base, through the worktop.",
        view=(-1.5, 0.7, 0.15),
    )


def _panda(q, further_parts, alt, caption, **options):
    """Return the Panda at joint angles q (7,) on its worktop, with further Parts on its bodies.

    The Parts are given in the base frame, for q = 0.
    """
    poses = link_poses(panda(), np.asarray(q, float))[None]
    return film(
        [*shell(panda()), *further_parts], poses, [0.0], alt, caption, ground=0.0, **options
    )


# ---- DH parameters ----


def four_parameters(a, alpha, d, theta):
    """Return two joint axes, their perpendiculars and the four parameters of a modified DH table.

    Parameters
    ----------
    a, d : float
        Lengths along x and z, in metres.
    alpha, theta : float
        Angles about x and z, in radians.

    Returns
    -------
    Picture
    """
    after_x = rigid.transform(rot_x(alpha), [a, 0, 0])
    after_z = after_x @ rigid.transform(rot_z(theta), [0, 0, d])
    origin_1, foot_2, origin_2 = np.zeros(3), after_x[:3, 3], after_z[:3, 3]
    x1, z1 = np.eye(3)[[0, 2]]
    x2, z2 = after_z[:3, 0], after_z[:3, 2]
    parts = [
        Part(0, X_RED, meshes.arrow(origin_1, x1, a, 0.016)),
        Part(0, X_RED, meshes.arrow(origin_2, x2, 0.6, 0.016)),
        Part(0, Z_BLUE, meshes.arrow(foot_2, z2, d, 0.016)),
        *_joint_axis(origin_1, z1, 0.5),
        *_joint_axis(foot_2, z2, d + 0.35),
    ]
    arc_of_alpha = _arc(foot_2, z1, z2, 0.33)
    arc_of_theta = _arc(origin_2, x1, x2, 0.364)
    paths = [
        (np.array([foot_2, foot_2 + 0.75 * z1]), GREY, (7, 5)),  # parallel to the first axis
        (np.array([origin_2, origin_2 + 0.5 * x1]), GREY, (7, 5)),  # parallel to the first x
        (_right_angle(origin_1, x1, z1), INK, ()),
        (_right_angle(foot_2, -x1, z2), INK, ()),
        (arc_of_alpha, ORANGE, ()),
        (arc_of_theta, ORANGE, ()),
    ]
    words = [
        ("z₁", 0.56 * z1, INK),
        ("z₂", foot_2 + (d + 0.41) * z2, INK),
        ("x₁", 0.35 * a * x1 - 0.06 * z1, INK),
        ("x₂", origin_2 + 0.66 * x2, INK),
        ("a", 0.7 * a * x1 - 0.06 * z1, BLUE),
        ("d", foot_2 + 0.6 * d * z2 - 0.07 * x1, BLUE),
        ("α", arc_of_alpha[8] + 0.1 * (arc_of_alpha[8] - foot_2), BLUE),
        ("θ", arc_of_theta[8] + 0.15 * (arc_of_theta[8] - origin_2), BLUE),
    ]
    return still(
        parts,
        f"Two joint axes, z1 and z2, do not meet. Their common perpendicular lies along x1. It has "
        f"a right angle with each of them, and its length is a = {a:g} m. About x1, the axis z2 is "
        f"rotated relative to z1 by alpha = {fixed(np.rad2deg(alpha), 0)} degrees. The next "
        f"perpendicular, x2, is d = {d:g} m further along z2, and it is rotated about z2 by "
        f"theta = {fixed(np.rad2deg(theta), 0)} degrees.",
        "The axis $x_1$ is perpendicular to both joint axes. Two of the four numbers belong to "
        "$x$, namely the length $a$ and the angle $\\alpha$. The other two belong to $z$, namely "
        "the length $d$ and the angle $\\theta$. Only $\\theta$ changes when the joint rotates.",
        paths=paths,
        words=words,
        view=(0.75, -1.25, 0.35),
    )


def _joint_axis(point, direction, end):
    """Return a joint at a point of its axis, which is drawn as far as `end` metres."""
    return [
        Part(0, STEEL, meshes.capsule(point - 0.25 * direction, point + end * direction, 0.012)),
        Part(0, STEEL, meshes.drum(point, direction, 0.07, 0.11)),
    ]


def _right_angle(corner, first, second):
    """Return points (3, 3) of the mark of a right angle between two unit vectors."""
    side = 0.17  # so that it is seen beside the joint
    return corner + side * np.array([first, first + second, second])


def _arc(centre, start, end, radius):
    """Return points (17, 3) of the arc from one unit vector to another."""
    angle = np.arccos(np.clip(start @ end, -1, 1))
    share = np.linspace(0, 1, 17)[:, None]
    from_start = np.sin((1 - share) * angle) * start
    from_end = np.sin(share * angle) * end
    return centre + radius * (from_start + from_end) / np.sin(angle)


def conventions(modified, standard, base):
    """Return the Panda twice, transparent, with the frames 1 to n of both conventions.

    Parameters
    ----------
    modified, standard : array_like, shape (n, 4, 4)
        Poses of the frames in the world. The arm is drawn where the modified ones, those of
        `arms.panda()`, are.
    base : array_like, shape (3,)
        Where the arm stands, in metres.

    Returns
    -------
    Picture
    """
    from_base = rigid.transform(np.eye(3), -np.asarray(base))
    poses = from_base @ body_poses(panda(), modified, base)
    arm = [Part(0, part.colour, part.mesh.moved(poses[part.body])) for part in shell(panda())]
    groups, in_words = {}, []
    for title, frames in {"modified": modified, "standard": standard}.items():
        frames = from_base @ frames
        numbers = _numbers(frames)
        triads = [part for T in frames for part in scene.triad(0, T, 0.13)]
        words = [(number, np.add(origin, [0, 0, 0.06]), INK) for number, origin in numbers.items()]
        groups[title] = triads, arm, (), words
        shared = [number.replace(", ", " and ") for number in numbers if ", " in number]
        origins = [f"{number} share an origin" for number in shared] or ["all origins differ"]
        in_words.append(f"{title}, {'; '.join(origins)}")
    # All arrows, the base and the titles: they fill the picture, so that a phone shows them large.
    origins = (from_base @ np.concatenate([modified, standard]))[:, :3, 3]
    tips = (origins[:, None] + 0.13 * np.concatenate([np.eye(3), -np.eye(3)])).reshape(-1, 3)
    return beside(
        groups,
        0.9,
        f"The same arm is drawn in the same configuration twice, with the frames 1 to "
        f"{len(modified)}: {'; '.join(in_words)}.",
        "In the modified convention the origin of frame $i$ lies on the axis of joint $i$. In the "
        "standard convention it lies on the axis of joint $i + 1$.",
        view=(0.5, -1.5, 0.5),
        high=-0.12,
        proportion=0.55,
        near=np.concatenate([tips, [[-0.15, 0, 0], [0.1, 0, -0.15]]]),
    )


def _numbers(frames):
    """Return the numbers of the frames (n, 4, 4) with their origins, once for each origin."""
    names = {}
    for i, origin in enumerate(rounded_array(frames[:, :3, 3], 3), 1):
        names.setdefault(tuple(origin), []).append(str(i))
    return {", ".join(numbers): origin for origin, numbers in names.items()}


# ---- errors of a pose ----


def pose_errors(T, T_target):
    """Return a toy: two poses in the plane, and the linear parts of three errors between them.

    The errors are those that belong to the space, the body and the geometric Jacobian. Both poses
    can be dragged, and a slider rotates the target.

    Parameters
    ----------
    T, T_target : array_like, shape (4, 4)
        The current and the target pose at the start. Both lie in the plane z = 0 and are rotated
        about z.

    Returns
    -------
    Toy
    """
    space = rigid.log_se3(T_target @ rigid.inverse(T))
    body = rigid.log_se3(rigid.inverse(T) @ T_target)
    lengths = {
        "space, at the base's origin": space[3:],
        "body, along its own axes": body[3:],
        "geometric, along the base's axes": (T_target - T)[:3, 3],
    }
    in_words = [
        f"{name}, {fixed(np.linalg.norm(arrow), 2)} m long" for name, arrow in lengths.items()
    ]
    alt = (
        f"A base, a current pose in blue, and a target in green, which is rotated by "
        f"{fixed(np.rad2deg(space[2]), 0)} degrees relative to the current pose; both can be "
        f"dragged. Arrows show the linear parts of three errors: {'; '.join(in_words)}. A dashed "
        f"arc is the screw motion to the target."
    )
    caption = (
        "Rotate the target with the slider and watch the three arrows: the geometric one stays, "
        "because the position of the target stays, and the other two change."
    )
    model = {"now": _planar(T), "target": _planar(T_target)}
    return Toy("pose_errors", model, alt, caption=caption)


def _planar(T):
    """Return (x, y, theta) of a pose (4, 4) in the plane z = 0."""
    return [float(T[0, 3]), float(T[1, 3]), float(np.arctan2(T[1, 0], T[0, 0]))]


# ---- the pick of a mug ----


def pinhole(K, T_cm, key_points):
    """Return a pinhole camera from the side, with the ray to the key point farthest from its axis.

    Parameters
    ----------
    K : array_like, shape (3, 3)
        Intrinsics of the camera, in pixels.
    T_cm : array_like, shape (4, 4)
        The mug's pose in the camera's frame.
    key_points : array_like, shape (n, 3)
        In the mug's frame, in metres.

    Returns
    -------
    Picture
    """
    seen = key_points @ T_cm[:3, :3].T + T_cm[:3, 3]
    k = np.abs(seen[:, 0]).argmax()
    x, _, z = seen[k]
    pixels = abs(K[0, 0] * x / z)
    # A pixel is a few micrometres in a real camera. Both lengths in pixels are drawn larger, by
    # the same factor, so that the triangles remain similar.
    focal = 0.3 * z
    fig, (side,) = plane_figure(4.6, 3.6)
    side.plot([0, 1.12 * z], [0, 0], color=GREY, linestyle="--", linewidth=1.5)
    side.plot([0, focal, focal, focal], [0, 0, -0.6 * x, 0.6 * x], color=BLUE, linewidth=3)
    side.plot([0, z], [0, x], color=CRIMSON, linewidth=2)
    side.plot([z, z], [0, x], color=GREEN, linewidth=2)
    side.plot(z, x, "o", color=CRIMSON, markersize=9)
    side.plot(0, 0, "o", color=INK, markersize=8)
    side.plot(focal, focal * x / z, "o", color=BLUE, markersize=7)
    labels = (
        ("camera", (-0.01, -0.42 * x), INK),
        (f"$f_x$ =\n{fixed(K[0, 0], 0)} pixels", (0.02 * z, -0.17 * x), BLUE),
        (f"$|u - c_x|$ =\n{fixed(pixels, 0)} pixels", (1.08 * focal, 0.75 * focal * x / z), BLUE),
        ("$|x|$", (1.02 * z, x / 2), GREEN),
        ("depth $z$", (0.62 * z, -0.12 * x), GREY),
    )
    for text, position, colour in labels:
        side.text(*position, text, color=colour, va="center")
    side.set(xlabel="z, the optical axis (m)", ylabel="x (m)")
    return Picture(
        fig,
        f"A camera from the side: point {k}, {fixed(1000 * abs(x), 0)} mm from the optical axis at "
        f"a depth of {fixed(z, 2)} m, is seen {fixed(pixels, 0)} pixels from the principal point, "
        f"with a focal length of {fixed(K[0, 0], 0)} pixels.",
        "The axes are in metres. The two blue lengths are in pixels, and both are drawn larger "
        "than they are, by the same factor. The two triangles are similar, so $u - c_x$ is to "
        "$f_x$ as $x$ is to $z$.",
    )


def motion(times, clearances, trajectory_times, speeds, accelerations):
    """Return how near a motion comes to its surroundings, and how much of their bounds motors use.

    The three panels have one time axis, and the pointer shows the values of all panels at a time.

    Parameters
    ----------
    times : array_like, shape (m,)
        Times of the clearances, in seconds.
    clearances : dict
        What the arm may touch to its distance from the arm, shape (m,), in metres. It is negative
        where they touch.
    trajectory_times : array_like, shape (n,)
        Times of the trajectory's rows, in seconds.
    speeds, accelerations : array_like, shape (n,)
        Shares of the bounds, as `pick.shares` returns them: 1 is a bound.

    Returns
    -------
    Picture
    """
    fig = charts.panels(
        ["clearance", "speed", "acceleration"],
        xlabel="time (s)",
        ylabel=["clearance (cm)", "speed (of its bound)", "acceleration (of its bound)"],
        columns=1,
        share="x",
        height=640,
    )
    times, trajectory_times = rounded_array(times, 4), rounded_array(trajectory_times, 4)
    for obstacle, distances in clearances.items():
        centimetres = rounded_array(100 * np.asarray(distances), DECIMALS)
        charts.add_line(fig, times, centimetres, obstacle, panel=0)
    lowest = min(distances.min() for distances in clearances.values())
    _add_contact(fig, min(-2.0, 100 * lowest - 1))
    shares = {"speed": np.asarray(speeds), "acceleration": np.asarray(accelerations)}
    for panel, (name, share) in enumerate(shares.items(), 1):
        drawn = rounded_array(share, DECIMALS)
        charts.add_line(fig, trajectory_times, drawn, name, panel=panel, dash="solid")
        fig.data[-1].line.shape = "hv"  # a value holds until the next row
        charts.add_rule(fig, y=1.0, text="bound", panel=panel)
    margin = 0.02 * trajectory_times[-1]  # so that a peak at the first or last row is seen
    fig.layout.xaxis.range = [-margin, trajectory_times[-1] + margin]
    least = {obstacle: 100 * distances.min() for obstacle, distances in clearances.items()}
    least_in_words = ", ".join(f"{obstacle} {fixed(gap, 1)} cm" for obstacle, gap in least.items())
    return Picture(
        fig,
        f"Three panels over time. The first shows the clearance, with its least values: "
        f"{least_in_words}. The others show the largest share of a joint's bound, at most: "
        f"speed {shares['speed'].max():.3g}, acceleration {shares['acceleration'].max():.3g}.",
        f"{_least_clearance_in_words(least)} {_bounds_in_words(shares)} The two lower panels show "
        "the joint that is nearest to its bound at that time. Point at a curve to see the values "
        "at that time.",
    )


def _least_clearance_in_words(least):
    """Return a sentence on the least clearances, obstacle to centimetres, of a motion."""
    nearest = min(least, key=least.get)
    if least[nearest] < 0:
        return (
            f"The arm reaches {fixed(-least[nearest], 1)} cm into the {nearest}: there the curve "
            f"is in the red band, which begins at a clearance of 0."
        )
    name = "itself" if nearest == "itself" else f"the {nearest}"
    return (
        f"The arm touches nothing, because no curve reaches the red band; it is nearest to {name}, "
        f"at {fixed(least[nearest], 1)} cm."
    )


def _bounds_in_words(shares):
    """Return a sentence on which bounds a motion exceeds, and by which factor."""
    largest = {name: share.max() for name, share in shares.items()}
    above = [
        f"the {name} by a factor of {most:.3g}" for name, most in largest.items() if most > 1.001
    ]
    if above:
        return f"The motion exceeds the bound on {' and that on '.join(above)}."
    return "Speed and acceleration stay within their bounds, which are at 1."


def _add_contact(fig, low):
    """Colour the first panel from low to 0 cm, where the arm touches something."""
    x_axis, y_axis = fig.layout.meta["panels"][0]
    look = {"fillcolor": CRIMSON, "opacity": 0.15, "line_width": 0, "layer": "below"}
    fig.add_shape(
        type="rect", xref=f"{x_axis} domain", yref=y_axis, x0=0, x1=1, y0=low, y1=0, **look
    )


def at_the_mug(q, T_mug, base):
    """Return the Panda's open gripper, large, and a mug.

    Parameters
    ----------
    q : array_like, shape (7,)
        Joint angles of the arm, in radians.
    T_mug : array_like, shape (4, 4)
        Pose of the mug in the world.
    base : array_like, shape (3,)
        Where the arm stands in the world, in metres.

    Returns
    -------
    Picture
    """
    from_base = rigid.transform(np.eye(3), -np.asarray(base))
    mug = [Part(0, MUG_RED, meshes.mug().moved(from_base @ T_mug))]
    fingertips = panda().home[-1] @ IN_FLANGE
    gripper = shells.gripper(7, fingertips)
    for side in (1, -1):
        opened = fingertips @ rigid.transform(np.eye(3), [0, -0.04 * side, 0])
        gripper += [part.moved(opened) for part in shells.finger(7, side)]
    poses = link_poses(panda(), np.asarray(q, float))
    contained = Model.of(gripper + mug).placed(poses)[::9]
    alt = (
        "The Panda's gripper at a mug, seen from near, in the configuration of the motion that is "
        "nearest to the mug."
    )
    caption = "Rotate the picture. Which part of the gripper is in the mug?"
    return _panda(q, gripper + mug, alt, caption, view=(1.0, -1.4, 0.3), near=contained)


def pick(frames, grippers, openings, mugs, times, base, camera):
    """Return a film of the Panda that picks a mug up from a round worktop and puts it down.

    Parameters
    ----------
    frames : array_like, shape (m, 8, 4, 4)
        Poses of the frames of `arms.panda()` in the world, at each of m times.
    grippers : array_like, shape (m, 4, 4)
        Poses between the fingertips: z away from the arm; the fingers move along y.
    openings : array_like, shape (m,)
        Distances between the fingertips, in metres.
    mugs : array_like, shape (m, 4, 4)
        Poses of the mug: the middle of its bottom, the handle along x.
    times : array_like, shape (m,)
        In seconds.
    base : array_like, shape (3,)
        Where the arm stands on the worktop, in metres.
    camera : array_like, shape (4, 4)
        Pose of a camera, which looks along its z axis.

    Returns
    -------
    Picture
    """
    to_fingertips = grippers[:, :3, 3] - frames[:, -1, :3, 3]
    along_gripper = (to_fingertips * grippers[:, :3, 2]).sum(-1)
    length = abs(np.median(along_gripper))
    half_openings = np.outer(openings / 2, [0, 1, 0])
    fingers = [grippers @ rigid.transform(np.eye(3), side * half_openings) for side in (-1, 1)]
    arm = body_poses(panda(), frames[:, :-1], base)
    cameras = np.broadcast_to(camera, (len(times), 4, 4))
    poses = np.concatenate([arm, np.stack([grippers, *fingers, mugs, cameras], 1)], 1)
    parts = [
        *shell(panda()),
        *shells.gripper(8, np.eye(4), length),
        *shells.finger(9, 1, length),
        *shells.finger(10, -1, length),
        Part(11, MUG_RED, meshes.mug()),
        Part(12, BLACK, meshes.box([-0.05, -0.035, -0.08], [0.05, 0.035, 0])),
        Part(12, STEEL, meshes.drum([0, 0, 0.02], [0, 0, 1], 0.022, 0.025)),
    ]
    lifted = mugs[:, 2, 3].max() - mugs[0, 2, 3]
    carried = np.linalg.norm(mugs[-1, :2, 3] - mugs[0, :2, 3])
    return film(
        parts,
        poses,
        times,
        f"Moving picture, {fixed(times[-1] - times[0], 0)} seconds. The Panda reaches over the mug "
        f"on the worktop and comes down with its open fingers on both sides of the mug. It closes "
        f"the fingers, lifts the mug by {fixed(100 * lifted, 0)} cm, carries it "
        f"{fixed(100 * carried, 0)} cm "
        f"across the worktop and sets it down. Then it opens the fingers and rises. A camera hangs "
        f"above the worktop and looks down.",
        "The blue line is the path of the point midway between the fingertips. The fingers close "
        "on both sides of the mug.",
        view=(1.2, 1.2, 0.7),
        name="pick",
        ghosts=2,
        paths=[(grippers[:, :3, 3], BLUE, ())],
        ground=base[2],
    )


# ---- wrong matches ----


def matches(template, scene_points, T, wrong):
    """Return the key points of a mug in its own frame, and those of the scene with the mug on them.

    Parameters
    ----------
    template, scene_points : array_like, shape (n, 3)
        Key points in the mug's frame, and their partners in the scene, in metres.
    T : array_like, shape (4, 4)
        Pose of the mug in the scene, from the good matches.
    wrong : array_like of int
        Indices of the wrong matches. They are red, with dashes to where they should be.

    Returns
    -------
    Picture
    """
    template, scene_points = np.asarray(template, float), np.asarray(scene_points, float)
    R = rigid.transform(T[:3, :3], np.zeros(3))
    rotated = template @ T[:3, :3].T  # where the matches should be, seen from the mug's origin
    seen = scene_points - T[:3, 3]
    distances = np.linalg.norm(rotated - seen, axis=1)
    mug = Part(0, STEEL, meshes.mug())
    scene_colours = [MUG_RED if k in wrong else Y_GREEN for k in range(len(seen))]
    dashes = [(np.array([seen[k], rotated[k]]), CRIMSON, (5, 4)) for k in wrong]
    groups = {
        "template": (_dots(template, [Z_BLUE] * len(template)), [mug], (), _beside_dots(template)),
        "scene": (_dots(seen, scene_colours), [mug.moved(R)], dashes, _beside_dots(seen)),
    }
    gaps = " and ".join(f"point {k} by {fixed(1000 * distances[k], 0)} mm" for k in wrong)
    return beside(
        groups,
        0.17,
        f"On the left is the template, a mug with {len(template)} numbered key points on it. On "
        f"the right is the scene, with the same mug placed by the good matches. "
        f"{int((distances < 0.005).sum())} points of the scene are within 5 mm of where they "
        f"should be. Dashed lines show how far the wrong matches are off: {gaps}.",
        "Both wrong matches are shifted by the same vector, so they agree with each other.",
        view=_VIEW_OF_MATCHES,
        high=-0.03,
    )


def _dots(points, colours):
    """Return a ball at each of the points (n, 3), each in its colour."""
    radius = 0.0025
    return [
        Part(0, colour, meshes.ball(point, radius))
        for point, colour in zip(points, colours, strict=True)
    ]


def _beside_dots(points):
    """Return the number of each of the points (n, 3), just above it."""
    return [(str(k), np.add(point, [0, 0, 0.008]), INK) for k, point in enumerate(points)]


# ---- methods of inverse kinematics ----


def descents(errors):
    """Return the length of the error after each step of several methods.

    Parameters
    ----------
    errors : dict
        Method to the lengths of the error, shape (n,), the first before any step. Lengths below
        1e-8 are drawn at 1e-8, because their digits are rounding errors.

    Returns
    -------
    Picture
    """
    drawn = {name: np.maximum(lengths, SMALLEST_ERROR) for name, lengths in errors.items()}
    steps = np.arange(len(next(iter(errors.values()))))
    fig = charts.lines(
        steps, drawn, xlabel="step", ylabel="length of the error (m, rad)", log="y", markers=True
    )
    ends = [_end_of_descent(name, lengths) for name, lengths in drawn.items()]
    return Picture(
        fig,
        "The length of the pose error after each step, on a logarithmic axis. At the end: "
        f"{'; '.join(ends)}.",
        "A straight line means that each step divides the error by the same factor. A line that "
        "bends down gains more and more digits with each step, as Newton's method does. Lengths "
        "below $10^{-8}$ are drawn at $10^{-8}$.",
    )


def _end_of_descent(name, lengths):
    """Return in words where a descent with these lengths of the error (n,) ends."""
    if lengths.min() < 1e-6:
        return f"{name} below 1e-6 after step {np.argmax(lengths < 1e-6)}"
    return f"{name} {lengths[-1]:.2g}"


def share_reached(x, shares, xlabel, caption):
    """Return the share of targets that is reached over a setting of the method.

    Parameters
    ----------
    x : array_like, shape (n,)
        The setting: numbers of steps or of starts, or dampings. An axis of more than a factor of
        ten is logarithmic.
    shares : array_like, shape (n,)
        From 0 to 1. They are drawn in whole per cent: rounding errors decide single targets.
    xlabel : str
        Name of the setting.
    caption : str

    Returns
    -------
    Picture
    """
    x, percent = np.asarray(x, float), np.round(100 * np.asarray(shares))
    fig, (ax,) = plane_figure(4.6, 2.6)
    ax.plot(x, percent, "o-", color=BLUE, linewidth=2, markersize=6)
    if x.max() > 10 * x.min() and x.min() < 1:
        ax.set_xscale("log")
        ax.set_xticks(x, [f"{value:g}" for value in x])
        ax.minorticks_off()
    ax.set(xlabel=xlabel, ylabel="targets reached (%)", ylim=(-3, 103))
    ax.grid(color=GRID_GREY)
    alt = (
        f"The share of targets that is reached, over the {xlabel}: {fixed(percent[0], 0)} % at "
        f"{x[0]:g}, {fixed(percent[-1], 0)} % at {x[-1]:g}, and the most, "
        f"{fixed(percent.max(), 0)} %, at {x[percent.argmax()]:g}."
    )
    return Picture(fig, alt, caption)


def fastest_joint(times, speeds):
    """Return the speed of the fastest joint over time, for several methods.

    Parameters
    ----------
    times : array_like, shape (n,)
        In seconds.
    speeds : dict
        Method to the largest joint speed, shape (n,), in rad/s.

    Returns
    -------
    Picture
    """
    drawn = {name: rounded_array(speed, DECIMALS) for name, speed in speeds.items()}
    fig = charts.lines(times, drawn, xlabel="time (s)", ylabel="fastest joint (rad/s)")
    largest = ", ".join(f"{name} {speed.max():.2g} rad/s" for name, speed in speeds.items())
    return Picture(
        fig,
        f"The speed of the fastest joint over time. Its largest value: {largest}.",
        "When the arm is nearly stretched, the undamped method asks for higher and higher joint "
        "speeds. The other two methods limit the speed, so the flange falls behind.",
    )


def following(dt, coarse_dt, distances, decay):
    """Return the errors of a gripper that follows a moving target, over time and over steps.

    Parameters
    ----------
    dt, coarse_dt : float
        The duration of a step of the runs on the left and on the right, in seconds.
    distances : dict
        Run to its errors after each step, in cm: two runs for the left panel, shape (n,), then two
        for the right one, shape (m,).
    decay : array_like, shape (n,)
        The error of the left panel that the differential equation predicts, in cm.

    Returns
    -------
    Picture
    """
    names = list(distances)
    fig = charts.panels(
        [f"steps of {dt:g} s", f"steps of {coarse_dt:g} s"],
        xlabel="time (s)",
        ylabel="error (cm)",
        columns=2,
    )
    for i, name in enumerate(names):
        panel, step = (0, dt) if i < 2 else (1, coarse_dt)
        errors = rounded_array(distances[name], DECIMALS)
        times = rounded_array(step * np.arange(len(errors)), DECIMALS)
        charts.add_line(fig, times, errors, name, panel=panel, markers=panel == 1)
    few = slice(None, None, max(1, len(decay) // 16))  # dots on the curve that they confirm
    times = rounded_array(dt * np.arange(len(decay)), DECIMALS)[few]
    expected = rounded_array(decay, DECIMALS)[few]
    charts.add_points(fig, times, expected, "e<sub>0</sub> exp(−K t)", colour=INK, size=5)
    # The errors that die out fill the panels; the one that grows may leave its panel.
    fig.update_yaxes(range=[0, MAX_DRAWN_LAG])
    ends = "; ".join(f"{name} {fixed(distances[name][-1], 1)} cm" for name in names)
    return Picture(
        fig,
        f"Errors of a gripper that follows a moving target. All start at "
        f"{fixed(distances[names[0]][0], 1)} cm. At the end: {ends}.",
        "With steps of 0.02 s, the gripper lags behind without feed-forward, and with "
        "feed-forward its error decays exponentially. With steps of 0.1 s, the gain is just below "
        "and just above 2/dt.",
    )


def iterations(counts, most):
    """Return histograms of the iterations that the reached targets took, one panel per method.

    Parameters
    ----------
    counts : dict
        Method to the numbers of iterations, shape (n,), one for each target that it reached.
    most : int
        The last bar counts all targets that took so many iterations or more.

    Returns
    -------
    Picture
    """
    width = 4  # iterations in a bar: about 25 bars up to 100 iterations
    bars = most // width + 1
    first = width * np.arange(bars)  # the least number of iterations in each bar
    fig = charts.panels(
        list(counts),
        xlabel="iterations",
        ylabel="targets reached",
        columns=1,
        share="x",
        height=560,
    )
    for panel, (name, taken) in enumerate(counts.items()):
        bar = np.minimum(np.asarray(taken, int), first[-1]) // width
        heights = np.bincount(bar, minlength=bars)
        edges = np.append(first, first[-1] + width) - 0.5
        charts.add_bars(fig, edges, heights, name, panel=panel, colour=COLOURS[panel])
        in_words = [f"{low} to {low + width - 1}" for low in first[:-1]]
        in_words.append(f"{first[-1]} or more")
        fig.data[-1].customdata = [[words] for words in in_words]
        fig.data[
            -1
        ].hovertemplate = (
            f"{name}<br>iterations: %{{customdata[0]}}<br>targets reached: %{{y}}<extra></extra>"
        )
    fig.layout.showlegend = False  # the panels have titles
    # Under the pointer a bar names all its iterations; one x for all panels would be its middle.
    fig.layout.hovermode = "closest"
    in_words = [
        f"{name} {len(taken)} targets, median {fixed(np.median(taken), 0)}"
        for name, taken in counts.items()
        if len(taken)
    ]
    return Picture(
        fig,
        f"Histograms: how many iterations the reached targets took. {'; '.join(in_words)}.",
        f"Each panel has its own scale. The last bar counts all targets that took {first[-1]} "
        "iterations or more.",
    )
