// Products that attain the joint spectral radius: section 4.10 of ../certificates/SPEC.md.
#pragma once

#include "polytope.hpp"

namespace subcert_check {

/// The number |z|^(1/length), z the only zero of a polynomial within a distance of re + i im.
struct ExactRadius {
  Vector polynomial;  // from the constant coefficient on
  mpq_class re, im, within;
  std::size_t length = 1;
  // What the line `root` says: a zero lies within `error` of near_re + i near_im, and low <= |z|^(1/length) <= high.
  mpq_class near_re, near_im, error, low, high;
};

/// |[p0,p1,...]@RE,IM,EPS|^1/L
ExactRadius parse_exact_radius(std::string_view text);

/// Reads the line `root` and shows that it is right, and that there is only one such zero.
void read_root(ExactRadius& radius, Reader& reader, Arithmetic& arithmetic);

/// Reads the lines from `cycle` on after those of the polytope, and shows that the joint spectral radius of its family
/// is this number.
void check_attained(const Polytope& body, const ExactRadius& radius, Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
