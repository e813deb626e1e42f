import base64
import os
import re
import tempfile
import unittest

from driver import report_document
from driver.report_document import Heading, Paragraph, Picture, Table


class ReportDocumentTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, *blocks):
        report_document.write("A <title>", blocks, self.folder)
        texts = []
        for name in ("report.md", "report.html"):
            with open(os.path.join(self.folder, name)) as file:
                texts.append(file.read())
        return texts

    def test_markdown(self):
        markdown, _ = self.write(
            Heading(2, "Part"), Paragraph("Some words."),
            Table(["what", "how"], [["a|b", "1"], ["c", "2\n3"]]))
        self.assertEqual(markdown, (
            "# A <title>\n\n## Part\n\nSome words.\n\n"
            "| what | how |\n|---|---:|\n| a\\|b | 1 |\n| c | 2 3 |\n"))

    def test_html_escapes(self):
        _, page = self.write(Paragraph("1 < 2 & 3"), Table(
            ["<x>"], [["<y>"]]))
        for text in ("<title>A &lt;title&gt;</title>", "<p>1 &lt; 2 &amp; 3</p>",
                     "<th>&lt;x&gt;</th>", "<td>&lt;y&gt;</td>"):
            self.assertIn(text, page)

    def test_pictures_are_inside_the_page_and_beside_the_markdown(self):
        data = b"\x89PNG and so on"
        with open(os.path.join(self.folder, "p.png"), "wb") as file:
            file.write(data)
        markdown, page = self.write(Picture("p.png", "Paths: what \"they\" "
                                            "drove"))
        self.assertIn("![Paths](p.png)", markdown)
        inside = re.search('src="data:image/png;base64,([^"]*)"', page)
        self.assertEqual(base64.b64decode(inside.group(1)), data)
        self.assertNotIn("p.png", page)


if __name__ == "__main__":
    unittest.main()
