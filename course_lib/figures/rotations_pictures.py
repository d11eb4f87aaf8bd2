"""Pictures of notebook 1 with alternative text made from their data: show(**pictures.rotated_point(w, p)).

Each function returns {"fig": a figure, "alt": what it shows in words, "caption": what to notice}.
"""

import numpy as np

from course_lib.figures import rotations
from course_lib.figures.plots import lines
from course_lib.rotations import exp_so3


def body_frame(R):
    """Return a drone with its frame b in the fixed frame a.

    Parameters
    ----------
    R : array_like, shape (3, 3)
        The orientation of b relative to a.

    Returns
    -------
    dict
        Arguments of `figures.show`: fig, alt, caption.

    Examples
    --------
    >>> body_frame(np.eye(3))["alt"].split("; ")[1:]
    ['y along (0.00, 1.00, 0.00)', 'z along (0.00, 0.00, 1.00).']
    """
    axes = "; ".join(f"{name} along ({_numbers(R[:, k])})" for k, name in enumerate("xyz"))
    return {
        "fig": rotations.body_frame(R),
        "alt": f"A drone with its own frame b, tilted in a fixed frame a. The axes of b, in coordinates of a: {axes}.",
        "caption": "Frame b is fixed to the drone (x red, ahead; y green; z blue, up), frame a (grey) to the room.",
    }


def frames(orientations):
    """Return a drone with its frame at several orientations.

    Parameters
    ----------
    orientations : dict
        {title: R (3, 3)}; R need not be a rotation.

    Returns
    -------
    dict
        Arguments of `figures.show`: fig, alt, caption.

    Examples
    --------
    >>> frames({"longer": 2 * np.eye(3)})["caption"]
    'A rotation keeps all three axes at length one; here the longest grows to 2.00.'
    """
    said = []
    for title, R in orientations.items():
        lengths = np.linalg.norm(R, axis=0)
        axes = ", ".join(f"{name} {_direction(R[:, k])}" for k, name in enumerate("xyz"))
        stretched = f", of lengths {_numbers(lengths)}" if np.ptp(np.append(lengths, 1)) > 0.01 else ""
        said.append(f"{title}: {axes}{stretched}")
    alt = f"A drone with its three axes, {len(said)} times. The axes point near the fixed axes so: {'; '.join(said)}."
    grown = max(np.linalg.norm(R, axis=0).max() for R in orientations.values())
    caption = "The two products end in different orientations: the order counts."
    if grown > 1.01:
        caption = f"A rotation keeps all three axes at length one; here the longest grows to {grown:.2f}."
    return {"fig": rotations.frames(orientations), "alt": alt, "caption": caption}


def rotated_point(w, p, exp=exp_so3):
    """Return the path of a point about an axis.

    Parameters
    ----------
    w : array_like, shape (3,)
        Rotation vector, radians.
    p : array_like, shape (3,)
    exp : callable
        The exponential that draws it: w -> R.

    Returns
    -------
    dict
        Arguments of `figures.show`: fig, alt, caption.

    Examples
    --------
    >>> rotated_point(np.array([0, 0, 1.5]), np.array([1.0, 0, 0.5]))["alt"]
    'A point p moves about the axis w by 1.50 rad to R p, along an arc in a plane perpendicular to it.'
    """
    heights = [w @ exp(t * w) @ p / np.linalg.norm(w) for t in np.linspace(0, 1, 9)]
    plane = "in a plane perpendicular to it" if np.ptp(heights) < 1e-6 else "which leaves the plane perpendicular to it"
    alt = f"A point p moves about the axis w by {np.linalg.norm(w):.2f} rad to R p, along an arc {plane}."
    caption = "The point keeps its height along the axis $w$ and its distance from it."
    return {"fig": rotations.rotated_point(w, p, exp), "alt": alt, "caption": caption}


def series_errors(errors):
    """Return how far sums of the exponential series are from a rotation.

    Parameters
    ----------
    errors : dict
        {label: errors after 1, 2, ... terms}.

    Returns
    -------
    dict
        Arguments of `figures.show`: fig, alt, caption.

    Examples
    --------
    >>> series_errors({"0.1 rad": [1e-2, 1e-4, 1e-8]})["alt"].split(": ")[1]
    'for 0.1 rad it is 0.01 after one term, at most 0.01, and 1e-08 after 3.'
    """
    said = [
        f"for {label} it is {e[0]:.2g} after one term, at most {max(e):.2g}, and {e[-1]:.1g} after {len(e)}"
        for label, e in errors.items()
    ]
    terms = np.arange(1, 1 + len(next(iter(errors.values()))))
    fig = lines(terms, errors, log="y", xlabel="terms of the series after I", ylabel="largest entry of $R^T R - I$")
    alt = f"On a logarithmic axis, the error against the number of terms: {'; '.join(said)}."
    return {
        "fig": fig,
        "alt": alt,
        "caption": "The larger the angle, the larger the error at first, and the more terms are needed.",
    }


def log_errors(short_of_pi, errors):
    """Return errors of logarithms near the angle pi.

    Parameters
    ----------
    short_of_pi : array_like, shape (n,)
        Pi minus the angle, radians.
    errors : dict
        {label: errors (n,)}, radians.

    Returns
    -------
    dict
        Arguments of `figures.show`: fig, alt, caption.

    Examples
    --------
    >>> log_errors([1e-8, 1e-4], {"arccos": [1e-3, 1e-9], "library": [0, 1e-16]})["alt"].split(". ")[1]
    'arccos rises to more than 1e-4; library stays below 1e-12.'
    """
    drawn = {label: np.maximum(each, 1e-17) for label, each in errors.items()}
    said = [f"{label} {_size_of_errors(each)}" for label, each in drawn.items()]
    axes = {"xlabel": r"$\pi - a$ (rad)", "ylabel": "error (rad)"}
    fig = lines(short_of_pi, drawn, log="xy", **axes)
    alt = f"Errors of logarithms against pi minus the angle, both axes logarithmic. {'; '.join(said)}."
    caption = "From right to left the angle approaches $\\pi$, and the formula with arccos loses digit after digit."
    return {"fig": fig, "alt": alt, "caption": caption}


def euler_rates(beta, smallest):
    """Return the smallest singular value of the Euler rate matrix against the pitch.

    Parameters
    ----------
    beta : array_like, shape (n,)
        Pitch, radians.
    smallest : array_like, shape (n,)

    Returns
    -------
    dict
        Arguments of `figures.show`: fig, alt, caption.

    Examples
    --------
    >>> pitch = np.array([-np.pi / 2, 0, np.pi / 2])
    >>> euler_rates(pitch, np.array([0, 1, 0]))["alt"].split(" and ")[1]
    'falls to 0.00 at pitch -1.57'
    """
    fig = lines(beta, {"": smallest}, xlabel=r"pitch $\beta$ (rad)", ylabel="smallest singular value", parts_of_pi=4)
    top, first, last = _numbers([beta[np.argmax(smallest)]]), _numbers(smallest[:1]), _numbers(smallest[-1:])
    alt = f"The smallest singular value of the Euler rate matrix is {max(smallest):.2f} at pitch {top} and falls to "
    alt += f"{first} at pitch {beta[0]:.2f} and to {last} at pitch {beta[-1]:.2f}: gimbal lock."
    caption = (
        "At $\\beta = \\pm\\pi/2$ it is zero: about one direction the body cannot rotate, at any rates of the angles."
    )
    return {"fig": fig, "alt": alt, "caption": caption}


def double_cover(angle, w, entry):
    """Return an entry of a quaternion and one of a matrix against the angle of rotation.

    Parameters
    ----------
    angle : array_like, shape (n,)
        Radians.
    w : array_like, shape (n,)
        The scalar of the quaternion.
    entry : array_like, shape (n,)
        The first entry of the matrix.

    Returns
    -------
    dict
        Arguments of `figures.show`: fig, alt, caption.

    Examples
    --------
    >>> angle = np.array([0, 2 * np.pi, 4 * np.pi])
    >>> double_cover(angle, np.cos(angle / 2), np.cos(angle))["alt"].split("; ")[1]
    'the first entry of the matrix begins at 1 and is 1 after one revolution.'
    """
    once = np.argmin(np.abs(angle - 2 * np.pi))
    named = {"the scalar w of the quaternion": w, "the first entry of the matrix": entry}
    said = [f"{name} begins at {v[0]:.2g} and is {v[once]:.2g} after one revolution" for name, v in named.items()]
    drawn = {"$w$": w, "$R_{00}$": entry}
    fig = lines(angle, drawn, xlabel="angle of rotation (rad)", ylabel="value", parts_of_pi=1)
    alt = f"Two curves over {angle[-1] / 2 / np.pi:.2g} revolutions: {'; '.join(said)}."
    return {"fig": fig, "alt": alt, "caption": "The matrix repeats after $2\\pi$, the quaternion only after $4\\pi$."}


def interpolation(t, angles):
    """Return the angle from the start against t.

    Parameters
    ----------
    t : array_like, shape (n,)
    angles : dict
        {label: angles (n,)}, radians.

    Returns
    -------
    dict
        Arguments of `figures.show`: fig, alt, caption.

    Examples
    --------
    >>> t = np.array([0, 0.5, 1])
    >>> interpolation(t, {"slerp": t, "another": t**2})["alt"].split("; ")[1]
    'another differs from a straight line by up to 0.25 rad.'
    """
    said = []
    for label, angle in angles.items():
        gap = angle - angle[-1] * t
        bend = np.abs(gap).max()
        shape = f"differs from a straight line by up to {bend:.2g} rad" if bend > 1e-6 else "is a straight line"
        said.append(f"{label} {shape}")
    caption = (
        "Slerp rotates at constant speed; the straight line, normalised, is slow at its ends and fast in the middle."
    )
    fig = lines(t, angles, xlabel="t", ylabel="angle from the start (rad)")
    return {
        "fig": fig,
        "alt": f"The angle from the start against t, by two methods: {'; '.join(said)}.",
        "caption": caption,
    }


def nearest_on_circle(M, candidates):
    """Return a matrix beside rotations of the plane, and its distance to those around them.

    Parameters
    ----------
    M : ndarray, shape (2, 2)
    candidates : dict
        {name: R (2, 2)}, two at most.

    Returns
    -------
    dict
        Arguments of `figures.show`: fig, alt, caption.

    Examples
    --------
    >>> nearest_on_circle(np.diag([2.0, 1.0]), {"the nearest": np.eye(2)})["alt"].split(": ")[1]
    'the nearest at 1.0000.'
    """
    said = [f"{name} at {np.linalg.norm(M - R):.4f}" for name, R in candidates.items()]
    alt = "Left, the columns of M and of two rotations in the unit circle, with the ellipse that M makes of it. Right, "
    alt += f"the curve of distances from M to the rotations around, with two marks: {', '.join(said)}."
    caption = "Only one of the two marks lies at the minimum of the curve."
    return {"fig": rotations.nearest_on_circle(M, candidates), "alt": alt, "caption": caption}


def on_sphere(samples):
    """Return where samples of rotations take the x axis, on spheres side by side.

    Parameters
    ----------
    samples : dict
        {title: R (n, 3, 3)}.

    Returns
    -------
    dict
        Arguments of `figures.show`: fig, alt, caption.

    Examples
    --------
    >>> on_sphere({"no rotation": np.eye(3)[None]})["alt"].split(": ")[1]
    '0% in the cap above 0.9, 0% below -0.9.'
    """
    said = [
        f"{title}: {np.mean(R[:, 2, 0] > 0.9):.0%} in the cap above 0.9, {np.mean(R[:, 2, 0] < -0.9):.0%} below -0.9"
        for title, R in samples.items()
    ]
    alt = f"Spheres seen from below, with a dot where each rotation takes the x axis. {'; '.join(said)}."
    caption = "Left, the dots crowd at the lower pole and none is in the upper half; right, they are everywhere alike."
    return {"fig": rotations.rotations_on_sphere(samples), "alt": alt, "caption": caption}


def angles(samples):
    """Return histograms of the rotation angle, with the density of uniform rotations.

    Parameters
    ----------
    samples : dict
        {title: R (n, 3, 3)}.

    Returns
    -------
    dict
        Arguments of `figures.show`: fig, alt, caption.

    Examples
    --------
    >>> angles({"no rotation": np.eye(3)[None]})["alt"].split(". ")[1]
    'no rotation: 100% are below a right angle.'
    """
    said = []
    for title, R in samples.items():
        cosine = (np.trace(R, axis1=1, axis2=2) - 1) / 2
        said.append(f"{title}: {np.mean(cosine > 0):.0%} are below a right angle")
    alt = f"Histograms of the rotation angle, with the density (1 - cos a)/pi. {'; '.join(said)}."
    caption = "Small angles are rare among uniform rotations; the naive sampler draws too many just above $\\pi/2$."
    return {"fig": rotations.angle_histogram(samples), "alt": alt, "caption": caption}


def heights(samples):
    """Return histograms of the heights of the images of the three axes.

    Parameters
    ----------
    samples : dict
        {title: R (n, 3, 3)}.

    Returns
    -------
    dict
        Arguments of `figures.show`: fig, alt, caption.

    Examples
    --------
    >>> heights({"no rotation": np.eye(3)[None]})["alt"].split(": ")[1]
    'the images of e_x, e_y, e_z have the mean heights 0.00, 0.00, 1.00.'
    """
    said = []
    for title, R in samples.items():
        means = _numbers(R[:, 2].mean(0))
        said.append(f"{title}: the images of e_x, e_y, e_z have the mean heights {means}")
    alt = f"Histograms of the heights of the images of the three axes, flat at one half if uniform. {'; '.join(said)}."
    caption = "Right, every height is equally frequent, for all three axes; left, for none of them."
    return {"fig": rotations.height_histogram(samples), "alt": alt, "caption": caption}


def _size_of_errors(errors):
    """Return how large errors are, in words that rounding does not change."""
    if max(errors) < 1e-12:
        return "stays below 1e-12"
    passed = [bound for bound in ("1e-4", "1e-8", "1e-12") if max(errors) > float(bound)]
    return f"rises to more than {passed[0]}"


def _direction(v):
    """The fixed axis that is nearest to the direction of v, in words."""
    k = np.argmax(np.abs(v))
    return f"along {'' if v[k] > 0 else 'minus '}{'xyz'[k]}"


def _numbers(values):
    return ", ".join(f"{value + 0.0:.2f}".replace("-0.00", "0.00") for value in values)
