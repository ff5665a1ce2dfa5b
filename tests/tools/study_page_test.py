"""tools/study_page.py: what a page holds, and that it needs nothing else."""

import re
import struct
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
import study_page  # noqa: E402

STUDY = Path(__file__).resolve().parents[1] / "study"


def png(file, gray):
    """One gray pixel."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 0, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(bytes([0, gray]))) + chunk(b"IEND", b""))
    return file


class Page(unittest.TestCase):
    def setUp(self):
        with tempfile.TemporaryDirectory() as folder:
            left, right = png(Path(folder) / "a.png", 10), png(Path(folder) / "b.png", 200)
            pair = study_page.Pair("default", "A<B", "What is <seen>.", left, right)
            self.text = (STUDY / "README.md").read_text()
            self.page = study_page.page(self.text, STUDY, [pair])

    def test_needs_no_other_file(self):
        for source in re.findall(r"""(?:src|href)=["']([^"']*)["']""", self.page):
            self.assertTrue(source.startswith(("data:", "#")), source)
        self.assertNotIn("@import", self.page)

    def test_holds_every_table_and_plot(self):
        self.assertEqual(self.page.count("<table>"), self.text.count("<!-- table:"))
        self.assertEqual(self.page.count("<svg"), len(re.findall(r"!\[.*\]\(.*\.svg\)", self.text)))

    def test_plots_take_no_part_from_one_another(self):
        names = re.findall(r"""\bid=["']([^"']*)["']""", self.page)
        used = re.findall(r"""(?:href=["']|url\(["']?)#([^"')]*)""", self.page)
        self.assertGreater(len(used), 0)
        for name in set(used):
            self.assertEqual(names.count(name), 1, name)

    def test_shows_a_pair_with_its_slider(self):
        self.assertEqual(self.page.count("class='pair'"), 1)
        self.assertEqual(self.page.count("data:image/png;base64,"), 2)
        self.assertIn("type='range'", self.page)
        self.assertIn("A&lt;B", self.page)
        self.assertIn("What is &lt;seen&gt;.", self.page)


unittest.main()
