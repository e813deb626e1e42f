"""The command `benchmark tune`: a search on some worlds, and what its best
configuration is worth on others."""

import os

from driver import amounts, barn, confidence, drive_runs, poses, scene
from driver import search_space, tune, tune_worlds
from driver.config_text import ConfigText

HELP = "searches a configuration's parameters on some worlds, and tries the " \
    "best on others"
_SPACE = os.path.join(scene.ROOT, "config", "tune.yaml")


def add_options(parser):
    parser.add_argument("--worlds", required=True, action="append",
                        metavar="DIR", help="folder of BARN's or DynaBARN's "
                        "worlds; may be given for each")
    parser.add_argument("--train", type=amounts.indices, metavar="I,J,...",
                        help="the worlds to search on (drawn)")
    parser.add_argument("--held-out", type=amounts.indices, metavar="I,J,...",
                        help="the worlds that the search does not see (the "
                        "rest)")
    parser.add_argument("--held-out-share", type=amounts.share, default=0.5,
                        metavar="S", help="of the worlds, where they are drawn "
                        "(0.5)")
    parser.add_argument("--space", metavar="FILE", default=_SPACE,
                        help="what may be changed (config/tune.yaml)")
    parser.add_argument("--trials", type=amounts.count, default=60, metavar="N",
                        help="configurations to try (60); more of them later "
                        "go on with the same search")
    parser.add_argument("--seed", type=int, default=1, metavar="S",
                        help="of the draws of worlds and parameters (1)")
    parser.add_argument("--score", type=int, choices=(2, 4), default=2,
                        metavar="K", help="BARN's score with k = 2 or 4 (2)")
    parser.add_argument("--start", type=poses.pose_argument,
                        default=barn.START, metavar="X,Y,YAW",
                        help="in BARN's worlds (-2,3,1.57)")
    parser.add_argument("--output", metavar="FILE", help="where the best "
                        "configuration goes (.workspace/benchmark/tuned.yaml)")


def check(options, fail):
    """Calls fail(sentence) for options that do not go together."""
    if options.seed < 0:
        fail("--seed: {} is below 0".format(options.seed))
    if not os.path.isfile(options.space):
        fail("--space: there is no file " + options.space)
    if len(options.worlds) > 1 and (options.train or options.held_out):
        fail("--train and --held-out are for one folder of --worlds; several "
             "are split by --held-out-share and --seed")
    options.output = os.path.abspath(options.output or os.path.join(
        scene.OUTPUT, "benchmark", "tuned.yaml"))
    os.makedirs(os.path.join(scene.OUTPUT, "benchmark"), exist_ok=True)
    if not os.path.isdir(os.path.dirname(options.output)):
        fail("--output: there is no folder for " + options.output)


def run(options, perform_one=drive_runs.perform, store=None):
    """Searches, judges and writes the best configuration; its figures."""
    base = ConfigText(options.config)
    space = search_space.read(options.space, base)
    training, held_out = tune_worlds.choose(
        options.worlds, options.train, options.held_out,
        options.held_out_share, options.seed)
    task = tune.TuneTask(base, tuple(space), tuple(training), options.runs,
                         options.start, options.score, options.trials,
                         options.seed)
    folders = {} if store is None else {"store": store}
    with tune.search_folder(task, **folders) as folder:
        search = tune.Search(task, folder)
        drives = options.runs * (
            len(training) * max(0, options.trials - len(search.trials()))
            + 2 * len(held_out))
        with drive_runs.make_executor(options.jobs, options.scheduler) \
                as executor, drive_runs.make_bar(drives, 0) as bar:
            driver = tune.Driver(task, executor, folder, bar.update,
                                 perform_one)
            search.perform(driver)
            trials = search.trials()
            best = max(trials, key=lambda trial: trial["objective"])
            text = task.config_text(best["parameters"])
            results = {"base": driver.results(held_out, base.text, "base"),
                       "best": driver.results(held_out, text, "best")}
    figures = _figures(task, trials, best, held_out, results)
    figures["config"] = options.output
    _write(options.output, text, figures, base)
    return figures


def _figures(task, trials, best, held_out, results):
    score = "score_k{}".format(task.k)
    gains = [after[score] - before[score]
             for before, after in zip(results["base"], results["best"])]
    base = task.base_values()
    return {
        "seed": task.seed, "run_seeds": list(range(1, task.runs + 1)),
        "score": score,
        "worlds": {"training": [w.name() for w in task.training],
                   "held_out": [w.name() for w in held_out]},
        "trials": trials,
        "best": {"trial": best["trial"], "score": best["score"],
                 "parameters": {
                     name: {"base": base[name], "best": value}
                     for name, value in best["parameters"].items()}},
        "held_out": {**{name: barn.summary(drives)
                        for name, drives in results.items()},
                     "gain": sum(gains) / len(gains),
                     "gain_deviation": confidence.mean_deviation(gains)},
    }


def _write(file, text, figures, base):
    held_out, score = figures["held_out"], figures["score"]
    lines = [
        "# Found by scripts/benchmark tune from {}: trial {} of {}, seed {}.".
        format(os.path.basename(base.file), figures["best"]["trial"],
               len(figures["trials"]), figures["seed"]),
        "# Mean {} in {} worlds that the search did not see: {:.4f}; the "
        "base's: {:.4f}.".format(
            score, len(figures["worlds"]["held_out"]),
            held_out["best"][score], held_out["base"][score]), ""]
    with open(file, "w") as stream:
        stream.write("\n".join(lines) + text)


def table(figures):
    """Scores of base and best where the search was made and where it was not,
    and what was changed."""
    best, held_out = figures["best"], figures["held_out"]
    refused = [t["refused"] for t in figures["trials"] if t["refused"]]
    form = "{:6}{:>12.4f}{:>12.4f}{:>11.1%}{:>11.1%}".format
    lines = ["{} trials with seed {}, {} worlds to search on, {} held out".
             format(len(figures["trials"]), figures["seed"],
                    *map(len, figures["worlds"].values())),
             "{:6}{:>12}{:>12}{:>11}{:>11}".format(
                 figures["score"][6:], "searched on", "held out", "success",
                 "collision")]
    for name, score in (("base", figures["trials"][0]["score"]),
                        ("best", best["score"])):
        values = held_out[name]
        lines.append(form(name, score, values[figures["score"]],
                          values["success"], values["collision"]))
    lines.append("gain where held out: {:+.4f} (+- {:.2g} with 95 % "
                 "confidence)".format(held_out["gain"],
                                      held_out["gain_deviation"]))
    if refused:
        lines.append("{} trials had parameters that the stack refuses, the "
                     "last: {}".format(len(refused), refused[-1]))
    if best["trial"] == 0:
        lines.append("No trial was better than the base.")
    else:
        lines.append("trial {} is the best:".format(best["trial"]))
        width = max(map(len, best["parameters"]))
        lines += ["  {}  {:g} -> {:g}".format(name.ljust(width), v["base"],
                                              v["best"])
                  for name, v in best["parameters"].items()
                  if v["base"] != v["best"]]
    return lines + ["written to " + figures["config"]]
