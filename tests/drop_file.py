#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Drops files on the X11 window under a point, as a file manager does (XDND, version 5):
drop_file.py X Y FILE... Exits with 77 without libX11, with 1 if the window does not take them."""
import os
import sys
import time
import urllib.parse
from ctypes import byref, c_char_p, c_ulong

from x11 import (CLIENT_MESSAGE, SELECTION_NOTIFY, SELECTION_REQUEST, Event, SelectionNotify, atom,
                 display, root, send, send_message, window_at, x11)

x, y, files = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3:]
source = x11.XCreateSimpleWindow(display, root, 0, 0, 1, 1, 0, c_ulong(0), c_ulong(0))
target = window_at(x, y)
uris = "".join("file://" + urllib.parse.quote(os.path.abspath(f)) + "\r\n" for f in files).encode()
x11.XSetSelectionOwner(display, c_ulong(atom("XdndSelection")), c_ulong(source), c_ulong(0))
send_message(target, "XdndEnter", source, 5 << 24, atom("text/uri-list"), 0, 0)
send_message(target, "XdndPosition", source, 0, x << 16 | y, 0, atom("XdndActionCopy"))
send_message(target, "XdndDrop", source, 0, 0, 0, 0)
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
    send(c_ulong(r.requestor), answer)
sys.exit(1)
