// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <picture/colors.h>
#include <view/found_planes.h>

using namespace pcl_ops;
using namespace pcl_ops::apps;

namespace {

/** \brief The state after some keys, all of which must change it. */
ViewState
afterKeys (const std::string& keys, ViewState state = {})
{
  for (const char key : keys)
    EXPECT_TRUE (pressKey (key, state)) << key;
  return state;
}

/** \brief Two planes of a point each, the first horizontal, and a point on none. */
FoundPlanes
twoPlanes ()
{
  FoundPlanes found;
  found.detected.planes.resize (2);
  found.detected.planes[0].orientation = Orientation::Horizontal;
  found.extents.resize (2);
  found.extents[0].area = 1.5;
  found.labels = {1, 2, 0};
  return found;
}

} // namespace

TEST (ViewState, KeysSwitchOneWayAndBack)
{
  EXPECT_EQ (afterKeys ("2").coloring, "orientations");
  EXPECT_EQ (afterKeys ("3").coloring, "input");
  EXPECT_EQ (afterKeys ("31").coloring, "planes");
  EXPECT_EQ (afterKeys ("p").preset, "paper");
  EXPECT_EQ (afterKeys ("pp").preset, "default");
  EXPECT_EQ (afterKeys ("m").method, "fspf");
  EXPECT_EQ (afterKeys ("mmm").method, "ops");
  for (const auto& [key, value] :
       std::initializer_list<std::pair<const char*, bool ViewState::*>>{
           {"l", &ViewState::hulls},
           {"e", &ViewState::edges},
           {"n", &ViewState::normals},
           {"b", &ViewState::merging},
           {"h", &ViewState::help}}) {
    EXPECT_NE (afterKeys (key).*value, ViewState().*value) << key;
    EXPECT_EQ (afterKeys (std::string (key) + key).*value, ViewState().*value) << key;
  }
  ViewState state;
  for (const char key : {'r', 'o', 'q', '+', '-', 'x'})
    EXPECT_FALSE (pressKey (key, state)) << key << " is a key of the camera or none";
}

TEST (ViewState, OnlyOtherPlanesEndASelection)
{
  ViewState state;
  state.selected = 2;
  EXPECT_EQ (afterKeys ("2ln", state).selected, 2u);
  for (const char* key : {"m", "p", "b"})
    EXPECT_EQ (afterKeys (key, state).selected, 0u) << key;
}

TEST (FoundPlanes, AreThoseOfEveryMethodBeforeAndAfterMerging)
{
  const auto table = pcl::make_shared<XyzCloud>();
  for (int x = 0; x <= 100; ++x)
    for (int y = 0; y <= 100; ++y)
      table->emplace_back (
          0.02f * static_cast<float> (x), 0.02f * static_cast<float> (y), 0.0f);
  table->emplace_back (1.0f, 1.0f, 0.5f);
  for (const char* keys : {"", "m", "mm", "b", "bm", "bmm"}) {
    const FoundPlanes found = findPlanes (afterKeys (keys), {}, table);
    ASSERT_EQ (found.extents.size(), 1u) << keys;
    EXPECT_NEAR (found.extents[0].area, 4.0, 0.3) << keys;
    EXPECT_EQ (found.labels.front(), 1u) << keys;
    EXPECT_EQ (found.labels.back(), 0u) << keys;
  }
}

TEST (FoundPlanes, ColorTheirPoints)
{
  const std::vector<pcl::RGB> input = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  const auto colorsAfter = [&] (const char* keys, std::uint32_t selected = 0) {
    ViewState state = afterKeys (keys);
    state.selected = selected;
    return colorsOfPoints (twoPlanes(), state, input);
  };
  EXPECT_EQ (colorsAfter ("")[0].rgba, colorOfLabel (1).rgba);
  EXPECT_EQ (colorsAfter ("")[2].rgba, colorOfLabel (0).rgba);
  EXPECT_EQ (colorsAfter ("3")[1].rgba, input[1].rgba);
  EXPECT_EQ (colorsAfter ("2")[0].rgba, colorOf (Orientation::Horizontal).rgba);
  EXPECT_NE (colorsAfter ("", 2)[0].rgba, colorOfLabel (1).rgba);
  EXPECT_EQ (colorsAfter ("", 2)[1].rgba, colorOfLabel (2).rgba);
}

TEST (FoundPlanes, AreDescribedInTheFrameOfTheFile)
{
  FoundPlanes found = twoPlanes();
  found.detected.up_note = "Up axis: the planes cannot tell";
  ViewState state;
  state.selected = 1;
  const std::string text = statusText ("folder/room.pcd", found, state, {0, 0, 10});
  for (const char* part : {"say which plane this is",
                           "\nroom.pcd, 3 points",
                           "2 planes\n",
                           "cannot tell",
                           "plane 1: horizontal, 0 points, area 1.500",
                           "+1.0000 z -10.0000 = 0"})
    EXPECT_NE (text.find (part), std::string::npos) << part << " in " << text;
}
