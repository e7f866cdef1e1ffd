#include "source_path.hpp"

namespace weft {

std::string source_path(const std::string& relative) { return WEFT_SOURCE_DIR "/" + relative; }

}  // namespace weft
