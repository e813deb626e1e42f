"""What the demo prints. Robots go by their names; a robot that is alone needs
none and goes by the empty one."""


class ProgressPrinter:
    """A line for each robot every second of simulated time, and at every new
    state of it."""

    def __init__(self, observers):
        """observers: {robot's name: Observer}"""
        self._observers = observers
        self._next = 0.0
        self._states = {}
        self._width = max(map(len, observers))

    def __call__(self, elapsed):
        is_due = elapsed >= self._next
        if is_due:
            self._next = elapsed + 1.0
        for name, observer in self._observers.items():
            state = observer.last_state
            if state is None:
                continue
            if is_due or state.state != self._states.get(name):
                self._states[name] = state.state
                self._print(elapsed, name, state)

    def _print(self, elapsed, name, state):
        # Rounded first, and 0 added: no "-0.00".
        print("{:7.1f} s  {}{:<10} {:6.2f} m to go  {:5.2f} m/s  "
              "clearance {:.2f} m".format(
                  elapsed, name and name.ljust(self._width) + "  ", state.state,
                  state.distance_to_goal, round(state.speed, 2) + 0.0,
                  state.clearance), flush=True)


def print_scene(world, robots):
    print("World {}".format(world))
    for robot in robots:
        print("{} {} to {}".format(robot.name or "From", _text(robot.start),
                                   _text(robot.goal)))


def _text(pose):
    return "({:g}, {:g}, {:.3g})".format(*pose)


def print_outcome(records, picture):
    """records: {robot's name: DriveRecord}"""
    for name, record in records.items():
        figures = record.figures()
        print("\n{}{}: {}".format(
            name and name + ": ",
            "Goal reached" if record.succeeded else "Goal not reached",
            record.message))
        print("time {:.1f} s (simulated), path {:.2f} m, least clearance {}, "
              "{}".format(
                  figures["time_s"], figures["path_m"],
                  "unknown" if figures["min_clearance_m"] is None
                  else "{:.2f} m".format(figures["min_clearance_m"]),
                  "contact with " + ", ".join(record.contacts)
                  if record.contacts else "no contact"))
    print("picture: {}".format(picture))


def figures(records):
    """For the JSON file: those of the one robot, or of several by name."""
    if len(records) == 1:
        return next(iter(records.values())).figures()
    return {name: record.figures() for name, record in records.items()}
