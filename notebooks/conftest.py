"""Settings for pytest with nbval, which runs the notebooks as tests.

The settings of the person who runs it, such as IPython's start-up files or a matplotlibrc, change
outputs, so they are left out, as make leaves them out.
"""

import os
from pathlib import Path

BUILD = Path(__file__).parents[1] / "build"
os.environ["IPYTHONDIR"] = str(BUILD / "ipython")
os.environ["MPLCONFIGDIR"] = str(BUILD / "matplotlib")

# Matplotlib lists the fonts once for each folder of settings. It reports on stderr if that takes
# long, and nbval would compare that too, so it is done before the notebooks run.
import matplotlib.font_manager  # noqa: E402, F401
