import argparse
import unittest

from driver import amounts


class AmountsTest(unittest.TestCase):

    def test_what_is_read(self):
        self.assertEqual(amounts.count("3"), 3)
        self.assertEqual(amounts.indices("6,0,12,6"), [0, 6, 12])
        self.assertEqual(amounts.share("0.25"), 0.25)
        self.assertEqual(amounts.pace("1"), 1.0)

    def test_what_is_not(self):
        for read, texts in ((amounts.count, ("0", "-1")),
                            (amounts.indices, ("", "1,a", "1;2")),
                            (amounts.share, ("0", "1", "nan")),
                            (amounts.pace, ("0", "1.5", "nan", "-1"))):
            for text in texts:
                with self.subTest((read.__name__, text)), \
                        self.assertRaises(argparse.ArgumentTypeError):
                    read(text)


if __name__ == "__main__":
    unittest.main()
