#pragma once
/// What an experiment measures, and the relations between measured quantities that a claim can state.

#include "statistics.hpp"

#include <subcert/reports/formats/section.hpp>

#include <cmath>
#include <compare>
#include <functional>
#include <map>
#include <optional>

namespace subcert::experiments {

using Names = std::vector<std::string>;
using NamePairs = std::vector<std::pair<std::string, std::string>>;

/// Each of the first names with each of the second.
NamePairs all_pairs(const Names& first, const Names& second);

/// What is measured and of what, as the error of S_3.
struct Quantity {
  std::string measure;
  std::string subject;
  auto operator<=>(const Quantity&) const = default;
};

/// Something found without samples, and the numbers that show it. The name says of what; it may be empty.
struct Fact {
  std::string name;
  bool holds;
  std::string numbers;
};

/// The outcome of an experiment before its claims are decided.
struct Measured {
  std::map<Quantity, std::vector<double>> samples = {};  ///< one number for each sample of the noise
  std::map<std::string, std::vector<Fact>> facts = {};   ///< by topic
  std::vector<formats::PlainTable> tables = {};          ///< those that are not means of quantities
  std::vector<formats::Figure> figures = {};
  std::vector<formats::SurfaceFigure> surface_figures = {};

  /// Errors: throws a domain error where this was not measured.
  const std::vector<double>& at(const Quantity& quantity) const;
  void add_fact(const std::string& topic, const std::string& name, bool holds, const std::string& numbers);
};

/// The mean of a quantity, or of its paired differences to a multiple of another one, and where a claim wants it.
struct Mean {
  std::string name;  ///< may be empty
  Quantity of;
  std::optional<Quantity> minus = {};
  double factor = 1;
  double lower = -INFINITY;  ///< the whole interval lies above this
  double upper = INFINITY;   ///< and below this

  MeanInterval in(const Measured& measured) const;
};
using Means = std::vector<Mean>;

Means means(const std::string& measure, const Names& subjects);
/// The first of each pair minus `factor` times the second.
Means differences(const std::string& measure, const NamePairs& pairs, double factor = 1);
/// Of the same subject: `measure` minus `factor` times `subtracted`.
Means excess(const std::string& measure, const std::string& subtracted, const Names& subjects, double factor = 1);
/// The same means, wanted on one side of a bound.
Means all_above(double bound, Means means);
Means all_below(double bound, Means means);

struct Finding {
  Verdict verdict;
  std::string numbers;
};

/// What a claim says about measured quantities: in words, and as a decision.
struct Relation {
  std::string statistic;
  std::function<Finding(const Measured&)> decide;
};

/// confirmed where `holds`, else not_confirmed.
Finding finding(bool holds, const std::string& numbers);

/// Every mean lies with its whole interval where it is wanted.
Relation whole_intervals(const std::string& statistic, const Means& means);
/// Every mean lies below (above) the bound with its whole interval. `measure` says what the means are of.
Relation below(const std::string& measure, double bound, const Means& means);
Relation above(const std::string& measure, double bound, const Means& means);
/// All facts of this topic hold. Errors: of the decision, a domain error where there are none.
Relation all_facts(const std::string& topic, const std::string& statistic);

/// A table of means: a row for each subject, a column for each measure.
struct MeansTable {
  struct Row {
    Names labels;
    std::string subject;
  };
  struct Column {
    std::string head;
    std::string measure;
    std::string minus = {};  ///< where given, the paired differences to this measure
  };
  std::string id;
  std::string title;
  Names label_heads;
  std::vector<Row> rows;
  std::vector<Column> columns;

  formats::PlainTable filled(const Measured& measured) const;
};

}  // namespace subcert::experiments
