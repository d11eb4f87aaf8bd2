"""Moving pictures written to files: what notebooks store becomes one GIF each, at twenty pictures a
second."""

import shutil
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose
from PIL import Image, ImageSequence
from site_notebooks import TURNING, cell, output, write

from course_lib.arms import planar_arm
from course_lib.figures import solids
from course_lib.figures.solids import Part
from course_lib.figures.solids.meshes import ball
from course_lib.figures.solids.model import MUG_RED
from course_lib.figures.stills import TOY
from course_lib.figures.toys.film import film
from course_lib.lessons.rigid_motion import figures as rigid_motion
from course_lib.pack.authors import animations

TIMES = np.linspace(0, 1, 5)  # four times fewer than pictures
POSES = np.stack([np.linspace(-6, 6, 5), np.linspace(-5, 2, 5), 0 * TIMES], -1)
TURNED = np.stack([2 * TIMES, 0 * TIMES], -1)  # joint angles of a planar arm that swings once
CENTRES = 0.9 * np.stack([np.cos(2 * np.linspace(0, 1, 21)), np.sin(2 * np.linspace(0, 1, 21))], -1)


def swing():
    """A planar arm in space, seen from above, with a red ball at its tip, which hides it."""
    arm = planar_arm([0.5, 0.4])
    parts = [*solids.shell(arm), Part(2, MUG_RED, ball([0.9, 0, 0.1], 0.06))]
    view, words = (0.01, -0.01, 1), "An arm swings."
    return {
        TOY: film(
            parts, solids.link_poses(arm, TURNED), TIMES, words, name="moving", view=view
        ).stored()
    }


@pytest.mark.tools("browser")
@pytest.mark.parametrize(("movie", "true"), [
    (lambda: {TOY: rigid_motion.body_movie("moving", POSES, TIMES).stored()},
     np.linspace(POSES[0], POSES[-1], 21)[:, :2]),
    (swing, CENTRES),
], ids=["in the plane", "in space"])  # fmt: skip
def test_an_animation_interpolates_between_the_stored_times(
    movie, true, tmp_path, monkeypatch, capsys
):
    write(tmp_path, "01.ipynb", cell(output(movie()), output({TOY: TURNING})))
    monkeypatch.setattr(animations, "FOLDER", tmp_path / "made")
    assert animations.main([str(tmp_path / "01.ipynb")]) == 0
    made = [str(tmp_path / "made/moving.gif")]
    made += (
        [str(tmp_path / "made/moving.mp4")]
        if shutil.which("ffmpeg")
        else ["There is no MP4, because ffmpeg was not found: install it to have both."]
    )
    assert capsys.readouterr() == ("\n".join(made) + "\n", "")
    with Image.open(made[0]) as gif:
        pictures = [
            np.array(frame.convert("RGB")).astype(int) for frame in ImageSequence.Iterator(gif)
        ]
        assert gif.info["duration"] == 50
    is_red = [(picture[..., 0] > 110) & (picture[..., 1:] < 90).all(-1) for picture in pictures]
    red = np.array([np.argwhere(where).mean(0)[::-1] * [1, -1] for where in is_red])
    # Pixels are metres times one scale, and in space also turned: perspective bends it a little.
    shift = true - true.mean(0)
    fit, *_ = np.linalg.lstsq(shift, red - red.mean(0), rcond=None)
    assert_allclose(shift @ fit, red - red.mean(0), rtol=0, atol=6)
    assert np.ptp(red, axis=0).max() > 100


@pytest.mark.parametrize(
    ("content", "message"), [("<<<<<<< half a merge", "cannot be read"), (None, "No animation")]
)
def test_trouble_is_reported_in_a_sentence(content, message, tmp_path, capsys):
    write(tmp_path, "01.ipynb", cell(output({TOY: TURNING})))
    if content:
        (tmp_path / "01.ipynb").write_text(content)
    assert animations.main([str(tmp_path / "01.ipynb")]) == 1
    assert message in capsys.readouterr().err


def test_a_missing_notebook_is_named_without_an_error_number(tmp_path, capsys):
    path = tmp_path / "07_x.ipynb"
    assert animations.main([str(path)]) == 1
    message = f"A notebook cannot be read. {path}: No such file or directory\n"
    assert capsys.readouterr().err == message


@pytest.mark.parametrize("old", [None, b"whole film"])
def test_an_interrupted_film_leaves_the_file_before(old, tmp_path, monkeypatch):
    def interrupted(picture, file, *_, **__):
        if hasattr(file, "write"):
            file.write(b"half")
        else:
            Path(file).write_bytes(b"half")
        raise KeyboardInterrupt

    gif = tmp_path / "moving.gif"
    if old:
        gif.write_bytes(old)
    pictures = [Image.new("RGB", (8, 8))]
    monkeypatch.setattr(animations, "film_pictures", lambda movie, times: pictures)
    monkeypatch.setattr(Image.Image, "save", interrupted)
    with pytest.raises(KeyboardInterrupt):
        animations.write({"times": [0, 1]}, tmp_path / "moving")
    assert [path.name for path in tmp_path.iterdir()] == (["moving.gif"] if old else [])
    assert not old or gif.read_bytes() == old


def test_an_interrupted_mp4_leaves_the_file_before(tmp_path, monkeypatch):
    def interrupted(command, **_):
        Path(command[-1]).write_bytes(b"half")
        raise KeyboardInterrupt

    mp4 = tmp_path / "moving.mp4"
    mp4.write_bytes(b"whole film")
    pictures = [Image.new("RGB", (8, 8)), Image.new("RGB", (8, 8), "red")]
    monkeypatch.setattr(animations, "film_pictures", lambda movie, times: pictures)
    monkeypatch.setattr(animations.shutil, "which", lambda name: name)
    monkeypatch.setattr(animations.subprocess, "run", interrupted)
    with pytest.raises(KeyboardInterrupt):
        animations.write({"times": [0, 1]}, tmp_path / "moving")
    assert mp4.read_bytes() == b"whole film"
    assert {path.name for path in tmp_path.iterdir()} == {"moving.gif", "moving.mp4"}
