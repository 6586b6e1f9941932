// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <picture/colors.h>
#include <view/found_planes.h>

using namespace pcl_ops;
using namespace pcl_ops::apps;

namespace {

/** \brief The state after some keys are pressed, of which each must change it. Plane 2
 * is selected at first. */
ViewState
afterKeys (const std::string& keys)
{
  ViewState state;
  state.selected = 2;
  for (const char key : keys)
    EXPECT_TRUE (pressKey (key, state)) << key;
  return state;
}

} // namespace

TEST (ViewState, KeysSwitchOneWayAndBack)
{
  EXPECT_EQ (afterKeys ("2").coloring, "orientations");
  EXPECT_EQ (afterKeys ("21").coloring, "planes");
  EXPECT_EQ (afterKeys ("p").detector.preset, "paper");
  EXPECT_EQ (afterKeys ("pp").detector.preset, "default");
  EXPECT_EQ (afterKeys ("m").method, "fspf");
  EXPECT_EQ (afterKeys ("mmm").method, "ops");
  EXPECT_FALSE (afterKeys ("h").shows_keys);
  EXPECT_TRUE (afterKeys ("hh").shows_keys);
  EXPECT_EQ (afterKeys ("2h").selected, 2u);
  for (const char* key : {"m", "p"})
    EXPECT_EQ (afterKeys (key).selected, 0u) << "other planes than the selected one";
  ViewState state;
  for (const char key : {'r', 'o', 'q', '+', '-', 'x'})
    EXPECT_FALSE (pressKey (key, state)) << key << " is a key of the camera or none";
}

TEST (FoundPlanes, AreThoseOfEveryMethodInTheirColorsAndInWords)
{
  const auto table = pcl::make_shared<XyzCloud>();
  for (int x = 0; x <= 100; ++x)
    for (int y = 0; y <= 100; ++y)
      table->emplace_back (0.02f * float (x), 0.02f * float (y), 0.0f);
  table->emplace_back (1.0f, 1.0f, 0.5f);
  for (const char* keys : {"", "m", "mm"}) {
    SCOPED_TRACE (keys);
    ViewState state = afterKeys (keys);
    const FoundPlanes found = findPlanes (state, table);
    ASSERT_EQ (found.detected.planes.size(), 1u);
    const std::size_t in_the_air = table->size() - 1;
    EXPECT_EQ (found.labels[0], 1u);
    EXPECT_EQ (found.labels[in_the_air], 0u);
    state.selected = 0;
    EXPECT_EQ (colorOfPoint (found, state, 0).rgba, colorOfLabel (1).rgba);
    EXPECT_EQ (colorOfPoint (found, state, in_the_air).rgba, colorOfLabel (0).rgba);
    state.coloring = "orientations";
    EXPECT_EQ (colorOfPoint (found, state, 0).rgba,
               colorOf (Orientation::Horizontal).rgba);
    state.selected = 1;
    EXPECT_NE (colorOfPoint (found, state, in_the_air).rgba, colorOfLabel (0).rgba)
        << "points off the selected plane";
    const Eigen::Vector3d shift (0, 0, 10); // of the cloud
    const std::string text = statusText (found, state, shift);
    for (const char* part : {"say which plane this is",
                             "10202 points\n",
                             "1 plane\nplane 1: horizontal, 10201 points, area 4.0",
                             "1.0000 z", // the equation, in the frame of the file
                             "10.0000 = 0"})
      EXPECT_NE (text.find (part), std::string::npos) << part << " in " << text;
  }
}
