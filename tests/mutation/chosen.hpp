/// Which formula is wrong.
#pragma once

namespace mutation {

/// Number of the formula that is wrong in this process, from the environment variable PELAGIC_MUTANT; 0: none.
extern const int chosen;

}  // namespace mutation
