"""A toy: an interactive figure, the same in a live notebook, in a stored one and on an exported page.

What a toy computes and draws stands once, in the JavaScript of course_lib/figures/scripts. Its model (link lengths,
screw axes, a start) travels in the plotly figure's `layout.meta.course`. An exported page loads the scripts and draws
the toy in place of the figure; in JupyterLab a widget with the same scripts does. A stored notebook holds the plotly
figure alone, which shows the toy at its start, without kernel or script.
"""

import json
import os
from functools import cache
from pathlib import Path

from course_lib.figures.display import show, show_caption

SCRIPTS = Path(__file__).parents[1] / "scripts"
CORE = ("motion", "kinematics", "toys", "shapes")
# anywidget asks a module for `render`; the scripts are those of the page.
_RENDER = """
export default { render({ model, el }) {
  const meta = JSON.parse(JSON.stringify(model.get("meta")));
  const answers = new Set(), { kinds, parts } = globalThis.course;
  // anywidget gives up on a model that takes longer than 2 s to start, and then hands it no message: say what helps.
  const note = document.createElement("p");
  note.textContent = "The kernel does not answer. When it is idle, run this cell again.";
  let late = null;
  model.on("msg:custom", (message) => {
    clearTimeout(late);
    note.remove();
    answers.forEach((hear) => hear(message));
  });
  const ask = (question) => {
    clearTimeout(late);
    late = setTimeout(() => el.append(note), 5000);
    model.send(question);
  };
  const kernel = { ask, hear: (answer) => answers.add(answer) };
  el.setAttribute("aria-label", model.get("alt"));
  const start = () => kinds[meta.kind](el, meta, model.get("figure"), model.get("answers") ? kernel : null);
  let stop = start();
  // What is in `meta` outlives the change to the colours of the other theme.
  const leave = parts.onTheme(() => { stop(); answers.clear(); stop = start(); });
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
    figure : plotly.graph_objects.Figure
        The toy at its start, for places that run no script.
    alt : str
        What the toy shows and what can be moved, in words.
    answer : callable, optional
        In a live notebook the script's questions (dicts) go to this function, its answers (dicts) to the script.
    caption : str, optional
        What to try, one sentence, shown below the toy.

    Examples
    --------
    >>> from plotly.graph_objects import Figure
    >>> toy = Toy("plane", {"width": 2}, Figure(), "A robot on a floor, to be dragged.")
    >>> toy.meta["kind"], toy.figure.layout.meta["course"]["width"]
    ('toy:plane', 2)
    """

    def __init__(self, name, model, figure, alt, answer=None, caption=""):
        scripts = [*CORE, f"toy_{name}"]
        self.meta = {"kind": f"toy:{name}", "scripts": scripts, "plotly": False, **model}
        self.figure = figure.update_layout(meta={"course": self.meta})
        self.alt = alt
        self.answer = answer
        self.caption = caption

    def _ipython_display_(self):
        if is_live():
            from IPython.display import display

            widget = self.widget()
            bundle = widget._repr_mimebundle_()
            data, metadata = bundle if isinstance(bundle, tuple) else (bundle, {})
            display({**data, "text/plain": self.alt}, raw=True, metadata=metadata)
            show_caption(self.caption)
        else:
            show(self.figure, alt=self.alt, caption=self.caption)

    def widget(self):
        """Return the toy as a widget for JupyterLab, which loads the same scripts as the page."""
        widget = _widget_class()(
            _esm=module(tuple(self.meta["scripts"])),
            meta=self.meta,
            figure=json.loads(self.figure.to_json()),
            alt=self.alt,
        )
        if self.answer is not None:
            widget.answers = True
            widget.on_msg(lambda _, question, __: widget.send(self.answer(question)))
        return widget


def is_live():
    """Return whether a person looks at this kernel: it was started for a session of a Jupyter server.

    Jupyter names the session in an environment variable of the kernel. What runs notebooks for files (nbclient, nbval,
    nbgrader) sets none, so that stored outputs hold plain figures and no state of widgets.

    Examples
    --------
    >>> is_live()  # not for doctest, which needs no Jupyter server
    False
    """
    return bool(os.environ.get("JPY_SESSION_NAME"))


@cache
def module(scripts):
    """Return the JavaScript module of a toy's widget.

    Parameters
    ----------
    scripts : tuple of str
        Names of files in course_lib/figures/scripts, without ".js", in the order in which they are loaded.

    Returns
    -------
    str
        The scripts, and after them the function `render` that anywidget calls.

    Examples
    --------
    >>> "export default" in module(("motion",))
    True
    """
    return "\n".join((SCRIPTS / f"{name}.js").read_text(encoding="utf-8") for name in scripts) + _RENDER


@cache
def _widget_class():
    import anywidget  # here, for stored notebooks do without
    import traitlets

    class ToyWidget(anywidget.AnyWidget):
        """The state that the browser gets; nothing comes back but questions."""

        _esm = traitlets.Unicode().tag(sync=True)
        meta = traitlets.Dict().tag(sync=True)
        figure = traitlets.Dict().tag(sync=True)
        alt = traitlets.Unicode().tag(sync=True)
        answers = traitlets.Bool(False).tag(sync=True)

    return ToyWidget
