#pragma once
/// What `subcert regularity` prints.

#include "exponent_text.hpp"

#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>

namespace subcert::cli {

struct RegularityPage {
  Scheme scheme;
  HolderRegularity regularity;
  std::optional<SobolevRegularity> sobolev;
  Enclosure holder;  ///< as far as convergence is proved
  bool complete;     ///< the enclosure is as narrow as it gets
  double seconds;
  int digits = 0;  ///< of the exponent, at least

  Json json() const;
  std::string text() const;

 private:
  std::string exponent_text() const;
  std::string reduced_text() const;
  Json reduced_json() const;
};

}  // namespace subcert::cli
