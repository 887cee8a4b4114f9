#pragma once
/// A sentence of a paper, what decides it, and its verdict over what the paper leaves open.

#include "measured.hpp"

#include <subcert/proofs-checks/verdict.hpp>

namespace subcert::experiments {

/// What the paper leaves open: the value that an experiment takes, and others that are as fair. What the values mean is
/// the business of the measure.
struct Choice {
  std::string name;  ///< as `spacing`
  std::string open;  ///< what the paper says of it, or that it says nothing
  std::string taken;
  Names others;
};

/// One way to read a sentence. Texts that need no words of their own leave them empty.
struct Reading {
  std::string words;
  Relation relation;
  bool late = false;    ///< chosen after the numbers were seen: it can save a sentence, but not show it
  bool weaker = false;  ///< it says less than the words: what it shows is not the sentence as printed
};

/// Canonical: at least one reading.
struct Claim {
  std::string sentence;
  std::string place;
  std::vector<Reading> readings;
  Names over = {};              ///< the choices with which it is decided
  bool on_our_data = false;     ///< the paper's data were not published and cannot be made from what it prints
  std::string counted_in = {};  ///< the experiment that counts the sentence, where this one only adds a remark to it
  /// What this version of the toolkit is known to find with the default seed.
  ClaimVerdict recorded = ClaimVerdict::holds;
};

/// What was measured with one choice other than taken, or with none where `choice` is empty.
struct Variant {
  std::string choice;
  std::string value;
  std::size_t runs;
  Measured measured;

  /// `as taken`, or `spacing = 1/2`.
  std::string name() const { return choice.empty() ? "as taken" : choice + " = " + value; }
};

/// What one variant says of one reading.
struct VariantFinding {
  std::string variant;
  std::size_t runs;
  Finding finding;
};

struct DecidedReading {
  std::string words;
  ClaimVerdict verdict;                  ///< of this reading, whosever data they are; never own_data
  bool late;                             ///< then depends at best
  bool weaker;                           ///< then weaker at best
  std::vector<VariantFinding> findings;  ///< as taken first
  /// How the sentence is read, and whether that was chosen late; may be empty.
  std::string read_as() const;
  /// The numbers as taken, and which other choices say the same, the contrary or nothing.
  std::string numbers() const;
};

/// A claim with what was found: by its best reading, that is the first of those with the best verdict.
struct DecidedClaim {
  std::string sentence;
  std::string place;
  ClaimVerdict finding;
  std::string statistic;  ///< what decides, and how the sentence is read
  std::string numbers;
  ClaimVerdict recorded = ClaimVerdict::holds;
  std::string counted_in = {};
  std::vector<DecidedReading> readings = {};  ///< the best first
};

/// holds: every finding is yes; contrary: every one is no; depends: some are yes and some no; else undecided. Domain:
/// at least one finding.
ClaimVerdict verdict_over(const std::vector<VariantFinding>& findings);

/// Whether more samples could lead to a better verdict: the reading is undecided, and a decision of it would
/// count. Never on our data, where no verdict hangs on it.
bool is_open(const DecidedClaim& claim, const DecidedReading& reading);

/// By the variants of the choices that the claim names. Domain: the first variant is the one as taken. Errors: throws a
/// domain error that names what was not measured.
DecidedClaim decided(const Claim& claim, const std::vector<Variant>& variants);

}  // namespace subcert::experiments
