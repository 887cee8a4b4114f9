#include "work.hpp"

#include <subcert/analysis/radii/joint/constrained.hpp>
#include <subcert/analysis/radii/joint/p_radius.hpp>
#include <subcert/analysis/radii/subradius/joint_spectral_subradius.hpp>
#include <subcert/analysis/regularity/frequency/frequency_bound.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/proofs-checks/certificates/scheme_regularity.hpp>
#include <subcert/reports/facts/exponent_formula.hpp>
#include <subcert/reports/facts/regularity_facts.hpp>
#include <subcert/schemes/specification.hpp>

#include <memory>

namespace subcert::python {
namespace {

Budget budget_of(double seconds, std::size_t mebibytes) { return {Deadline::in(seconds), mebibytes << 20}; }

/// The strongest one first: text, ends, matrices, what the number is, the power of the logarithm, and the product.
py::list to_list(const Certificate& certificate, const std::optional<std::string>& matrices = std::nullopt) {
  py::list result;
  const auto add = [&](const Certificate& one) {
    result.append(py::make_tuple(one.text(), one.claim.lower, one.claim.upper, matrices, one.claim.exact,
                                 one.claim.logarithm, one.claim.attains));
  };
  add(certificate);
  if (certificate.claim.exact || certificate.claim.attains) add(certificate.of_bounds());
  return result;
}

/// What an answer about a radius holds. `word`: of the product, in the letters of the caller.
py::dict radius_dict(const JointSpectralRadius& radius, const std::vector<int>& word) {
  return py::dict("radius"_a = radius.radius, "product"_a = word, "exact"_a = radius.exact.is_yes(),
                  "exactness"_a = radius.exact.reason, "closed"_a = radius.is_closed(),
                  "method"_a = to_text(radius.method()), "vertices"_a = radius.vertices());
}

struct HolderEvidence {
  Scheme scheme;
  Regularity regularity;
};

/// `certificate`: of what a certificate can hold, of a tensor product as a whole.
std::shared_ptr<HolderEvidence> holder(const Scheme& scheme, int levels, double seconds, std::size_t memory, int bits,
                                       bool certificate, std::optional<std::size_t> component,
                                       const py::object& progress) {
  return interruptible(progress, [&] {
    RegularityOptions options = of_scheme(scheme, {.bits = bits, .levels = levels});
    options.proof = certificate ? HolderProof::certificate : HolderProof::shortest;
    options.component = component;
    const bool whole = certificate && scheme.mask.dimension() > 1;
    return std::make_shared<HolderEvidence>(HolderEvidence{
        scheme,
        regularity_of(whole ? scheme.mask.without_factors() : scheme.mask, budget_of(seconds, memory), options)});
  });
}

/// What is exact, or in other letters than in JSON.
py::dict holder_dict(const HolderEvidence& evidence) {
  const auto& [curve, surface] = evidence.regularity;
  const JointSpectralRadius* radius = evidence.regularity.radius();
  py::dict result("exponent"_a = evidence.regularity.exponent(), "radius"_a = radius ? radius->radius : Enclosure{},
                  "product"_a = radius ? radius->product.word : std::vector<int>{},
                  "converges"_a = evidence.regularity.converges(), "stable"_a = evidence.regularity.stable(),
                  "closed"_a = evidence.regularity.is_closed(), "bound"_a = py::none(),
                  "logarithm"_a = py::make_tuple(0, py::none()), "sobolev"_a = py::none());
  if (surface) result["sobolev"] = surface->sobolev;
  if (!curve) return result;
  const HolderBound& bound = curve->bounds.last();
  result["bound"] = py::make_tuple(bound.levels, bound.norm, bound.exponent);
  result["logarithm"] = py::make_tuple(curve->logarithm.at_least, curve->logarithm.at_most);
  return result;
}

/// None where the evidence is none that a certificate can hold.
py::object holder_certificate(const HolderEvidence& evidence) {
  const auto& surface = evidence.regularity.surface;
  if (surface && !surface->space) return py::none();
  return to_list(exponent_certificate(evidence.scheme.mask, evidence.regularity, evidence.scheme.rounding,
                                      evidence.scheme.quadratic));
}

/// A family with the graph that restricts its products, if there is one.
struct RadiusEvidence {
  MatrixFamily family;  ///< lifted where there is a graph
  std::vector<int> letters;
  JointSpectralRadius radius;
};

MatrixFamily family_of(const std::vector<std::vector<std::vector<Rational>>>& lists) {
  std::vector<RationalMatrix> matrices;
  const auto require_size = [&](std::size_t count, std::size_t size) {
    require(FamilyLimits::hold(count, size),
            "matrices: need 1 to {} of size 1 to {} with at most {} entries together, got {} of size {}",
            FamilyLimits::matrices, FamilyLimits::size, FamilyLimits::entries, count, size);
  };
  require_size(lists.size(), lists.empty() ? 0 : lists.front().size());
  for (const auto& rows : lists) {
    require_size(1, rows.size());
    RationalMatrix matrix(rows.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      require(rows[i].size() == rows.size(), "matrix {}: need {} entries in each of {} rows, got {} in row {}",
              matrices.size(), rows.size(), rows.size(), rows[i].size(), i);
      for (std::size_t j = 0; j < rows.size(); ++j) matrix(i, j) = rows[i][j];
    }
    matrices.push_back(std::move(matrix));
  }
  return matrices;
}

std::shared_ptr<RadiusEvidence> jsr(const std::vector<std::vector<std::vector<Rational>>>& matrices,
                                    const std::vector<std::tuple<std::size_t, std::size_t, std::size_t>>& edges,
                                    double seconds, std::size_t memory, int bits, const py::object& progress) {
  MatrixFamily family = family_of(matrices);
  std::vector<int> letters;
  if (!edges.empty()) {
    std::vector<Succession> graph;
    for (const auto& [from, to, matrix] : edges) graph.push_back({from, to, matrix});
    LiftedFamily lift = lifted(family, graph);
    family = std::move(lift.family);
    letters = std::move(lift.letters);
  }
  return interruptible(progress, [&] {
    const Budget budget = budget_of(seconds, memory);
    JointSpectralRadius radius = joint_spectral_radius(family, budget);
    sharpen(radius, family, bits, budget.deadline);
    return std::make_shared<RadiusEvidence>(RadiusEvidence{std::move(family), std::move(letters), std::move(radius)});
  });
}

py::dict jsr_dict(const RadiusEvidence& evidence) {
  std::vector<int> word = evidence.radius.product.word;
  if (!evidence.letters.empty())
    for (int& letter : word) letter = evidence.letters[static_cast<std::size_t>(letter)];
  py::dict known = radius_dict(evidence.radius, word);
  for (const facts::Fact& fact : facts::radius_formula_facts(evidence.family, evidence.radius))
    if (fact.key == "formula")
      known["formula"] = fact.json.is_null() ? py::object(py::none()) : py::str(fact.json.get<std::string>());
  return known;
}

struct SubradiusEvidence {
  MatrixFamily family;
  JointSpectralSubradius radius;
};

std::shared_ptr<SubradiusEvidence> subradius(const std::vector<std::vector<std::vector<Rational>>>& matrices,
                                             double seconds, std::size_t memory, int bits, const py::object& progress) {
  MatrixFamily family = family_of(matrices);
  require(is_nonnegative(family), "matrices: need no negative entry for a subradius");
  return interruptible(progress, [&] {
    JointSpectralSubradius radius = joint_spectral_subradius(family, budget_of(seconds, memory), {{}, {}, bits});
    return std::make_shared<SubradiusEvidence>(SubradiusEvidence{std::move(family), std::move(radius)});
  });
}

py::dict subradius_dict(const SubradiusEvidence& evidence) {
  const JointSpectralSubradius& radius = evidence.radius;
  return py::dict("radius"_a = radius.radius, "product"_a = radius.product.word, "exact"_a = radius.exact.is_yes(),
                  "exactness"_a = radius.exact.reason, "closed"_a = radius.is_closed(),
                  "vertices"_a = radius.antinorm ? radius.antinorm->vertices.size() : 0);
}

}  // namespace

void add_regularity(py::module_& module) {
  module.attr("default_bits") = default_bits;
  module.def("bits_for_width", &bits_for_width);
  module.def("word_text", &word_text);
  py::class_<HolderEvidence, std::shared_ptr<HolderEvidence>>(module, "HolderEvidence")
      .def_property_readonly("exact", &holder_dict)
      .def_property_readonly(
          "facts",
          [](const HolderEvidence& evidence) {
            return page_json(facts::regularity_facts(evidence.scheme, evidence.regularity, {}, {})).dump();
          })
      .def("certificate", &holder_certificate);
  module.def("holder", &holder);
  module.def("vector_scheme_certificate", [](const Scheme& scheme, double seconds, const py::object& progress) {
    return to_list(interruptible(progress, [&] { return scheme_certificate(scheme, {Deadline::in(seconds)}); }));
  });
  module.def("frequency_bound", [](const Scheme& scheme, const py::object& progress) -> std::optional<Rational> {
    require(!scheme.rounding && is_affine(scheme.mask.curve()), "{}: need a mask of exact numbers with coset sums 1",
            scheme.specification);
    const auto found = interruptible(progress, [&] { return frequency_bound(scheme.mask.curve()); });
    return found && found->exponent > 0 ? std::optional(found->exponent) : std::nullopt;
  });
  module.def("sobolev", [](const Scheme& scheme, double seconds, const py::object& progress) {
    const auto found = interruptible(progress,
                                     [&] { return sobolev_regularity(scheme.mask.curve(), Deadline::in(seconds)); });
    return found ? std::optional(found->exponent) : std::nullopt;
  });
  py::class_<RadiusEvidence, std::shared_ptr<RadiusEvidence>>(module, "RadiusEvidence")
      .def_property_readonly("facts", &jsr_dict)
      .def("certificate", [](const RadiusEvidence& evidence) {
        return to_list(radius_certificate(evidence.family, evidence.radius), matrices_text(evidence.family));
      });
  module.def("jsr", &jsr);
  py::class_<SubradiusEvidence, std::shared_ptr<SubradiusEvidence>>(module, "SubradiusEvidence")
      .def_property_readonly("facts", &subradius_dict)
      .def("certificate", [](const SubradiusEvidence& evidence) {
        return to_list(subradius_certificate(evidence.family, evidence.radius), matrices_text(evidence.family));
      });
  module.def("subradius", &subradius);
  module.def("p_radius", [](const std::vector<std::vector<std::vector<Rational>>>& matrices, int p, int bits,
                            double seconds, const py::object& progress) {
    const MatrixFamily family = family_of(matrices);
    require(has_p_radius(family, p), "p: need an even number where entries are negative, got {}", p);
    const auto found = interruptible(progress, [&] { return p_radius(family, p, bits, Deadline::in(seconds)); });
    if (!found)
      fail(ErrorKind::undecided, "budget: the p-radius takes more than {} seconds of processor time", seconds);
    return found->radius;
  });
}

}  // namespace subcert::python
