#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Drops files on the X11 window under a point, as a file manager does (XDND, version 5):
drop_file.py X Y FILE... Exits with 77 without libX11, with 1 if the window does not take them."""
import ctypes
import os
import sys
import time
import urllib.parse
from ctypes import byref, c_char_p, c_int, c_long, c_ulong, c_void_p

try:
    x11 = ctypes.CDLL("libX11.so.6")
except OSError:
    sys.exit(77)


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


SELECTION_REQUEST, SELECTION_NOTIFY, CLIENT_MESSAGE = 30, 31, 33
x, y, files = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3:]
x11.XOpenDisplay.restype = c_void_p
for name in ("XDefaultRootWindow", "XCreateSimpleWindow", "XInternAtom"):
    getattr(x11, name).restype = c_ulong
display = c_void_p(x11.XOpenDisplay(None))
root = c_ulong(x11.XDefaultRootWindow(display))
source = x11.XCreateSimpleWindow(display, root, 0, 0, 1, 1, 0, c_ulong(0), c_ulong(0))


def atom(text):
    return x11.XInternAtom(display, text.encode(), 0)


# The window under the point; without a window manager it is a child of the root.
target = c_ulong()
inner = [c_int(), c_int()]
x11.XTranslateCoordinates(display, root, root, x, y, byref(inner[0]), byref(inner[1]),
                          byref(target))
uris = "".join("file://" + urllib.parse.quote(os.path.abspath(f)) + "\r\n" for f in files).encode()
x11.XSetSelectionOwner(display, c_ulong(atom("XdndSelection")), c_ulong(source), c_ulong(0))


def send(message, *data):
    event = Event()
    event.client = ClientMessage(CLIENT_MESSAGE, 0, 1, display, target.value, atom(message), 32,
                                 (c_long * 5)(source, *data))
    x11.XSendEvent(display, target, 0, c_long(0), byref(event))
    x11.XFlush(display)


send("XdndEnter", 5 << 24, atom("text/uri-list"), 0, 0)
send("XdndPosition", 0, x << 16 | y, 0, atom("XdndActionCopy"))
send("XdndDrop", 0, 0, 0, 0)
event, end = Event(), time.time() + 20
while time.time() < end:
    if not x11.XPending(display):
        time.sleep(0.02)
        continue
    x11.XNextEvent(display, byref(event))
    if event.type == CLIENT_MESSAGE and event.client.message == atom("XdndFinished"):
        sys.exit(0 if event.client.data[1] else 1)
    if event.type != SELECTION_REQUEST:
        continue
    r = event.request
    x11.XChangeProperty(display, c_ulong(r.requestor), c_ulong(r.property), c_ulong(r.target), 8, 0,
                        c_char_p(uris), len(uris))
    answer = Event()
    answer.notify = SelectionNotify(SELECTION_NOTIFY, 0, 1, display, r.requestor, r.selection,
                                    r.target, r.property, 0)
    x11.XSendEvent(display, c_ulong(r.requestor), 0, c_long(0), byref(answer))
    x11.XFlush(display)
sys.exit(1)
