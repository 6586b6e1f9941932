// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "text_columns.h"

#include "header_reader.h"
#include <cli/errors.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <set>
#include <string_view>
#include <system_error>

namespace pcl_ops::apps {

namespace {

/** \brief A coordinate, and what surveyors and ParaView call it. */
struct Axis {
  const char* field;
  std::array<const char*, 5> names;
};

constexpr std::array<Axis, 3> axes = {
    {{"x", {"x", "easting", "east", "e", "points:0"}},
     {"y", {"y", "northing", "north", "n", "points:1"}},
     {"z", {"z", "elevation", "height", "h", "points:2"}}}};

bool
isNumber (const std::string& word)
{
  double number = 0.0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars (word.data(), end, number);
  return error != std::errc::invalid_argument && rest == end;
}

/** \brief Also one with letters beyond ASCII. */
bool
isName (const std::string& word)
{
  const auto first = static_cast<unsigned char> (word[0]);
  return (std::isalpha (first) != 0 || first == '_' || first > 127) && !isNumber (word);
}

/** \brief A name in small letters without the unit in brackets behind it. */
std::string
plainName (const std::string& name)
{
  std::string plain = name.substr (0, name.find_first_of ("[("));
  plain.resize (plain.find_last_not_of (" \t_") + 1);
  for (char& c : plain)
    c = static_cast<char> (std::tolower (static_cast<unsigned char> (c)));
  return plain;
}

/** \brief Where an axis is among the names: as the field is called, or else by the
 * first of its other names that there is. */
Words::const_iterator
findAxis (const Words& names, const Axis& axis)
{
  auto found = std::find (names.begin(), names.end(), axis.field);
  for (std::size_t i = 0; i < axis.names.size() && found == names.end(); ++i)
    found = std::find_if (names.begin(), names.end(), [&] (const std::string& name) {
      return plainName (name) == axis.names[i];
    });
  return found;
}

/** \brief A name as headers of clouds can have it: without blanks, and short. */
std::string
fieldName (std::string name)
{
  constexpr std::size_t longest = 100;
  name.resize (std::min (name.size(), longest));
  for (char& c : name)
    c = std::isspace (static_cast<unsigned char> (c)) != 0 ||
                std::iscntrl (static_cast<unsigned char> (c)) != 0
            ? '_'
            : c;
  return name == "_" ? "" : name; // PCD's name of bytes that are nothing
}

} // namespace

char
separatorOf (const std::string& line)
{
  for (const char separator : {';', ','})
    if (line.find (separator) != std::string::npos)
      return separator;
  return ' ';
}

Words
wordsOf (const std::string& line)
{
  std::vector<std::string_view> parts;
  splitWords (line, separatorOf (line), parts);
  Words words;
  for (std::string_view part : parts) {
    constexpr std::string_view quotes = "\"'";
    part.remove_prefix (std::min (part.find_first_not_of (quotes), part.size()));
    words.emplace_back (part.substr (0, part.find_last_not_of (quotes) + 1));
  }
  return words;
}

bool
areNames (const Words& words)
{
  const auto is_empty = [] (const std::string& word) { return word.empty(); };
  return !std::all_of (words.begin(), words.end(), is_empty) &&
         std::all_of (words.begin(), words.end(), [&] (const std::string& word) {
           return is_empty (word) || isName (word);
         });
}

bool
nameCoordinates (const Words& words)
{
  return std::all_of (axes.begin(), axes.end(), [&] (const Axis& axis) {
    return findAxis (words, axis) != words.end();
  });
}

Words
fieldNames (const std::string& file, const Words& names, std::size_t count)
{
  Words fields (count);
  std::set<std::string> taken;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto found = findAxis (names, axes[i]);
    if (!names.empty() && found == names.end())
      throw WorkError (
          file,
          std::string ("has names of columns, but none is ") + axes[i].field +
              "; call the coordinates x, y and z, or remove the line of names");
    fields[names.empty() ? i : std::size_t (found - names.begin())] = axes[i].field;
    taken.insert (axes[i].field);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!fields[i].empty())
      continue;
    std::string name = names.empty() ? "" : fieldName (names[i]);
    if (name.empty() || taken.count (name) > 0)
      name = "field_" + std::to_string (i + 1);
    while (!taken.insert (name).second)
      name += "_";
    fields[i] = name;
  }
  return fields;
}

} // namespace pcl_ops::apps
