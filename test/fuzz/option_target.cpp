// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_targets.h"
#include "scene.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <detection/methods.h>

#include <iostream>
#include <sstream>

namespace pcl_ops::fuzz {

namespace {

/** Takes away what --help prints. */
class SilentOutput {
public:
  SilentOutput() : before_ (std::cout.rdbuf (nothing_.rdbuf())) {}
  SilentOutput (const SilentOutput&) = delete;
  SilentOutput&
  operator= (const SilentOutput&) = delete;
  ~SilentOutput() { std::cout.rdbuf (before_); }

private:
  std::ostringstream nothing_;
  std::streambuf* before_;
};

std::vector<std::string>
linesOf (const Bytes& bytes)
{
  std::istringstream text (std::string (bytes.begin(), bytes.end()));
  std::vector<std::string> lines;
  for (std::string line; std::getline (text, line, '\n');)
    lines.push_back (line.substr (0, line.find ('\0')));
  return lines;
}

apps::XyzCloud::ConstPtr
smallCorner ()
{
  static const apps::XyzCloud::ConstPtr cloud = Scene (1)
                                                    .floor (1_m, 1_m)
                                                    .wall ({0, 0}, {1, 0}, 1_m)
                                                    .spacing (5_cm)
                                                    .build()
                                                    .cloud;
  return cloud;
}

void
detectAsTold (const std::vector<std::string>& arguments)
{
  std::vector<const char*> argv{"pcl_ops_segment"};
  for (const std::string& argument : arguments)
    argv.push_back (argument.c_str());
  apps::CommandLine line ("pcl_ops_segment", "Finds planes", "0");
  std::string method = apps::allMethods().front().name;
  apps::DetectorOptions options;
  apps::declareMethodOptions (line, method, options);
  if (!line.parse (static_cast<int> (argv.size()), argv.data()))
    return;
  const apps::Method& chosen = apps::methodCalled (method);
  apps::checkMethodOptions (line, chosen);
  const apps::Detected found = chosen.detect (options, smallCorner());
  const std::vector<std::uint32_t> labels =
      apps::labelsOf (found.planes, smallCorner()->size());
  promise (labels.size() == smallCorner()->size(), "every point has a label");
}

} // namespace

void
readOptions (const Bytes& bytes)
{
  const SilentOutput silent;
  try {
    detectAsTold (linesOf (bytes));
  }
  catch (const apps::ProgramError& error) {
    promise (std::string (error.what()).size() > 0, "an error says what is wrong");
  }
}

} // namespace pcl_ops::fuzz
