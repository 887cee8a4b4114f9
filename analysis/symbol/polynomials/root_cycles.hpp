#pragma once
/// Cycles of roots of unity, at which a mask with unstable shifts may be 0.

#include <optional>
#include <vector>

namespace subcert {

/// The numbers omega^h, h = a^i or -a^i, for a root of unity omega of this order: e^(2 pi i e/order) for all e of
/// `half` and their conjugates. Canonical: the first e of `half` is the least, no number and its conjugate are both in
/// it.
struct RootCycle {
  long order = 1;
  std::vector<long> half;
  long size = 1;
};

/// All cycles of at most `most` numbers, of orders above 1 and coprime to a; nothing where orders above 2^20 would have
/// to be looked at. Domain: a >= 2. Cost: about a^(most / 2). Proof: proofs-checks/certificates/SPEC.md, theorem 43.
std::optional<std::vector<RootCycle>> root_cycles(long a, long most);

}  // namespace subcert
