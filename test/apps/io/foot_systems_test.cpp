// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/foot_systems.h>

using pcl_ops::apps::isInFeet;

TEST (FootSystems, AreStatePlanesInUsSurveyOrInternationalFeet)
{
  EXPECT_TRUE (isInFeet (2230)) << "California zone 6";
  EXPECT_TRUE (isInFeet (2263)) << "New York, Long Island";
  EXPECT_TRUE (isInFeet (2881)) << "Florida East, HARN";
  EXPECT_TRUE (isInFeet (3435)) << "Illinois East";
  EXPECT_TRUE (isInFeet (6539)) << "New York, Long Island, 2011";
  EXPECT_TRUE (isInFeet (2994)) << "Oregon Lambert, in international feet";
  EXPECT_TRUE (isInFeet (32667)) << "the last number";
}

TEST (FootSystems, AreNoSystemsInOtherUnits)
{
  EXPECT_FALSE (isInFeet (25832)) << "UTM zone 32";
  EXPECT_FALSE (isInFeet (32633)) << "UTM zone 33";
  EXPECT_FALSE (isInFeet (2154)) << "Lambert-93, one before a system in feet";
  EXPECT_FALSE (isInFeet (27700)) << "British National Grid";
  EXPECT_FALSE (isInFeet (26910)) << "UTM zone 10";
  EXPECT_FALSE (isInFeet (6538)) << "6539 in meters";
  EXPECT_FALSE (isInFeet (2993)) << "2994 in meters";
  EXPECT_FALSE (isInFeet (2136)) << "Ghana National Grid, in Gold Coast feet";
  for (const unsigned compound : {6172, 6190, 6871})
    EXPECT_FALSE (isInFeet (compound)) << "x and y in meters, with heights";
  EXPECT_FALSE (isInFeet (0));
  EXPECT_FALSE (isInFeet (32767)) << "a system of the user's own";
}
