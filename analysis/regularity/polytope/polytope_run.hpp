#pragma once

#include "polytope_search.hpp"

#include <optional>

namespace subcert::detail {

/// A product with its leading eigenvectors along the cycle, in working coordinates.
struct RootCycle {
  int product = 0;                      ///< index into the products of the run
  std::vector<Eigen::VectorXcd> right;  ///< right[t] = A_{w_t} ... A_{w_1} right[0] / radius^t
  std::vector<Eigen::VectorXcd> left;   ///< left[t] . right[t] = 1, or empty when the eigenvalue is defective
  std::complex<double> phase;  ///< one turn multiplies right[0] by it (times (radius of the product/scale)^length)
  double size = 1;             ///< balancing factor
};

/// Coordinates x' = to x in which orbits are round and, under flip symmetry, the flip negates the trailing coordinates.
struct Coordinates {
  Eigen::MatrixXd to, from;
  int odd = 0;
};
Coordinates working_coordinates(const SearchFamily& family, PolytopeKind kind);

/// Eigenvector cycles of all products; the kind is complex if one of them needs it.
std::vector<RootCycle> leading_cycles(const std::vector<Eigen::MatrixXd>& matrices,
                                      const std::vector<Candidate>& products, double tolerance);

/// One growing polytope. It may be advanced in slices.
class PolytopeRun {
 public:
  enum class State { open, closed };

  /// Images are divided by scale >= radius of the first product.
  PolytopeRun(const SearchFamily& family, std::vector<Candidate> products, std::size_t maximizing, PolytopeKind kind,
              double scale, const SearchOptions& options);

  /// Works until closed, `seconds` have passed, or there are `max_vertices`.
  State advance(double seconds, std::size_t max_vertices);

  /// A word along which the polytope keeps growing and whose radius beats `radius` by a relative 1e-9, if there is one.
  std::optional<Candidate> better_product(double radius) const;

  /// Solves what is still open or has little margin to optimality; true if all images have norms in the end.
  bool finish(double seconds);

  void report(SearchResult& result) const;
  State state() const { return state_; }
  std::size_t size() const { return vertices_.size(); }
  std::size_t waiting() const { return waiting_.size() + fresh_.size(); }
  /// Images that are open, per vertex.
  double open_share() const {
    return static_cast<double>(waiting()) / static_cast<double>(std::max<std::size_t>(size(), 1));
  }
  double spent() const { return spent_; }
  void count(SearchCounters& counters) const;

 private:
  struct Node {
    Eigen::VectorXd value;
    int parent = -1, letter = -1, cycle = -1, place = -1;
  };
  struct Image {
    bool known = false, identity = false;
    double norm = std::numeric_limits<double>::infinity();
    std::vector<Term> terms;
  };
  struct Pending {
    int vertex = 0, letter = 0;
    double key = 0;
    Hint hint;
  };

  Eigen::VectorXd apply(int letter, const Eigen::VectorXd& x) const;
  Eigen::VectorXd real_form(const Eigen::VectorXcd& x) const;
  int add(Node node);
  void add_roots();
  void add_extra_vertices();
  void add_spanning_vertices();
  bool settle(Pending& pending, bool optimum = false);
  bool match(const Eigen::VectorXd& x, Image& entry) const;
  Image& image(int vertex, int letter) {
    return images_[static_cast<std::size_t>(vertex) * matrices_.size() + static_cast<std::size_t>(letter)];
  }
  std::vector<int> path(int vertex) const;

  PolytopeKind kind_;
  bool flip_;
  double scale_;
  SearchOptions options_;
  std::vector<Eigen::MatrixXd> original_, matrices_;  // matrices_: working coordinates, divided by scale_
  std::vector<Candidate> products_;
  std::size_t maximizing_;
  Coordinates coordinates_;
  int dimension_;
  std::vector<RootCycle> cycles_;
  IncrementalSimplex simplex_;
  std::vector<Node> vertices_;
  std::vector<Image> images_;
  std::vector<Pending> fresh_, waiting_;
  State state_ = State::open;
  bool spanning_ = false;
  double spent_ = 0;
};

}  // namespace subcert::detail
