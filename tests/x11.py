# SPDX-License-Identifier: MIT
"""What the tests' programs need of libX11: a display, windows under points, messages to windows.
Exits with 77 without it."""
import ctypes
import sys
from ctypes import byref, c_int, c_long, c_ulong, c_void_p

try:
    x11 = ctypes.CDLL("libX11.so.6")
except OSError:
    sys.exit(77)

SELECTION_REQUEST, SELECTION_NOTIFY, CLIENT_MESSAGE = 30, 31, 33


class ClientMessage(ctypes.Structure):
    _fields_ = [("type", c_int), ("serial", c_ulong), ("sent", c_int), ("display", c_void_p),
                ("window", c_ulong), ("message", c_ulong), ("format", c_int), ("data", c_long * 5)]


class SelectionRequest(ctypes.Structure):
    _fields_ = [("type", c_int), ("serial", c_ulong), ("sent", c_int), ("display", c_void_p),
                ("owner", c_ulong), ("requestor", c_ulong), ("selection", c_ulong),
                ("target", c_ulong), ("property", c_ulong), ("time", c_ulong)]


class SelectionNotify(ctypes.Structure):
    _fields_ = [("type", c_int), ("serial", c_ulong), ("sent", c_int), ("display", c_void_p),
                ("requestor", c_ulong), ("selection", c_ulong), ("target", c_ulong),
                ("property", c_ulong), ("time", c_ulong)]


class Event(ctypes.Union):
    _fields_ = [("type", c_int), ("client", ClientMessage), ("request", SelectionRequest),
                ("notify", SelectionNotify), ("pad", c_long * 24)]


x11.XOpenDisplay.restype = c_void_p
for name in ("XDefaultRootWindow", "XCreateSimpleWindow", "XInternAtom"):
    getattr(x11, name).restype = c_ulong
display = c_void_p(x11.XOpenDisplay(None))
root = c_ulong(x11.XDefaultRootWindow(display))


def atom(text):
    return x11.XInternAtom(display, text.encode(), 0)


def window_at(x, y):
    """The window under a point; without a window manager it is a child of the root."""
    window, inner = c_ulong(), [c_int(), c_int()]
    x11.XTranslateCoordinates(display, root, root, x, y, byref(inner[0]), byref(inner[1]),
                              byref(window))
    return window


def send(window, event):
    x11.XSendEvent(display, window, 0, c_long(0), byref(event))
    x11.XSync(display, 0)


def send_message(window, message, *data):
    event = Event()
    event.client = ClientMessage(CLIENT_MESSAGE, 0, 1, display, window.value, atom(message), 32,
                                 (c_long * 5)(*data))
    send(window, event)
