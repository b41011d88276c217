"""The command `plm`: `python -m plm check FILE`."""

import sys

from ._native import command

sys.exit(command(sys.argv[1:]))
