// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/text.h>

using pcl_ops::apps::oneLine;
using pcl_ops::apps::validUtf8;

TEST (Text, OfUtf8StaysAsItIs)
{
  for (const char* text : {"", "a", "caf\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x98\x80"})
    EXPECT_EQ (validUtf8 (text), text);
}

TEST (Text, HasAMarkForEachByteThatIsNoUtf8)
{
  const std::string mark = "\xef\xbf\xbd";
  EXPECT_EQ (validUtf8 ("caf\xe9.pcd"), "caf" + mark + ".pcd") << "Latin-1";
  EXPECT_EQ (validUtf8 ("a\xe2\x82"), "a" + mark + mark) << "cut";
  EXPECT_EQ (validUtf8 ("\xc0\xaf"), mark + mark) << "longer than it has to be";
  EXPECT_EQ (validUtf8 ("\xed\xa0\x80"), mark + mark + mark) << "half of a pair";
  EXPECT_EQ (validUtf8 ("\xf5\x80"), mark + mark) << "beyond all characters";
}

TEST (Text, IsOneLine) { EXPECT_EQ (oneLine ("a\nb\r\nc"), "a b  c"); }
