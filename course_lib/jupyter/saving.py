"""What JupyterLab does not save of a notebook: views of widgets whose kernel will be gone."""

from __future__ import annotations

TOY = "application/vnd.course.toy+json"
VIEW = "application/vnd.jupyter.widget-view+json"


def leave_views_out(model: dict, **_options: object) -> None:
    """Remove the widget's view from each toy in a notebook that is about to be saved.

    A view names a widget of the kernel. After a restart JupyterLab finds no such widget, and would
    show an error in place of the picture and the words that the same output holds. In the open
    notebook the toy stays alive.

    Parameters
    ----------
    model : dict
        What the server is about to save; `jupyter_server_config.json` names this function as its
        hook. It is changed in place.

    Examples
    --------
    >>> outputs = [{"data": {TOY: {}, VIEW: {}, "text/plain": "A toy."}}]
    >>> notebook = {"type": "notebook", "content": {"cells": [{"outputs": outputs}]}}
    >>> leave_views_out(notebook)
    >>> sorted(outputs[0]["data"])
    ['application/vnd.course.toy+json', 'text/plain']
    """
    if model.get("type") != "notebook" or not model.get("content"):
        return
    for cell in model["content"]["cells"]:
        for output in cell.get("outputs", []):
            data = output.get("data", {})
            if TOY in data:
                data.pop(VIEW, None)
