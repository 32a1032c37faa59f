# SPDX-License-Identifier: GPL-3.0-or-later
"""Files and pictures."""

import pathlib
import tempfile
import unittest
import xml.etree.ElementTree as xml

import fretwork as fw
import support


class Exports(unittest.TestCase):
    def test_each_kind_of_file_is_written(self):
        surface = support.surface()
        result = fw.simulate(surface, support.tip(), model="corotational")
        for writer in fw.writer_catalogue():
            with self.subTest(writer.description):
                content = fw.export_content(surface, writer.ending, result, support.tip(), writer.content, size="64x48")
                self.assertGreater(len(content), 100)

    def test_several_files_are_written_or_none(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = [pathlib.Path(folder) / "a.svg", pathlib.Path(folder) / "no" / "b.obj"]
            with self.assertRaises(fw.IoError):
                fw.export(support.surface(), paths)
            self.assertFalse(paths[0].exists())

    def test_a_result_of_another_painting_is_refused(self):
        result = fw.simulate(support.surface(), support.tip(), model="corotational")
        session = fw.Session(support.surface(), support.tip())
        session.paint([0], support.OTHER)
        with self.assertRaisesRegex(fw.InputError, "painting"):
            fw.export_content(session.surface, ".vtu", result)

    def test_an_unknown_keyword_is_refused(self):
        with self.assertRaisesRegex(TypeError, "colur"):
            fw.export_content(support.surface(), ".svg", colur="plain")

    def test_fillets_are_lengths_with_units(self):
        shape = fw.make_shape(support.surface(), fillet=5e-4)
        self.assertGreater(shape.area, fw.make_shape(support.surface()).area)
        self.assertEqual(fw.make_solid(shape).open_edges, 0)


class Pictures(unittest.TestCase):
    def test_notebooks_show_layouts_outlines_projects_and_surfaces(self):
        project = support.project()
        for thing in (project.layout, project.outline, project, support.surface()):
            with self.subTest(repr(thing)[:20]):
                self.assertTrue(xml.fromstring(thing._repr_svg_()).tag.endswith("svg"))
        self.assertIn("svg", project.layout.draw(support.PATTERN)._repr_svg_())

    def test_a_view_is_a_frame_that_needs_nothing_else(self):
        result = fw.simulate(support.surface(), support.tip(), model="corotational")
        page = support.surface().view(result)
        self.assertTrue(page._repr_html_().startswith("<iframe srcdoc="))
        self.assertNotIn("https://cdn", page.page)

    def test_pandas_gets_a_row_a_node(self):
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("pandas is not installed")
        result = fw.simulate(support.surface(), support.tip(), model="corotational")
        table = result.to_pandas()
        self.assertEqual(len(table), len(result.displacements))
        self.assertEqual(table["uz"].iloc[3], result.displacements[3, 2])


if __name__ == "__main__":
    unittest.main()
