"""The navigation stacks that can be compared."""

import os
from dataclasses import dataclass
from typing import Dict, Tuple

import rospkg

from driver import scene

_CONFIG = os.path.join(scene.ROOT, "config")


@dataclass(frozen=True)
class Stack:
    name: str
    packages: Tuple[str, ...]  # ROS packages that it needs
    nodes: Tuple[str, ...]  # whose CPU time and memory are the stack's
    plan_topic: str
    # Whether its map and plans lie in the world's frame or begin at the start.
    starts_at_zero: bool
    # What launch/compare.launch has to know of it.
    launch_arguments: Dict[str, str]

    def missing_packages(self):
        packages = rospkg.RosPack()
        missing = []
        for name in self.packages:
            try:
                packages.get_path(name)
            except rospkg.ResourceNotFound:
                missing.append(name)
        return missing


def _vfh_astar(name, config):
    return Stack(name, ("vfh_astar",),
                 ("navigation_manager",), "plan", starts_at_zero=False,
                 launch_arguments={"stack": "vfh_astar",
                                   "config": os.path.join(_CONFIG, config)})


# {short name: (package, plugin, topic of its plans)}
_GLOBAL_PLANNERS = {
    "navfn": ("navfn", "navfn/NavfnROS", "move_base/NavfnROS/plan"),
    "global_planner": ("global_planner", "global_planner/GlobalPlanner",
                       "move_base/GlobalPlanner/plan"),
}
# {short name: (package, plugin)}
_LOCAL_PLANNERS = {
    "trajectory": ("base_local_planner",
                   "base_local_planner/TrajectoryPlannerROS"),
    "dwa": ("dwa_local_planner", "dwa_local_planner/DWAPlannerROS"),
    "teb": ("teb_local_planner", "teb_local_planner/TebLocalPlannerROS"),
}


def _move_base(name, config, global_planner, local_planner):
    global_package, global_plugin, plan_topic = _GLOBAL_PLANNERS[global_planner]
    local_package, local_plugin = _LOCAL_PLANNERS[local_planner]
    return Stack(name, ("move_base", "gmapping", global_package, local_package),
                 ("move_base", "slam_gmapping"), plan_topic,
                 starts_at_zero=True,
                 launch_arguments={
                     "stack": "move_base",
                     "config": os.path.join(_CONFIG, "move_base", config),
                     "global_planner": global_plugin,
                     "local_planner": local_plugin})


def _all_stacks():
    yield _vfh_astar("vfh_astar", "jackal.yaml")
    yield _vfh_astar("vfh_astar_paper", "paper.yaml")
    # As it is: Clearpath's own choice at 0.5 m/s, and the best found at 2 m/s.
    yield _move_base("move_base", "clearpath.yaml", "navfn", "trajectory")
    yield _move_base("move_base_fast", "fast.yaml", "navfn", "dwa")
    for prefix, config in (("move_base", "clearpath.yaml"),
                           ("move_base_fast", "fast.yaml")):
        for global_planner in _GLOBAL_PLANNERS:
            for local_planner in _LOCAL_PLANNERS:
                yield _move_base(
                    "_".join((prefix, global_planner, local_planner)), config,
                    global_planner, local_planner)


STACKS = {stack.name: stack for stack in _all_stacks()}
