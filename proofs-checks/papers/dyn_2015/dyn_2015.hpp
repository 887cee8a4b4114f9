#pragma once
/// Dyn, Heard, Hormann & Sharon 2015 [DHHS15], statement by statement.

#include <subcert/analysis/symbol/mask.hpp>
#include <subcert/proofs-checks/statements/paper.hpp>

namespace subcert::statements::dyn_2015 {

PaperStatements paper();

/// The mask of S_n.
Mask s_n(long n);
/// `n = 2..10`, or `n = 2`.
std::string range(int first, int last);
/// `n = 2, d = 1`, as in witnesses.
std::string at_n_d(int n, int d);

/// One part of the paper each; `to` grows.
void add_section_2(PaperStatements& to);
void add_section_2_2(PaperStatements& to);
void add_section_3(PaperStatements& to);
void add_section_4(PaperStatements& to);
void add_section_4_3(PaperStatements& to);
void add_section_5(PaperStatements& to);
void add_appendix(PaperStatements& to);

}  // namespace subcert::statements::dyn_2015
