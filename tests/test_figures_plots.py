"""Plots and movies in the plane draw the numbers that they are given: lines, dots, arms,
histograms."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from course_lib import rotations
from course_lib.arms import planar_arm
from course_lib.figures.style import BLUE, CRIMSON
from course_lib.lessons.decomposition_ik import figures as nb6
from course_lib.lessons.panda_dh_ik import figures as nb5
from course_lib.lessons.poe_kuka_iiwa import figures as nb4
from course_lib.lessons.rigid_motion import figures as nb2
from course_lib.lessons.subproblems_damped_ik import figures as nb3
from course_lib.planar import interpolate_arm, interpolate_body

N = 31
POSES = interpolate_body([-7, -5, 2.6], [6, 5, -2.2], N)
ANGLES = interpolate_arm([0.1, 0.2], [np.pi - 0.2, np.pi / 2], N)
ARM = planar_arm([1, 1]).frames(ANGLES)[..., :2, 3]
TARGET = np.array([-1.9, 1.1])
SPACE = np.random.default_rng(2).normal(size=(9, 3))
ELBOWS = np.array([[0.0, np.pi / 2], [np.pi / 2, -np.pi / 2]])
STEPS = np.arange(N)
S = np.linspace(0.01, 4.2, 300)
COSTS = {"table": 240000, "formula": 16}, {"table": 0.2, "formula": 2e-14}


def wrist_rates(b):
    """The columns of Ry(b1) Rx(b2) Ry(b3): the axes of its rates."""
    first = rotations.rot_y(b[0])
    return np.column_stack([[0, 1, 0], first[:, 0], (first @ rotations.rot_x(b[1]))[:, 1]])


def over(x, *series):
    return [np.stack([x, y], -1) for y in series]


B2 = np.linspace(0.02, np.pi - 0.02, 301)
MISS = np.hypot(*(ARM[:, -1] - TARGET).T)
DESCENT = nb3.descents({"run": ARM, "back": ARM[::-1]}, TARGET, "")
# (picture, which of its panels, the points of the lines that it draws first)
LINES = {
    "outlines": (nb2.past_a_gate({"a": POSES}), 0, [POSES[:, :2], *(nb2.outline(POSES[i]) for i in (0, 16, 30))]),
    "Euler": (nb2.euler_paths({"a": POSES[:, :2], "b": ARM[:, -1]}), 0, [POSES[:, :2], ARM[:, -1]]),
    "car": (nb2.parking(POSES, [1, 2, 1.6], [0.6, 1, 0.4], 0.5), 0, [POSES[:, :2]]),
    "arm": (nb2.arm_paths({"a": ARM}), 0, [*ARM[::10], ARM[:, -1]]),
    "descent": (DESCENT, 0, [ARM[:, -1], ARM[-1], ARM[::-1, -1], ARM[0], [TARGET]]),
    "distance": (DESCENT, 1, over(STEPS, MISS, MISS[::-1])),
    "rates": (nb3.largest_rates(lambda b: np.linalg.inv(wrist_rates(b))), 0,
              over(B2, 1 / np.sqrt(1 - np.abs(np.cos(B2))), 1 / np.sin(B2))),
    "elbows": (nb6.two_elbows(ELBOWS, np.ones(2)), 0, [[[0, 0], [1, 0], [1, 1]], [[0, 0], [0, 1], [1, 1]], [[1, 1]]]),
    "costs": (nb6.costs(*COSTS), 0, [[[240000, 0.2]], [[16, 2e-14]]]),
    "from above": (nb4.plane_projections(np.arange(9), SPACE), 0, [SPACE[:, :2]]),
    "velocities": (nb4.velocities_against_each_other(np.arange(9), {"a": SPACE, "b": 2 * SPACE}), 5,
                   [2 * SPACE[:, [1, 2]]]),
    "bounds": (nb4.near_its_bounds(np.arange(9), SPACE[:, 0], SPACE, np.outer([1, 2, 4], [-1, 3])), 1,
               over(np.arange(9), *100 * np.abs(SPACE / [2, 4, 8] - 0.5).T)),
    "scalings": (nb2.time_scalings(np.arange(9), {"a": SPACE.T, "b": 2 * SPACE.T}), 1,
                 over(np.arange(9), SPACE[:, 1], 2 * SPACE[:, 1])),
}  # fmt: skip


# Metres: the steps of an arm are drawn with the digits that every machine has in common.
ROUNDED_TO = {"descent": 5.1e-5, "distance": 5.1e-3}


def curves_of_chart(fig, panel):
    """Return the points (n, 2) of each series in a panel of a chart by plotly, in their order."""
    x_axis, y_axis = fig.layout.meta["panels"][panel]
    in_panel = [trace for trace in fig.data if (trace.xaxis, trace.yaxis) == (x_axis, y_axis)]
    return [np.stack([trace.x, trace.y], -1) for trace in in_panel]


@pytest.mark.parametrize("name", LINES)
def test_lines_go_through_their_data_and_lie_in_the_panel(name):
    picture, panel, expected = LINES[name]
    if hasattr(picture.fig, "to_plotly_json"):  # its panels always contain their data
        for points, wanted in zip(curves_of_chart(picture.fig, panel), expected, strict=False):
            assert_allclose(points, wanted, rtol=1e-7, atol=ROUNDED_TO.get(name, 1e-9))
        return
    ax = picture.fig.axes[panel]
    low, high = np.transpose([ax.get_xlim(), ax.get_ylim()])
    for line, points in zip(ax.lines, expected, strict=False):
        assert_allclose(np.transpose(line.get_data()), points, atol=1e-9)
        assert ((low <= points) & (points <= high)).all()


# A start at full speed: its acceleration is far above the bound, and no curve may be cut.
GAP = np.array([0.2, -0.01, 0.1])
MOTION = nb5.motion(np.arange(3), {"mug": GAP}, np.arange(3), [1.5, 1.5, 0], [19.3, 3e-13, 19.3])


def test_a_motion_is_drawn_without_rounding_errors():
    expected = [100 * GAP, [1.5, 1.5, 0], [19.3, 0, 19.3]]
    for panel, heights in enumerate(expected):
        (curve,) = curves_of_chart(MOTION.fig, panel)
        assert_allclose(curve, np.stack([np.arange(3), heights], -1), atol=1e-12)


def test_the_caption_of_a_motion_says_what_is_wrong_with_it():
    assert MOTION.caption.startswith(
        "The arm reaches 1.0 cm into the mug: there the curve is in the red band, which begins at "
        "a clearance of 0. The motion exceeds the bound on the speed by a factor of 1.5 and that "
        "on the acceleration by a factor of 19.3."
    )
    calm = nb5.motion(np.arange(3), {"itself": GAP + 0.1}, np.arange(3), [1, 1, 0], [0.5, 1, 0])
    assert "it is nearest to itself, at 9.0 cm. Speed and acceleration stay within" in calm.caption


def test_panels_of_a_motion_have_one_time_axis():
    assert len({x_axis for x_axis, _ in MOTION.fig.layout.meta["panels"]}) == 1


def test_lengths_of_errors_that_rounding_decides_are_drawn_alike():
    fig = nb5.descents({"one": np.array([1, 3e-16]), "other": np.array([1, 7e-15])}).fig
    one, other = curves_of_chart(fig, 0)
    assert_allclose(one, other)
    assert_allclose(one[:, 1], [1, 1e-8])


def test_each_target_is_counted_in_the_bar_of_its_iterations():
    fig = nb5.iterations({"one": np.array([0, 3, 4, 7, 8, 99])}, 8).fig
    (bars,) = fig.data
    words = [row[0] for row in bars.customdata]
    assert dict(zip(words, bars.y, strict=True)) == {"0 to 3": 2, "4 to 7": 2, "8 or more": 2}


XY = np.array([[1.0, 1.0], [0.0, 1.0], [2.0, 0.0]])
ERRORS = np.array([12.0, 0.3, np.nan])


@pytest.fixture
def dots():
    """The dots of a chart of errors at two positions; a third one has no answer."""
    picture = nb6.errors({"a": (XY, ERRORS)}, "", {"a": {"cell": np.array([7, 8, 9])}})
    (trace,) = picture.fig.data
    return picture.fig, trace


def test_an_error_that_is_missing_is_not_drawn(dots):
    _, trace = dots
    assert_allclose(np.stack([trace.x, trace.y], -1), [XY[1], XY[0]])


def test_a_larger_error_is_a_larger_dot_in_a_colour_further_on(dots):
    _, trace = dots
    small, large = trace.marker.size
    assert small < large
    assert_allclose(10 ** np.array(trace.marker.color), [0.3, 12])


def test_a_dot_says_its_error_and_its_details(dots):
    _, trace = dots
    assert [list(row) for row in trace.customdata] == [[0.3, 8], [12.0, 7]]


def test_the_largest_error_is_named_at_its_dot(dots):
    fig, _ = dots
    (note,) = [note for note in fig.layout.annotations if note.showarrow is not False]
    assert (note.text, note.x, note.y) == ("largest: 12.0 cm", 1.0, 1.0)


def impulses_of(*velocities):
    """Return the (time, height) of the arrows that a time scaling with these velocities has."""
    u = np.linspace(0, 1, len(velocities))
    curve = np.array([u, velocities, 0 * u])
    notes = nb2.time_scalings(u, {"one": curve}).fig.layout.annotations
    return [(note.x, note.y) for note in notes if note.showarrow]


def test_a_velocity_that_jumps_at_both_ends_has_two_impulses():
    assert impulses_of(1.0, 1.0, 1.0) == [(0.0, 1.0), (1.0, -1.0)]


def test_a_velocity_that_begins_and_ends_at_rest_has_no_impulse():
    assert impulses_of(0.0, 1.5, 0.0) == []


# ---- films: bodies and arms are where their data say, at each time ----

CORNERS = np.array([[-1, -0.7], [0.7, -0.7], [1.4, 0], [0.7, 0.7], [-1, 0.7], [-1, -0.7]])
TIMES = np.linspace(0, 3, N)
FILMS = [nb2.body_movie("body", POSES, TIMES), nb2.arm_movie("arm", ARM, TIMES, ARM[::-1])]
ROUNDED = 6e-4  # films keep millimetres


@pytest.mark.parametrize(("number", "track"), [(0, POSES[:, :2]), (1, ARM[:, -1])])
def test_a_film_shows_its_whole_path_within_the_window(number, track):
    """Everything that it draws stays in the window."""
    film = FILMS[number].meta
    assert film["movie"] == ["body", "arm"][number]
    assert_allclose(film["times"], TIMES, atol=1e-4)
    (path, colour, dash, *_), *others = film["still"]
    assert_allclose(path, track, atol=ROUNDED)
    assert (colour, dash) == (BLUE, [7, 5])
    seen = np.concatenate(
        [
            np.reshape(each, (-1, 2))
            for each in (*film["shapes"], *(points for points, *_ in others))
        ]
    )
    room = film["half"] * np.array([1, film["proportion"]])
    assert (np.abs(seen - film["centre"]) < room).all()


def test_the_body_stands_at_each_pose_with_its_nose_ahead():
    for corners, (x, y, theta) in zip(FILMS[0].meta["shapes"][0], POSES, strict=True):
        ahead, left = (
            np.array([np.cos(theta), np.sin(theta)]),
            np.array([-np.sin(theta), np.cos(theta)]),
        )
        assert_allclose(
            corners, [x, y] + CORNERS[:, :1] * ahead + CORNERS[:, 1:] * left, atol=ROUNDED
        )
        nose = np.array(corners)[np.argmax((corners - np.array([x, y])) @ ahead)]
        assert_allclose(nose, [x, y] + 1.4 * ahead, atol=ROUNDED)
        assert_allclose(nb2.outline([x, y, theta]), corners, atol=1e-9)


def test_a_second_body_stands_behind_the_first_in_grey():
    film = nb2.body_movie("body", POSES, TIMES, POSES[::-1]).meta
    assert film["colours"] == [nb2.GHOST, CRIMSON]
    for behind, pose in zip(film["shapes"][0], POSES[::-1], strict=True):
        assert_allclose(behind, nb2.outline(pose), atol=ROUNDED)
    for before, pose in zip(film["shapes"][1], POSES, strict=True):
        assert_allclose(before, nb2.outline(pose), atol=ROUNDED)


def test_the_answers_of_a_query_are_drawn_the_better_one_first():
    angles = np.array([[[0.1, 0.2], [0.3, 0.4]], [[0.5, 0.6], [np.nan, np.nan]]])
    errors = np.array([[2.0, 1.0], [3.0, np.nan]])
    course = nb6.errors_of_arm(np.ones((2, 2)), angles, errors, [7, 8], "Words.").meta
    assert course["angles"] == [[[0.3, 0.4], [0.5, 0.6]], [[0.1, 0.2], None]]
    assert course["errors"] == [[1.0, 3.0], [2.0, None]]
    assert course["cells"] == [7, 8]


def test_a_descent_is_drawn_alike_when_rounding_differs():
    noise = 1e-10 * np.random.default_rng(1).normal(size=ARM.shape)
    near = TARGET + 1e-9 * SPACE[:, :2]  # where rounding decides all digits of a distance
    runs = [np.concatenate([ARM, np.tile(near[:, None], (1, 3, 1))])]
    runs.append(runs[0] + np.concatenate([noise, 1e-10 * SPACE[:, None, :2] * np.ones((1, 3, 1))]))
    first, second = (nb3.descents({"run": run}, TARGET, "").fig.to_json() for run in runs)
    assert first == second


def test_the_pointer_says_nothing_on_an_arm_that_a_run_ends_with():
    tip, arm, *_ = nb3.descents({"run": ARM / 10}, TARGET, "").fig.data
    assert (arm.hoverinfo, arm.hovertemplate) == ("skip", None)
    assert "distance from the target" in tip.hovertemplate
