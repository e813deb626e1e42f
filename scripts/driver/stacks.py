"""The navigation stacks that can be compared."""

from dataclasses import dataclass
from typing import Tuple

import rospkg


@dataclass(frozen=True)
class Stack:
    name: str
    packages: Tuple[str, ...]  # ROS packages that it needs
    nodes: Tuple[str, ...]  # whose CPU time is the stack's
    plan_topic: str
    # Whether its map and plans lie in the world's frame or begin at the start.
    starts_at_zero: bool

    def missing_packages(self):
        packages = rospkg.RosPack()
        missing = []
        for name in self.packages:
            try:
                packages.get_path(name)
            except rospkg.ResourceNotFound:
                missing.append(name)
        return missing


STACKS = {
    stack.name: stack for stack in (
        Stack("vfh_astar", ("vfh_astar",),
              ("navigation_manager", "grid_mapper", "path_planner",
               "trajectory_fitter", "navigator"),
              "plan", starts_at_zero=False),
        Stack("move_base",
              ("move_base", "gmapping", "navfn", "dwa_local_planner"),
              ("move_base", "slam_gmapping"),
              "move_base/NavfnROS/plan", starts_at_zero=True),
    )
}
