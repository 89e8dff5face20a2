"""A progress bar on standard error."""

from __future__ import annotations

import sys
import time

CELLS = 24
# Nobody needs a bar for less, in seconds.
SHORT = 0.5


class Bar:
    """Draws the share of the work that is done, in one line that is taken away at the end."""

    def __init__(self) -> None:
        self._began = time.monotonic()
        self._width = 0
        self._state = ""
        self._proved = ""

    def __call__(self, share: float, left: float) -> None:
        full = int(share * CELLS)
        cells = "█" * full + "░" * (CELLS - full)
        self._state = f"{cells} {100 * share:3.0f} %, about {left:.0f} s left "
        self._show()

    def proved(self, scene: str, push: str, lower: str, state: str) -> None:
        """Shows a lower bound as it grows, and the lowest state, both as the program writes them."""
        self._proved = f"({scene}, pushed to the {push}: λ ≥ {lower} proved, lowest state {state})"
        self._show()

    def _show(self) -> None:
        if time.monotonic() - self._began >= SHORT:
            self._draw(self._state + self._proved)

    def clear(self) -> None:
        """Takes the bar away."""
        if self._width:
            self._draw("")
            sys.stderr.write("\r")
            sys.stderr.flush()

    def _draw(self, text: str) -> None:
        sys.stderr.write("\r" + text.ljust(self._width))
        sys.stderr.flush()
        self._width = len(text)


def bar(wanted: bool | None) -> Bar | None:
    """A bar where it is wanted, or where nobody said and a person looks on."""
    if wanted is None:
        wanted = sys.stderr is not None and (sys.stderr.isatty() or _in_notebook())
    return Bar() if wanted else None


def _in_notebook() -> bool:
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython else None
    return shell is not None and type(shell).__name__ == "ZMQInteractiveShell"
