"""The picture with two sliders: whatever they are set to, the windows show the data of that pair and no other."""

import json
import re
from itertools import pairwise

import numpy as np
import pytest
from helpers import ALT, FIGURE, places, shown, stored
from numpy.testing import assert_allclose

from course_lib.arms import planar_arm
from course_lib.figures.explorer import explorer
from course_lib.figures.style import BLACK, BLUE, CRIMSON, GREEN, PURPLE

ALPHAS, EPSILONS = np.array([0.05, 0.2, 2.8]), np.array([0.5, 8])
START, TARGET = (1, 0), np.array([-1.9, 1.1])
SINGULAR = np.array([[2.5, 1.2], [2.4, 1.1]])
PAIRS = [(i, j) for i in range(3) for j in range(2)]
NUMBERS = ("", "2", "3")  # as plotly counts axes
EACH_PAIR = pytest.mark.parametrize("pair", PAIRS, ids=str)


def runs():
    """Arms (3, 2, 61, 5, 2) that wander: one is cut short, one has longer links and leaves the window."""
    q = np.random.default_rng(1).normal(0, 0.2, (3, 2, 61, 4)).cumsum(-2) * [1, 0.1, 0.1, 0.1]
    points = planar_arm([1, 1, 1, 1]).frames(q)[..., :2, 3]
    points[2, 0, 44:] = np.nan
    points[1, 1] *= 1.15
    return points


def explored(shake=1.0):
    return explorer(ALPHAS * shake, EPSILONS * shake, runs() * shake, TARGET * shake, SINGULAR * shake, START)


@pytest.fixture(scope="module")
def figure():
    return stored(explored())


def window(figure, pair, number):
    """The corners (2, 2) of what a panel shows when the sliders are set to a pair: low (x, y), then high."""
    steps = [slider["steps"][k] for slider, k in zip(figure["layout"]["sliders"], pair, strict=True)]
    limits = steps[0]["args"][0] | steps[1]["args"][0]
    return np.transpose([limits[f"{c}axis{number}.range"] for c in "xy"])


def within(points, corners):
    """Which points lie in a window, its edge included as far as the figure is rounded."""
    return ((points > corners[0] - 1e-3) & (points < corners[1] + 1e-3)).all(-1)


def seen(figure, pair, number):
    """What stands in a panel's window: {(mode, colour): places (n, 2)}, moved back to where the data were."""
    corners = window(figure, pair, number)
    found = {}
    for trace in figure["data"]:
        assert trace["xaxis"][1:] == trace["yaxis"][1:]
        if trace["xaxis"] == f"x{number}":
            here = places(trace)[within(places(trace), corners)]
            look = trace.get("line") or trace.get("marker") or trace["textfont"]
            found[trace["mode"], look["color"]] = here - corners[0] + window(figure, (0, 0), number)[0]
    return found


def inside(figure, number, points):
    """The points that a panel's window can show."""
    points = np.array(points)
    return points[within(points, window(figure, (0, 0), number))]


def assert_seen(figure, pair, number, expected):
    got = seen(figure, pair, number)
    assert got.keys() == expected.keys()
    for look, points in expected.items():
        assert_allclose(got[look], inside(figure, number, points), atol=2e-3, err_msg=str(look))


def test_it_is_shown_with_words_and_the_same_on_every_machine(figure):
    output = shown(explored())
    assert set(output.data) == {FIGURE, "text/plain"}
    assert output.data["text/plain"] == output.metadata["image/png"]["alt"] == ALT
    assert json.dumps(figure) == json.dumps(stored(explored(shake=1 + 1e-15)))


@EACH_PAIR
def test_the_first_panel_shows_the_way_the_last_posture_and_the_target(figure, pair):
    run = runs()[pair]
    run = run[np.isfinite(run[:, 0, 0])]
    steps = [k for k in range(len(run)) if k < 30 or k % 3 == 0]
    assert_seen(
        figure,
        pair,
        "",
        {("lines", BLUE): run[steps, -1], ("lines", CRIMSON): run[-1], ("markers", BLACK): [TARGET]},
    )


@EACH_PAIR
def test_the_second_panel_shows_the_distance_left_at_each_step(figure, pair):
    run = runs()[pair]
    steps = [k for k in range(len(run)) if (k < 30 or k % 3 == 0) and np.isfinite(run[k, 0, 0])]
    distances = np.hypot(*(run[steps, -1] - TARGET).T)
    assert_seen(figure, pair, "2", {("lines", BLUE): np.stack([steps, np.log10(distances)], -1)})


@EACH_PAIR
def test_the_third_panel_shows_the_step_for_each_singular_value(figure, pair):
    alpha, eps = ALPHAS[pair[0]], EPSILONS[pair[1]]
    got = seen(figure, pair, "3")
    step, twice = got["lines", BLUE], got["lines", PURPLE]
    assert len(step) > 20
    assert_allclose(10 ** step[:, 1], alpha * step[:, 0] / (step[:, 0] ** 2 + eps), rtol=5e-3)
    assert np.ptp(step[:, 0]) > 3.5
    assert_allclose(10 ** twice[:, 1], 2 / twice[:, 0], rtol=5e-3)
    bound = np.log10(alpha / (2 * np.sqrt(eps)))
    assert_allclose(got["lines", GREEN], [[0, bound], [4.2, bound]], atol=2e-3)
    assert step[:, 1].max() <= bound + 2e-3
    s = SINGULAR[pair[1]]
    assert_allclose(got["markers", CRIMSON], np.stack([s, np.log10(alpha * s / (s**2 + eps))], -1), atol=2e-3)


@EACH_PAIR
def test_the_words_name_the_step_size_and_its_limit(figure, pair):
    (trace,) = [trace for trace in figure["data"] if trace["mode"] == "text"]
    here = within(places(trace), window(figure, pair, "3"))
    (words,) = [word for word, stands in zip(trace["text"], here, strict=True) if stands]
    alpha, limit = ALPHAS[pair[0]], 2 * (1 + EPSILONS[pair[1]] / SINGULAR[pair[1]].max() ** 2)
    said = re.fullmatch(r"alpha = (\S+) is (below|above) its limit (\S+)", words)
    assert float(said[1]) == alpha
    assert said[2] == ("below" if alpha < limit else "above")
    assert float(said[3]) == pytest.approx(limit, abs=0.005)


def test_the_pairs_hold_the_hard_cases(figure):
    assert ALPHAS[0] < 2 * (1 + EPSILONS[0] / 2.5**2) < ALPHAS[-1], "below the limit and above"
    assert np.isnan(runs()[2, 0, -1]).all(), "a run that is cut short"
    reaches = runs()[1, 1, :, -1]
    assert 0 < len(inside(figure, "", reaches)) < len(reaches), "a run that leaves the window"


def test_every_point_stands_in_one_window_and_no_line_runs_between_two(figure):
    for trace in figure["data"]:
        points = places(trace)
        drawn = np.isfinite(points[:, 0])
        windows = np.array([within(points, window(figure, pair, trace["xaxis"][1:])) for pair in PAIRS])
        assert (windows[:, drawn].sum(0) == 1).all()
        joined = drawn[1:] & drawn[:-1]
        cells = windows.argmax(0)
        if trace["mode"] == "lines":
            assert (cells[1:] == cells[:-1])[joined].all()


@pytest.mark.parametrize("number", NUMBERS)
def test_windows_do_not_overlap_and_leave_room_between_them(figure, number):
    for axis in (0, 1):
        ranges = sorted({tuple(window(figure, pair, number)[:, axis]) for pair in PAIRS})
        assert len(ranges) == (3, 2)[axis]
        for (low, high), (next_low, _) in pairwise(ranges):
            assert next_low - high >= high - low


@EACH_PAIR
@pytest.mark.parametrize("number", NUMBERS)
def test_ticks_in_a_window_read_the_values_that_stand_there(figure, pair, number):
    corners, base = window(figure, pair, number), window(figure, (0, 0), number)
    for axis, letter in enumerate("xy"):
        settings = figure["layout"][f"{letter}axis{number}"]
        ticks = zip(settings["tickvals"], settings["ticktext"], strict=True)
        low, high = corners[:, axis]
        read = {tick - low + base[0, axis]: float(text) for tick, text in ticks if low <= tick <= high}
        assert len(read) >= 4
        for value, said in read.items():
            logarithmic = letter == "y" and number  # the ways of the tip are in metres
            assert said == pytest.approx(10.0**value if logarithmic else value)


def test_it_begins_with_the_pair_that_it_is_asked_for(figure):
    sliders = figure["layout"]["sliders"]
    assert tuple(slider["active"] for slider in sliders) == START
    for number in NUMBERS:
        shown_first = [figure["layout"][f"{letter}axis{number}"]["range"] for letter in "xy"]
        assert_allclose(np.transpose(shown_first), window(figure, START, number))


def test_the_sliders_name_their_values_and_each_moves_its_own_axes(figure):
    for slider, values, letter in zip(figure["layout"]["sliders"], (ALPHAS, EPSILONS), "xy", strict=True):
        assert [float(step["label"]) for step in slider["steps"]] == values.tolist()
        for step in slider["steps"]:
            assert step["method"] == "relayout"
            assert set(step["args"][0]) == {f"{letter}axis{number}.range" for number in NUMBERS}
    assert [s["currentvalue"]["prefix"] for s in figure["layout"]["sliders"]] == [
        "step size alpha: ",
        "damping epsilon (m²): ",
    ]


def test_every_axis_has_a_title_and_the_plane_has_equal_scales(figure):
    titles = [figure["layout"][f"{c}axis{number}"]["title"]["text"] for number in NUMBERS for c in "xy"]
    assert all(title.endswith((")", "steps")) for title in titles)
    axis = figure["layout"]["yaxis"]
    assert (axis["scaleanchor"], axis["scaleratio"]) == ("x", 1)
