// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/help_page.h>

using namespace pcl_ops::apps;

TEST (HelpPage, BreaksLongMeaningsBetweenWords)
{
  EXPECT_EQ (listed ({{"A", "one two three"}, {"LONG", "four"}}, 16),
             "  A      one two\n"
             "         three\n"
             "  LONG   four\n");
}
