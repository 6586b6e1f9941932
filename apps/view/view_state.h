// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief What the colour of a point tells. */
enum class Coloring {
  /** \brief Its plane; grey for none. */
  Planes,
  /** \brief Whether its plane is horizontal, vertical or neither. */
  Orientations,
  /** \brief What the file says, or its height where the file has no colours. */
  Input
};

/** \brief Which run of a detector is shown. */
struct DetectionRun {
  std::string method = "ops";
  std::string preset = "default";
  /** \brief Off: the planes before the merging process. */
  bool merging = true;

  bool
  operator== (const DetectionRun& other) const
  {
    return method == other.method && preset == other.preset && merging == other.merging;
  }
};

/** \brief Everything the keys and clicks of the viewer change but the camera. */
struct ViewState {
  DetectionRun run;
  Coloring coloring = Coloring::Planes;
  bool hulls = false;
  /** \brief Whether edges and corners are drawn. */
  bool edges = false;
  bool normals = false;
  /** \brief Edge of the square that a point is drawn as [pixel]. */
  int point_size = 2;
  /** \brief Whether the window lists the keys. */
  bool help = true;
  /** \brief The plane that was clicked, counted from 1; 0 for none. */
  std::uint32_t selected = 0;
};

/** \brief A key of the viewer. */
struct Key {
  /** \brief The character. */
  std::string name;
  std::string help;
};

/** \brief The keys of the viewer, in the order they are listed. */
std::vector<Key>
allKeys ();

/** \brief The state after a key, or nothing if the key means nothing to it. Another run
 * starts without a selected plane. */
std::optional<ViewState>
afterKey (const ViewState& state, const std::string& key);

/** \brief The key that shows the cloud as at the start. It changes no state. */
inline constexpr const char* reset_key = "r";

} // namespace pcl_ops::apps
