#pragma once
// For tests of errors: CHECK_FAILS(expression, kind) passes where the expression throws an Error of this kind.

#include <subcert/analysis/symbol/support/error.hpp>

#include <optional>

namespace subcert::testing {

/// The kind of the Error that the call throws; nothing where it throws none.
template <class Call>
std::optional<ErrorKind> error_kind(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.kind();
  }
  return std::nullopt;
}

}  // namespace subcert::testing

#define CHECK_FAILS(expression, kind) \
  CHECK(subcert::testing::error_kind([&] { static_cast<void>(expression); }) == subcert::ErrorKind::kind)
