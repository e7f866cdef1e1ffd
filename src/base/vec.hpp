// The vectors of the public interface are those of the engine.
#pragma once

#include "weft/vec.hpp"
