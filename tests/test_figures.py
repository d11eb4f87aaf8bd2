"""show() and every picture of the notebooks: words made from the data, numbers that do not depend
on the machine."""

import io
import json
from unittest import mock

import numpy as np
import pytest
from helpers import ALT, shown
from matplotlib.figure import Figure
from matplotlib.text import Text
from PIL import Image

from course_lib import arms, rigid, rotations, trajectory
from course_lib.figures import show
from course_lib.figures.display import Picture
from course_lib.figures.plots import velocities_of_the_tip
from course_lib.figures.stored_chart import PLOTLY, is_chart, stored
from course_lib.figures.style import MAX_PANEL_WIDTH, plane_figure
from course_lib.figures.three_views import three_views
from course_lib.figures.toys.toy import Toy
from course_lib.lessons.decomposition_ik import figures as nb6
from course_lib.lessons.panda_dh_ik import figures as nb5
from course_lib.lessons.panda_dh_ik import tables
from course_lib.lessons.panda_dh_ik.exercises.shared import READY
from course_lib.lessons.poe_kuka_iiwa import figures as nb4
from course_lib.lessons.rigid_motion import figures as nb2
from course_lib.lessons.rotations import figures as nb1
from course_lib.lessons.subproblems_damped_ik import figures as nb3

X, Y, Z = np.eye(3)
R = rotations.random_rotations(200, np.random.default_rng(0))
DRIVE = np.array([[0, 0, 0], [1, 0, 0.25], [2, 0, 0.5]])
ARM = np.array([[[0, 0], [1.0, 0], [2, 0]], [[0, 0], [0, 1], [0, 2]]])
SCREW = rigid.exp_se3(np.linspace(0, 6, 30)[:, None] * np.array([0, 0, 1, 0, -0.5, 0.1]))
T = np.array([0.0, 1, 2])
IIWA, PANDA, GENERIC = arms.iiwa14(), arms.panda(), np.array([0.3, 0.5, 0, -1.2, 0, 0.8, 0])
FRAMES = PANDA.frames(READY + np.linspace(0, 0.3, 3)[:, None])
POINTS = np.array([[0.03, 0, 0.09], [-0.03, 0, 0.09], [0, 0.03, 0.0]])
LOWERED = np.outer(np.linspace(0, 0.3, 5), [0, 1, 0, -1, 0, 1, 0])  # angles of the iiwa
ERRORS = np.array([[0.1, 0.4], [0.3, 0.2], [0.5, np.nan]])
XY = np.array([[0.0, 1.0], [1.0, 1.0], [2.0, 0.0]])
ELBOWS = np.array([[0, np.pi / 2], [np.pi / 2, -np.pi / 2]])


def points_of(q):
    return np.stack([0 * q, q], -2) @ np.ones((1, 2))


# (function, its arguments, words that its alternative text or caption must contain)
PICTURES = [
    (nb1.body_frame, (np.eye(3),), "y along (0.00, 1.00, 0.00); z along (0.00, 0.00, 1.00)."),
    (nb1.frames, ({"start": np.eye(3), "longer": 2 * np.eye(3)},), "here the longest grows to 2.00."),
    (nb1.frames, ({"a": R[0]}, "One log."), "One log."),
    (nb1.rotated_point, (1.5 * Z, X + 0.5 * Z, rotations.exp_so3), "by 1.50 rad to R p, along an arc in a plane"),
    (nb1.rotated_point, (Z, X + Z, lambda w: rotations.exp_so3(w) * (1 + w[2])), "which leaves the plane"),
    (nb1.log_errors, ([1e-8, 1e-4], {"arccos": [1e-3, 1e-9], "library": [0, 1e-16]}),
     "arccos rises to more than 1e-4; library stays below 1e-12"),
    (nb1.euler_rates, ([-1.57, 0, 1.57], np.array([0, 1, 0])),
     "is 1.00 at pitch 0.00 and falls to 0.00 at pitch -1.57"),
    (nb1.projections, (np.diag([2.0, 1.0]), {"$R$": np.eye(2), "other": -np.eye(2)}),
     "R: 1.00, 1.00, and a sum of 3.00; other: -1.00, -1.00, and a sum of -3.00"),
    (nb1.angles, ({"none": np.eye(3)[None], "any": R},), "none: 0% above 90 degrees"),
    (nb1.on_sphere, ({"none": np.eye(3)[None], "any": R},), "none: 0% in the cap above 0.9, 0% below -0.9"),
    (nb1.distances, (T, 2 * T, 1 - np.cos(T / 2)), "the Euler angles is 2.0 to 2.0 times the angle"),
    (nb2.parking, (DRIVE, [1, 2, 1.57], [0.6, 1, 0.4], 0.6), "as near as 1.08 m to the middle"),
    (nb2.wheels, (0.2, 0.4, 0.2), "on circles about one point, the pole, 0.3 m to the left of the robot's middle."),
    (nb2.body_movie, ("x", DRIVE, T), "2 s. A body outlined in red moves along a dashed blue path from (0, 0) "
     "to (2, 0), rotating counter-clockwise by 0.50 rad."),
    (nb2.body_movie, ("x", DRIVE, T, DRIVE + 3 * Y), "outlined in grey, is up to 3.00 m away from the first."),
    (nb2.longer_arc, (T, DRIVE, DRIVE * [1, 1, -9]), "ot wrapped: -4.50 rad, rotating clockwise by 4.50 rad"),
    (nb2.past_a_gate, ({"cubic": DRIVE * [1, 1, 0]},), "Cubic: from (0, 0) to (2, 0) over 2.0 m, without rotation"),
    (nb2.straight_and_screw, ({"straight": DRIVE}, [0, 0]), "Distance from the pole: straight: 0.00 to 2.00 m."),
    (nb2.euler_paths, ({"Euler": DRIVE[:, :2], "exact": DRIVE[:, :2] + [[0, 0.1]]},),
     "ends at (2, 0), 0.10 m from the end of"),
    (nb2.euler_errors, (np.array([0.5, 0.1]), np.array([0.7, 0.14])), "0.14 m for steps of 0.1 s, 0.7 m for 0.5"),
    (nb2.time_scalings, ([0, 1], {"linear": [[0, 1], [1, 1], [0, 0]]}), "velocity 1.00 at the start, up to 1.00"),
    (nb2.speed_profiles, ({"even": (T, T, np.ones(3), 0 * T)},), "even: 2 m in 2.00 s, speed up to 1.00 m/s"),
    (nb2.past_via_points, (XY[:, :2], {"slow": (T, XY[:, :2])}), "slow: takes 2.00 s and passes the farthest corner at"),
    (nb2.arm_movie, ("x", ARM, [0, 1]), "An arm of 2 links moves; its tip draws a dashed blue curve from (2, 0)"),
    (nb2.arm_movie, ("x", ARM, [0, 1], ARM), "A second arm moves to its right; their tips are up to 0.00 m apart"),
    (nb2.arm_paths, ({"one": ARM, "two": ARM},), "Two: the path is 2.83 m long, (2, 0) to (0, 2)."),
    (nb2.joint_tracks, ({"both": np.array([[0, 0], [1, 2]])},), "Both: joint 2 between 0.00 and 2.00 rad."),
    (nb3.rotated_onto, (Z, X, 2 * Y, 1.5), "R p is 1.005 from g; p itself 2.236."),
    (nb3.rotated_onto, (Z, X, 2 * Y, np.pi / 2), "distance of $R\\,p$ from $g$, 1.000 m"),
    (nb3.circles_meet, (Z, X, X, Z, [(np.pi / 2, -np.pi / 2)]), "they touch in one point"),
    (nb3.circle_and_sphere, (Z, X, X, 1.0, [np.pi / 3, -np.pi / 3]), "radius 1 about g at two points, marked 1 and 2."),
    (nb3.circle_and_plane, (Z, X, X, 1.0, [0.0]), "perpendicular to the direction h at one point."),
    (nb3.orientation_paths, ({"still": R[[0, 0]]}, 1.0), "still on a path of length 0.00, at 0.00 rad/s."),
    (nb3.arm_by_hand, (), "from (4, 3) to (5, 0). Seen from above, the wrist center goes from (5, 0) to (3, 4)."),
    (nb3.choices, (np.array([0.5, 1.25]), [2, 2, 8]), "most often 2, for 2 of 3 poses."),
    (nb3.joint_motion, ({"undamped": lambda bend: 1.2 / bend},), "undamped from 1.2 to 400 rad."),
    (nb3.largest_rates, (lambda b: np.eye(3) / np.sin(b[1]),), "largest single rate from 1 to 50 rad/s."),
    (nb3.descents, ({"run": ARM}, [0, 2.0], "Words."), "run: jumps about and is less than a micrometre from it."),
    (nb3.race, ({"one": T[:, None] / 2}, points_of, [1.0, 1.0]),
     "one: 2 steps to 1 cm, at most 0.5 rad: ends less than"),
    (nb3.gains, ([1.0], {"s1": 2.0, "s2": 0.5}), "a largest value, 0.50 rad/m for 1 m², and falls again."),
    (nb3.step_map, ([0.1, 9], [0.1, 1], np.array([[1e-4] * 2, [0.5] * 2]), 2.0, [(0.1, 1)],
                    np.zeros(4), XY[0], 9),
     "100 % of it is blue, below a "
     "centimetre; right of it 0 %. Circles mark 1 run."),
    (nb3.two_arms, ({0.5: T[:, None] / 2}, points_of), "The last elbow bends at most by epsilon = 0.5 m²: 1.0 rad."),
    (nb3.manipulability_along, ([2.0], np.array([[1.0, 2.0]])), "(m²) over the steps. epsilon = 2 m²: 1.0 to 2.0."),
    (nb4.wrong_frame, (IIWA, {"A": 0 * LOWERED, "B": LOWERED}, 1.25), "One path goes into the table."),
    (nb4.wrong_frame, (IIWA, {"A": 0 * LOWERED, "B": LOWERED}, 0.05),
     "B: the gripper moves by 46 cm. No path touches the table."),
    (nb4.screw_motion, (SCREW, np.zeros(3), Z), "rises by 0.60 m."),
    (nb4.two_observers, (), "A turntable: v_a is (0, -1, 0), v_b is (0, 0, 0); a door: v_a is (0, 0, 0)"),
    (nb4.digits_lost, (lambda a: (1 - np.cos(a)) / a,), "below 1e-9 from 0.001 rad on, larger"),
    (nb4.arc_of_a_twist, (np.pi / 3,), "from (0, 0) to (0.866, 0.5) m."),
    (velocities_of_the_tip, ({"bent": np.array([[0, 0], [2, 0], [2, 1]])},), "1: (-1, 2) m/s; bent, joint 2: (-1, 0)"),
    (nb4.arm_movie, (IIWA, trajectory.Trajectory(T, T[:, None] * GENERIC, 0 * T[:, None] * GENERIC)), "2.0 s: the"),
    (nb4.plane_projections, (np.arange(len(SCREW)), SCREW[:, :3, 3]), "1.00 by 1.00 by 0.60 m."),
    (nb4.velocities_over_time, (T, {"space": 0 * R[0], "body": np.eye(3)}, FRAMES[:, -1]), "space up to 0.00 m/s, body up to 1.00"),
    (nb4.velocities_against_each_other, (np.arange(len(R[0])), {"space": R[0], "body": R[1]}),
     "for each of the frames space, body."),
    (nb4.singular_values, (IIWA, GENERIC, GENERIC * [1, 1, 1, 1, 1, 0, 1]), "q6 varies (wrist): least 0.11 at -0.08"),
    (nb4.near_its_bounds, (T, 0.1 + 0 * T, T[:, None] * GENERIC, IIWA.limits), "manipulability is between 0.100 and"),
    (nb4.workspace, ([0.1, 0.3], [0, 0.2], np.array([[0.02, np.nan], [0.01, 0.05]]), 0.05,
                     ([0.05, 1, 1, 0.05], [-0.5, -0.5, 0.7, 0.7])),
     "is largest, 0.050 m³, near r = 0.30 m and z = 0.20 m."),
    (three_views, ("iiwa", IIWA), "From the base the arm goes 360 along +z, then 420 along +z"),
    (three_views, ("ur5e", arms.ur5e(), ("0", "f")), "The flange's frame f has x along +x, y along +z, z along -y"),
    (nb5.through_the_table, ([2.0, 1.7, 0.3, -0.6, 0, 1.6, 0],), "cm below the worktop."),
    (nb5.four_parameters, (0.8, 0.7, 0.6, 0.9),
     "its length is a = 0.8 m. About x1, the axis z2 is rotated relative to z1 by alpha = 40"),
    (nb5.conventions, (FRAMES[0, :7], FRAMES[0, 1:], np.zeros(3)), "modified, 1 and 2 share an origin; 5 and 6 share"),
    (nb5.pose_errors, (np.eye(4), rigid.transform(rotations.rot_z(0.5), [0.3, 0.4, 0])), "rotated by 29 degrees"),
    (nb5.pinhole, (np.diag([500, 500, 1]), rigid.transform(np.eye(3), [0, 0, 0.5]), POINTS), "is seen 25 pixels"),
    (nb5.motion, (np.arange(3.0), {"mug": np.array([0.1, -0.02, 0.03])}, np.arange(2.0), np.ones(2), np.ones(2)),
     "with its least values: mug -2.0 cm"),
    (nb5.at_the_mug, ([0, -0.8, 0, -2.4, 0, 1.6, 0.8], np.eye(4), np.zeros(3)), "gripper at a mug, seen from near, in the"),
    (nb5.pick, (FRAMES, FRAMES[:, -1], np.full(3, 0.08), FRAMES[[0, 0, 0], 3], T, X, np.eye(4)), "2 seconds"),
    (nb5.descents, ({"slow": np.array([1, 0.5]), "fast": np.array([1, 1e-9])},),
     "slow 0.5; fast below 1e-6 after step 1."),
    (nb5.share_reached, ([5, 10], [0.1, 0.42], "steps", "Words."),
     "over the steps: 10 % at 5, 42 % at 10, and the most, 42 %, at 10."),
    (nb5.fastest_joint, (T, {"undamped": T, "damped": T / 2}), "value: undamped 2 rad/s, damped 1 rad/s."),
    (nb5.following, (0.5, 1, {"open": T + 1, "closed": 1 - T / 2, "low": 1 - T / 2, "high": T + 1}, 1 - T / 2),
     "All start at 1.0 cm. At the end: open 3.0 cm; closed 0.0 cm;"),
    (nb5.matches, (POINTS, POINTS + 0.1 * Z * (np.arange(len(POINTS)) == 1)[:, None], np.eye(4), [1]),
     "how far the wrong matches are off: point 1 by 100 mm."),
    (nb5.iterations, ({"a": np.array([3, 5]), "b": np.array([9])}, 10),
     "a 2 targets, median 4; b 1 targets, median 9."),
    (nb6.two_elbows, (ELBOWS, np.ones(2)), "to the same position, (1, 1) m. Each is bent by 90.0°,"),
    (nb6.two_elbows, (ELBOWS, np.array([1.0, 1.1])), "they miss it by 10.0 and 10.0 cm."),
    (nb6.samples, (XY, np.array([[0, 0], [1, 0], [3, 1]]), *np.array([[0, 0], [2, 2]]), 5), "3 positions: a band"),
    (nb6.clusters, ({"one": (ELBOWS, np.array([0, 1]))},), "one: q2 from 90 to 90 and -90 to -90 degrees in the"),
    (nb6.two_cells, (ELBOWS, XY[:2], np.array([True, False]), np.ones(2, bool)), "q2 from 90 to 90 and -90 to -90 deg"),
    (nb6.errors, ({"a": (XY[:2], np.array([0.5, 2]))}, "Words."), "half below 1.2, the largest 2.0 at (1.0, 1.0) m."),
    (nb6.convergence, (T[1:], {"affine": T[1:] ** 2}, {"affine": 2.0}), "affine falls with slope 2.0 to 4e+02."),
    (nb6.samples_as_reported, (XY, np.array([[0, 0], [1, 0], [1, 0]])), "At the right the dots of each of 2 cells have"),
    (nb6.errors_as_reported, (XY[:2], np.array([0.5, 2])), "bar from 0 to 2.0 cm; 50% of them are below 1 cm"),
    (nb6.by_bend, (np.array([0, 2, 10, 90]), np.array([0.1, 0.3, 0.02])), "largest, 0.30 cm, between 2 and 10"),
    (nb6.costs, ({"a table": 240000}, {"a table": 0.21}), "a table: 240,000 bytes, 0.21 cm."),
]  # fmt: skip  # one picture a line, but for long words


@pytest.fixture(scope="module")
def made():
    return [function(*arguments) for function, arguments, _ in PICTURES]


@pytest.fixture(scope="module")
def outputs(made):
    """What show makes of every third plot: a PNG takes long."""
    return {i: shown(p) for i, p in enumerate(made) if isinstance(p, Picture) and i % 3 == 0}


def test_every_picture_says_what_its_data_say(made):
    for picture, (function, _, words) in zip(made, PICTURES, strict=True):
        assert words in picture.alt + picture.caption, function.__name__
        assert len(picture.alt) > 50
        assert picture.alt.endswith(".")
        assert (
            picture.caption.endswith(".")
            or function.__name__.endswith("movie")
            or "?" in picture.caption
        )


def test_plots_have_the_same_bytes_again(made, outputs):
    for i, output in outputs.items():
        assert output.metadata["image/png"]["alt"] == output.data["text/plain"] == made[i].alt
        function, arguments, _ = PICTURES[i]
        kind = PLOTLY if PLOTLY in output.data else "image/png"
        assert set(output.data) == {kind, "text/plain"}
        assert shown(function(*arguments)).data[kind] == output.data[kind], function.__name__
        assert b"Software" not in output.data.get("image/png", b""), "the version that drew it"


def test_plots_name_every_axis(made):
    shown_by = [
        (p.fig, f) for p, (f, *_) in zip(made, PICTURES, strict=True) if isinstance(p, Picture)
    ]
    plots = [fig for fig, f in shown_by if isinstance(fig, Figure) and f != three_views]
    for fig in plots:
        for ax in fig.axes:
            beside = ax.get_shared_y_axes().get_siblings(ax)
            below = ax.get_shared_x_axes().get_siblings(ax)
            assert any(each.get_xlabel() for each in below) or ax.get_label() == "<colorbar>"
            assert any(each.get_ylabel() for each in beside) or len(fig.axes) > 1


# ---- letters on a phone ----

PHONE = 358  # pixels: a picture on a phone 390 wide
MIN_LETTERS = 10.5  # pixels
MIN_EXPONENTS = 9
EXPONENT = 0.7  # of the letters beside it, as matplotlib draws it


def phone_scale(fig):
    """How much smaller a phone shows a plot whose panels it stacks than it was drawn."""
    metadata = shown(Picture(fig, ALT)).metadata["image/png"]
    ends = [0, *metadata.get("cuts", []), metadata["width"]]
    enlargement = metadata["width"] / (96 * fig.get_size_inches()[0])
    return enlargement * min(1, PHONE / np.diff(ends).max())


def letters(fig):
    """The words of a figure, and their height in pixels as drawn."""
    texts = [text for text in fig.findobj(Text) if text.get_visible() and text.get_text().strip()]
    return {text.get_text(): text.get_fontsize() * 96 / 72 for text in texts}


def matplotlib_plots(made):
    return [p.fig for p in made if isinstance(p, Picture) and isinstance(p.fig, Figure)]


@pytest.mark.slow
def test_a_phone_shows_the_letters_of_every_plot_readably(made):
    plots = matplotlib_plots(made)
    assert len(plots) > 15
    for fig in plots:
        scale = phone_scale(fig)
        for words, height in letters(fig).items():
            least = MIN_EXPONENTS / EXPONENT if "10^" in words else MIN_LETTERS
            assert scale * height >= least, words


def test_no_plot_of_the_lessons_has_a_small_fraction(made):
    assert not any(r"\frac" in words for fig in matplotlib_plots(made) for words in letters(fig))


def test_a_panel_too_wide_for_a_phone_is_refused():
    plane_figure(2 * MAX_PANEL_WIDTH, 3, columns=2)
    with pytest.raises(ValueError, match=r"width must be at most .* for each of the 2 columns"):
        plane_figure(2 * MAX_PANEL_WIDTH + 0.1, 3, columns=2)


@pytest.mark.parametrize(("width", "height"), [(4.4, 3.2), (4.4, 6), (4.4, 9), (9.2, 3)])
def test_a_plot_is_never_blurred_when_shown_larger(width, height):
    fig, _ = plane_figure(width, height, columns=2 if width > MAX_PANEL_WIDTH else 1)
    output = shown(Picture(fig, ALT))
    metadata = output.metadata["image/png"]
    dots = Image.open(io.BytesIO(output.data["image/png"])).width
    assert dots >= 1.4 * metadata["width"]
    assert metadata["width"] >= round(96 * width)
    assert metadata["width"] / metadata["height"] == pytest.approx(width / height, rel=0.01)
    if height == 3.2:
        assert 550 < metadata["width"] <= 760


def test_charts_name_every_axis_and_its_unit(made):
    for picture in made:
        if isinstance(picture, Picture) and is_chart(picture.fig):
            layout = picture.fig.to_plotly_json()["layout"]
            in_space = any(key.startswith("scene") for key in layout)
            for axes in [] if in_space else layout["meta"]["panels"]:
                for axis in axes:
                    assert layout[f"{axis[0]}axis{axis[1:]}"]["title"]["text"]


def as_stored(picture):
    """The JSON of a toy or a chart, or None for a plot, whose PNG nobody compares."""
    if isinstance(picture, Toy):
        return json.dumps(picture.stored())
    return json.dumps(stored(picture.fig)) if is_chart(picture.fig) else None


def test_the_last_bits_of_a_machine_do_not_reach_the_file(made):
    for (function, arguments, _), picture in zip(PICTURES, made, strict=True):
        shaken = [
            a * (1 + 1e-15) if isinstance(a, np.ndarray) and a.dtype == float else a
            for a in arguments
        ]
        again = as_stored(picture) and as_stored(function(*shaken))
        assert as_stored(picture) == again, function.__name__


# ---- show ----


def test_pages_may_cut_panels_apart_that_are_side_by_side():
    fig, (left, right) = plane_figure(8, 3, 2)
    right.set(
        ylabel="y (m)",
        xlim=(-2, 2),
        ylim=(-2, 2),
        aspect="equal",
        title="A title as wide as its panel is",
    )
    left.set_title("Another one, which is about as wide")
    (cut,) = shown(Picture(fig, ALT)).metadata["image/png"]["cuts"]
    assert 768 * left.get_position().x1 < cut < 768 * right.get_position().x0
    assert "cuts" not in shown(Picture(plane_figure(6, 6, 2, rows=2)[0], ALT)).metadata["image/png"]


@pytest.mark.parametrize("alt", ["", "short", None, 3])
def test_a_picture_without_words_is_refused(alt):
    with pytest.raises(ValueError, match="alt must say"):
        show(Figure(), alt=alt)
    with pytest.raises(
        ValueError, match="fig must be a plotly or matplotlib figure; it is of type list"
    ):
        show([1, 2], alt=ALT)


def test_a_caption_is_an_output_of_its_own():
    words = "It rises by $\\pi$."
    with mock.patch("IPython.display.display") as display:
        show(Picture(Figure(), "Words that are replaced", "Others"), alt=ALT, caption=words)
    (data, figure), (_, caption) = (
        (*call.args, call.kwargs["metadata"]) for call in display.call_args_list
    )
    assert data["text/plain"] == ALT
    assert "caption" not in figure
    assert caption == {"caption": words}
    assert display.call_args.args == ({"text/markdown": words, "text/plain": words},)
    with pytest.raises(ValueError, match="caption must be a sentence"):
        show(Figure(), alt=ALT, caption=3)


# ---- plots and tables ----


def test_a_count_that_rounding_decides_is_about_half():
    assert tables.mirrored(4, [120.0, 1, 2], [3.0, 1, 2]) == ("1 of 3", 2.0)
    assert tables.mirrored(3, [120.0, 1, 90, 2], [3.0, 1, 3, 2]) == ("about half of 4", 2.5)
