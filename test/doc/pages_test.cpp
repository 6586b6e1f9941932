// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

const fs::path source_dir = PCL_OPS_SOURCE_DIR;

/** \brief README.md and the pages of the documentation. */
std::vector<fs::path>
pages ()
{
  std::vector<fs::path> files = {source_dir / "README.md"};
  for (const auto& entry : fs::directory_iterator (source_dir / "src" / "doc"))
    if (entry.path().extension() == ".md")
      files.push_back (entry.path());
  return files;
}

Lines
linesOf (const fs::path& file)
{
  Lines lines;
  std::ifstream stream (file);
  for (std::string line; std::getline (stream, line);)
    lines.push_back (line);
  return lines;
}

/** \brief The lines of a page that stand in fences of this language. */
Lines
codeOf (const fs::path& page, const std::string& language)
{
  Lines code;
  std::string fence;
  for (const std::string& line : linesOf (page)) {
    if (line.rfind ("```", 0) == 0)
      fence = fence.empty() ? line : "";
    else if (fence == "```" + language)
      code.push_back (line);
  }
  return code;
}

/** \brief Whether a page has the heading that a link names: in small letters, without
 * punctuation, blanks as hyphens. */
bool
hasSection (const fs::path& page, const std::string& section)
{
  const Lines lines = linesOf (page);
  return std::any_of (lines.begin(), lines.end(), [&] (const std::string& line) {
    std::string name;
    for (const char c : line.substr (std::min (line.size(), line.find (' ') + 1)))
      if (std::isalnum (static_cast<unsigned char> (c)) || c == ' ' || c == '-')
        name += c == ' ' ? '-' : static_cast<char> (std::tolower (c));
    return line.rfind ("#", 0) == 0 && name == section;
  });
}

/** \brief Options that keep a simulation short. */
std::string
smallerScene (const std::string& command)
{
  for (const char* sized : {"--points", "--scene street", "--scene drive"})
    if (command.find (sized) != std::string::npos)
      return "";
  if (command.find ("--scene walk") != std::string::npos)
    return " --frames 5 --width 80 --height 60";
  return command.find ("--scene") != std::string::npos ? " --points 5000"
                                                       : " --width 160 --height 120";
}

/** \brief The commands of a page that need no display, no data of others and no
 * minutes; rooms are made small. */
Lines
commandsOf (const fs::path& page)
{
  Lines commands;
  for (const std::string& line : codeOf (page, "sh")) {
    const auto startsWith = [&] (const char* text) {
      return line.rfind (text, 0) == 0;
    };
    if (startsWith ("pcl_ops_simulate "))
      commands.push_back (line + smallerScene (line));
    else if (startsWith ("pcl_ops_segment ") || startsWith ("cat room.pcd | ") ||
             startsWith ("pcl_ops_evaluate compare ") ||
             startsWith ("pcl_ops_evaluate planes ") ||
             startsWith ("pcl_ops_evaluate track ") || startsWith ("pcl_ops_tiles ") ||
             startsWith ("printf "))
      commands.push_back (line);
  }
  return commands;
}

/** \brief Runs a command in a folder as a user's shell does; where it does not succeed
 * the test fails with all it said. */
void
run (const std::string& command, const fs::path& folder)
{
  const std::string shell = "cd '" + folder.string() + "' && PATH='" +
                            PCL_OPS_PROGRAMS_DIR "':$PATH && { " + command +
                            "\n} >said 2>&1";
  if (std::system (shell.c_str()) == 0)
    return;
  std::string said;
  for (const std::string& line : linesOf (folder / "said"))
    said += line + "\n";
  ADD_FAILURE() << command << "\n" << said;
}

/** \brief The clouds the pages speak of: room.pcd and a folder of scans. */
void
makeClouds (const fs::path& folder)
{
  fs::remove_all (folder);
  fs::create_directories (folder / "scans");
  const std::string size = " --seed 1 --width 160 --height 120";
  run ("pcl_ops_simulate room.pcd" + size, folder);
  run ("pcl_ops_simulate scans/first.pcd" + size, folder);
  run ("pcl_ops_simulate scans/second.pcd" + size, folder);
}

} // namespace

TEST (Pages, CommandsRun)
{
  const fs::path folder = fs::canonical (testing::TempDir()) /
                          ("pcl_ops_pages_" + std::to_string (::getpid()));
  for (const fs::path& page : pages()) {
    SCOPED_TRACE (page.filename());
    const Lines commands = commandsOf (page);
    if (!commands.empty())
      makeClouds (folder);
    for (const std::string& command : commands)
      run (command, folder);
  }
  fs::remove_all (folder);
}

TEST (Pages, LinksLeadToFilesAndSections)
{
  const std::regex link (R"(\]\(([^)#:]+)(#([^)]+))?\))");
  for (const fs::path& page : pages())
    for (const std::string& line : linesOf (page))
      for (std::sregex_iterator found (line.begin(), line.end(), link), end;
           found != end;
           ++found) {
        const fs::path target = page.parent_path() / found->str (1);
        EXPECT_TRUE (fs::exists (target))
            << page.filename() << " links to " << found->str (1);
        const std::string section = found->str (3);
        EXPECT_TRUE (section.empty() || hasSection (target, section))
            << page.filename() << " links to " << found->str (1) << "#" << section;
      }
}

TEST (Pages, MainPageAndReadmeLinkToAll)
{
  for (const char* start : {"README.md", "src/doc/main.md"}) {
    std::string text;
    for (const std::string& line : linesOf (source_dir / start))
      text += line;
    for (const fs::path& page : pages()) {
      const bool is_start =
          page.filename() == "README.md" || page.filename() == "main.md";
      if (!is_start) {
        EXPECT_NE (text.find (page.filename().string() + ")"), std::string::npos)
            << start << " has no link to " << page.filename();
      }
    }
  }
}

TEST (Readme, DropInLinesAreThoseOfTheFirstExample)
{
  std::string example;
  for (const std::string& line :
       linesOf (source_dir / "apps/examples/01_minimal/minimal.cpp"))
    example += line + "\n";
  const Lines lines = codeOf (source_dir / "README.md", "cpp");
  EXPECT_GE (lines.size(), 4u);
  for (std::string line : lines) {
    // The example asks whether the call succeeded, the README says what it gives.
    line = line.substr (0, line.find (';'));
    EXPECT_NE (example.find (line), std::string::npos) << line;
  }
}

TEST (Readme, IsAFrontDoor)
{
  EXPECT_LE (linesOf (source_dir / "README.md").size(), 220u);
}
