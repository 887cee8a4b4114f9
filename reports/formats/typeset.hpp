#pragma once
/// Plain words of a page with the letters and signs that people use.

#include <string>

namespace subcert::formats {

/// The HTML with Hoelder, psi, phi, <=, >=, ..., minus signs and powers such as n^2 in its texts as they are printed,
/// spaces that do not part `all n`, and places where lists of numbers may go on in the next line: behind commas. In
/// code only these places; nothing in tags, scripts, styles, formulas, pictures and what a form shows. Domain:
/// well-formed. Cost: linear, but for specifications as long as the text.
std::string typeset(const std::string& html);

}  // namespace subcert::formats
