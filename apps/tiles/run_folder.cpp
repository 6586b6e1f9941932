// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder.h"

#include <cli/errors.h>
#include <io/output_file.h>

#include <filesystem>
#include <system_error>
#include <utility>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

/** \brief Of what phases leave, in the order of the phases. */
constexpr const char* folders[] = {"cells", "planes", "labelled"};

std::string
nameOf (const TileKey& tile)
{
  return std::to_string (tile.x) + "_" + std::to_string (tile.y);
}

} // namespace

RunFolder::RunFolder (std::string output_dir) : folder_ (std::move (output_dir)) {}

void
RunFolder::make() const
{
  makeFolder (folder_);
  for (const char* folder : folders)
    makeFolder (inWork (folder));
}

std::string
RunFolder::inWork (const std::string& name) const
{
  return (fs::path (folder_) / "work" / name).string();
}

std::string
RunFolder::plan() const
{
  return inWork ("plan.json");
}

std::string
RunFolder::cells (std::size_t input) const
{
  return inWork ("cells/" + std::to_string (input) + ".cells");
}

std::string
RunFolder::planes (const TileKey& tile) const
{
  return inWork ("planes/" + nameOf (tile) + ".planes");
}

std::string
RunFolder::labels (const TileKey& tile) const
{
  return inWork ("planes/" + nameOf (tile) + ".labels");
}

std::string
RunFolder::numbers() const
{
  return inWork ("planes/numbers");
}

std::string
RunFolder::list() const
{
  return inWork ("planes/planes.json");
}

std::string
RunFolder::mark (std::size_t input) const
{
  return inWork ("labelled/" + std::to_string (input));
}

std::string
RunFolder::end() const
{
  return inWork ("done");
}

std::string
RunFolder::output (const std::string& name) const
{
  return (fs::path (folder_) / name).string();
}

void
RunFolder::startAnew() const
{
  std::error_code error;
  fs::remove (end(), error);
  for (const char* folder : folders)
    if (!error)
      fs::remove_all (inWork (folder), error);
  if (error)
    throw WorkError ((fs::path (folder_) / "work").string(),
                     "cannot be emptied (" + error.message() +
                         "); remove it or give another --output-dir");
  make();
}

void
RunFolder::clean() const
{
  std::error_code ignored;
  for (const char* folder : folders)
    fs::remove_all (inWork (folder), ignored);
}

bool
isThere (const std::string& file)
{
  std::error_code error;
  return fs::exists (file, error);
}

} // namespace pcl_ops::apps
