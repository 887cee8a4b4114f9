#pragma once
/// How the searches share their time: every share and every number of seconds behind a joint spectral radius and the
/// exponents that come from it. Inner header. A share is of what is left when its step begins, unless it says `whole`:
/// then it is of what its stage had at first, cut where less is left. Proofs of what was found may take `grace` more.

namespace subcert::schedule {

inline constexpr double grace_of_norms = 0.2;  ///< seconds, for norms of products: norm_of_products.cpp

/// A family: joint_spectral_radius.cpp.
namespace family {
inline constexpr double triangular_form = 0.2;
inline constexpr double grace_of_basis = 0.5;        ///< seconds, to verify such a form
inline constexpr double first_letter = 0.3;          ///< to prove it, where its polynomial is long,
inline constexpr double letters = 0.1;               ///< and the others in so much of all
inline constexpr double symmetries = 0.1;            ///< for balanced blocks, and as much for the symmetries of each
inline constexpr double first_look = 0.02;           ///< whole, a block: norms and a product
inline constexpr double least_of_block = 0.05;       ///< whole, however small its part of the work
inline constexpr double first_seconds = 0.05;        ///< for a block that seems smaller; twice as many with each try
inline constexpr double shorter_rounds = 1.0 / 3;    ///< once more with less time, where one search is not exact,
inline constexpr double most_of_shorter_rounds = 5;  ///< in so many seconds at most,
inline constexpr double least_round = 0.03;          ///< and none with fewer,
inline constexpr double grace_of_rounds = 0.5;       ///< later by so many, where proofs took the time
inline constexpr double norms_beside_blocks = 0.5;   ///< of the grace to compare blocks: norms of the whole
inline constexpr double grace_of_blocks = 0.5;       ///< seconds, to compare them
inline constexpr double grace_of_one_matrix = 1;     ///< seconds, for its eigenvalues
}  // namespace family

/// A block: one_block.cpp. Polytopes and forms are sought side by side.
namespace block {
inline constexpr double opposite_as_one = 0.5;  ///< for opposite matrices as one, where they are told apart in the end
inline constexpr double commuting = 0.2;        ///< to see whether matrices commute, and then for a polytope,
inline constexpr double commuting_seconds = 2;  ///< in so many at most
inline constexpr double norms = 0.05;           ///< of products
inline constexpr double polytopes = 0.5;        ///< the search; the rest is for its proof
inline constexpr double closed_proof = 0.6;     ///< the proof of a closed polytope
inline constexpr double larger_polytope = 0.3;  ///< then, where nothing closed or was proved: one with fewer vertices
inline constexpr double alone = 0.05;           ///< polytopes, before forms are sought beside them,
inline constexpr double alone_seconds = 10;     ///< in so many at most
inline constexpr double alone_least = 0.25;     ///< and so many at least: who else is at work may double their time,
inline constexpr double alone_share = 0.4;      ///< if that is no more of the time
inline constexpr double grace = 0.5;            ///< seconds that a proof may take in any case
inline constexpr double grace_of_short = 0.1;   ///< the same for products of few letters
}  // namespace block

/// Families near one: rounded_family.cpp.
namespace rounded {
inline constexpr double exact = 0.5;   ///< for a product that attains the radii of all of them
inline constexpr double search = 0.6;  ///< of that, for its polytope
inline constexpr double grace = 0.5;   ///< seconds, to enclose its eigenvalue
}  // namespace rounded

/// A polytope: polytope_search.cpp. What closes exactly is worth most of the time; enclosing gets the rest.
namespace polytope {
inline constexpr double races = 0.91;            ///< whole: all but enclosing
inline constexpr double first_products = 0.35;   ///< whole: the first look for products
inline constexpr double later_products = 0.175;  ///< whole: each of at most three later ones
inline constexpr double first_race = 0.84;       ///< whole
inline constexpr double early_race = 0.2;    ///< of the patience for the second race, before long products are sought
inline constexpr double large_extras = 0.2;  ///< of the races: one with large extra vertices
inline constexpr double last_look = 0.7;     ///< whole: what may be gone when products are sought once more
inline constexpr double last_race = 0.5;     ///< of what is left for races, where forms come after polytopes
inline constexpr double enclosing_proof = 0.5;  ///< the last digits of a polytope that encloses
inline constexpr double least_race = 0.1;       ///< seconds
inline constexpr double least_slice = 0.02,
                        largest_slice = 60;  ///< seconds of a run before it is the turn of the other
}  // namespace polytope

/// Long products: long_products.cpp.
namespace products {
inline constexpr double coordinates = 0.5;  ///< in which norms are small
inline constexpr double runs = 0.2;         ///< words with long runs of one letter
}  // namespace products

/// Quadratic forms: quadratic_proof.cpp and context_forms.cpp.
namespace forms {
inline constexpr double one_form = 0.3;
inline constexpr double contexts = 0.78;      ///< ever longer ones
inline constexpr double tree = 0.55;          ///< the words for their forms
inline constexpr double look = 0.4;           ///< of what the last contexts took: whether words are few already
inline constexpr double first_look = 0.1;     ///< seconds, of the first contexts
inline constexpr double next_contexts = 0.5;  ///< of what longer contexts take, by the last ones: else none are begun
inline constexpr double kept_tree = 0.5;      ///< of the tree: one that keeps the product
inline constexpr double fine_proof = 0.7;     ///< a proof with long numbers
inline constexpr double grace = 0.5;          ///< seconds of a proof
inline constexpr double isometry_seconds = 0.5;
}  // namespace forms

/// Orbits of rational vectors: closed_orbit.cpp.
namespace orbit {
inline constexpr double all = 0.1;    ///< for all products,
inline constexpr double seconds = 1;  ///< in so many at most
}  // namespace orbit

/// The p-radius: p_radius.cpp.
namespace p_radius {
inline constexpr double splitting = 0.2;  ///< into diagonal blocks
}

/// An exponent in one variable: holder_regularity.cpp.
namespace curve {
inline constexpr double reduced = 0.7;            ///< the reduced mask, where that one tells the exponent
inline constexpr double norms = 0.5;              ///< of the difference scheme, level by level
inline constexpr double convergence = 0.5;        ///< by one product, and then by norms
inline constexpr double growth_grace = 0.5;       ///< seconds, for norms where the exponent is an integer
inline constexpr double frequencies = 0.5;        ///< of large matrices, before their radius,
inline constexpr double frequencies_grace = 0.5;  ///< seconds, after that of others
}  // namespace curve

/// An exponent in several variables: multivariate_regularity.cpp.
namespace surface {
inline constexpr double stability = 0.5;
inline constexpr double sobolev = 0.3;
inline constexpr double search = 0.9;                       ///< of the radius, so that some is left for convergence
inline constexpr double norms = 0.05;                       ///< of the search, for each space
inline constexpr double first_slice = 3, slice_factor = 2;  ///< seconds for each of several dilations
inline constexpr double along = 0.5;                        ///< differences of one order along a subspace
inline constexpr double convergence = 0.5;                  ///< by norms, and by differences of one order
inline constexpr double convergence_seconds = 5, convergence_grace = 0.5;  ///< once the rest of the time is gone
}  // namespace surface

/// An exponent of a vector of functions: vector_regularity.cpp.
namespace vector {
inline constexpr double scheme = 0.2;   ///< whether the scheme converges itself
inline constexpr double spaces = 0.2;   ///< differences of ever higher orders
inline constexpr double norms = 0.05;   ///< of each radius
inline constexpr double blocks = 0.3;   ///< of a field
inline constexpr double mirrors = 0.2;  ///< of each block over a field
inline constexpr double whole = 0.6;    ///< the worst function
inline constexpr double sobolev = 0.2;  ///< its exponent in the mean of squares
}  // namespace vector

}  // namespace subcert::schedule
