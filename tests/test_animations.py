"""Moving pictures written to files: what notebooks store becomes one GIF each, and trouble is told in a sentence."""

import io
import shutil
from contextlib import redirect_stderr, redirect_stdout
from types import SimpleNamespace

import numpy as np
import pytest
from helpers import FIGURE, stored
from matplotlib.animation import FFMpegWriter
from nbformat.v4 import new_markdown_cell
from numpy.testing import assert_allclose
from PIL import Image, ImageColor, ImageSequence
from site_notebooks import HELIX, MOVING, cell, output, write

from course_lib.arms import planar_arm as arm_of_links
from course_lib.figures import planar_arm, rigid_motion, solids
from course_lib.figures.solids import Part
from course_lib.figures.solids.meshes import ball
from course_lib.figures.solids.model import MUG_RED
from course_lib.figures.style import BLACK, BLUE, CRIMSON
from course_lib.pack import animations, film_frames

TIMES = np.linspace(0, 1, 11)
POSES = np.stack([np.linspace(-6, 6, 11), np.linspace(-5, 2, 11), np.linspace(0, 2, 11)], -1)
ANGLES = np.linspace(0.1, 2, 11)
LINK = np.stack([np.cos(ANGLES), np.sin(ANGLES)], -1)
POINTS = np.stack([0 * LINK, LINK, 2 * LINK], 1)  # a straight arm that turns


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Where the files go; ffmpeg is not there."""
    monkeypatch.setattr(animations, "FOLDER", tmp_path / "build/animations")
    monkeypatch.setattr(FFMpegWriter, "isAvailable", lambda: False)
    return tmp_path / "build/animations"


@pytest.fixture(scope="module")
def movies():
    return [rigid_motion.body_movie("body", POSES, TIMES)["fig"], planar_arm.arm_movie("arm", POINTS, TIMES)]


@pytest.fixture(scope="module")
def written(movies, tmp_path_factory):
    """A run over a notebook with two movies among other figures: its exit code, where it wrote, what it said."""
    home = tmp_path_factory.mktemp("course")
    outputs = [output({FIGURE: stored(movie)}) for movie in movies] + [
        output({FIGURE: HELIX}),
        output({FIGURE: MOVING}),
    ]
    write(home, "01.ipynb", new_markdown_cell("# One"), cell(outputs[0]), cell(*outputs[1:]), cell())
    with (
        pytest.MonkeyPatch.context() as patch,
        redirect_stdout(io.StringIO()) as out,
        redirect_stderr(io.StringIO()) as err,
    ):
        patch.setattr(animations, "FOLDER", home / "build/animations")
        patch.setattr(FFMpegWriter, "isAvailable", lambda: False)
        code = animations.main([str(home / "01.ipynb")])
    return SimpleNamespace(code=code, folder=home / "build/animations", out=out.getvalue(), err=err.getvalue())


@pytest.fixture
def short(tmp_path):
    """A notebook with one movie of two frames."""
    movie = rigid_motion.body_movie("body", POSES[:2], TIMES[:2])["fig"]
    write(tmp_path, "01.ipynb", cell(output({FIGURE: stored(movie)})))
    return tmp_path / "01.ipynb"


def frames(path):
    """The frames (n, height, width, 3) of a GIF, and how long it plays, in seconds."""
    with Image.open(path) as gif:
        images = [(np.array(frame.convert("RGB")), frame.info["duration"]) for frame in ImageSequence.Iterator(gif)]
    return np.stack([image for image, _ in images]), sum(duration for _, duration in images) / 1000


def where(frame, colour):
    """The pixels (n, 2) of about a colour: to the right and down."""
    apart = np.abs(frame.astype(int) - ImageColor.getrgb(colour)).max(-1)
    return np.argwhere(apart < 40)[:, ::-1]


def middle(corners):
    """The middle (2,) of a drawn line through corners (n, 2)."""
    lengths = np.linalg.norm(np.diff(corners, axis=0), axis=-1)
    return lengths @ (corners[1:] + corners[:-1]) / (2 * lengths.sum())


def test_each_movie_becomes_a_gif_of_its_frames_and_its_length(written):
    folder = written.folder
    assert written.code == 0
    assert written.out.splitlines() == [f"{folder}/body.gif", f"{folder}/arm.gif", "No MP4: ffmpeg was not found."]
    assert written.err == "", "no bar where no one watches"
    assert sorted(file.name for file in folder.iterdir()) == ["arm.gif", "body.gif"]
    for file in folder.iterdir():
        images, seconds = frames(file)
        assert len(images) == len(TIMES)
        assert seconds == pytest.approx(1.1, abs=0.06), "ten steps in a second, and the last frame stands as long"


@pytest.mark.parametrize(
    ("name", "corners"),
    [
        ("body", [rigid_motion.outline(pose) for pose in POSES]),
        ("arm", POINTS),
    ],
    ids=["body", "arm"],
)
def test_what_is_red_moves_as_the_data_say(written, name, corners):
    images, _ = frames(written.folder / f"{name}.gif")
    true = np.array([middle(np.asarray(line)) for line in corners])
    red = np.array([where(image, CRIMSON).mean(0) for image in images]) * [1, -1]
    # Pixels are metres times one scale for both axes, and a shift.
    scale = np.ptp(red[:, 0]) / np.ptp(true[:, 0])
    assert np.ptp(red[:, 0]) > 100
    assert_allclose(red - red.mean(0), scale * (true - true.mean(0)), rtol=0, atol=3)


def test_the_path_and_the_axes_stay_while_the_body_moves(written):
    images, _ = frames(written.folder / "body.gif")
    paths = [{*map(tuple, where(image, BLUE).tolist())} for image in images]
    everywhere = set.intersection(*paths)
    assert all(len(everywhere) > 0.6 * len(path) for path in paths), "the body covers a part"
    edge = images[:, :, :60].astype(int)
    assert np.abs(edge - edge[-1]).max() < 16, "the axis at the left, but for the colours of each frame's palette"


def test_the_first_frame_has_the_colours_of_the_figure_and_lies_on_white(written):
    for name, colours in (("body", (CRIMSON, BLUE)), ("arm", (CRIMSON, BLUE, BLACK))):
        first = frames(written.folder / f"{name}.gif")[0][0]
        assert all(len(where(first, colour)) > 30 for colour in colours)
        assert (first[0] == 255).all()
        assert (first[:, 0] == 255).all()


def test_the_frame_shows_the_scene_of_the_figure(movies):
    fig, lines = animations.draw(stored(movies[0]))
    (ax,) = fig.axes
    assert (ax.get_xlim(), ax.get_ylim(), ax.get_aspect()) == ((-10, 10), (-10, 10), 1)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("x (m)", "y (m)")
    assert_allclose(np.transpose(lines[0].get_data()), POSES[:, :2], atol=1e-3)
    assert [line.get_linestyle() for line in lines] == ["--", "None", "-"]


# ---- in space ----


@pytest.fixture(scope="module")
def solid():
    """A planar arm in space that swings once, seen from above, with a red ball at its tip."""
    arm = arm_of_links([0.5, 0.4])
    q = np.stack([np.linspace(0, 2, 9), 0 * np.arange(9)], -1)
    model = solids.arm_model(arm, [Part(2, MUG_RED, ball([0.9, 0, 0.1], 0.06))])
    film = solids.film("swing", model, solids.link_poses(arm, q), np.linspace(0, 2, 9), view=(0.01, -0.01, 1))
    return q, stored(film)


def test_a_film_in_space_is_written_without_a_browser_and_moves_as_its_data_say(solid, tmp_path):
    q, figure = solid
    animations.write(figure, tmp_path / "swing.gif", animations.PillowWriter)
    images, seconds = frames(tmp_path / "swing.gif")
    assert len(images) == 9
    assert seconds == pytest.approx(9 * 0.25, abs=0.06)
    fig, show, count = film_frames.draw(figure)
    assert count == 9
    red = []
    for i in range(9):  # without the palette of the GIF
        show(i)
        image = fig.axes[0].images[0].get_array().astype(int)
        red.append(np.argwhere((image[..., 0] > 110) & (image[..., 1:] < 90).all(-1)).mean(0)[::-1])
    red = np.array(red)
    true = 0.9 * np.stack([np.cos(q[:, 0]), np.sin(q[:, 0])], -1)
    # Seen from above, pixels are metres times a scale, a rotation and a shift: perspective bends it a little.
    moved, drawn = true - true.mean(0), (red - red.mean(0)) * [1, -1]
    fit, *_ = np.linalg.lstsq(moved, drawn, rcond=None)
    assert_allclose(moved @ fit, drawn, atol=6)
    assert np.linalg.svd(fit)[1].min() > 100, "pixels a metre"


def test_the_nearest_body_hides_those_behind_it():
    near, far = (np.array([[-0.8, -0.8, z], [0.8, -0.8, z], [0, 0.8, z]]) for z in (1.0, 0.0))
    picture, depth = np.zeros((40, 40, 3)), np.full((40, 40), -np.inf)
    points = np.concatenate([near, far]) * [20, -20, 1] + [20, 20, 0]
    colours = np.repeat([[255.0, 0, 0], [0, 0, 255]], 3, axis=0)
    for order in ([[0, 1, 2], [3, 4, 5]], [[3, 4, 5], [0, 1, 2]]):
        film_frames._fill((picture, depth), points, np.array(order), colours)
        assert picture[20, 20].tolist() == [255, 0, 0]
        picture[:], depth[:] = 0, -np.inf
    film_frames._fill((picture, depth), points, np.array([[0, 2, 1]]), colours)
    assert not picture.any(), "a face that looks away is not drawn"


# ---- with ffmpeg, and before a terminal ----


class Recorder:
    """Plays a writer of matplotlib: notes what it was to write."""

    files: dict = {}  # noqa: RUF012

    def __init__(self, fps):
        self.fps = fps

    @staticmethod
    def isAvailable():
        return True

    def saving(self, fig, path, dpi):
        self.path, self.files[path] = path, []
        return self

    def __enter__(self):
        return self

    def __exit__(self, *error):
        pass

    def grab_frame(self, facecolor):
        self.files[self.path].append(self.fps)


def test_with_ffmpeg_each_movie_becomes_an_mp4_too(folder, short, monkeypatch, capsys):
    monkeypatch.setattr(Recorder, "files", {})
    monkeypatch.setattr(animations, "FFMpegWriter", Recorder)
    assert animations.main([str(short)]) == 0
    assert capsys.readouterr().out.splitlines() == [f"{folder}/body.gif", f"{folder}/body.mp4"]
    assert Recorder.files == {f"{folder}/body.mp4": [10, 10]}, "two frames, ten a second"


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="ffmpeg is not installed")
def test_ffmpeg_writes_a_film(tmp_path, movies):
    animations.write(stored(movies[0]), tmp_path / "body.mp4", FFMpegWriter)
    assert (tmp_path / "body.mp4").read_bytes()[4:8] == b"ftyp"


def test_a_terminal_sees_how_far_it_is(folder, short, monkeypatch):
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    terminal = Terminal()
    monkeypatch.setattr("sys.stderr", terminal)
    animations.main([str(short)])
    assert "body.gif" in terminal.getvalue()
    assert "0/2 " in terminal.getvalue()


# ---- what can be wrong ----


def sentence(capsys, *paths):
    """The one line that a failed run says."""
    assert animations.main([*map(str, paths)]) == 1
    said = capsys.readouterr()
    assert said.out == ""
    assert "Traceback" not in said.err
    (line,) = said.err.splitlines()
    return line


def test_figures_that_are_no_movies_are_left_out(folder, tmp_path, capsys):
    solid = HELIX | {"layout": {"meta": {"movie": "helix", "seconds": 1}}}
    write(tmp_path, "01.ipynb", cell(*[output({FIGURE: figure}) for figure in (HELIX, MOVING, solid)]), cell())
    assert sentence(capsys, tmp_path / "01.ipynb").startswith("No animation is stored in these notebooks.")
    assert not folder.exists()


@pytest.mark.parametrize(
    "content",
    [
        b"<<<<<<< two versions of a notebook",
        b"\xff\xfe\x00",
        b"",
        b"[1]",
        b'{"a": 1}',
        b'{"nbformat": 4}',
    ],
    ids=["half a merge", "bytes", "empty", "list", "settings", "no cells"],
)
def test_a_file_that_is_no_notebook(folder, tmp_path, capsys, content):
    (tmp_path / "01.ipynb").write_bytes(content)
    assert sentence(capsys, tmp_path / "01.ipynb").startswith(f"{tmp_path}/01.ipynb cannot be read: ")
    assert not folder.exists()


def test_a_file_that_is_missing_stops_before_anything_is_written(folder, short, tmp_path, capsys):
    assert sentence(capsys, short, tmp_path / "02.ipynb").startswith(f"{tmp_path}/02.ipynb cannot be read: ")
    assert not folder.exists()
