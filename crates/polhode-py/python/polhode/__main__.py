"""``python -m polhode``: the command."""

from __future__ import annotations

import sys

from polhode_command import main

if __name__ == "__main__":
    sys.exit(main())
