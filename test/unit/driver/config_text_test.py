import os
import tempfile
import unittest

import yaml

from driver.config_text import ConfigError, ConfigText, number_text

_TEXT = """# What stands above.
planner:
  threshold: &threshold 65  # percent
  shape: &shape
    front: 0.2   # m
  name: astar
  label: "7"
navigator:
  threshold: *threshold
  shape: *shape
  speed: 1.5
"""


class ConfigTextTest(unittest.TestCase):

    def setUp(self):
        self.config = ConfigText("c.yaml", _TEXT)

    def test_numbers(self):
        self.assertEqual(self.config.number("planner.threshold"), 65)
        self.assertEqual(self.config.number("navigator.threshold"), 65)
        self.assertEqual(self.config.number("navigator.shape.front"), 0.2)
        self.assertIsInstance(self.config.number("planner.threshold"), int)

    def test_replaces_nothing_but_the_numbers(self):
        text = self.config.with_numbers({"planner.threshold": 70,
                                         "navigator.speed": 0.25,
                                         "planner.shape.front": 0.3})
        self.assertEqual(text, _TEXT.replace("65", "70").replace(
            "1.5", "0.25").replace("0.2 ", "0.3 "))

    def test_an_alias_is_its_anchor(self):
        self.assertEqual(self.config.place("navigator.shape.front"),
                         self.config.place("planner.shape.front"))
        values = yaml.safe_load(self.config.with_numbers(
            {"navigator.threshold": 50, "navigator.shape.front": 0.4}))
        self.assertEqual(values["planner"]["threshold"], 50)
        self.assertEqual(values["navigator"]["threshold"], 50)
        self.assertEqual(values["planner"]["shape"]["front"], 0.4)

    def test_errors_name_what_is_wrong(self):
        for name, text in (("planner.speed", "there is no planner.speed"),
                           ("plan.shape.x", "there is no plan,"),
                           ("navigator.speed.x", "no navigator.speed.x"),
                           ("planner.name", "planner.name is 'astar'"),
                           ("planner.label", "planner.label is '7'"),
                           ("planner.shape", "planner.shape is 'a section'")):
            with self.subTest(name), self.assertRaisesRegex(
                    ConfigError, "c.yaml: .*" + text):
                self.config.number(name)
        with self.assertRaisesRegex(ConfigError, "c.yaml"):
            ConfigText("c.yaml", "a: [")
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(ConfigError, "none.yaml"):
                ConfigText(os.path.join(folder, "none.yaml"))

    def test_every_number_is_read_back_as_one(self):
        for value in (1e-5, 1e20, 0.1, 3, -2.5e-9, 123456.789):
            self.assertEqual(yaml.safe_load(number_text(value)), value)


if __name__ == "__main__":
    unittest.main()
