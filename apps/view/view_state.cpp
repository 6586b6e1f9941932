// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "view_state.h"

#include <detection/methods.h>

#include <algorithm>
#include <vector>

namespace pcl_ops::apps {

namespace {

struct Key {
  std::string name;
  std::string help;
  /** \brief Null for keys that change the camera, or that PCLVisualizer handles. */
  void (*press) (ViewState&);
};

void
takeNextMethod (ViewState& state)
{
  const std::vector<Method>& methods = allMethods();
  auto method = std::find_if (methods.begin(), methods.end(), [&] (const Method& m) {
    return m.name == state.method;
  });
  state.method = (++method == methods.end() ? methods.front() : *method).name;
}

const std::vector<Key>&
allKeys ()
{
  static const std::vector<Key> keys = {
      {"1", "color by plane", [] (ViewState& s) { s.coloring = Coloring::Planes; }},
      {"2",
       "color by orientation: horizontal green, vertical blue, other orange",
       [] (ViewState& s) { s.coloring = Coloring::Orientations; }},
      {"3", "colors of the input", [] (ViewState& s) { s.coloring = Coloring::Input; }},
      {"b", "before or after merging", [] (ViewState& s) { s.merging = !s.merging; }},
      {"m", "next method: OPS, FSPF, 3D-KHT", takeNextMethod},
      {"p",
       "preset: default or paper",
       [] (ViewState& s) { s.preset = s.preset == "paper" ? "default" : "paper"; }},
      {"l", "outlines on or off", [] (ViewState& s) { s.hulls = !s.hulls; }},
      {"e",
       "edges where planes meet on or off",
       [] (ViewState& s) { s.edges = !s.edges; }},
      {"n", "normals on or off", [] (ViewState& s) { s.normals = !s.normals; }},
      {"h", "this list on or off", [] (ViewState& s) { s.help = !s.help; }},
      {reset_key, "view as at the start", nullptr},
      {"+", "larger points", nullptr},
      {"-", "smaller points", nullptr},
      {"o", "perspective or parallel projection", nullptr},
      {"q", "quit", nullptr}};
  return keys;
}

} // namespace

std::string
keysText ()
{
  std::string text;
  for (const Key& key : allKeys())
    text += key.name + "  " + key.help + "\n";
  return text + "click  say which plane this is";
}

bool
pressKey (const std::string& key, ViewState& state)
{
  for (const Key& own : allKeys()) {
    if (own.name != key || own.press == nullptr)
      continue;
    const ViewState before = state;
    own.press (state);
    if (!state.hasSamePlanes (before))
      state.selected = 0;
    return true;
  }
  return false;
}

} // namespace pcl_ops::apps
