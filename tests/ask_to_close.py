#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Asks the X11 window under a point to close, as a desktop's close button does (WM_DELETE_WINDOW):
ask_to_close.py X Y. Exits with 77 without libX11."""
import sys

from x11 import atom, send_message, window_at

send_message(window_at(int(sys.argv[1]), int(sys.argv[2])), "WM_PROTOCOLS",
             atom("WM_DELETE_WINDOW"))
