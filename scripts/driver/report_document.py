"""A document of headings, paragraphs, tables and pictures, as Markdown with PNG
files and as one HTML page with everything in it."""

import base64
import html
import os
from dataclasses import dataclass
from typing import List, Sequence

_STYLE = """
body { font: 16px/1.5 sans-serif; color: #222; background: #fff;
       max-width: 72em; margin: 2em auto; padding: 0 1em; }
table { border-collapse: collapse; margin: 1em 0; font-size: 0.9em; }
div.wide { overflow-x: auto; }
th, td { padding: 0.3em 0.8em; border-bottom: 1px solid #ccc;
         text-align: right; vertical-align: bottom; white-space: nowrap; }
th { border-bottom: 2px solid #888; }
th:first-child, td:first-child { text-align: left; }
figure { margin: 1.5em 0; }
img { max-width: 100%; height: auto; }
figcaption { color: #555; font-size: 0.9em; }
"""


@dataclass(frozen=True)
class Heading:
    level: int  # from 1
    text: str

    def markdown(self):
        return "#" * self.level + " " + self.text

    def html(self, folder):
        return "<h{0}>{1}</h{0}>".format(self.level, html.escape(self.text))


@dataclass(frozen=True)
class Paragraph:
    text: str

    def markdown(self):
        return self.text

    def html(self, folder):
        return "<p>{}</p>".format(html.escape(self.text))


@dataclass(frozen=True)
class Table:
    header: Sequence[str]
    rows: Sequence[Sequence[str]]

    def markdown(self):
        def line(cells):
            return "| " + " | ".join(cell.replace("|", "\\|").replace(
                "\n", " ") for cell in cells) + " |"

        align = "|---" + "|---:" * (len(self.header) - 1) + "|"
        return "\n".join([line(self.header), align, *map(line, self.rows)])

    def html(self, folder):
        def line(cells, tag):
            return "<tr>{}</tr>".format("".join(
                "<{0}>{1}</{0}>".format(tag, html.escape(cell))
                for cell in cells))

        return ('<div class="wide"><table>\n<thead>{}</thead>\n<tbody>\n{}\n'
                "</tbody>\n</table></div>").format(
                    line(self.header, "th"),
                    "\n".join(line(row, "td") for row in self.rows))


@dataclass(frozen=True)
class Picture:
    file: str  # PNG in the report's folder
    caption: str

    def markdown(self):
        return "![{}]({})\n\n*{}*".format(self.caption.split(":")[0], self.file,
                                          self.caption)

    def html(self, folder):
        with open(os.path.join(folder, self.file), "rb") as png:
            data = base64.b64encode(png.read()).decode()
        return ('<figure><img src="data:image/png;base64,{}" alt="{}">'
                "<figcaption>{}</figcaption></figure>").format(
                    data, html.escape(self.caption, quote=True),
                    html.escape(self.caption))


def write(title, blocks: List, folder):
    """Writes report.md and report.html beside the pictures."""
    blocks = [Heading(1, title), *blocks]
    with open(os.path.join(folder, "report.md"), "w",
              encoding="utf-8") as file:
        file.write("\n\n".join(block.markdown() for block in blocks) + "\n")
    with open(os.path.join(folder, "report.html"), "w",
              encoding="utf-8") as file:
        file.write('<!DOCTYPE html>\n<html lang="en">\n<head>\n'
                   '<meta charset="utf-8">\n'
                   '<meta name="viewport" content="width=device-width">\n'
                   "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}\n"
                   "</body>\n</html>\n".format(
                       html.escape(title), _STYLE,
                       "\n".join(block.html(folder) for block in blocks)))
