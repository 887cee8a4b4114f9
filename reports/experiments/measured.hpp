#pragma once
/// What an experiment measures, and the relations between measured quantities that a claim can state.

#include "statistics.hpp"

#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/reports/formats/section.hpp>

#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <tuple>
#include <variant>

namespace subcert::experiments {

using Names = std::vector<std::string>;

/// What is measured and of what, as the error of S_3.
struct Quantity {
  std::string measure;
  std::string subject;
  bool operator<(const Quantity& other) const {
    return std::tie(measure, subject) < std::tie(other.measure, other.subject);
  }
};

/// Something found without samples, and the numbers that show it. The name says of what; it may be empty.
struct Fact {
  std::string name;
  bool holds;
  std::string numbers;
};

/// A number, or the name of one in Measured::numbers.
using Bound = std::variant<double, std::string>;

/// The outcome of an experiment before its claims are decided.
struct Measured {
  std::map<Quantity, std::vector<double>> samples = {};  ///< one number for each sample of the noise
  std::map<std::string, std::vector<Fact>> facts = {};   ///< by topic
  std::map<std::string, double> numbers = {};            ///< found without samples; texts and bounds name them
  std::vector<formats::PlainTable> tables = {};
  std::vector<formats::Figure> figures = {};
  std::vector<formats::SurfaceFigure> surface_figures = {};

  /// Errors: throws a domain error where this was not measured.
  const std::vector<double>& at(const Quantity& quantity) const;
  double number(const Bound& bound) const;
  /// The text with the number of this name, four significant digits, for {name}. Errors: as number().
  std::string filled(const std::string& text) const;
  void add_fact(const std::string& topic, const std::string& name, bool holds, const std::string& shown);
};

/// The mean of a quantity, or of its paired differences to a multiple of another one, and where a claim wants it.
struct Mean {
  std::string name;  ///< may be empty
  Quantity of;
  std::optional<Quantity> minus = {};
  double factor = 1;
  Bound lower = -INFINITY;  ///< the whole interval lies above this
  Bound upper = INFINITY;   ///< and below this

  MeanInterval in(const Measured& measured, double confidence) const;
  bool is_bounded() const { return lower != Bound(-INFINITY) || upper != Bound(INFINITY); }
};

/// yes: the data show what a sentence says; no: they show its contrary; unknown: neither, more samples are needed.
struct Finding {
  Truth truth;
  std::string statistic;  ///< what decides, in words
  std::string numbers;
};

/// What a sentence says about measured quantities. Its intervals cover all their means together with the confidence
/// `together`. Errors: throws a domain error that names what was not measured.
using Relation = std::function<Finding(const Measured&)>;

/// Every mean lies with its whole interval where it is wanted; the contrary is that one interval lies wholly elsewhere.
Relation whole_intervals(const std::string& statistic, const std::vector<Mean>& means);
/// All facts of this topic hold, or one does not; no facts are an error.
Relation all_facts(const std::string& statistic, const std::string& topic);

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
