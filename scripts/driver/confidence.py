"""95 % confidence intervals."""

import math

_Z = 1.96
# Student's t that 97.5 % lie below, for 1, 2, ... degrees of freedom; the normal
# distribution's is near enough for more.
_T = (12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
      2.201, 2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
      2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042)


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
    t = _T[count - 2] if count - 2 < len(_T) else _Z
    return t * math.sqrt(variance / count)


def mean_text(values, form):
    """Their mean, with how far it may be off where there are several; form: such
    as "{:.1f}"."""
    text = form.format(sum(values) / len(values))
    if len(values) > 1:
        text += " ± " + form.format(mean_deviation(values))
    return text
