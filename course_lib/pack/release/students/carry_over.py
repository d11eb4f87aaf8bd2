"""Carry your answers over from an older release to this one.

    python carry_over.py ../robot-kinematics-of-before

Every answer of the older notebooks, in code or in words, is in the new notebook afterwards or is
named with the reason why it is not. So are your predictions, your own cells, given cells that you
changed, and your own files beside the notebooks. The older folder is only read, and nothing that
you have written in the new one is replaced.

This program needs Python 3.11 and its standard library alone.
"""

import sys

from update.command import main

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
