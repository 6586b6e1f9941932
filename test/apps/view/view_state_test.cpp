// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <detection/methods.h>
#include <view/view_state.h>

#include <set>
#include <string>

using namespace pcl_ops::apps;

namespace {

/** \brief The state after some keys, all of which must be keys of the viewer. */
ViewState
afterKeys (ViewState state, const std::string& keys)
{
  for (const char key : keys)
    state = afterKey (state, std::string (1, key)).value();
  return state;
}

} // namespace

TEST (ViewState, EveryListedKeyButThoseOfPclChangesIt)
{
  const std::set<std::string> by_pcl = {reset_key, "o", "q"};
  for (const Key& key : allKeys())
    EXPECT_EQ (afterKey ({}, key.name).has_value(), by_pcl.count (key.name) == 0)
        << key.name;
}

TEST (ViewState, NoKeyIsListedTwice)
{
  std::set<std::string> names;
  for (const Key& key : allKeys())
    EXPECT_TRUE (names.insert (key.name).second) << key.name;
}

TEST (ViewState, KeysChooseColours)
{
  EXPECT_EQ (afterKeys ({}, "2").coloring, Coloring::Orientations);
  EXPECT_EQ (afterKeys ({}, "3").coloring, Coloring::Input);
  EXPECT_EQ (afterKeys ({}, "31").coloring, Coloring::Planes);
}

TEST (ViewState, KeysSwitchOnAndOff)
{
  EXPECT_TRUE (afterKeys ({}, "l").hulls);
  EXPECT_FALSE (afterKeys ({}, "ll").hulls);
  EXPECT_TRUE (afterKeys ({}, "e").edges);
  EXPECT_FALSE (afterKeys ({}, "ee").edges);
  EXPECT_TRUE (afterKeys ({}, "n").normals);
  EXPECT_FALSE (afterKeys ({}, "nn").normals);
  EXPECT_FALSE (afterKeys ({}, "h").help);
  EXPECT_FALSE (afterKeys ({}, "b").run.merging);
  EXPECT_TRUE (afterKeys ({}, "bb").run.merging);
  EXPECT_EQ (afterKeys ({}, "p").run.preset, "paper");
  EXPECT_EQ (afterKeys ({}, "pp").run.preset, "default");
}

TEST (ViewState, PointsGrowAndShrinkButNeverVanish)
{
  const ViewState state;
  EXPECT_GT (afterKeys (state, "+").point_size, state.point_size);
  EXPECT_EQ (afterKeys (state, "+-").point_size, state.point_size);
  EXPECT_EQ (afterKeys (state, std::string (50, '-')).point_size, 1);
}

TEST (ViewState, MethodsComeRoundToTheFirst)
{
  ViewState state;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < allMethods().size(); ++i) {
    seen.insert (state.run.method);
    state = afterKeys (state, "m");
  }
  EXPECT_EQ (seen.size(), allMethods().size());
  EXPECT_EQ (state.run.method, ViewState().run.method);
}

TEST (ViewState, ASelectionOutlivesColoursButNotAnotherRun)
{
  ViewState state;
  state.selected = 2;
  EXPECT_EQ (afterKeys (state, "2ln").selected, 2u);
  for (const char* key : {"m", "p", "b"})
    EXPECT_EQ (afterKeys (state, key).selected, 0u) << key;
}
