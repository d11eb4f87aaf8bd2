"""Joint trajectories: what is read is what was written, and a broken file is refused by row and
column."""

import re

import numpy as np
import pytest

from course_lib.trajectory import Trajectory, UnclearFileError, disagreement, load, save

HEADER = "t,q1,q2,qd1,qd2"
ROWS = ["0,0.1,0.2,1,2", "0.5,0.3,-0.4,3,4", "1,0.5,0.6,5,6"]
LIMITS = np.array([[-np.inf, np.inf], [-0.5, 0.7]])


@pytest.fixture
def file(tmp_path):
    def write(*lines, name="own.csv", encoding="utf-8"):
        path = tmp_path / name
        path.write_text("\n".join(lines) + "\n", encoding=encoding)
        return path

    return write


def refusal(path, limits=None):
    with pytest.raises(ValueError, match=re.escape(path.name)) as refused:
        load(path, limits)
    return str(refused.value)


def changed(row, column, value):
    """The rows with one cell changed, both counted as in the message."""
    cells = ROWS[row - 1].split(",")
    cells[HEADER.split(",").index(column)] = value
    return [*ROWS[: row - 1], ",".join(cells), *ROWS[row:]]


def test_csv_is_read_by_the_names_of_its_columns(file):
    shuffled = [",".join(np.array(line.split(","))[[3, 0, 2, 4, 1]]) for line in (HEADER, *ROWS)]
    for path in (
        file(HEADER, *ROWS),
        file(*shuffled, name="b.csv"),
        file(HEADER, "", *ROWS, "", name="c.CSV"),
    ):
        read = load(path, LIMITS)
        assert read.t.tolist() == [0, 0.5, 1]
        assert read.q.tolist() == [[0.1, 0.2], [0.3, -0.4], [0.5, 0.6]]
        assert read.qd.tolist() == [[1, 2], [3, 4], [5, 6]]


def test_a_spreadsheets_csv_is_read(file):
    quoted = '"' + HEADER.replace(",", '" , "') + '"'
    assert load(
        file(quoted, *(row.replace(",", ";") for row in ROWS), ",,,,", encoding="utf-8-sig")
    ).q.shape == (3, 2)


def test_npy_is_read(tmp_path):
    table = np.array([row.split(",") for row in ROWS], float)
    np.save(tmp_path / "a.npy", table)
    read = load(tmp_path / "a.npy", LIMITS)
    assert np.array_equal(np.column_stack([read.t, read.q, read.qd]), table)


def test_what_is_saved_is_read_again(tmp_path):
    rng = np.random.default_rng(1)
    made = Trajectory(np.arange(5) / 7, *rng.normal(size=(2, 5, 7)))
    save(tmp_path / "a.csv", made)
    read = load(tmp_path / "a.csv")
    for name in ("t", "q", "qd"):
        np.testing.assert_allclose(getattr(read, name), getattr(made, name), rtol=0, atol=1e-10)


@pytest.mark.parametrize(
    ("row", "column", "value", "words"),
    [
        (2, "q2", "nan", "is not a finite number"),
        (1, "q1", "left", "'left', which is not a number"),
        (1, "t", "", "'', which is not a number"),
        (2, "q2", "-0.6", "is -0.6000 rad, outside -0.5000 to 0.7000"),
        (3, "t", "0.5", "is 0.5 s, after 0.5 s: time must increase"),
    ],
)
def test_a_bad_cell_is_named(file, row, column, value, words):
    message = refusal(file(HEADER, *changed(row, column, value)), LIMITS)
    assert f"row {row}, column {column} " in message
    assert words in message


@pytest.mark.parametrize("column", HEADER.split(","))
def test_a_missing_column_is_named(file, column):
    keep = [i for i, name in enumerate(HEADER.split(",")) if name != column]
    lines = [",".join(line.split(",")[i] for i in keep) for line in (HEADER, *ROWS)]
    assert f"column {column} is missing" in refusal(file(*lines))


def test_other_broken_files(file, tmp_path):
    assert "column q1 occurs twice" in refusal(file("t,q1,q1,qd1,qd2", *ROWS))
    assert "row 2 has 4 columns, not 5" in refusal(file(HEADER, ROWS[0], "1,2,3,4"))
    assert "it must hold a row of numbers" in refusal(file(HEADER))
    (tmp_path / "x.csv").write_bytes(b"\xff\xfe\x00")
    assert "cannot be read as a table" in refusal(tmp_path / "x.csv")
    (tmp_path / "x.npy").write_bytes(b"no array")
    assert "cannot be read as NPY" in refusal(tmp_path / "x.npy")
    np.save(tmp_path / "o.npy", np.array([[1, "a", None]], dtype=object))
    assert "cannot be read as NPY" in refusal(tmp_path / "o.npy")  # nothing is unpickled
    np.save(tmp_path / "s.npy", np.zeros((3, 4)))
    assert "must begin with a header, or hold t, q1" in refusal(tmp_path / "s.npy")


def test_bad_arguments(file, tmp_path):
    with pytest.raises(
        ValueError, match=r"path must name a \.csv, \.tsv, \.txt, \.dat or \.npy file"
    ):
        load(tmp_path / "a.xlsx")
    for units in (("h", "rad"), ("s",), ("s", "turns")):
        with pytest.raises(ValueError, match=r"^units must be"):
            load(file(HEADER, *ROWS), units=units)
    assert load(file(HEADER, *ROWS), units={"t": "ms"}).t.tolist() == [0, 0.0005, 0.001]
    with pytest.raises(FileNotFoundError):
        load(tmp_path / "none.csv")
    with pytest.raises(ValueError, match=r"^limits must be an array of real numbers of shape"):
        load(file(HEADER, *ROWS), np.zeros((7, 3)))
    with pytest.raises(ValueError, match=r"^trajectory must be a Trajectory"):
        save(tmp_path / "a.csv", np.zeros((3, 3)))
    with pytest.raises(ValueError, match=r"^trajectory must hold t"):
        save(tmp_path / "a.csv", Trajectory(np.zeros(2), np.zeros((3, 1)), np.zeros((3, 1))))


def two_files(folder, q, qd, kind="csv", **how):
    """Write positions and velocities as tables of their own, and return both paths."""
    paths = [folder / f"{name}.{kind}" for name in ("positions", "velocities")]
    for path, table in zip(paths, (q, qd), strict=True):
        np.save(path, table) if kind == "npy" else np.savetxt(path, table, **how)
    return paths


ANGLES = np.random.default_rng(2).uniform(-0.4, 0.4, (7, 200))
SEVEN = np.tile([-0.5, 0.5], (7, 1))
STEP = 4 * np.pi / 200


@pytest.mark.parametrize(
    "how", [{"delimiter": ","}, {}, {"delimiter": ";"}, {"delimiter": ",", "header": "joints"}]
)
@pytest.mark.parametrize("upright", [False, True])
def test_two_files_with_joints_as_rows_or_columns_are_read(tmp_path, how, upright):
    tables = [table.T if upright else table for table in (ANGLES, 2 * ANGLES)]
    for paths in (two_files(tmp_path, *tables, **how), two_files(tmp_path, *tables, kind="npy")):
        read = load(paths[0], SEVEN, velocities=paths[1], step=STEP)
        np.testing.assert_allclose(read.q, ANGLES.T)
        np.testing.assert_allclose(read.qd, 2 * ANGLES.T)
        np.testing.assert_allclose(read.t, STEP * np.arange(200))


def test_a_bad_cell_of_two_files_is_named_where_it_stands(tmp_path):
    q, qd = ANGLES.copy(), ANGLES.copy()
    qd[2, 39] = np.nan
    paths = two_files(tmp_path, q, qd, delimiter=",")
    with pytest.raises(
        ValueError, match=r"velocities\.csv: row 3, column 40 is not a finite number"
    ):
        load(paths[0], SEVEN, paths[1], STEP)
    q[6, 0] = 0.7
    paths = two_files(tmp_path, q.T, ANGLES.T)
    with pytest.raises(
        ValueError, match=r"positions\.csv: row 1, column 7 is 0\.7000 rad, outside"
    ):
        load(paths[0], SEVEN, paths[1], STEP)


def test_two_files_that_do_not_belong_together(tmp_path):
    paths = two_files(tmp_path, ANGLES, ANGLES[:, 1:], delimiter=",")
    with pytest.raises(ValueError, match=r"positions and velocities must have one shape"):
        load(paths[0], SEVEN, paths[1], STEP)
    with pytest.raises(ValueError, match="velocities need the time step"):
        load(paths[0], SEVEN, velocities=paths[1])
    for step in (0, -1, np.nan, [0.1, 0.2], "x"):
        with pytest.raises(ValueError, match=r"^step must"):
            load(paths[0], SEVEN, paths[1], step)
    assert "give the time step, and the file of the velocities" in refusal(paths[0], SEVEN)


def titled_files(folder, title_of_velocities):
    """Write positions q1 to q7 and velocities with titles of this form, and return both paths."""
    tables = ANGLES.T, 2 * ANGLES.T
    paths = [folder / f"{name}.csv" for name in ("positions", "velocities")]
    for path, title, table in zip(paths, ("q{}", title_of_velocities), tables, strict=True):
        header = ",".join(title.format(i) for i in range(1, 8))
        np.savetxt(path, table, delimiter=",", header=header, comments="")
    return paths


@pytest.mark.parametrize("columns", [{"qd": "foo_*"}, {"q": "q*", "qd": "foo_*"}])
def test_columns_name_the_velocities_of_a_second_file(tmp_path, columns):
    positions, velocities = titled_files(tmp_path, "foo_{}")
    with pytest.raises(
        UnclearFileError, match=r"velocities\.csv: (.*\n)*.*columns=\{\"qd\": \"foo_"
    ):
        load(positions, velocities=velocities, step=STEP)
    read = load(positions, velocities=velocities, step=STEP, columns=columns)
    np.testing.assert_allclose(read.qd, 2 * ANGLES.T)
    np.testing.assert_allclose(read.q, ANGLES.T)


def test_titles_of_angles_may_name_the_velocities_of_a_second_file(tmp_path):
    positions, velocities = titled_files(tmp_path, "q{}")
    read = load(positions, velocities=velocities, step=STEP)
    np.testing.assert_allclose(read.qd, 2 * ANGLES.T)


def test_titles_without_numbers_of_a_second_file_are_shown_as_they_are_to_be_written(tmp_path):
    positions, velocities = (tmp_path / f"{name}.csv" for name in ("positions", "velocities"))
    positions.write_text("q1,q2\n0,0\n1,2\n")
    velocities.write_text("alpha,beta\n1,2\n1,2\n")
    with pytest.raises(UnclearFileError) as asked:
        load(positions, velocities=velocities, step=STEP)
    assert 'columns={"qd": ["alpha", "beta"]}' in str(asked.value)
    read = load(positions, None, velocities, STEP, columns={"qd": ["alpha", "beta"]})
    np.testing.assert_allclose(read.qd, [[1, 2], [1, 2]])


def test_a_second_file_with_angles_too_gives_its_velocities(tmp_path):
    positions, _ = titled_files(tmp_path, "qd{}")
    both = tmp_path / "both.csv"
    header = ",".join(f"{kind}{i}" for kind in ("q", "qd") for i in range(1, 8))
    table = np.hstack([ANGLES.T, 3 * ANGLES.T])
    np.savetxt(both, table, delimiter=",", header=header, comments="")
    read = load(positions, velocities=both, step=STEP)
    np.testing.assert_allclose(read.qd, 3 * ANGLES.T)


def test_a_missing_column_of_a_second_file_is_asked_for_as_a_velocity(tmp_path):
    positions, velocities = titled_files(tmp_path, "q{}")
    velocities.write_text(velocities.read_text().replace("q3", "effort", 1))
    with pytest.raises(UnclearFileError, match=r'column qd3 is missing(.*\n)*.*columns=\{"qd": \['):
        load(positions, velocities=velocities, step=STEP)


@pytest.mark.parametrize(
    ("argument", "refused"),
    [
        ({"step": 0.1, "units": {"t": "ms"}}, r'^units must not have "t" beside step=0\.1'),
        ({"step": 0.1, "columns": {"t": "q1"}}, r'^columns must not have "t" beside step=0\.1'),
        ({"step": 0.1, "units": {"qd": "deg/s"}}, r'^units must not have "qd", because no angular'),
    ],
)
def test_arguments_that_nothing_is_read_for_are_refused(tmp_path, argument, refused):
    positions, _ = titled_files(tmp_path, "qd{}")
    with pytest.raises(ValueError, match=refused):
        load(positions, **argument)


def test_a_unit_of_seconds_and_nanoseconds_is_refused(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text("stamp_sec,stamp_nanosec,q1\n1,0,0.1\n1,500000000,0.2\n")
    np.testing.assert_allclose(load(path).t, [1, 1.5])
    with pytest.raises(ValueError, match=r'^units must not have "t", because times are read from'):
        load(path, units={"t": "ms"})


def swinging(step, factor=1.0, n=200):
    t = STEP * np.arange(n)
    speed = np.linspace(0.5, 2, 7)
    return Trajectory(
        step * np.arange(n), np.sin(np.outer(t, speed)), factor * speed * np.cos(np.outer(t, speed))
    )


def test_times_that_disagree_with_the_velocities_are_said():
    assert disagreement(swinging(STEP)) == ""
    said = (
        "The velocities fit times that are 1.26 times as far apart: a mean step of about 0.063 s, "
        "not 0.05 s."
    )
    assert disagreement(swinging(0.05)) == said
    assert "0.0175 times as far apart" in disagreement(swinging(STEP, np.rad2deg(1)))
    assert "not those of the positions" in disagreement(swinging(STEP, -1))
    assert "not those of the positions" in disagreement(swinging(STEP, 0))
    assert "times that are 0.918 times as far apart" in disagreement(swinging(1.09 * STEP))
    for joint in range(7):
        still = swinging(STEP)
        still.qd[:, joint] = 0
        assert f"The velocities of joint {joint + 1} are not those" in disagreement(still)
        still.qd[:, joint] = 1.05 * swinging(STEP).qd[:, joint]
        assert f"times as fast as the velocities of joint {joint + 1} say" in disagreement(still)


def test_few_samples_disagree_with_nothing():
    for n in (1, 2, 3, 6):
        assert disagreement(swinging(STEP, n=n)) == ""


def test_an_arm_that_stands_still_disagrees_with_nothing():
    assert disagreement(Trajectory(np.arange(9.0), np.full((9, 7), 0.3), np.zeros((9, 7)))) == ""


def curve(n=200):
    """Times and angles of a smooth motion of two joints, evenly spaced by 2 pi / 100 s."""
    t = 2 * np.pi / 100 * np.arange(n)
    return t, np.stack([0.3 * np.sin(t) - 0.7, 0.2 * np.cos(2 * t)], 1)


def test_backward_differences_are_called_half_a_step_late():
    """A first row of zeros is mentioned."""
    t, q = curve()
    qd = np.vstack([np.zeros(2), np.diff(q, axis=0) / t[1]])
    assert (
        disagreement(Trajectory(t, q.round(9), qd.round(9)))
        == "The velocities are differences with the sample before: each is half a step, about 0.031"
        " s, late, and the first row is zero."
    )


def test_forward_differences_are_said_to_be_half_a_step_early():
    t, q = curve()
    slopes = np.diff(q, axis=0) / t[1]
    said = disagreement(Trajectory(t, q, np.vstack([slopes, slopes[-1]])))
    assert "differences with the sample after: each is half a step, about 0.031 s, early." in said


def test_other_velocities_are_not_called_backward_differences():
    t, q = curve()
    exact = np.stack([0.3 * np.cos(t), -0.4 * np.sin(2 * t)], 1)
    for qd in (exact, np.gradient(q, t, axis=0)):
        assert disagreement(Trajectory(t, q, qd)) == ""


def test_a_constant_velocity_is_not_called_a_difference():
    t = np.arange(20) / 10
    q, qd = np.outer(t, [1, -2]), np.tile([1.0, -2], (20, 1))
    assert disagreement(Trajectory(t, q, qd)) == ""


def smooth_step(t, height):
    s = t / t[-1]
    return height * (10 * s**3 - 15 * s**4 + 6 * s**5)


RECORDINGS = {
    "half a radian at 1 kHz, noise 1e-4": (10_000, 1e-3, 0.5, 1e-4),
    "a twentieth of a radian at 1 kHz, noise 1e-5": (10_000, 1e-3, 0.05, 1e-5),
    "a tenth of a radian at 100 Hz, noise 1e-3": (1000, 1e-2, 0.1, 1e-3),
    "a joint that stands, with drift and noise": (1000, 1e-2, 1e-4, 3e-6),
    "a joint that stands, with noise alone": (10_000, 1e-3, 0.0, 1e-4),
}


@pytest.mark.parametrize("recording", RECORDINGS)
@pytest.mark.parametrize("seed", range(3))
def test_our_own_differences_are_no_fault_of_the_file(tmp_path, recording, seed):
    n, step, height, noise = RECORDINGS[recording]
    t = step * np.arange(n)
    q = smooth_step(t, height) + noise * np.random.default_rng(seed).normal(size=n)
    moved = smooth_step(t, 1.0)
    np.savetxt(
        tmp_path / "own.csv", np.column_stack([t, q, moved]), delimiter=",", header="t,q1,q2"
    )
    read = load(tmp_path / "own.csv")
    assert not read.velocities_given
    assert disagreement(read) == ""
    save(tmp_path / "again.csv", read)  # now the velocities are in the file
    again = load(tmp_path / "again.csv")
    assert again.velocities_given
    assert disagreement(again) == ""


def test_a_wrong_joint_is_seen_in_spite_of_noise(tmp_path):
    rng = np.random.default_rng(4)
    t = 1e-3 * np.arange(10_000)
    q = np.stack([smooth_step(t, 0.5), smooth_step(t, -0.8)], 1)
    qd = np.gradient(q, t, axis=0)
    qd[:, 1] = 0
    noisy = Trajectory(t, q + 1e-4 * rng.normal(size=q.shape), qd)
    assert "velocities of joint 2 are not those" in disagreement(noisy)
    assert "1.3" in disagreement(Trajectory(t / 1.3, noisy.q[:, :1], qd[:, :1]))
