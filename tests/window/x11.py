"""What a window manager and a file manager say to a window of X11, as `xdotool` cannot."""

import select
import time
from urllib.parse import quote

from Xlib import X, display
from Xlib.protocol import event

HANG = 60  # [s] ends a hang only


class Client:
    """A client of this display, which speaks to the window of this number."""

    def __init__(self, name, window):
        self.display = display.Display(name)
        self.target = self.display.create_resource_object("window", window)
        self.own = self.display.screen().root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)

    def close(self):
        self.display.close()

    def atom(self, name):
        return self.display.intern_atom(name)

    def send(self, kind, data):
        message = event.ClientMessage(window=self.target, client_type=self.atom(kind), data=(32, data))
        self.target.send_event(message)
        self.display.flush()

    def ask_to_close(self):
        """As the cross of a title bar does."""
        self.send("WM_PROTOCOLS", [self.atom("WM_DELETE_WINDOW"), X.CurrentTime, 0, 0, 0])

    def drop(self, paths, x, y):
        """Drops files at this place of the screen, by the protocol XDND; True: they have been taken."""
        text = "".join(f"file://{quote(str(path))}\r\n" for path in paths).encode()
        self.own.set_selection_owner(self.atom("XdndSelection"), X.CurrentTime)
        self.send("XdndEnter", [self.own.id, 5 << 24, self.atom("text/uri-list"), 0, 0])
        self.send("XdndPosition", [self.own.id, 0, x << 16 | y, X.CurrentTime, self.atom("XdndActionCopy")])
        until = time.monotonic() + HANG
        while time.monotonic() < until:
            if self.display.pending_events() == 0:
                select.select([self.display], [], [], 1)
                continue
            heard = self.display.next_event()
            if heard.type == X.SelectionRequest:
                self.hand_over(heard, text)
            elif heard.type == X.ClientMessage and heard.client_type == self.atom("XdndStatus"):
                self.send("XdndDrop", [self.own.id, 0, X.CurrentTime, 0, 0])
            elif heard.type == X.ClientMessage and heard.client_type == self.atom("XdndFinished"):
                return True
        return False

    def hand_over(self, asked, text):
        asked.requestor.change_property(asked.property, asked.target, 8, text)
        asked.requestor.send_event(
            event.SelectionNotify(
                time=asked.time,
                requestor=asked.requestor,
                selection=asked.selection,
                target=asked.target,
                property=asked.property,
            )
        )
        self.display.flush()
