"""How long a run will take yet, from how long its cases took so far."""

import sys


class TimeLeft:
    def __init__(self):
        self.weight = self.seconds = 0.0

    def add(self, weight, seconds):
        self.weight += weight
        self.seconds += seconds

    def left(self, weights):
        """[s], or None while nothing is known."""
        return sum(weights) * self.seconds / self.weight if self.weight > 0 else None


def in_words(seconds):
    if seconds is None:
        return "time left not known yet"
    if seconds < 90:
        return f"about {max(1, round(seconds))} s left"
    if seconds < 5400:
        return f"about {round(seconds / 60)} min left"
    return f"about {seconds / 3600:.1f} h left"


def say(text):
    print(f"weft: {text}", file=sys.stderr, flush=True)
