import json
import os
import tempfile
import unittest

from driver import barn, benchmark_tables
from driver.benchmark_tables import FiguresError


class BenchmarkTablesTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = os.path.join(folder.name, "ours.json")
        runs = [{"world": i % 2, "run": i // 2, "outcome": outcome,
                 "time_s": 10.0, "score_k4": score, "score_k2": 2.0 * score}
                for i, (outcome, score) in enumerate(
                    [("success", 0.25)] * 3 + [("collision", 0.0)])]
        self.figures = barn.summary(runs)
        self.write(self.figures)

    def write(self, figures):
        with open(self.file, "w") as stream:
            json.dump(figures, stream)

    def test_labels(self):
        self.assertEqual(benchmark_tables.read(self.file).label, "ours")
        self.assertEqual(benchmark_tables.read("the new one=" + self.file).label,
                         "the new one")

    def test_barn_beside_what_is_published(self):
        header, rows = benchmark_tables.barn_table(
            [benchmark_tables.read(self.file)])
        self.assertTrue(all(len(row) == len(header) for row in rows))
        # Wilson's interval of 3 in 4.
        self.assertEqual(rows[0][:5], ["ours", "2", "4", "75.0% (30% to 95%)",
                                       "25.0% (5% to 70%)"])
        # Mean 0.1875; deviation 0.125, of which 1.96 / sqrt(4) is 0.1225.
        self.assertEqual(rows[0][6:], ["10.0 ± 0.0", "0.188 ± 0.199",
                                       "0.375 ± 0.398"])
        published = {row[0]: row for row in rows[1:]}
        self.assertEqual(len(published), 3)
        self.assertIn("0.4975", rows[3])

    def test_dynabarn_has_no_scores(self):
        header, rows = benchmark_tables.dynabarn_table(
            [benchmark_tables.read(self.file)])
        self.assertEqual(len(rows), 1)
        self.assertEqual(len(rows[0]), len(header))
        self.assertFalse([title for title in header if "score" in title])

    def test_errors_name_the_file(self):
        with self.assertRaisesRegex(FiguresError, "none.json"):
            benchmark_tables.read("none.json")
        for figures, text in (([], "no runs"), ({"runs": []}, "no success"),
                              ({**self.figures, "runs": []}, "no runs")):
            self.write(figures)
            with self.assertRaisesRegex(FiguresError, "ours.json: .*" + text):
                benchmark_tables.read(self.file)


if __name__ == "__main__":
    unittest.main()
