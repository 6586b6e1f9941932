// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/cloud_file.h>
#include <io/output_file.h>
#include <support/program_folder.h>

#include <cmath>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

/** A row of a table: a command (empty: that of the row above), where to look after it,
 * and what has to be there. */
struct Answer {
  std::string command, where, expected;
};

/** A section of a table: a heading and its rows. Their commands run in one folder. */
struct Answers {
  std::string heading;
  std::vector<Answer> rows;

  friend std::ostream&
  operator<< (std::ostream& stream, const Answers& answers)
  {
    return stream << answers.heading;
  }
};

/** Reads a table in the format that segment/answers.tsv describes. Without it there
 * would be no tests. \throws std::runtime_error if the file cannot be read */
inline std::vector<Answers>
answersIn (const std::string& file)
{
  std::ifstream stream (file);
  if (!stream)
    throw std::runtime_error (file + ": cannot be read");
  std::vector<Answers> all;
  for (std::string line; std::getline (stream, line);) {
    if (line.substr (0, 3) == "## ")
      all.push_back ({line.substr (3), {}});
    else if (!line.empty() && line[0] != '#') {
      std::istringstream columns (line);
      Answer& row = all.back().rows.emplace_back();
      for (std::string* column : {&row.command, &row.where, &row.expected})
        std::getline (columns, *column, '\t');
    }
  }
  return all;
}

/** The heading of a section as the name of its test: one underscore in place of
 * successive characters that are no letters or digits. */
inline std::string
nameOfAnswers (const testing::TestParamInfo<Answers>& info)
{
  return std::regex_replace (info.param.heading, std::regex ("[^A-Za-z0-9]+"), "_");
}

/** A cloud in JSON: "width"; "origin" of its sensor; for each field its type, such as
 * F4, in "types", and a list of its values by its name. Values that are not finite
 * become null; values of a 4-byte field rgb become [red, green, blue]. */
inline nlohmann::json
toJson (const pcl_ops::apps::FileCloud& cloud)
{
  nlohmann::json json = {
      {"width", cloud.points.width},
      {"origin", {cloud.origin[0], cloud.origin[1], cloud.origin[2]}}};
  for (const pcl::PCLPointField& field : cloud.points.fields) {
    const pcl_ops::apps::NumberType& type = pcl_ops::apps::numberType (field.datatype);
    json["types"][field.name] = type.kind + std::to_string (type.size);
    nlohmann::json& values = json[field.name] = nlohmann::json::array();
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const std::uint8_t* const bytes =
          &cloud.points.data[i * cloud.points.point_step + field.offset];
      const double value = type.read (bytes);
      if (field.name == "rgb" && type.size == 4)
        values.push_back ({bytes[2], bytes[1], bytes[0]});
      else
        values.push_back (std::isfinite (value) ? nlohmann::json (value) : nullptr);
    }
  }
  return json;
}

/** Runs the commands of a table, each section in a folder of its own. */
class AnswersFolder : public ProgramFolder,
                      public testing::WithParamInterface<Answers> {
protected:
  using ProgramFolder::ProgramFolder;
  using Json = nlohmann::json;

  /** Whether two JSON values are equal; numbers may differ by less than a tolerance. */
  static bool
  isNear (const Json& value, const Json& expected, double tolerance)
  {
    if (value.is_number() && expected.is_number())
      return std::abs (value.get<double>() - expected.get<double>()) < tolerance;
    if (!value.is_structured() || value.type() != expected.type() ||
        value.size() != expected.size())
      return value == expected;
    for (const auto& item : value.items()) { // the keys of a list are its positions
      const Json::json_pointer position ("/" + item.key());
      if (!expected.contains (position) ||
          !isNear (item.value(), expected[position], tolerance))
        return false;
    }
    return true;
  }

  /** The text of an output of the last command.
   * \param[in] where out or nothing: standard output; err: standard error; else the
   * name of a file */
  std::string
  textAt (const std::string& where) const
  {
    if (where.empty() || where == "out")
      return last_outcome_.out;
    if (where == "err")
      return last_outcome_.err;
    EXPECT_TRUE (std::filesystem::exists (folder_ / where)) << "no such file";
    return contentOf (folder_ / where);
  }

  /** A JSON value in an output of the last command.
   * \param[in] where TEXT#POINTER with TEXT as for \ref textAt; a cloud is read by \ref
   * toJson. Behind it may be .FIRST-LAST, for the set of these entries of a list, and
   * then .size, for the number of entries.
   * \return a discarded value if the JSON has no such value; fails if \p where has
   * another form, or there is no JSON or no such entry of the list */
  Json
  valueAt (const std::string& where) const
  {
    const Json no_value (Json::value_t::discarded);
    const std::regex form (R"(([^#]*)#([^.]*)(\.(\d+)-(\d+))?(\.size)?)");
    std::smatch parts;
    if (!std::regex_match (where, parts, form)) {
      ADD_FAILURE() << where << ": is no TEXT#POINTER";
      return no_value;
    }
    const std::string file = parts[1];
    const bool is_range = parts[3].matched, is_size = parts[6].matched;
    const Json json = pcl_ops::apps::hasCloudExtension (file)
                          ? toJson (pcl_ops::apps::loadCloud (folder_ / file))
                          : Json::parse (textAt (file), nullptr, false);
    EXPECT_FALSE (json.is_discarded()) << where << ": is no JSON";
    const Json::json_pointer pointer (parts[2]);
    Json value = json.contains (pointer) ? json[pointer] : no_value;
    if (is_range) {
      const long first = std::stol (parts[4]), last = std::stol (parts[5]);
      if (!value.is_array() || first > last || last >= long (value.size())) {
        ADD_FAILURE() << where << ": are no entries of a list";
        return no_value;
      }
      value = std::set<Json> (value.begin() + first, value.begin() + last + 1);
    }
    // A discarded value would have the size 1.
    return is_size && !value.is_discarded() ? Json (value.size()) : value;
  }

  /** Fails unless a value is as expected.
   * \param[in] expected absent, =WHERE (the value there, \ref valueAt), >NUMBER,
   * <NUMBER, a value within 0.001, or VALUE +- TOLERANCE */
  void
  expectValue (const Json& value, const std::string& expected) const
  {
    constexpr double usual_tolerance = 1e-3;
    if (expected == "absent")
      EXPECT_TRUE (value.is_discarded()) << value;
    else if (expected[0] == '=')
      EXPECT_TRUE (!value.is_discarded() && value == valueAt (expected.substr (1)))
          << "is another value";
    else if (expected[0] == '>')
      EXPECT_GT (value.get<double>(), std::stod (expected.substr (1)));
    else if (expected[0] == '<')
      EXPECT_LT (value.get<double>(), std::stod (expected.substr (1)));
    else {
      const std::size_t end = expected.find (" +- ");
      const double tolerance = end == std::string::npos
                                   ? usual_tolerance
                                   : std::stod (expected.substr (end + 4));
      EXPECT_TRUE (isNear (value, Json::parse (expected.substr (0, end)), tolerance))
          << value << " is not " << expected;
    }
  }

  /** Fails unless a text is as expected.
   * \param[in] where as for \ref textAt; with ! in front it must not be as expected
   * \param[in] expected a part of the text, with the escapes of JSON; =TEXT: all of it;
   * ^TEXT: its begin, and err must be one line */
  void
  expectText (const std::string& where, const std::string& expected) const
  {
    const bool is_absent = where[0] == '!';
    const bool is_all = expected[0] == '=', is_begin = expected[0] == '^';
    const std::string text = textAt (where.substr (is_absent));
    const std::string part =
        Json::parse ('"' + expected.substr (is_all || is_begin) + '"')
            .get<std::string>();
    const bool is_as_expected =
        is_all     ? text == part
        : is_begin ? text.rfind (part, 0) == 0 && (where != "err" || lines (text) == 1)
                   : text.find (part) != std::string::npos;
    EXPECT_NE (is_as_expected, is_absent)
        << "expected: " << expected << "\nthe text: " << text;
  }

  /** Runs the commands of the section and checks their outputs. A command is run once
   * for successive rows, but again with --planes - where Answer::where begins with #.
   * Its exit code has to be 0, or that of "exit N" in its first row.
   * \param[in] conditions for the beginning of a heading whether such sections are run,
   * not skipped */
  void
  expectAnswers (const std::map<std::string, bool>& conditions = {})
  {
    for (const auto& [condition, is_met] : conditions)
      if (!is_met && GetParam().heading.rfind (condition, 0) == 0)
        GTEST_SKIP() << condition;
    std::string command, last_line;
    for (const Answer& row : GetParam().rows) {
      const auto& [new_command, where, expected] = row;
      if (!new_command.empty())
        command = new_command;
      const std::string line = command + (where[0] == '#' ? " --planes -" : "");
      SCOPED_TRACE (line + ": " + where);
      const bool fails = where.substr (0, 5) == "exit ";
      if (!new_command.empty() || line != last_line) {
        last_outcome_ = shell (line);
        EXPECT_EQ (last_outcome_.exit_code, fails ? std::stoi (where.substr (5)) : 0)
            << last_outcome_.err;
      }
      last_line = line;
      if (where.find ('#') != std::string::npos)
        expectValue (valueAt (where), expected);
      else if (!where.empty())
        expectText (fails ? "err" : where, expected);
    }
  }

private:
  Outcome last_outcome_{};
};
