// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <drawing/drawing.h>

using namespace pcl_ops::apps;

namespace {

/** \brief A drawing with one text. */
Drawing
drawingWith (const std::string& text)
{
  Drawing drawing;
  drawing.layers = {{"TEXT", CadColor::Gray, "#404040", 0.18}};
  drawing.texts = {{"TEXT", Eigen::Vector3d::Zero(), text, 0.2}};
  return drawing;
}

bool
contains (const std::string& text, const std::string& part)
{
  return text.find (part) != std::string::npos;
}

} // namespace

TEST (Dxf, HasCharactersBeyondAsciiAsFourDigits)
{
  EXPECT_TRUE (contains (toDxf (drawingWith ("5 m\u00b2")), "\n5 m\\U+00B2\n"));
  EXPECT_TRUE (contains (toDxf (drawingWith ("\u20ac")), "\n\\U+20AC\n"));
}

TEST (Dxf, HasAQuestionMarkForACharacterOfFiveDigits)
{
  EXPECT_TRUE (contains (toDxf (drawingWith ("a\U0001f3e0z")), "\na?z\n"));
}

TEST (Dxf, HasAReplacementForEachByteThatIsNoUtf8)
{
  // The byte 0xff begins no character, 0xc3 one of two bytes, 0xed 0xa0 0x80 would be
  // half of a pair of UTF-16.
  EXPECT_TRUE (contains (toDxf (drawingWith ("a\xffroom")), "\na\\U+FFFDroom\n"));
  EXPECT_TRUE (contains (toDxf (drawingWith ("a\xc3")), "\na\\U+FFFD\n"));
  EXPECT_FALSE (contains (toDxf (drawingWith ("\xed\xa0\x80")), "\\U+D800"));
}

TEST (Dxf, HasBlanksForControlCharacters)
{
  EXPECT_TRUE (contains (toDxf (drawingWith ("a\nb\x7f"
                                             "c")),
                         "\na b c\n"));
}

TEST (Svg, HasOnlyCharactersThatXmlAllows)
{
  // U+FFFF and U+FFFE are not allowed, U+FFFD is.
  const std::string svg = toSvg (drawingWith ("<\xef\xbf\xbf>"), "a\xef\xbf\xbe");
  EXPECT_TRUE (contains (svg, ">&lt;\xef\xbf\xbd&gt;</text>"));
  EXPECT_TRUE (contains (svg, "<title>a\xef\xbf\xbd</title>"));
}
