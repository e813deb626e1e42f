import os
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

from driver import test_counts
from driver.test_counts import Counts

_CASES = """<testsuites><testsuite>
<testcase name="a"/>
<testcase name="b"><failure message="x"/></testcase>
<testcase name="c" status="run" result="skipped"><skipped/></testcase>
</testsuite></testsuites>"""
_GOOD_CASES = "<testsuite><testcase name='a'/><testcase name='b'/></testsuite>"


def ctest_entry(name, status):
    return ElementTree.fromstring(
        '<Test Status="{}"><Name>{}</Name></Test>'.format(status, name))


class TestCountsTest(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def write(self, name, text):
        with open(os.path.join(self.folder.name, name), "w") as file:
            file.write(text)

    def count(self, name, status):
        return test_counts.count_test(ctest_entry(name, status),
                                      self.folder.name)

    def test_cases_of_a_program(self):
        self.write("unit_grid.xml", _CASES)
        self.assertEqual(self.count("unit_grid", "failed"), Counts(1, 1, 1))

    def test_cases_of_a_rostest(self):
        self.write("rosunit-hairpin.xml", _GOOD_CASES)
        self.assertEqual(
            self.count("_ctest_x_rostest_test_integration_hairpin.test",
                       "passed"), Counts(2, 0, 0))

    def test_a_crash_after_good_cases_fails(self):
        self.write("unit_grid.xml", _GOOD_CASES)
        self.assertEqual(self.count("unit_grid", "failed"), Counts(2, 1, 0))

    def test_a_truncated_file_fails(self):
        self.write("unit_grid.xml", _CASES[:40])
        self.assertEqual(self.count("unit_grid", "failed"), Counts(0, 1, 0))

    def test_without_cases_the_program_counts(self):
        self.assertEqual(self.count("other", "passed"), Counts(1, 0, 0))
        self.assertEqual(self.count("other", "notrun"), Counts(0, 1, 0))


if __name__ == "__main__":
    unittest.main()
