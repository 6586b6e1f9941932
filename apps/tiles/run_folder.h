// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_grid.h"

#include <cstddef>
#include <string>

namespace pcl_ops::apps {

/** \brief Where the files of a run are, which its phases leave for one another. */
class RunFolder {
public:
  explicit RunFolder (std::string output_dir);

  /** \brief Makes the folders that are missing. \throws WorkError */
  void
  make () const;

  /** \brief Where the plan is that all other files are of. */
  std::string
  plan () const;
  std::string
  cells (std::size_t input) const;
  std::string
  planes (const TileKey& tile) const;
  std::string
  labels (const TileKey& tile) const;
  std::string
  numbers () const;
  /** \brief What planes.json becomes once all else is done. */
  std::string
  list () const;
  /** \brief Says that an input has its labels. */
  std::string
  mark (std::size_t input) const;
  /** \brief Says that all is done. */
  std::string
  end () const;
  std::string
  output (const std::string& name) const;

  /** \brief Removes all but the plan, and makes the folders again. \throws WorkError */
  void
  startAnew () const;

  /** \brief Removes all but the plan and \ref end. */
  void
  clean () const;

private:
  std::string
  inWork (const std::string& name) const;

  std::string folder_;
};

/** \brief Whether a phase has left this file. */
bool
isThere (const std::string& file);

} // namespace pcl_ops::apps
