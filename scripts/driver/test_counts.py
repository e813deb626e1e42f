"""Counts test cases from what the test runners have written.

A ctest test that wrote cases of its own (a gtest program, a rostest) counts by
them, every other one as one case. Called with ctest's Test.xml and the folder
of the case files; prints the totals and fails when a case failed.
"""

import os
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass


@dataclass
class Counts:
    passed: int = 0
    failed: int = 0
    skipped: int = 0

    def __add__(self, other):
        return Counts(self.passed + other.passed, self.failed + other.failed,
                      self.skipped + other.skipped)


def count_cases(file):
    """The cases of one file in JUnit's format."""
    counts = Counts()
    for case in ElementTree.parse(file).getroot().iter("testcase"):
        if case.find("failure") is not None or case.find("error") is not None:
            counts.failed += 1
        elif (case.find("skipped") is not None
              or case.get("result") in ("skipped", "suppressed")):
            counts.skipped += 1
        else:
            counts.passed += 1
    return counts


def case_file(test_name, results_folder):
    """Where the cases of a ctest test are, if it wrote any."""
    name = test_name
    if test_name.endswith(".test"):
        # rostest's own file has one entry for a whole program of cases; the
        # program's file is named after the test's name, here the launch file's.
        name = "rosunit-" + test_name.split("test_integration_")[-1][:-5]
    file = os.path.join(results_folder, name + ".xml")
    return file if os.path.isfile(file) else None


def count_test(test, results_folder):
    """test: a Test element of ctest's file."""
    ended_well = test.get("Status") == "passed"
    file = case_file(test.findtext("Name"), results_folder)
    if file is None:
        return Counts(passed=int(ended_well), failed=int(not ended_well))
    try:
        counts = count_cases(file)
    except ElementTree.ParseError:
        return Counts(failed=1)  # the program died while it wrote
    if not ended_well and counts.failed == 0:
        counts.failed += 1  # e.g. a crash or a time limit after the last case
    return counts


def main():
    report, results_folder = sys.argv[1:]
    total = Counts()
    for test in ElementTree.parse(report).getroot().iter("Test"):
        if test.get("Status") is None:
            continue  # an entry of the list of names, without a result
        counts = count_test(test, results_folder)
        total += counts
        if counts.failed:
            print("failed: {}".format(test.findtext("Name")))
    line = "{} passed, {} failed".format(total.passed, total.failed)
    if total.skipped:
        line += ", {} skipped".format(total.skipped)
    print(line)
    return 1 if total.failed or total.passed == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
