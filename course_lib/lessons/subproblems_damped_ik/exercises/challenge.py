"""The score of notebook 3's challenge: how many damped steps a rule for step size and damping
needs."""

import numpy as np

MOST = 200  # steps; a run that takes more counts as many


def mean_steps(rule, step, alpha=0.2, eps=2.0):
    """Return the mean number of steps to 1 mm over 40 targets of the planar arm with four links of
    one metre.

    Parameters
    ----------
    rule : callable
        From the step just tried, rule(k, before, after, alpha, eps), to the next alpha and eps: its
        number, counted from 0, the distance from the target before and after it in metres, its step
        size and its damping.
    step : callable
        step(q, target, alpha, eps), the joint angles after one damped step, shape (4,).
    alpha, eps : float, optional
        Step size and damping (square metres) of the first step of each run.

    Returns
    -------
    float
        A run that takes more than 200 steps counts 200.

    Raises
    ------
    ValueError
        If the rule does not return two finite numbers, the second of them positive.

    Examples
    --------
    >>> def unchanged(k, before, after, alpha, eps):
    ...     return alpha, eps
    >>> mean_steps(unchanged, lambda q, target, alpha, eps: q)
    200.0
    """
    draw = np.random.default_rng(8)
    radius, angle = draw.uniform(0.5, 3.98, 40), draw.uniform(-np.pi, np.pi, 40)
    counts = []
    for target in np.transpose(radius * [np.cos(angle), np.sin(angle)]):
        q, used, k = np.array([0, 0, 0, np.pi / 2]), (alpha, eps), 0
        away = _distance(q, target)
        while away > 1e-3 and k < MOST:
            q, before = step(q, target, *used), away
            away = _distance(q, target)
            used, k = _checked(rule(k, before, away, *used)), k + 1
        counts.append(k)
    return float(np.mean(counts))


def _distance(q, target):
    angles = np.cumsum(q)
    return float(np.hypot(np.cos(angles).sum() - target[0], np.sin(angles).sum() - target[1]))


def _checked(answer):
    try:
        alpha, eps = (float(number) for number in answer)
    except (TypeError, ValueError):
        alpha = eps = np.nan
    if not (np.isfinite([alpha, eps]).all() and eps > 0):
        raise ValueError(
            f"rule must return two finite numbers, alpha and a positive eps; it returned {answer!r}"
        )
    return alpha, eps
