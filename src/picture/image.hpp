#pragma once

#include "weft/image.hpp"

namespace weft::picture {

using weft::Image;

}  // namespace weft::picture
