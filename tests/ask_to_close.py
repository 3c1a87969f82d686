#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Asks the X11 window under a point to close, as a desktop's close button does (WM_DELETE_WINDOW):
ask_to_close.py X Y. Exits with 77 without libX11."""
import ctypes
import sys
from ctypes import byref, c_int, c_long, c_ulong, c_void_p

try:
    x11 = ctypes.CDLL("libX11.so.6")
except OSError:
    sys.exit(77)


class ClientMessage(ctypes.Structure):
    _fields_ = [("type", c_int), ("serial", c_ulong), ("sent", c_int), ("display", c_void_p),
                ("window", c_ulong), ("message", c_ulong), ("format", c_int), ("data", c_long * 5),
                ("pad", c_long * 12)]


x11.XOpenDisplay.restype = c_void_p
for name in ("XDefaultRootWindow", "XInternAtom"):
    getattr(x11, name).restype = c_ulong
display = c_void_p(x11.XOpenDisplay(None))
root = c_ulong(x11.XDefaultRootWindow(display))
target = c_ulong()
inner = [c_int(), c_int()]
x11.XTranslateCoordinates(display, root, root, int(sys.argv[1]), int(sys.argv[2]),
                          byref(inner[0]), byref(inner[1]), byref(target))
CLIENT_MESSAGE = 33
event = ClientMessage(CLIENT_MESSAGE, 0, 1, display, target.value,
                      x11.XInternAtom(display, b"WM_PROTOCOLS", 0), 32,
                      (c_long * 5)(x11.XInternAtom(display, b"WM_DELETE_WINDOW", 0), 0, 0, 0, 0))
x11.XSendEvent(display, target, 0, c_long(0), byref(event))
x11.XSync(display, 0)
