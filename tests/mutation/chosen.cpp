#include "mutation/chosen.hpp"

#include <cstdlib>

namespace {

int fromEnvironment() {
  const char* number = std::getenv("PELAGIC_MUTANT");
  return number ? std::atoi(number) : 0;
}

}  // namespace

const int mutation::chosen = fromEnvironment();
