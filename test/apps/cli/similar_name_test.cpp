// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/similar_name.h>

using pcl_ops::apps::similarName;

TEST (SimilarName, DiffersByALetterInsertedDeletedChangedOrSwapped)
{
  for (const char* mistyped : {"viiew", "vew", "vies", "veiw"})
    EXPECT_EQ (similarName (mistyped, {"up", "view", "seed"}), "view") << mistyped;
}

TEST (SimilarName, IsTheNameWithTheFewestEdits)
{
  EXPECT_EQ (similarName ("min-aera", {"min-areas", "min-area"}), "min-area");
}

TEST (SimilarName, IsEmptyIfNoNameIsSimilar)
{
  EXPECT_EQ (similarName ("color", {"seed", "keep-color"}), "");
  EXPECT_EQ (similarName ("", {"up"}), "");
  EXPECT_EQ (similarName (std::string (100'000, 'x'), {"up"}), "");
}
