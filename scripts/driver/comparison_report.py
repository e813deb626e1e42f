"""Writes what a comparison has found: report.html, which needs nothing else, and
the same as report.md with its pictures."""

from driver import benchmark_tables, comparison_tables
from driver.comparison_pictures import Pictures
from driver.report_document import Heading, Paragraph, Picture, Table, write \
    as write_document

_TITLE = "Navigation stacks compared"
_HOW = (
    "Every stack drives the same simulated Jackal, with the same seeds of the "
    "noise, a map that it builds as it drives and the speeds of its own "
    "configuration. Time is simulated time from sending the goal to its result. "
    "Time, path, smoothness, replans, stops and CPU are means over the drives "
    "that reached the goal without contact, with 95 % confidence intervals "
    "where there are several; clearance, memory and real-time factor are the "
    "extremes over all drives.",
    "Clearance is between the robot's true footprint and anything solid. Jerk is "
    "of the true forward speed, averaged over 0.1 s; a turn reversal is a change "
    "from turning one way with more than 0.1 rad/s to the other; a stop is 0.3 s "
    "or more of standing on the way. Replans are the plans published after the "
    "first. CPU and memory are of the stack's own processes, without simulator "
    "and ROS master, from sending the goal to its result; memory adds up each "
    "process's peak, with libraries that they share. Cycles missed are those "
    "that the stack itself reports. A real-time factor below the one "
    "asked for (1, if nothing is said) means that the machine did not keep up, "
    "which spoils times and missed cycles.",
)
_PICTURES = (
    ("draw_plans", "Global plans: the first strong, those that replaced it "
     "faint, over the map that the stack had built at the end.",
     "No stack published a plan."),
    ("draw_trajectories", "Trajectory over path: each stack's longest, and the "
     "plan that it was fitted to, over the map at the end of the drive, of which "
     "less was known when they were made. Stacks that publish no trajectory are "
     "not shown.",
     "No stack here publishes trajectories."),
    ("draw_driven", "Driven paths: by ground truth, among the obstacles (grey: "
     "what moves or pops up, where it begins), an outline every second.", ""),
    ("draw_errors", "Errors over time: distance from the newest plan, and the "
     "tracking errors of stacks that publish them, while they track.", ""),
)


def _scene_blocks(name, drives, folder):
    blocks = [Heading(2, name), Table(*comparison_tables.measures(drives))]
    failures = comparison_tables.failures(drives)
    if failures:
        blocks.append(Paragraph("Not reached without contact: "
                                + "; ".join(failures) + "."))
    for noise in comparison_tables.names(d.task.noise for d in drives):
        shown = _first_of_each_stack(
            [d for d in drives if d.record and d.task.noise == noise])
        blocks.append(Heading(3, "{}, {}".format(
            name, comparison_tables.NOISES[noise])))
        if not shown:
            blocks.append(Paragraph("No stack drove here."))
            continue
        pictures = Pictures(shown, folder)
        for method, caption, without in _PICTURES:
            file = getattr(pictures, method)()
            blocks.append(Picture(file, caption) if file
                          else Paragraph(without))
    return blocks


def _first_of_each_stack(drives):
    first = {}
    for drive in drives:
        first.setdefault(drive.task.stack, drive)
    return list(first.values())


def _benchmark_blocks(benchmarks):
    blocks = [Heading(2, "BARN")]
    if not benchmarks["barn"]:
        blocks.append(Paragraph(
            "BARN was not driven for this report: it takes figures that "
            "scripts/benchmark barn has written, with --barn."))
    else:
        blocks += [
            Table(*benchmark_tables.barn_table(benchmarks["barn"])),
            Paragraph("Rates with 95 % confidence intervals. The published "
                      "ones are on their authors' worlds, simulators and "
                      "machines, so the difference is not the stack's alone.")]
    blocks.append(Heading(2, "DynaBARN"))
    if not benchmarks["dynabarn"]:
        blocks.append(Paragraph(
            "DynaBARN was not driven for this report: it takes figures that "
            "scripts/benchmark dynabarn has written, with --dynabarn."))
    else:
        blocks += [Table(*benchmark_tables.dynabarn_table(
            benchmarks["dynabarn"])), Paragraph(
                "DynaBARN has no score; no published rates are at hand to set "
                "beside these.")]
    return blocks


def write(drives, benchmarks, facts, folder):
    """Writes the report and its pictures; returns what to print.

    drives: of comparison.perform_all.
    benchmarks: {"barn", "dynabarn": lists of benchmark_tables.Benchmark}
    facts: of machine.describe.
    """
    missing = comparison_tables.names(
        d.why_missing for d in drives if not d.record)
    scenes = {}
    for drive in drives:
        scenes.setdefault(drive.task.scene.name, []).append(drive)
    times = {name: Table(*comparison_tables.completion_times(own))
             for name, own in scenes.items()}
    blocks = [Heading(2, "Completion time")]
    for name, table in times.items():
        blocks += [Heading(3, name), table]
    blocks += [Paragraph(sentence) for sentence in missing]
    for name, own in scenes.items():
        if any(d.record for d in own):
            blocks += _scene_blocks(name, own, folder)
    blocks += _benchmark_blocks(benchmarks)
    blocks += [Heading(2, "How it was measured"),
               *(Paragraph(text) for text in _HOW),
               Table(*comparison_tables.stacks(drives)), Heading(2, "Machine"),
               Table(["what", "value"], [list(fact) for fact in facts.items()])]
    write_document(_TITLE, blocks, folder)
    return "\n\n".join(
        ["\n\n".join([name, times[name].markdown(),
                      Table(*comparison_tables.measures(own)).markdown()])
         for name, own in scenes.items() if any(d.record for d in own)]
        + missing)
