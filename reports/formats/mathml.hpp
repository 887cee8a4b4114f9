#pragma once
/// Formulas of the pages: MathML Core from the LaTeX text, and the difference of two of them.

#include "latex_math.hpp"

#include <string>
#include <string_view>

namespace subcert::formats {

/// One `<math>`, in a line of text or as a block of its own, with the LaTeX text as its annotation. Domain and errors:
/// those of read_latex().
std::string mathml(std::string_view latex, bool block = false);

/// The formula in display style as a run of `<math>` and words between which a line may break: at \quad and \; and in
/// a \text, unless these stand inside of brackets or arguments, and in front of the signs of a very long sum. Domain
/// and errors: those of read_latex().
std::string formula_html(std::string_view latex);

struct MarkedFormulas {
  std::string printed, corrected;
};

/// Both as formula_html(), with class `changed` on what mark_difference() marks: on the largest elements and runs of
/// elements of which everything has changed. Domain and errors: those of read_latex().
MarkedFormulas marked_difference(std::string_view printed, std::string_view corrected);

/// Marks the leaves of both as `changed` that are not in common. In common is a longest subsequence of leaves,
/// preferably in long runs, or one of each part where the relations and commas between the parts are the same; leaves
/// are equal with the same symbol in the same kind of place: the index of an exponent, the radicand in a numerator and
/// so on. A few equal leaves between more changed ones are marked, too; all are where only their grouping differs.
/// Cost: the product of the numbers of leaves.
void mark_difference(MathNode& printed, MathNode& corrected);

}  // namespace subcert::formats
