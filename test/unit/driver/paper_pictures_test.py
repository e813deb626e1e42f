import math
import os
import tempfile
import unittest

from driver import paper_pictures

_TRACE = """time,x,y,state,e1,e2,reference_x,reference_y,reason
0.0,1.0,2.0,PLANNING,0.0,0.0,,,"new goal"
0.1,1.0,2.0,TRACKING,0.3,0.4,1.5,2.0,"trajectory received"
0.2,1.1,2.0,AVOIDING,0.0,0.7,1.6,2.0,"too close: 0.1 m, ahead"
"""
_MOTIONS = """motion,time,line,x,y
0,0.0,path,1.0,2.0
0,0.0,path,5.0,2.0
0,0.0,trajectory,1.0,2.0
1,0.1,path,2.0,2.0
"""


class DriveTest(unittest.TestCase):

    def setUp(self):
        with tempfile.TemporaryDirectory() as folder:
            files = []
            for name, content in (("trace", _TRACE), ("motions", _MOTIONS)):
                files.append(os.path.join(folder, name))
                with open(files[-1], "w") as file:
                    file.write(content)
            self.drive = paper_pictures.Drive(*files)

    def test_course_and_reference(self):
        self.assertEqual(self.drive.driven().tolist(),
                         [[1.0, 2.0], [1.0, 2.0], [1.1, 2.0]])
        self.assertEqual(self.drive.reference().tolist(),
                         [[1.5, 2.0], [1.6, 2.0]])

    def test_errors_while_tracking_alone(self):
        times, errors = self.drive.errors()
        self.assertEqual(times.tolist(), [0.0, 0.1, 0.2])
        self.assertTrue(math.isnan(errors[0]))
        self.assertAlmostEqual(errors[1], 0.5)
        self.assertTrue(math.isnan(errors[2]))

    def test_lines_by_motion(self):
        paths = self.drive.lines("path")
        self.assertEqual(paths[0].tolist(), [[1.0, 2.0], [5.0, 2.0]])
        self.assertEqual(paths[1].tolist(), [[2.0, 2.0]])
        self.assertEqual(list(self.drive.lines("trajectory")), [0])


if __name__ == "__main__":
    unittest.main()
