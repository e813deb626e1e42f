"""95 % confidence intervals."""

import math

_Z = 1.96


def rate_interval(hits, count):
    """Wilson's score interval of a rate: lowest and highest, 0 to 1."""
    if count == 0:
        return 0.0, 1.0
    rate = hits / count
    scale = 1.0 + _Z * _Z / count
    middle = (rate + _Z * _Z / (2 * count)) / scale
    half = _Z / scale * math.sqrt(
        rate * (1.0 - rate) / count + _Z * _Z / (4 * count * count))
    return max(0.0, middle - half), min(1.0, middle + half)


def mean_deviation(values):
    """How far the mean of normal values may be off; 0 for a single one."""
    count = len(values)
    if count < 2:
        return 0.0
    mean = sum(values) / count
    variance = sum((v - mean) ** 2 for v in values) / (count - 1)
    return _Z * math.sqrt(variance / count)
