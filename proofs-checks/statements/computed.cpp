#include "computed.hpp"

#include <subcert/schemes/specification.hpp>

#include <map>
#include <memory>
#include <mutex>

namespace subcert::statements {
namespace {

constexpr int holder_levels = 16;  // as in Tables 1 and 2 of [DHHS15]
constexpr double regularity_seconds = 10;

/// The value that `make` gives for this key the first time.
template <class Value, class Make>
const Value& remembered(const std::string& key, const Make& make) {
  static std::mutex lock;
  static std::map<std::string, std::unique_ptr<const Value>> known;
  {
    const std::lock_guard guard(lock);
    if (const auto found = known.find(key); found != known.end()) return *found->second;
  }
  auto value = std::make_unique<const Value>(make());
  const std::lock_guard guard(lock);
  return *known.emplace(key, std::move(value)).first->second;
}

}  // namespace

const Mask& mask_of(const std::string& scheme) {
  return remembered<Mask>(scheme, [&] { return make_scheme(scheme).mask.curve(); });
}

const VarianceRange& variance_of(const std::string& scheme) {
  return remembered<VarianceRange>(scheme, [&] { return variance_range(mask_of(scheme)); });
}

const LimitRange& limit_range_of(const std::string& scheme) {
  return remembered<LimitRange>(scheme, [&] { return limit_range(mask_of(scheme)); });
}

const HolderBound& holder_bound_of(const std::string& scheme) {
  return remembered<HolderBound>(scheme, [&] { return holder_bounds(mask_of(scheme), holder_levels).last(); });
}

const HolderRegularity& holder_regularity_of(const std::string& scheme) {
  return remembered<HolderRegularity>(
      scheme, [&] { return holder_regularity(mask_of(scheme), holder_levels, {Deadline::in(regularity_seconds)}); });
}

const VarianceOrder& variance_order_of(const std::string& first, const std::string& second) {
  return remembered<VarianceOrder>(first + " | " + second,
                                   [&] { return compare_variance(mask_of(first), mask_of(second)); });
}

std::string specification(const std::string& family, int n, int degree) {
  return family + ":n=" + std::to_string(n) + ",d=" + std::to_string(degree);
}

}  // namespace subcert::statements
