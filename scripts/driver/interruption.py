"""What a command does when it is told to end."""

import signal


def _end(number, _):
    raise SystemExit(128 + number)


def exit_on_signals():
    """Lets SIGINT, SIGTERM and SIGHUP leave by an exception, so that what was
    started is ended too."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, _end)
