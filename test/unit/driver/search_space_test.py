import os
import tempfile
import unittest

from driver import drive_runs, search_space
from driver.config_text import ConfigError, ConfigText
from driver.drive_runs import DriveRun

_CONFIG = ConfigText("c.yaml", "a: &a 0.5\nb: 3\nc: {d: 2.0}\ne: *a\n")
_ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")


def read(text):
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "space.yaml")
        with open(file, "w") as stream:
            stream.write(text)
        return search_space.read(file, _CONFIG)


class SearchSpaceTest(unittest.TestCase):

    def test_reads_ranges(self):
        a, b, d = read("a: {low: 0.25, high: 1.0, step: 0.25}\n"
                       "b: {low: 1, high: 5}\n"
                       "c.d: {low: 0.1, high: 10.0, log: true}\n")
        self.assertEqual((a.name, a.low, a.high, a.step, a.log, a.is_whole),
                         ("a", 0.25, 1.0, 0.25, False, False))
        self.assertTrue(b.is_whole)
        self.assertEqual((d.name, d.log), ("c.d", True))

    def test_rounds_inside_the_range(self):
        d, = read("c.d: {low: 1.23456, high: 2.34567}")
        self.assertEqual(d.rounded(2.0001234), 2.0)
        self.assertEqual(d.rounded(1.23457), 1.235)
        self.assertEqual(d.rounded(1.23421), 1.23456)
        self.assertEqual(d.rounded(2.34566), 2.34567)
        b, = read("b: {low: 1, high: 5}")
        self.assertEqual(repr(b.rounded(4)), "4")

    def test_errors_name_entry_value_and_what_is_expected(self):
        for text, message in (
                ("", "expected lines of the form"),
                ("- a", "expected lines of the form"),
                ("a: [0, 1]", r"a is \[0, 1\]; expected {low"),
                ("a: {low: 0.1}", "a.high is None; expected a finite number"),
                ("a: {low: .nan, high: 1}", "a.low is nan"),
                ("a: {low: true, high: 1}", "a.low is True"),
                ("a: {low: 1.0, high: 0.1}", "a.high is 0.1; expected more"),
                ("a: {low: 0, high: 1, width: 2}", "a is 'width'; expected "
                 "only low, high, step, log"),
                ("a: {low: 0, high: 1, log: true}", "a.low is 0; .*log"),
                ("a: {low: 0.1, high: 1, log: 3}", "a.log is 3"),
                ("a: {low: 0.1, high: 1, log: true, step: 0.1}", "a.step"),
                ("a: {low: 0, high: 1, step: 0.3}", "a.step is 0.3; expected a "
                 "fraction of high - low, which is 1"),
                ("a: {low: 0, high: 1, step: -0.5}", "a.step is -0.5"),
                ("a: {low: 0.6, high: 1}", "a is 0.5; expected from 0.6 to 1"),
                ("a: {low: 0, high: 1.2, step: 0.4}", "a is 0.5; .*steps of"),
                ("b: {low: 1.5, high: 5}", "b.low is 1.5; expected a whole"),
                ("a: {low: 0, high: 1}\ne: {low: 0, high: 1}",
                 "a and e are one and the same"),
                ("a: [", "space.yaml")):
            with self.subTest(text), self.assertRaisesRegex(
                    search_space.SpaceError, message):
                read(text)
        with self.assertRaisesRegex(ConfigError, "there is no z"):
            read("z: {low: 0, high: 1}")

    def own_space(self):
        config = ConfigText(os.path.join(_ROOT, "config", "jackal.yaml"))
        return config, search_space.read(
            os.path.join(_ROOT, "config", "tune.yaml"), config)

    def test_the_packages_own_space_fits_its_configuration(self):
        _, parameters = self.own_space()
        self.assertGreater(len(parameters), 5)
        # What keeps the robot from harm is nothing to be tuned for speed.
        self.assertFalse([p for p in parameters if ".safety." in p.name
                          or ".limits." in p.name])

    @unittest.skipUnless(os.path.isfile(drive_runs.PROGRAM),
                         "the benchmark program is not built")
    def test_the_stack_takes_the_ends_of_the_packages_own_space(self):
        config, parameters = self.own_space()
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "end.yaml")
            for end in ("low", "high"):
                with open(file, "w") as stream:
                    stream.write(config.with_numbers(
                        {p.name: getattr(p, end) for p in parameters}))
                figures = drive_runs.perform(DriveRun(
                    (), os.path.join(_ROOT, "worlds", "open_field.yaml"), file,
                    ("--time-limit", "0.1")))
                self.assertEqual(figures["outcome"], "timeout")


if __name__ == "__main__":
    unittest.main()
