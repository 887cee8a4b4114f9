#include "work.hpp"

#include <subcert/analysis/family/exponent_curve.hpp>
#include <subcert/analysis/family/limit_of_levels.hpp>
#include <subcert/analysis/family/limit_values_of_levels.hpp>
#include <subcert/analysis/family/local_levels.hpp>
#include <subcert/analysis/family/mask_list.hpp>
#include <subcert/analysis/family/property_of_levels.hpp>
#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/proofs-checks/properties/mask_list_file.hpp>
#include <subcert/reports/facts/exponent_formula.hpp>
#include <subcert/reports/facts/range_summary.hpp>
#include <subcert/schemes/parametric_specification.hpp>
#include <subcert/schemes/plain_text.hpp>

#include <fmt/format.h>

#include <memory>

namespace subcert::python {
namespace {

py::list certificates_list(const std::vector<RangeCertificate>& certificates) {
  py::list result;
  for (const RangeCertificate& one : certificates)
    result.append(py::make_tuple(one.low, one.high, one.holds, one.certificate.text(), one.certificate.claim.lower,
                                 one.certificate.claim.upper));
  return result;
}

const char* why_of(SpecialValue::Why why) {
  switch (why) {
    case SpecialValue::Why::sum_rules: return "sum rules";
    case SpecialValue::Why::unstable: return "stability";
    case SpecialValue::Why::sign: return "sign";
    default: return "threshold";
  }
}

py::dict special_dict(const SpecialValue& value) {
  return py::dict("value"_a = value.value, "polynomial"_a = value.polynomial, "why"_a = why_of(value.why),
                  "holds"_a = value.holds);
}

struct RangeEvidence {
  ParametricScheme scheme;
  RangeProperty property;
  PropertyRange range;
  Rational width;
  std::string name;  ///< of the property
};

py::dict range_dict(const RangeEvidence& evidence) {
  py::list pieces, ends, special;
  for (const RangePiece& piece : evidence.range.pieces)
    pieces.append(
        py::make_tuple(piece.low, piece.high, piece.low_included, piece.high_included, piece.holds, piece.reason));
  for (const RangeEnd& end : evidence.range.ends)
    ends.append(py::make_tuple(Enclosure{end.low, end.high}, end.polynomial, end.word, end.holds));
  for (const SpecialValue& value : evidence.range.special) special.append(special_dict(value));
  return py::dict("sum_rules"_a = evidence.range.sum_rules, "pieces"_a = pieces, "ends"_a = ends, "special"_a = special,
                  "complete"_a = evidence.range.complete,
                  "summary"_a = facts::range_summary(evidence.range, evidence.scheme, evidence.name).value_or(""));
}

std::shared_ptr<RangeEvidence> range(const ParametricScheme& scheme, const std::string& text, const Rational& low,
                                     const Rational& high, const Rational& width, double seconds, int jobs,
                                     const py::object& progress) {
  const auto property = parse_range_property(text);
  if (!property)
    fail(ErrorKind::usage,
         "property: expected convergent, C1, HC1, holder>=3/2, sobolev>=1, stable, positive, monotone or convex, got "
         "'{}'",
         text);
  return interruptible(progress, [&] {
    return std::make_shared<RangeEvidence>(RangeEvidence{
        scheme, *property, property_range(scheme.mask, *property, low, high, {width, jobs, {Deadline::in(seconds)}}),
        width, text});
  });
}

struct LevelsEvidence {
  ParametricScheme scheme;
  RangeProperty property;
  Box box;
  PropertyOfLevels levels;
  std::optional<FollowedLevels> followed;
  double seconds;
};

py::dict levels_dict(const LevelsEvidence& evidence) {
  std::vector<Rational> period;
  for (const Values& values : evidence.levels.period) period.push_back(values.front());
  const Truth all = evidence.levels.holds;
  const auto& followed = evidence.followed;
  return py::dict("holds"_a = followed ? followed->have(evidence.property, all) : all,
                  "reason"_a = evidence.levels.reason, "sum_rules"_a = evidence.levels.sum_rules, "period"_a = period,
                  "first_level"_a = followed ? followed->first_level() : std::nullopt);
}

std::shared_ptr<LevelsEvidence> levels(const ParametricScheme& scheme, const std::string& text, const Rational& low,
                                       const Rational& high, const std::optional<std::string>& recurrence,
                                       const std::pair<Rational, std::optional<Rational>>& start, double seconds,
                                       const py::object& progress) {
  const auto property = parse_range_property(text);
  if (!property) fail(ErrorKind::usage, "property: expected convergent, C1 or holder>=3/2, got '{}'", text);
  return interruptible(progress, [&] {
    const Box box{{low}, {high}};
    auto evidence = std::make_shared<LevelsEvidence>(LevelsEvidence{
        scheme, *property, box, property_of_levels(scheme.mask, *property, box, {Deadline::in(seconds)}), {}, seconds});
    if (recurrence)
      evidence->followed = follow(scheme.mask, Recurrence::parse(plain_text(*recurrence), scheme.name, scheme.letter),
                                  {{start.first, start.second.value_or(start.first)}, !start.second}, {low, high},
                                  {Deadline::in(seconds)});
    return evidence;
  });
}

std::optional<std::string> formula_of(const ExponentOfList& found) {
  const auto formula = facts::exponent_formula(found);
  return formula ? std::optional(formula->text()) : std::nullopt;
}

py::dict limit_of(const ParametricScheme& scheme, const std::string& recurrence, const Rational& low,
                  const Rational& high, double seconds, const py::object& progress) {
  const Recurrence read = Recurrence::parse(plain_text(recurrence), scheme.name, scheme.letter);
  const auto found = interruptible(progress, [&] {
    return limit_of_levels(scheme.mask, read, {low, high}, {Deadline::in(seconds)});
  });
  if (!found) return {};
  return py::dict("value"_a = found->value, "sum_rules"_a = found->rules.sum_rules,
                  "exponentials"_a = found->rules.exponentials, "exponent"_a = found->exponent.exponent,
                  "exact"_a = found->exponent.exact.is_yes(), "formula"_a = formula_of(found->exponent));
}

std::string specification_at(const Mask& mask) {
  return fmt::format("mask:{},arity={}", mask.symbol().to_mask_text(), mask.arity());
}

std::vector<std::string> masks_at(const ParametricScheme& scheme, const std::string& recurrence, const Rational& start,
                                  int levels) {
  require(levels >= 0 && levels <= 1000, "levels: need 0 to 1000, got {}", levels);
  const LevelMasks masks = masks_of_levels(scheme.mask,
                                           Recurrence::parse(plain_text(recurrence), scheme.name, scheme.letter), start,
                                           static_cast<std::size_t>(levels));
  std::vector<std::string> result;
  for (const LatticeMask& mask : masks.first) result.push_back(specification_at(mask.curve()));
  return result;
}

py::tuple values_of(const ParametricScheme& scheme, const std::string& recurrence, const Rational& start, int level,
                    const py::object& progress) {
  const Recurrence read = Recurrence::parse(plain_text(recurrence), scheme.name, scheme.letter);
  const EnclosedLimitValues found = interruptible(progress,
                                                  [&] { return limit_values(scheme.mask, read, start, level); });
  std::vector<Enclosure> values;
  for (const Interval& value : found.values) values.push_back(value.enclosure());
  return py::make_tuple(found.arity, found.first_index, values);
}

/// A value for each new point.
struct LocalEvidence {
  ParametricScheme scheme;
  Box box;
  LocalLevels found;
};

std::shared_ptr<LocalEvidence> local_of(const ParametricScheme& scheme, const Rational& low, const Rational& high,
                                        double seconds, const py::object& progress) {
  return interruptible(progress, [&] {
    const Box box{{low}, {high}};
    return std::make_shared<LocalEvidence>(
        LocalEvidence{scheme, box, local_levels(scheme.mask, box, {Deadline::in(seconds)})});
  });
}

/// Of masks, one for each level.
struct ListEvidence {
  MaskList list;
  ExponentOfList found;
  double seconds;
};

std::shared_ptr<ListEvidence> list_of(const std::vector<std::string>& schemes, const std::vector<std::size_t>& period,
                                      const std::vector<std::pair<std::size_t, std::size_t>>& follows, double seconds,
                                      const py::object& progress) {
  properties::MaskListFile file;
  for (const std::string& one : schemes) properties::add_mask(file, one);
  if (!schemes.empty()) properties::require_common_data(file.list);
  MaskList list = std::move(file.list);
  list.period = period;
  list.follows = follows;
  return interruptible(progress, [&] {
    ExponentOfList found = exponent_of(list, {Deadline::in(seconds)});
    return std::make_shared<ListEvidence>(ListEvidence{std::move(list), std::move(found), seconds});
  });
}

py::dict list_dict(const ListEvidence& evidence) {
  const ExponentOfList& found = evidence.found;
  const auto hermite = hermite_order_of(found);
  return py::dict("exponent"_a = found.exponent, "exact"_a = found.exact, "sum_rules"_a = found.sum_rules,
                  "sequence"_a = found.sequence, "stable"_a = found.stable.is_yes(), "formula"_a = formula_of(found),
                  "sum_rules_alone"_a = found.vectors ? found.vectors->alone : std::vector<int>{},
                  "hermite_order"_a = hermite && hermite->order >= 0 ? std::optional(hermite->order) : std::nullopt);
}

py::list certificates_of(const ListEvidence& evidence) {
  py::list result;
  for (const Certificate& one : list_certificates(evidence.list, evidence.found, {Deadline::in(evidence.seconds)}))
    result.append(py::make_tuple(one.text(), one.claim.lower, one.claim.upper, one.claim.exact, one.claim.logarithm));
  return result;
}

struct CurveEvidence {
  ParametricScheme scheme;
  ExponentCurve curve;
};

py::dict curve_dict(const CurveEvidence& evidence) {
  py::list pieces, special;
  for (const CurvePiece& piece : evidence.curve.pieces)
    pieces.append(py::make_tuple(piece.proof.low, piece.proof.high, piece.exponent,
                                 piece.proof.below ? piece.proof.below->word : std::vector<int>{}));
  for (const CurvePoint& point : evidence.curve.special) {
    py::dict one = special_dict(point.at);
    one["exponent"] = point.exponent;
    special.append(one);
  }
  return py::dict("sum_rules"_a = evidence.curve.sum_rules, "pieces"_a = pieces, "special"_a = special);
}

}  // namespace

void add_families(py::module_& module) {
  py::class_<ParametricScheme>(module, "ParametricScheme")
      .def_readonly("specification", &ParametricScheme::specification)
      .def_readonly("title", &ParametricScheme::title)
      .def_property_readonly("parameter", [](const ParametricScheme& scheme) { return scheme.name; })
      .def_property_readonly("sum_rules", [](const ParametricScheme& scheme) { return sum_rules(scheme.mask); })
      .def("at", [](const ParametricScheme& scheme, const Rational& value) {
        if (scheme.form) return vector_scheme(*scheme.form, "", scheme.mask.lattice_mask_at({value})).specification;
        return specification_at(scheme.mask.at(value));
      });
  module.def("make_parametric_scheme",
             [](const std::string& specification) { return make_parametric_scheme(specification); });
  py::class_<RangeEvidence, std::shared_ptr<RangeEvidence>>(module, "RangeEvidence")
      .def_property_readonly("facts", &range_dict)
      .def("certificates", [](const RangeEvidence& evidence) {
        return certificates_list(range_certificates(evidence.scheme.mask, evidence.scheme.letter, evidence.property,
                                                    evidence.range, evidence.width));
      });
  module.def("property_range", &range);
  py::class_<LevelsEvidence, std::shared_ptr<LevelsEvidence>>(module, "LevelsEvidence")
      .def_property_readonly("facts", &levels_dict)
      .def("certificates", [](const LevelsEvidence& evidence) {
        const auto& [scheme, property, box, levels, followed, seconds] = evidence;
        std::vector<RangeCertificate> certificates;
        const auto add = [&, &of = box](std::optional<Certificate> one) {
          if (one) certificates.push_back({of.low[0], of.high[0], Truth::yes, std::move(*one)});
        };
        add(levels_certificate(scheme.mask, scheme.letter, property, box, levels, followed ? &*followed : nullptr));
        if (followed) add(limit_certificate(scheme.mask, scheme.letter, box, *followed, {Deadline::in(seconds)}));
        return certificates_list(certificates);
      });
  module.def("property_of_levels", &levels);
  module.def("limit_of_levels", &limit_of);
  py::class_<ListEvidence, std::shared_ptr<ListEvidence>>(module, "ListEvidence")
      .def_property_readonly("facts", &list_dict)
      .def("certificates", &certificates_of);
  module.def("exponent_of_levels", &list_of);
  py::class_<LocalEvidence, std::shared_ptr<LocalEvidence>>(module, "LocalEvidence")
      .def_property_readonly("order", [](const LocalEvidence& evidence) { return evidence.found.order; })
      .def_property_readonly("exponent", [](const LocalEvidence& evidence) { return evidence.found.exponent; })
      .def("certificates", [](const LocalEvidence& evidence) {
        const auto& [scheme, box, found] = evidence;
        std::vector<RangeCertificate> certificates;
        if (auto one = each_point_certificate(scheme.mask, scheme.letter, box, found))
          certificates.push_back({box.low[0], box.high[0], Truth::yes, std::move(*one)});
        return certificates_list(certificates);
      });
  module.def("local_levels", &local_of);
  module.def("masks_of_levels", &masks_at);
  module.def("limit_values_of_levels", &values_of);
  py::class_<CurveEvidence, std::shared_ptr<CurveEvidence>>(module, "CurveEvidence")
      .def_property_readonly("facts", &curve_dict)
      .def("certificates", [](const CurveEvidence& evidence) {
        return certificates_list(curve_certificates(evidence.scheme.mask, evidence.scheme.letter, evidence.curve));
      });
  module.def("exponent_curve", [](const ParametricScheme& scheme, const Rational& low, const Rational& high, int pieces,
                                  double seconds, int jobs, const py::object& progress) {
    require(pieces >= 1 && pieces <= 100'000, "curve: need 1 <= pieces <= 100000, got {}", pieces);
    return interruptible(progress, [&] {
      return std::make_shared<CurveEvidence>(
          CurveEvidence{scheme, exponent_curve(scheme.mask, low, high, {pieces, jobs, {Deadline::in(seconds)}})});
    });
  });
}

}  // namespace subcert::python
