// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/text.h>

using pcl_ops::apps::counted;
using pcl_ops::apps::oneLine;
using pcl_ops::apps::validUtf8;

TEST (ValidUtf8, IsTheTextItselfIfThatIsValid)
{
  for (const char* text : {"", "a", "caf\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x98\x80"})
    EXPECT_EQ (validUtf8 (text), text);
}

TEST (ValidUtf8, HasTheReplacementCharacterForEachByteThatIsNotValid)
{
  const std::string mark = "\xef\xbf\xbd"; // U+FFFD in UTF-8
  EXPECT_EQ (validUtf8 ("caf\xe9.pcd"), "caf" + mark + ".pcd") << "Latin-1";
  EXPECT_EQ (validUtf8 ("a\xe2\x82"), "a" + mark + mark)
      << "a character of three bytes without the last";
  EXPECT_EQ (validUtf8 ("\xc0\xaf"), mark + mark) << "two bytes for a character of one";
  EXPECT_EQ (validUtf8 ("\xed\xa0\x80"), mark + mark + mark)
      << "one half of a surrogate pair";
  EXPECT_EQ (validUtf8 ("\xf5\x80"), mark + mark) << "above U+10FFFF";
}

TEST (Counted, HasAnSUnlessTheNumberIsOne)
{
  EXPECT_EQ (counted (0, "plane"), "0 planes");
  EXPECT_EQ (counted (1, "plane"), "1 plane");
  EXPECT_EQ (counted (2, "plane"), "2 planes");
}

TEST (OneLine, HasABlankForEachCharacterOfALineBreak)
{
  EXPECT_EQ (oneLine ("a\nb\r\nc"), "a b  c");
}
