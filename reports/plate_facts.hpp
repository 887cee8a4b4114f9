#pragma once
/// What is said of a scheme in the gallery.

#include "facts/fact.hpp"
#include "gallery.hpp"

namespace subcert::reports {

/// What follows from the mask, shortened where it is too long for people, and what is proved; what is not known of this
/// scheme is left out, in JSON it is null.
facts::Facts plate_facts(const Plate& plate);

}  // namespace subcert::reports
