"""Plot the time for one pose against the number of poses in a batch, from 1 to a million."""

import sys
import time

import numpy as np

from course_lib.pack.bench.kinematics import configurations, pose_functions
from course_lib.pack.bench.peers import ARM, over

SIZES = 10 ** np.arange(7)
PATIENCE = 3.0  # seconds; a slower function is not measured with ten times as many poses
STYLES = [("#0072B2", "o"), ("#56B4E9", "s"), ("#D55E00", "^"), ("#009E73", "D"), ("#CC79A7", "v"), ("#000000", "x")]


def seconds_by_size(peers, repeats=3):
    """Return {name: (sizes, seconds a pose)}, the least of several repeats, measured alternately."""
    print("Measuring: cost against size ...", file=sys.stderr, flush=True)
    functions = {"course_lib, one batch": ARM.fk, "course_lib, Python loop": lambda qs: over(ARM.fk, qs)}
    functions |= pose_functions(peers)
    q, least = configurations(SIZES[-1]), {name: {} for name in functions}
    for n in SIZES:
        for _ in range(repeats):
            for name, function in functions.items():
                if n == 1 or least[name].get(n // 10, PATIENCE) * n < PATIENCE:
                    often = max(1, 100 // n)
                    start = time.process_time()
                    for _ in range(often):
                        function(q[:n])
                    taken = (time.process_time() - start) / often / n
                    least[name][n] = min(taken, least[name].get(n, np.inf))
    return {name: (np.array(list(times)), np.array(list(times.values()))) for name, times in least.items()}


def pays_from(curves, batch, loop):
    """Return the size from which the batch is the faster of two, between measured sizes along straight lines."""
    sizes = curves[batch][0]
    # In a loop the time for one pose does not depend on their number, so the last measurement is extended.
    both = [np.log(np.interp(np.log(sizes), np.log(x), y)) for x, y in (curves[batch], curves[loop])]
    ahead = both[1] - both[0]
    if ahead[0] >= 0:
        return 1
    later = np.flatnonzero(ahead >= 0)
    if not len(later):
        return None
    i = later[0]
    part = -ahead[i - 1] / (ahead[i] - ahead[i - 1])
    return round(np.exp(np.log(sizes[i - 1]) + part * np.log(sizes[i] / sizes[i - 1])))


def draw(curves, pays, path):
    """Write the picture: curves, and the sizes {loop's name: N} from which one batch is faster, as lines."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    fig, ax = plt.subplots(figsize=(9, 5.5), layout="constrained")
    for (name, (sizes, seconds)), (color, marker) in zip(curves.items(), STYLES, strict=False):
        ax.loglog(sizes, seconds * 1e6, color=color, marker=marker, label=name)
    for (name, n), linestyle in zip(pays.items(), ("--", ":", "-."), strict=False):
        ax.axvline(n, color="0.4", linestyle=linestyle, label=f"N = {n}: the batch is as fast\nas {name}")
    ax.set(xlabel="N, Panda poses in one call", ylabel="time a pose / µs", title="What a pose costs, one thread")
    ax.grid(True, alpha=0.3)
    ax.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False)
    fig.savefig(path, dpi=130)
    plt.close(fig)
