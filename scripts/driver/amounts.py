"""Counts, indices and shares on the command line."""

import argparse


def count(text):
    """A whole number from 1."""
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError("{} is not 1 or more".format(value))
    return value


def indices(text):
    """I,J,... in rising order, each once."""
    try:
        return sorted({int(part) for part in text.split(",")})
    except ValueError:
        raise argparse.ArgumentTypeError(
            "'{}': expected whole numbers with commas between them".format(text))


def share(text):
    """Between 0 and 1, neither of them."""
    value = float(text)
    if not 0.0 < value < 1.0:
        raise argparse.ArgumentTypeError("{} is not between 0 and 1".format(
            value))
    return value


def pace(text):
    """Simulated seconds per second of the wall clock: above 0, up to 1."""
    value = float(text)
    if not 0.0 < value <= 1.0:
        raise argparse.ArgumentTypeError(
            "{!r} is no number above 0 up to 1".format(text))
    return value
