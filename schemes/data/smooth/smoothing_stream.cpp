#include "smoothing_stream.hpp"

#include "smooth.hpp"

#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <algorithm>

namespace subcert::data {

SmoothingStream::SmoothingStream(Samples head, SmoothingMethod method, const SmoothingOptions& options, bool weighted)
    : kept_(std::move(head)), method_(std::move(method)), options_(options), weighted_(weighted) {
  require(options.boundary != Boundary::periodic, "a stream has no end that its beginning could follow");
  require(kept_.uniform() && kept_.count() == 0, "SmoothingStream: need uniform positions and no data yet");
  options_.at_data = false;
  options_.sparse = false;
  if (options.at_data) options_.level = 0;
  if (const auto* scheme = std::get_if<Scheme>(&method_)) {
    require_derivative(scheme->specification, scheme->mask, {options.derivative});
    kernel_ = std::make_shared<SmoothingKernel>(scheme->mask.curve(), scheme->rules, options_, weighted);
    end_window_ = kernel_->extension(options.boundary).window;
  } else if (auto* local = std::get_if<LocalPolynomial>(&method_)) {
    require(local->is_complete(), "a stream needs points or a width for {}", to_text(*local));
    require(local->robust == 0, "a stream needs a linear method; {} has robust steps", to_text(*local));
    require(!weighted || local->points == 0,
            "a stream with weights or missing data needs a scheme, or a width in place of points: {}", to_text(*local));
    local->width /= nearest_double(kept_.spacing);
    end_window_ = std::max<std::size_t>(1, local->points);
  } else {
    fail(ErrorKind::domain, "a stream needs a linear method; {} is none", to_text(method_));
  }
  const auto probe = smoother(end_window_);
  before_ = static_cast<std::size_t>(std::max(0L, -probe->lowest()));
  after_ = static_cast<std::size_t>(std::max(1L, probe->highest()));
}

std::unique_ptr<LinearSmoother> SmoothingStream::smoother(std::size_t count) const {
  DataSites sites{count, kept_.weights};
  if (weighted_) sites.weights.resize(count, 1);
  sites.before = first_;
  if (kernel_) return std::make_unique<SchemeSmoother>(kernel_, std::move(sites), options_);
  return std::make_unique<LocalSmoother>(std::get<LocalPolynomial>(method_), std::move(sites), options_);
}

void SmoothingStream::add(const std::vector<std::vector<double>>& columns, const std::vector<Rational>& weights) {
  require(columns.size() == kept_.columns.size(), "SmoothingStream: need {} columns, got {}", kept_.columns.size(),
          columns.size());
  require(weights.empty() || weighted_, "SmoothingStream: need weights from the first datum on");
  const std::size_t count = columns.front().size();
  for (std::size_t c = 0; c < columns.size(); ++c)
    kept_.columns[c].insert(kept_.columns[c].end(), columns[c].begin(), columns[c].end());
  if (!weighted_) return;
  kept_.weights.insert(kept_.weights.end(), weights.begin(), weights.end());
  if (weights.empty()) kept_.weights.insert(kept_.weights.end(), count, 1);
}

/// Whether the data on which the values at the first datum depend have come.
bool SmoothingStream::knows_left_end() const {
  const auto present = weighted_ ? std::count_if(kept_.weights.begin(), kept_.weights.end(),
                                                 [](const Rational& weight) { return weight > 0; })
                                 : static_cast<std::ptrdiff_t>(kept_.count());
  return static_cast<std::size_t>(present) >= end_window_ && kept_.count() > std::max(before_, after_);
}

SmoothedSamples SmoothingStream::values(std::size_t end, const LinearSmoother& smoother) {
  const std::vector<NoiseEstimate> noise(kept_.columns.size(),
                                         kept_.noise ? known_noise(*kept_.noise) : NoiseEstimate{});
  SmoothedSamples result = smoothed_columns(kept_, noise, smoother, options_.derivative, taken_ - first_, end - first_,
                                            first_);
  result.method = to_text(method_);
  taken_ = end;
  return result;
}

SmoothedSamples SmoothingStream::take() {
  const std::size_t last = first_ + kept_.count();
  const bool ready = last > taken_ + after_ && (first_ > 0 || taken_ > 0 || knows_left_end());
  const auto made = ready ? smoother(kept_.count()) : nullptr;
  if (!made) return {to_text(method_), {}, {}, std::vector<SmoothedColumn>(kept_.columns.size())};
  SmoothedSamples result = values(last - after_, *made);
  forget();
  return result;
}

SmoothedSamples SmoothingStream::finish() {
  require(kept_.count() > 0, "SmoothingStream: need a datum");
  const auto made = smoother(kept_.count());
  return values(first_ + made->spacings(), *made);
}

/// Keeps what the values that were not taken depend on, wherever the data will end.
void SmoothingStream::forget() {
  const std::size_t count = kept_.count();
  std::size_t from = taken_ - first_ > before_ + 1 ? taken_ - first_ - before_ - 1 : 0;
  const auto is_present = [&](std::size_t i) { return !weighted_ || kept_.weights[i] > 0; };
  std::size_t window = count;
  for (std::size_t present = 0; window > 0 && present < end_window_;) present += is_present(--window) ? 1 : 0;
  from = std::min(from, window);
  from = std::min(from, count - std::min(count, 2 * (before_ + after_) + 2));
  for (auto& column : kept_.columns) column.erase(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(from));
  if (weighted_) kept_.weights.erase(kept_.weights.begin(), kept_.weights.begin() + static_cast<std::ptrdiff_t>(from));
  first_ += from;
}

}  // namespace subcert::data
