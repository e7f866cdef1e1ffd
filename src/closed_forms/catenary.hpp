#pragma once

namespace weft {

/// How far the middle of a heavy rope that does not stretch sags below its ends, which are level:
/// a (cosh(span/2a) - 1) with length = 2a sinh(span/2a) [m]. `span` is above 0 and less than `length`.
double catenary_sag(double length, double span);

}  // namespace weft
