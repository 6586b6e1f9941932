// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <support/program_folder.h>

#include <sstream>

namespace {

class View : public ProgramFolder {
protected:
  View() : ProgramFolder (PCL_OPS_VIEW_PROGRAM)
  {
    // A floor of 2 m x 2 m and a wall at x = 2 m, of points 4 cm apart.
    constexpr int steps = 50;
    std::ostringstream text;
    for (int i = 0; i < steps * steps; ++i) {
      const double first = 0.04 * (i / steps), second = 0.04 * (i % steps);
      text << first << " " << second << " 0\n2 " << first << " " << second << "\n";
    }
    folder_.write ("in.xyz", text.str());
  }

  /** \brief Runs the viewer on a display of its own, by xvfb-run. The exit code is that
   * of the viewer, as xvfb-run may fail to tidy up; "out" has both of the viewer's
   * streams.
   * \param[in] environment variables, as "NAME=value" */
  Outcome
  screenshot (const std::string& arguments, const std::string& environment = "") const
  {
    streams_.write ("viewer.sh",
                    "env " + environment + " '" PCL_OPS_VIEW_PROGRAM "' in.xyz " +
                        arguments + " >said 2>&1\necho $? >code\n");
    return shell ("{ rm -f said code; xvfb-run -a -s '-screen 0 1024x768x24' sh '" +
                  streams_ / "viewer.sh" +
                  "' >display.log 2>&1; cat said; exit $(cat code); }");
  }
};

} // namespace

TEST_F (View, WritesScreenshotsOfTheWindowAndKeepsTheOldOneIfTheDiskIsFull)
{
#ifdef PCL_OPS_SANITIZED
  GTEST_SKIP() << "graphics drivers are not made for sanitizers";
#endif
  if (!contains (
          shell ("command -v xauth >/dev/null && xvfb-run -a echo a display").out,
          "a display"))
    GTEST_SKIP() << "xvfb-run is not installed or cannot start";
  const Outcome done = screenshot ("--screenshot a.png");
  if (contains (done.out, "OpenGL"))
    GTEST_SKIP() << done.out;
  EXPECT_EQ (done.exit_code, 0) << done.out;
  const std::string png = contentOf (folder_ / "a.png");
  ASSERT_GT (png.size(), 24u);
  EXPECT_EQ (png.substr (1, 3), "PNG");
  // Width and height are behind the signature and the head of the first chunk.
  constexpr std::size_t offset_of_size = 16;
  const std::string size_of_1280_x_960 ("\0\0\5\0\0\0\3\xC0", 8);
  EXPECT_EQ (png.substr (offset_of_size, 8), size_of_1280_x_960);
  EXPECT_EQ (screenshot ("--color orientations --screenshot b.png").exit_code, 0);
  const std::string by_orientation = contentOf (folder_ / "b.png");
  ASSERT_GT (by_orientation.size(), 24u);
  EXPECT_NE (by_orientation, png);
#ifdef PCL_OPS_FAILING_CALLS
  const Outcome full = screenshot (
      "--screenshot a.png", "LD_PRELOAD='" PCL_OPS_FAILING_CALLS "' FULL_AT_WRITE=1");
  EXPECT_EQ (full.exit_code, 1);
  EXPECT_EQ (full.out.find ("pcl_ops_view: a.png: cannot be written"), 0u) << full.out;
  EXPECT_EQ (contentOf (folder_ / "a.png"), png) << "the old one is kept";
#endif
}

TEST_F (View, WritesThePageThatPclOpsSegmentWritesWithoutADisplay)
{
  const Outcome done =
      shell ("pcl_ops_segment in.xyz --method kht --quiet --view a.html && "
             "env -u DISPLAY -u WAYLAND_DISPLAY pcl_ops_view in.xyz --method kht "
             "--view b.html && cmp a.html b.html");
  EXPECT_EQ (done.exit_code, 0) << done.out << done.err;
}
