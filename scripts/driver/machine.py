"""The machine that something was measured on."""

import os
import platform


def _field(file, name):
    """The first value of a `name: value` or name="value" line; None without."""
    try:
        with open(file) as stream:
            for line in stream:
                key, separator, value = line.replace("=", ":", 1).partition(":")
                if separator and key.strip() == name:
                    return value.strip().strip('"')
    except OSError:
        pass
    return None


def describe():
    """{what: text} for a report; what this system does not tell is left out."""
    memory = _field("/proc/meminfo", "MemTotal")
    facts = {
        "processor": _field("/proc/cpuinfo", "model name")
        or platform.processor(),
        "processors": str(len(os.sched_getaffinity(0))),
        "memory": memory and "{:.1f} GB".format(
            int(memory.split()[0]) * 1024 / 1e9),
        "system": _field("/etc/os-release", "PRETTY_NAME"),
        "kernel": platform.release(),
        "ROS": os.environ.get("ROS_DISTRO"),
        "Python": platform.python_version(),
        "load before": "{:.1f}".format(os.getloadavg()[0]),
    }
    return {what: text for what, text in facts.items() if text}
