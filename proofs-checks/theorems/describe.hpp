#pragma once
/// What theorems say, in words, once their inequalities are proved. Inner header.

#include "proofs.hpp"

namespace subcert::theorems {

/// Each takes a theorem with its degree and constants, and gives it a title, statements and ranges. `family`: of which
/// it is proved.
void describe_7_degree_one(Theorem& t);
void describe_8_degree_one(Theorem& t);
void describe_7(Theorem& t, const SchemeFamily& family);
void describe_8_n(Theorem& t, const SchemeFamily& family);
void describe_8_d(Theorem& t, const SchemeFamily& family);
void describe_smoothness_degree_one(Theorem& t);
void describe_smoothness(Theorem& t, const SchemeFamily& family);
void describe_every_smoothness(Theorem& t, const SchemeFamily& family);
void describe_rate(Theorem& t, const SchemeFamily& family);
void describe_limit_constants(Theorem& t);
void describe_convergence(Theorem& t);
void describe_large_n(Theorem& t);
void describe_every_n(Theorem& t);
void describe_all_higher(Theorem& t);
void describe_limits_grow(Theorem& t);

}  // namespace subcert::theorems
