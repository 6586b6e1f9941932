# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which lines scripts/mutate can break, and how.

python3 mutate_test.py SOURCES: the project's folder.
"""

import importlib.machinery
import importlib.util
import pathlib
import sys
import tempfile
import unittest

SCRIPT = str(pathlib.Path(sys.argv[1]) / "scripts" / "mutate")
loader = importlib.machinery.SourceFileLoader("mutate", SCRIPT)
mutate = importlib.util.module_from_spec(importlib.util.spec_from_loader("mutate", loader))
sys.modules["mutate"] = mutate  # where its data classes look for their module
sys.dont_write_bytecode = True
loader.exec_module(mutate)


class Lines(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        root, tree = mutate.ROOT, mutate.TREE
        self.addCleanup(lambda: setattr(mutate, "ROOT", root))
        self.addCleanup(lambda: setattr(mutate, "TREE", tree))
        mutate.ROOT = mutate.TREE = pathlib.Path(folder.name)
        self.source = mutate.TREE / "src" / "a.cpp"
        self.source.parent.mkdir()

    def broken(self, *lines):
        """What each line that can be broken becomes."""
        self.source.write_text("\n".join(lines))
        return [line.broken.strip() for line in mutate.breakable_lines(self.source)]

    def test_have_a_number_doubled_or_an_operator_turned(self):
        for line, expected in (
                ("  double width = 0.5;", "double width = (BROKEN ? 0.5 == 0 ? 1 : 2 * 0.5 : 0.5);"),
                ("  if (a < b)", "if (a < Broken<'<'>{BROKEN} < b)"),
                ("  if (a != b)", "if (a == Broken<'!='>{BROKEN} == b)"),
                ("  x (a - b);", "x (a + Broken<'-'>{BROKEN} + b);"),
                ("  if (a && b)", "if (a && !(BROKEN) && b)"),
                ("  if (a || b)", "if (a || (BROKEN) || b)")):
            # After "x = y", which ends no statement, no line begins one. So none can be left
            # out as a statement.
            self.assertEqual(self.broken("x = y", line), [expected])

    def test_that_are_statements_are_left_out(self):
        self.assertEqual(self.broken("{", "  sort (all);", "  continue;"),
                         ["if (BROKEN) {} else sort (all);", "if (BROKEN) {} else continue;"])
        self.assertEqual(self.broken("  call (one,", "  other);"), [], "half of a statement")

    def test_are_none_in_comments_texts_and_directives(self):
        self.assertEqual(self.broken("// a < 2", "  int x; // 5", "/** 3 */", " * 4 && 5", "#if X > 1",
                                     '  text = "9 < 3"', "  std::int32_t"), [])

    def test_are_the_same_of_the_same_seed(self):
        self.source.write_text("\n".join(f"  double a{i} = {i}.5;" for i in range(50)))
        one, again, other = (mutate.draw_lines("", 10, seed) for seed in (1, 1, 2))
        self.assertEqual(one, again)
        self.assertNotEqual(one, other)
        self.assertEqual(len(one), 15, "half as many again as asked for, as not all compile")

    def test_of_constants_take_along_what_is_made_of_them(self):
        self.source.write_text("constexpr double a = constants.b;\nconstexpr double c = 1.0;\n")
        line = mutate.BrokenLine("constants.h", 1, "  double b = 2.0;", "  double b = BROKEN;")
        mutate.break_lines(self.source, [line])
        text = self.source.read_text()
        self.assertIn("\nconst double a = constants.b;", text)
        self.assertIn("\nconstexpr double c = 1.0;", text)

    def test_of_constants_are_known_by_their_key(self):
        self.source.write_text("constexpr double a = 1.0;")
        line = next(mutate.breakable_lines(self.source))
        mutate.break_lines(self.source, [line])
        text = self.source.read_text()
        self.assertIn("\nconst double a = (", text)
        self.assertIn(f'PCL_OPS_DOES_NOTHING ("{line.key}")', text)

    def test_that_declare_constants_the_compiler_needs_are_the_errors_of_the_log(self):
        log = mutate.LOG
        self.addCleanup(lambda: setattr(mutate, "LOG", log))
        mutate.LOG = mutate.TREE / "log"
        mutate.LOG.write_text(
            "/b/tree/src/a.cpp:7:5: error: 'constants' is not usable in a constant expression\n"
            "/b/tree/src/c.h:9:1: note: 'constants' was not declared 'constexpr'\n")
        self.assertEqual(mutate.errors_of_log(), {("c.h", "9")})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
