"""CPU time and memory of the processes of ROS nodes."""

import os
from xmlrpc.client import ServerProxy

import rosgraph

_CALLER = "/node_processes"


def process_of_node(name):
    """The process id of a running node on this machine.

    Raises OSError for a node that the master does not know or that is gone.
    """
    try:
        uri = rosgraph.Master(_CALLER).lookupNode(name)
    except rosgraph.MasterError as error:
        raise OSError("there is no node {}: {}".format(name, error)) from error
    _, message, pid = ServerProxy(uri).getPid(_CALLER)
    if pid <= 0:
        raise OSError("node {} has no process id: {}".format(name, message))
    return pid


def processes_of_nodes(names):
    """Their process ids, each once."""
    return sorted({process_of_node(name) for name in names})


def cpu_seconds(pid):
    """User and system time that the process has had, all threads."""
    with open("/proc/{}/stat".format(pid)) as stat:
        # The command's name stands in brackets and may hold blanks.
        fields = stat.read().rsplit(")", 1)[1].split()
    user_ticks, system_ticks = int(fields[11]), int(fields[12])
    return (user_ticks + system_ticks) / os.sysconf("SC_CLK_TCK")


def peak_memory(pid):
    """MB of memory that the process has had at the most, with what it shares
    with others."""
    with open("/proc/{}/status".format(pid)) as status:
        for line in status:
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) * 1024 / 1e6
    raise OSError("/proc/{}/status has no VmHWM".format(pid))
