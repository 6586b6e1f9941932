// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "view_state.h"

#include <detection/methods.h>

#include <algorithm>

namespace pcl_ops::apps {

namespace {

struct Binding {
  Key key;
  void (*press) (ViewState&);
};

void
takeNextMethod (ViewState& state)
{
  const std::vector<Method>& methods = allMethods();
  const auto now =
      std::find_if (methods.begin(), methods.end(), [&] (const Method& method) {
        return method.name == state.run.method;
      });
  state.run.method =
      (std::next (now) == methods.end() ? methods.front() : *std::next (now)).name;
}

void
resizePoints (ViewState& state, int step)
{
  constexpr int smallest = 1;
  constexpr int largest = 20;
  state.point_size = std::clamp (state.point_size + step, smallest, largest);
}

const std::vector<Binding>&
bindings ()
{
  static const std::vector<Binding> all_bindings = {
      {{"1", "colour by plane"},
       [] (ViewState& state) { state.coloring = Coloring::Planes; }},
      {{"2", "colour by orientation"},
       [] (ViewState& state) { state.coloring = Coloring::Orientations; }},
      {{"3", "colours of the input"},
       [] (ViewState& state) { state.coloring = Coloring::Input; }},
      {{"b", "before or after merging"},
       [] (ViewState& state) { state.run.merging = !state.run.merging; }},
      {{"m", "next method: OPS, FSPF, 3D-KHT"}, takeNextMethod},
      {{"p", "preset: default or paper"},
       [] (ViewState& state) {
         state.run.preset = state.run.preset == "paper" ? "default" : "paper";
       }},
      {{"l", "outlines on or off"},
       [] (ViewState& state) { state.hulls = !state.hulls; }},
      {{"e", "edges where planes meet on or off"},
       [] (ViewState& state) { state.edges = !state.edges; }},
      {{"n", "normals on or off"},
       [] (ViewState& state) { state.normals = !state.normals; }},
      {{"+", "larger points"}, [] (ViewState& state) { resizePoints (state, 1); }},
      {{"-", "smaller points"}, [] (ViewState& state) { resizePoints (state, -1); }},
      {{"h", "this list on or off"},
       [] (ViewState& state) { state.help = !state.help; }}};
  return all_bindings;
}

} // namespace

std::vector<Key>
allKeys ()
{
  std::vector<Key> keys;
  for (const Binding& binding : bindings())
    keys.push_back (binding.key);
  keys.push_back ({reset_key, "view as at the start"});
  keys.push_back ({"o", "perspective or parallel projection"});
  keys.push_back ({"q", "quit"});
  return keys;
}

std::optional<ViewState>
afterKey (const ViewState& state, const std::string& key)
{
  for (const Binding& binding : bindings()) {
    if (binding.key.name != key)
      continue;
    ViewState next = state;
    binding.press (next);
    if (!(next.run == state.run))
      next.selected = 0;
    return next;
  }
  return std::nullopt;
}

} // namespace pcl_ops::apps
