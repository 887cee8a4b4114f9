#pragma once
/// One polytope that grows: the vertices, the images of each under the matrices, and which of these are inside.

#include "polytope_search.hpp"
#include "root_cycles.hpp"

#include <deque>
#include <optional>

namespace subcert::polytope {

/// One growing polytope. It may be advanced in slices.
class PolytopeRun {
 public:
  enum class State { open, closed };

  /// Images are divided by scale >= radius of the first product; orbits of extra vertices come so near to the faces at
  /// the roots. Nothing is done past the deadline of the budget, and no vertex is added once the polytope and its
  /// report would fill the memory. Domain: 0 < extra_reach < 1.
  PolytopeRun(const SearchFamily& family, std::vector<Candidate> products, PolytopeKind kind, double scale,
              double extra_reach, const SearchOptions& options);

  /// Works until closed, until that much work is done, until the deadline, or until full.
  State advance(double work, const Deadline& deadline);

  /// What was done so far, in seconds of a usual machine: by what was computed, not by a clock, so that equal input is
  /// treated equally.
  double work() const { return work_; }

  /// A word along which the polytope keeps growing and whose radius beats `radius` by a relative 1e-9, if there is one.
  std::optional<Candidate> better_product(double radius) const;

  /// Solves what is still open or has little margin to optimality, as far as the time reaches.
  void finish(const Deadline& deadline);

  /// What was found. The run is of no use afterwards.
  void report(SearchResult& result) &&;

  std::size_t size() const { return vertices_.size(); }
  /// No further vertex may be added.
  bool full() const { return size() >= most_vertices || bytes() + bytes_of_next_vertex() > options_.budget.memory; }
  /// Images that are open, per vertex.
  double open_share() const {
    return static_cast<double>(waiting_.size() + fresh_.size()) / static_cast<double>(std::max<std::size_t>(size(), 1));
  }

 private:
  struct Node {
    Vector value;
    int parent = -1, letter = -1, cycle = -1, place = -1;
  };
  struct Image {
    bool known = false, identity = false;
    double norm = std::numeric_limits<double>::infinity();
    std::vector<CombinationTerm> terms;
  };
  struct Pending {
    int vertex = 0, letter = 0;
    double key = 0;  // an estimate of the norm
    WarmStart warm;
  };

  Vector apply(int letter, const Vector& x) const;
  Vector acted_on(int element, Vector x) const;
  std::vector<CombinationTerm> combination() const;
  Vector real_form(const ComplexVector& x) const;
  ComplexVector complex_form(const Vector& x) const;
  int add(Node node);
  void add_roots();
  bool is_image_of_earlier_root(const RootCycle& cycle, std::size_t t) const;
  void add_extra_vertices();
  void add_spanning_vertices();
  Matrix gram_of_vertices(double& size) const;

  bool settle(Pending& pending, bool optimum = false);
  int next_root(const Pending& pending) const;
  bool match(const Vector& x, Image& entry);
  bool match(const Vector& x, int vertex, Image& entry);
  bool is_term(const Vector& x, const CombinationTerm& term) const;
  bool settle_fresh(const Deadline& deadline);
  void add_largest(const Deadline& deadline);
  void make_vertex(const Pending& pending);
  void set_terms(Image& entry, std::vector<CombinationTerm> terms);
  bool must_stop(const Deadline& deadline) const {
    return work_ >= work_limit_ || deadline.expired() || options_.budget.deadline.expired() || full();
  }
  void count_work(std::int64_t pivots);

  const Vector& value(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)].value; }
  Image& image(int vertex, int letter) {
    return images_[static_cast<std::size_t>(vertex) * matrices_.size() + static_cast<std::size_t>(letter)];
  }
  std::vector<int> path(int vertex) const;
  std::size_t bytes_of_vertex() const;
  std::size_t bytes() const;
  std::size_t bytes_of_next_vertex() const {
    return bytes_of_vertex() + images_in_simplex() * simplex_.bytes_of_next_vertex();
  }
  std::size_t images_in_simplex() const {
    return coordinates_.action.is_dense() ? static_cast<std::size_t>(coordinates_.action.order()) : 1;
  }

  const SearchFamily& family_;
  PolytopeKind kind_;
  double scale_, extra_reach_;
  SearchOptions options_;
  std::vector<Matrix> matrices_;  // in working coordinates, divided by scale_
  std::vector<Candidate> products_;
  Coordinates coordinates_;
  std::size_t dimension_;
  std::size_t stride_between_looks_;
  std::vector<RootCycle> cycles_;
  IncrementalSimplex simplex_;
  /// What a vertex of the simplex method is: an image of a vertex under a dense group. For the flip it knows the
  /// images.
  std::vector<std::pair<int, int>> image_of_;
  std::deque<Node> vertices_;  // a deque, as a vector that grows is held twice
  std::deque<Image> images_;
  std::size_t bytes_of_terms_ = 0;
  std::vector<Pending> fresh_, waiting_;
  State state_ = State::open;
  bool spanning_ = false;
  double work_ = 0, work_limit_ = 0;
};

}  // namespace subcert::polytope
