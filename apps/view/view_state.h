// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace pcl_ops::apps {

/** \brief What the color of a point shows: its plane, gray for none; the orientation of
 * its plane; or the color in the file, its height where the file has no colors. */
enum class Coloring { Planes, Orientations, Input };

/** \brief Everything the keys and clicks of the viewer change but the camera. */
struct ViewState {
  std::string method = "ops";
  std::string preset = "default";
  /** \brief Off: the planes before they are merged. */
  bool merging = true;
  Coloring coloring = Coloring::Planes;
  bool hulls = false;
  bool edges = false;
  bool normals = false;
  /** \brief Whether the window lists the keys. */
  bool help = true;
  /** \brief The plane that was clicked, counted from 1; 0 for none. */
  std::uint32_t selected = 0;

  bool
  hasSamePlanes (const ViewState& other) const
  {
    return method == other.method && preset == other.preset && merging == other.merging;
  }
};

/** \brief Shows the cloud as at the start; it changes no state. */
inline constexpr const char* reset_key = "r";

/** \brief The keys of the viewer, one a line, for the window and --help. */
std::string
keysText ();

/** \brief Changes a state as a key asks for. Other planes are shown without a selected
 * one.
 * \return false if the key changes no state */
bool
pressKey (const std::string& key, ViewState& state);

} // namespace pcl_ops::apps
