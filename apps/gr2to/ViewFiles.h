#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gr2to/io/CapturedViews.h"
#include "gr2to/pipeline/Gr2To.h"

namespace gr2to::cli
{
/** Gives each place of the map the views that were taken inside it, named `views/PLACE_NUMBER.ENDING`.
 * \return the files, by those names; a view outside of all places is left out
 */
std::vector<std::pair<std::string, std::string>> addViews(Extraction& extraction,
                                                          std::vector<CapturedView> views);
}  // namespace gr2to::cli
