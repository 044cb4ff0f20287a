// The measures of a MusicXML part, in the order in which they are played: repeats written out.
#pragma once

#include <cstddef>
#include <pugixml.hpp>
#include <vector>

namespace percussionist::files {

/// Indices of the part's <measure> elements in playing order. A repeat is played as often as it
/// says (twice), an ending in the passes it names. Never more than `most` measures.
std::vector<std::size_t> playing_order(const std::vector<pugi::xml_node>& measures,
                                       std::size_t most);

}  // namespace percussionist::files
