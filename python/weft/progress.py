"""How far a run is, on a line of a terminal."""

import sys
import time
from collections.abc import Iterable, Iterator
from typing import TextIO


def seconds_text(seconds: float) -> str:
    """ "0:05", "12:34", "1:02:03"."""
    whole = round(seconds)
    hours, minutes = divmod(whole // 60, 60)
    return f"{hours}:{minutes:02}:{whole % 60:02}" if hours else f"{minutes}:{whole % 60:02}"


class Progress:
    """Counts what is done, and says it with the time left; a terminal's line is written over, at most ten times a
    second. Where `out` is no terminal nothing is written."""

    def __init__(self, total: int, what: str, out: TextIO | None = None) -> None:
        self._total, self._what, self._out = total, what, out or sys.stderr
        self._shown = self._out.isatty()
        self._start = time.monotonic()
        self._last = 0.0

    def show(self, done: int, begun_with: int = 0) -> None:
        """`begun_with`: of those done, how many took no time now."""
        now = time.monotonic()
        if not self._shown or (done < self._total and now - self._last < 0.1):
            return
        self._last = now
        fresh = done - begun_with
        left = (now - self._start) * (self._total - done) / fresh if fresh else None
        rest = "" if left is None else f", {seconds_text(left)} left"
        self._out.write(f"\r{self._what} {done} of {self._total}{rest}\x1b[K")
        self._out.flush()

    def end(self) -> None:
        if self._shown:
            self._out.write("\r\x1b[K")
            self._out.flush()


def counted(items: Iterable[int], total: int, what: str) -> Iterator[int]:
    """The items, with a line of progress."""
    progress = Progress(total, what)
    try:
        for done, item in enumerate(items, 1):
            yield item
            progress.show(done)
    finally:
        progress.end()
