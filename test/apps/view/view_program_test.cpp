// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <support/run_program.h>
#include <support/temporary_folder.h>

#include <algorithm>
#include <limits>

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/** \brief A folder with a floor and a wall, to run the viewer in. */
class View : public testing::Test {
protected:
  View()
  {
    pcl::PointCloud<pcl::PointXYZ> cloud;
    for (int i = 0; i < 50; ++i)
      for (int j = 0; j < 50; ++j) {
        const float x = 0.04f * static_cast<float> (i);
        const float y = 0.04f * static_cast<float> (j);
        cloud.emplace_back (x, y, 0.0f);
        cloud.emplace_back (2.0f, y, x);
      }
    cloud.emplace_back (not_a_number, not_a_number, not_a_number);
    pcl::io::savePCDFileBinary (folder_ / "in.pcd", cloud);
  }

  /** \brief Runs the viewer without a display.
   * \param[in] environment variables for it, as env takes them */
  ProgramRun
  run (const std::string& arguments, const std::string& environment = "") const
  {
    return runInFolder ("env -u DISPLAY " + environment +
                        " '" PCL_OPS_VIEW_PROGRAM "' " + arguments);
  }

  /** \brief Runs the viewer on a display of its own. What xvfb-run says and how it ends
   * is left out: it may fail to tidy up after a viewer that did its work. */
  ProgramRun
  runOnDisplay (const std::string& arguments, const std::string& environment = "") const
  {
    const std::string viewer =
        folder_.write ("viewer.sh",
                       "env " + environment + " '" PCL_OPS_VIEW_PROGRAM "' " +
                           arguments + " >said 2>&1\necho $? >code\n");
    return runInFolder ("rm -f said code\nxvfb-run -a -s '-screen 0 1024x768x24' sh '" +
                        viewer +
                        "' >display.log 2>&1\n"
                        "[ -e code ] || { cat display.log; exit 1; }\n"
                        "cat said\nexit $(cat code)");
  }

  /** \brief Why nothing can be drawn on this machine; empty if it can. */
  static std::string
  whyNotDrawn ()
  {
#ifdef PCL_OPS_SANITIZED
    return "graphics drivers are not made for sanitizers";
#else
    const char* const probe =
        "'command -v xauth >/dev/null && xvfb-run -a echo a display'";
    return runProgram ("sh", std::string ("-c ") + probe).text.find ("a display") !=
                   std::string::npos
               ? ""
               : "xvfb-run is not installed or cannot start";
#endif
  }

  TemporaryFolder folder_;

private:
  ProgramRun
  runInFolder (const std::string& commands) const
  {
    const std::string script =
        folder_.write ("run.sh", "cd '" + folder_.path() + "'\n" + commands + "\n");
    return runProgram ("sh", "'" + script + "'");
  }
};

void
expectOneLine (const ProgramRun& run, int exit_code, const std::string& about)
{
  EXPECT_EQ (run.exit_code, exit_code) << run.text;
  EXPECT_EQ (std::count (run.text.begin(), run.text.end(), '\n'), 1) << run.text;
  EXPECT_EQ (run.text.find ("pcl_ops_view: "), 0u) << run.text;
  EXPECT_NE (run.text.find (about), std::string::npos) << run.text;
}

} // namespace

TEST_F (View, ListsOptionsAndKeysInItsHelp)
{
  const ProgramRun help = run ("--help");
  EXPECT_EQ (help.exit_code, 0);
  for (const char* part : {"--screenshot", "--method", "--hulls", "next method"})
    EXPECT_NE (help.text.find (part), std::string::npos) << part;
}

TEST_F (View, RefusesWrongUsageAndCloudsItCannotShow)
{
  pcl::PointCloud<pcl::PointXYZ> nowhere (
      3, 1, {not_a_number, not_a_number, not_a_number});
  pcl::io::savePCDFileBinary (folder_ / "nan.pcd", nowhere);
  for (const char* file : {"nan.pcd", "missing.pcd"})
    expectOneLine (run (file), 1, file);
  expectOneLine (run ("in.pcd --screenshot nowhere/out.png"), 1, "nowhere/out.png");
  for (const char* arguments : {"",
                                "in.abc",
                                "in.pcd --method sac",
                                "in.pcd --color rainbow",
                                "in.pcd --size 12",
                                "in.pcd --size 0x100",
                                "in.pcd --screenshot picture.gif"})
    expectOneLine (run (arguments), 2, "");
#ifndef __APPLE__ // where windows need no X11 display
  expectOneLine (run ("in.pcd"), 1, "xvfb-run");
  expectOneLine (run ("in.pcd", "DISPLAY=nowhere:99"), 1, "nowhere:99");
#endif
}

TEST_F (View, WritesScreenshotsAsAsked)
{
  if (!whyNotDrawn().empty())
    GTEST_SKIP() << whyNotDrawn();
  const ProgramRun done = runOnDisplay (
      "in.pcd --hulls --normals --edges --size 320x240 --screenshot a.png");
  if (done.text.find ("OpenGL") != std::string::npos)
    GTEST_SKIP() << done.text;
  EXPECT_EQ (done.exit_code, 0) << done.text;
  const std::string png = contentOf (folder_ / "a.png");
  ASSERT_GT (png.size(), 24u);
  EXPECT_EQ (png.substr (1, 3), "PNG");
  EXPECT_EQ (png.substr (16, 8), std::string ("\0\0\x01\x40\0\0\0\xF0", 8)); // 320x240
  for (const char* other : {"", "--color input --hulls --normals --edges"}) {
    runOnDisplay (std::string (other) + " in.pcd --size 320x240 --screenshot b.png");
    EXPECT_NE (contentOf (folder_ / "b.png"), png) << other;
  }
#ifdef PCL_OPS_FAILING_CALLS
  expectOneLine (runOnDisplay ("in.pcd --size 320x240 --screenshot a.png",
                               "LD_PRELOAD='" PCL_OPS_FAILING_CALLS
                               "' FULL_AT_WRITE=1"),
                 1,
                 "a.png: cannot be written");
  EXPECT_EQ (contentOf (folder_ / "a.png"), png) << "the old one is kept";
#endif
}
