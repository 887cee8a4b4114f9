#pragma once
/// Which data the rules of a scheme read along one axis, and which outputs a step makes there.

#include "boundary.hpp"
#include "grid_data.hpp"

#include <vector>

namespace subcert::data {

/// Outputs are numbered so that f'_i = sum of a_{i - arity*j} f_j with the data of the axis numbered from 0.
struct OutputRange {
  Axis input;  ///< as read: closed for `periodic`
  Axis output;
  long begin;  ///< outputs begin, ..., end - 1
  long end;
  long complete_begin;  ///< from here to complete_end - 1 all stencils lie within the data; empty where not before
                        ///< complete_end
  long complete_end;
};

/// Along one axis the rule of a residue class has the exponents lowest, lowest + arity, ..., highest.
class AxisStencils {
 public:
  struct Class {
    long lowest;
    long highest;
  };

  /// `classes[r]` has exponents congruent to r modulo the arity, which is classes.size(). `centre` is tau, the
  /// derivative of the symbol at 1 over its value, `degree` what the scheme reproduces; each datum has `components`
  /// numbers.
  AxisStencils(std::vector<Class> classes, const Rational& centre, int degree, int components = 1);

  long arity() const { return static_cast<long>(classes_.size()); }
  int degree() const { return degree_; }
  /// The number of data that one rule or fit reads at most, and at least 2.
  std::size_t window() const { return window_; }
  std::size_t residue(long output) const;
  long first_read(long output) const { return (output - classes_[residue(output)].highest) / arity(); }
  long last_read(long output) const { return (output - classes_[residue(output)].lowest) / arity(); }
  /// Where the output stands, in the numbers of the data.
  Rational position(long output) const { return Rational(output - centre_) / arity(); }

  /// Domain: axis.count >= window(); `reflect` asks 2 tau to be an integer. Errors: throws a domain error that
  /// names the inequality.
  OutputRange outputs(const Axis& axis, Boundary boundary) const;

 private:
  std::vector<Class> classes_;
  Rational centre_;
  int degree_;
  std::size_t window_;
};

/// The datum that stands at index j: itself, mirrored (`reflect`), or repeated (closed axes). Domain: 0 <= j < count
/// where the axis is open and the boundary is another.
std::size_t source(long j, const Axis& axis, Boundary boundary);

}  // namespace subcert::data
