#pragma once
/// What the gallery knows of a scheme, and its pages.

#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/reports/facts/fact.hpp>
#include <subcert/reports/formats/figure.hpp>
#include <subcert/reports/formats/surface_figure.hpp>
#include <subcert/reports/row_proof.hpp>
#include <subcert/schemes/specification.hpp>

#include <optional>
#include <string>
#include <vector>

namespace subcert::reports {

struct GalleryScheme {
  std::string specification;
  std::string key = {};            ///< of docs/references.md, without brackets; empty: a scheme of the reader's own
  Truth convergence = Truth::yes;  ///< as expected
};

/// Forty schemes of the papers and of the literature.
const std::vector<GalleryScheme>& gallery_schemes();

/// The entry of docs/references.md with this key. Errors: throws a domain error where there is none.
std::string reference(const std::string& key);

struct PlateOptions {
  double budget = 5;                          ///< seconds for the proofs about each scheme
  std::size_t memory = std::size_t{1} << 30;  ///< bytes
  bool open = false;                          ///< the polygon that is refined
  Verified verified = {};                     ///< who is asked about certificates; nobody: there are none
};

/// A picture of a plate.
struct PlatePicture {
  std::string name;     ///< `limit`, `derivative-1`, `variance`, `polygon`
  std::string caption;  ///< HTML
  formats::Panel panel;
};

/// A scheme, what is proved about it, and its pictures. What does not exist, or is not proved to, is absent, and a note
/// says why.
struct Plate {
  explicit Plate(const GalleryScheme& drawn) : scheme(make_refinable_scheme(drawn.specification)), key(drawn.key) {}

  Scheme scheme;
  std::string key;  ///< of the reference, or empty
  int sum_rules = 0;
  Decision convergence;
  Decision stable;
  Enclosure holder;
  Decision exact;  ///< whether a product attains the radius behind the exponent
  std::optional<Enclosure> sobolev;
  std::optional<FunctionVector> vector;  ///< of a mask of matrices: `convergence` is that of the scheme itself
  int derivatives = -1;  ///< continuous ones that norms prove, without the budget of the exponent; -1: not asked
  std::optional<Enclosure> largest_variance;
  std::optional<Rational> mean_variance;
  std::vector<PlatePicture> pictures;
  std::optional<formats::DrawnSurface> surface;
  std::string at_integers;                 ///< exact values of the limit, as text; empty where they are too long
  std::optional<formats::RowProof> proof;  ///< of the exponent
  std::vector<std::string> notes;

  const std::string& specification() const { return scheme.specification; }
  const std::string& title() const { return scheme.title; }
};

/// Domain: a scheme of one variable, or of two or three; a vector of functions. Errors: throws SpecificationError for
/// what is no linear scheme and no vector of functions; what a proof or a picture cannot have becomes a note. Cost: the
/// budget, the budget once more for pictures, and for long masks the first picture beside.
Plate make_plate(const GalleryScheme& scheme, const PlateOptions& options);

/// One page, all in one file: an index of pictures where there are several plates, then the plates.
std::string gallery_html(const std::vector<Plate>& plates);

/// One page, all in one file: what is known of the schemes side by side, their functions in one picture, then the
/// plates. Domain: at least one plate.
std::string comparison_html(const std::vector<Plate>& plates);

/// Pictures that all have of which several plates have one, each with the curves of all of these.
std::vector<PlatePicture> overlaid(const std::vector<Plate>& plates);

/// What follows from the mask, shortened where it is too long for people, and what is proved; what is not known of this
/// scheme is left out, in JSON it is null. Exponents have `digits` decimals for people.
facts::Facts plate_facts(const Plate& plate, int digits = 10);

}  // namespace subcert::reports
