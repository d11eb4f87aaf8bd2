"""A toy: an interactive figure, the same in a live notebook and on an exported page.

What a toy computes and draws is the JavaScript of course_lib/figures/scripts. Its model (link
lengths, screw axes, a start) is JSON. An exported page loads the scripts and draws the toy; in
JupyterLab a widget with the same scripts does. A stored notebook holds the model and, for places
that run no script, a picture of the toy at its start, which is also what a live notebook shows
where widgets do not run.
"""

import base64
import html
from functools import cache
from pathlib import Path

import numpy as np

from course_lib.figures.digits import rounded, rounded_array
from course_lib.figures.display import show_caption
from course_lib.figures.solids.model import PALETTE
from course_lib.figures.stills import TOY, as_key, is_live, stored_stills

# Decimals of the numbers of a model, in metres or radians: a nanometre, which no figure shows.
_DECIMALS = 9
_MAX_PROBLEM = 300  # characters of what a student's function raised
SCRIPTS = Path(__file__).parents[1] / "scripts"
CORE = ("motion", "scene", "toys")
# The scripts that are a folder with a file for each subject, in the order in which the files are
# joined: a file uses those before it. Every other script is a file. Stored notebooks name scripts,
# so a script may be divided here and no stored output changes.
PARTS = {
    "motion": ("algebra", "rigid", "planar", "points", "arms"),
    "scene": ("palette", "bodies", "webgl"),
    "toys": (
        "words",
        "style",
        "events",
        "stage",
        "plane",
        "grips",
        "camera",
        "space",
        "controls",
        "animation",
        "arm_space",
        "card",
    ),
    "toy_arm": ("self_motion", "jog"),
    "toy_orientation": ("modes", "axis", "gimbals", "order", "velocity", "belt"),
    "toy_alive": ("answers", "reach", "fly", "table", "drive", "click"),
}
# How the owners that exercises name are called in messages.
_OWNERS = {"yours": "your function", "the library's": "the library's function"}
BEGUN = {"begun": True}  # the kernel has a question and answers it, however long that takes
ELSEWHERE = (
    "Here the figure stands still. It moves in JupyterLab once its cell has run, and on the pages "
    "that `make html` writes."
)
# anywidget asks a module for `render`; the scripts are those of the page.
_RENDER = """
export default { render({ model, el }) {
  const meta = JSON.parse(JSON.stringify(model.get("meta")));
  const { kinds, palette } = globalThis.course;
  let act = () => {};  // of the toy that asked last
  // anywidget gives up on a model that takes longer than 2 s to start, and then hands it no
  // message: say what helps.
  const note = document.createElement("p");
  let late = null;
  const expect = (seconds, words) => {
    clearTimeout(late);
    late = setTimeout(() => { note.textContent = words; el.append(note); }, 1000 * seconds);
  };
  model.on("msg:custom", (message) => {
    note.remove();
    if (message.begun) return expect(1, "Your function is still computing this answer.");
    clearTimeout(late);
    act(message);
  });
  const ask = (question) => {
    expect(5, "The kernel does not answer. When it is idle, run this cell again.");
    model.send(question);
  };
  const kernel = { ask, onAnswer: (take) => { act = take; } };
  el.setAttribute("aria-label", model.get("alt"));
  const start = () => {
    try {
      return kinds[meta.kind](el, meta, model.get("answers") ? kernel : null);
    } catch (error) {
      el.textContent = `${model.get("alt")} It cannot be drawn here: ${error.message}.`;
      return () => {};
    }
  };
  let stop = start();
  // What is in `meta` outlives the change to the colours of the other theme.
  const leave = palette.onTheme(() => { stop(); stop = start(); });
  return () => { clearTimeout(late); leave(); stop(); };
} };
"""


class Toy:
    """What a toy's function returns: shown when it is the last line of a cell, or by display(toy).

    Parameters
    ----------
    name : str
        Which toy: the page and the widget start ``toy:name``, from the script ``toy_name.js``.
    model : dict
        What the script needs, as JSON: numbers, strings, lists, dicts.
    alt : str
        What the toy shows and what can be moved, in words.
    answer : callable, optional
        In a live notebook the script's questions (dicts) go to this function, its answers (dicts)
        to the script.
    caption : str, optional
        What to try, one sentence, shown below the toy.

    Examples
    --------
    >>> Toy("plane", {"width": 2}, "A robot on a floor, to be dragged.").meta["kind"]
    'toy:plane'
    """

    def __init__(self, name, model, alt, answer=None, caption=""):
        model = _rounded(model)
        self.meta = {"kind": f"toy:{name}", "scripts": [*CORE, f"toy_{name}"], **model}
        self.alt = alt
        self.answer = answer
        self.caption = caption

    def _ipython_display_(self):
        from IPython.display import display

        data = {TOY: self.stored(), "text/plain": self.alt}
        if still := stored_stills().get(as_key(data[TOY])):
            data["image/png"] = still
        if is_live():
            bundle = self.widget()._repr_mimebundle_()
            data |= bundle[0] if isinstance(bundle, tuple) else bundle
            data |= {"text/plain": f"{self.alt} {ELSEWHERE}", "text/html": self._still_page(still)}
        display(data, raw=True, metadata={"image/png": {"alt": self.alt}})
        show_caption(self.caption, remark="" if is_live() or not self._moves() else ELSEWHERE)

    def _moves(self):
        """Return whether something in the toy moves or can be moved, and not the view alone."""
        return len(self.meta.get("times", ())) != 1

    def _still_page(self, still):
        """Return the HTML that is shown where widgets are not, which says where the toy moves."""
        alt = html.escape(self.alt)
        picture = f"<p>{alt}</p>"
        if still:
            picture = f'<img src="data:image/png;base64,{still}" alt="{alt}">'
        return f"{picture}<p>{ELSEWHERE}</p>"

    def stored(self):
        """Return what a stored notebook holds: a figure without traces, whose script draws it."""
        return {"data": [], "layout": {"meta": {"course": self.meta}}}

    def widget(self):
        """Return the toy as a widget for JupyterLab, which loads the same scripts as the page."""
        scripts = module(tuple(self.meta["scripts"]))
        widget = _widget_class()(_esm=scripts, meta=self.meta, alt=self.alt)

        def reply(_widget, question, _buffers):
            widget.send(BEGUN)
            widget.send(self.answer(question))

        if self.answer is not None:
            widget.answers = True
            widget.on_msg(reply)
        return widget


class Answers:
    """The student's function as a script sees it: it takes a question and returns an answer.

    Parameters
    ----------
    f : callable
        Its attribute ``whose``, if it has one, says whose it is.
    ask : callable
        ``ask(f, question)`` calls a function for a question and returns its answer, a dict of JSON;
        it raises ValueError if what f returned cannot be drawn.
    """

    def __init__(self, f, ask):
        self.f = f
        self.ask = ask
        whose = str(getattr(f, "whose", "yours"))
        self.whose = _OWNERS.get(whose, whose)

    def __call__(self, question):  # noqa: D102
        answer = {"whose": self.whose, "problem": None, "value": None, "gap": None}
        try:
            return answer | self.ask(self.f, question)
        except (Exception, KeyboardInterrupt) as error:  # of the student's code
            message = " ".join(str(error).split())
            owner = f"{self.whose[0].upper()}{self.whose[1:]}"
            problem = f"{owner}: {type(error).__name__}: {message}."
            answer["problem"] = problem[:_MAX_PROBLEM]
        return answer


def numbers(given, what, *shape):
    """Return what a student's function gave as an array of a shape.

    Parameters
    ----------
    given : object
        What the function returned.
    what : str
        What it should have returned, in words, for the message.
    *shape : int or "n"
        The sizes that it should have, where "n" is any size.

    Returns
    -------
    ndarray

    Raises
    ------
    ValueError
        If it is no such array, is empty, or contains NaN or infinity.
    """
    array = np.asarray(given, float)
    if not array.size or not _has_shape(array, shape):
        wanted = str(shape).replace("'", "")
        raise ValueError(
            f"the answer should be {what} of shape {wanted}; its shape is {array.shape}"
        )
    if not np.isfinite(array).all():
        raise ValueError("the answer contains NaN or infinity")
    return array


def _has_shape(array, shape):
    if array.ndim != len(shape):
        return False
    return all(size in ("n", actual) for actual, size in zip(array.shape, shape, strict=True))


def _rounded(node):
    """Return JSON with rounded numbers, because further decimals differ between processors."""
    if isinstance(node, dict):
        return {key: _rounded(value) for key, value in node.items()}
    if isinstance(node, list | tuple):
        return [_rounded(item) for item in node]
    return rounded(node, _DECIMALS) if isinstance(node, float) else node


def script_names():
    """Return the names of all scripts that a toy can name, sorted."""
    return sorted({*PARTS, *(path.stem for path in SCRIPTS.glob("*.js"))})


def script_paths(name):
    """Return the files of a script that a toy names: one, or those of a folder in their order."""
    if name in PARTS:
        return [SCRIPTS / name / f"{part}.js" for part in PARTS[name]]
    return [SCRIPTS / f"{name}.js"]


@cache
def script(name):
    """Return the text of a script that a toy names, which a browser runs."""
    return "\n".join(path.read_text(encoding="utf-8") for path in script_paths(name))


@cache
def module(scripts):
    """Return the JavaScript module of a toy's widget: its scripts, and anywidget's `render`."""
    return "\n".join(script(name) for name in scripts) + _RENDER


def solid(model):
    """Return a model of solid bodies for the scripts of the scene, as JSON.

    Parameters
    ----------
    model : course_lib.figures.solids.Model

    Returns
    -------
    dict
        Whole numbers in base64; lengths are in tenths of a millimetre.
    """

    def packed(array, kind):
        return base64.b64encode(rounded_array(array, 0).astype(kind).tobytes()).decode()

    return {
        "vertices": packed(1e4 * model.vertices, "<i2"),
        "faces": packed(model.faces, "<u2"),
        "colours": packed(model.colours[model.faces[:, 0]], "u1"),
        "bodies": packed(model.bodies, "u1"),
        "palette": PALETTE,
    }


@cache
def _widget_class():
    # Imported here, because stored notebooks do without.
    import anywidget
    import traitlets

    class ToyWidget(anywidget.AnyWidget):
        """The state that the browser gets; nothing comes back but questions."""

        _esm = traitlets.Unicode().tag(sync=True)
        meta = traitlets.Dict().tag(sync=True)
        alt = traitlets.Unicode().tag(sync=True)
        answers = traitlets.Bool(False).tag(sync=True)

    return ToyWidget
