#include "check.hpp"

#include <gmp.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>

namespace {

// Hard caps, whatever is in the files: the work that is counted is less, as a rule.
constexpr rlim_t most_memory = 1UL << 30;  // bytes
constexpr rlim_t most_seconds = 10;        // of the processor

[[noreturn]] void give_up(const char* answer) {
  if (write(STDOUT_FILENO, answer, std::strlen(answer)) < 0) _exit(70);
  _exit(1);
}

void* allocate(std::size_t size) {
  void* memory = std::malloc(size);
  if (!memory) give_up("REJECTED more memory than the checker allows, line 0\n");
  return memory;
}

void* reallocate(void* memory, std::size_t, std::size_t size) {
  memory = std::realloc(memory, size);
  if (!memory) give_up("REJECTED more memory than the checker allows, line 0\n");
  return memory;
}

void release(void* memory, std::size_t) { std::free(memory); }

/// GMP ends the program where there is no memory left; this one answers.
[[maybe_unused]] void set_caps() {
  mp_set_memory_functions(allocate, reallocate, release);
  std::signal(SIGXCPU, [](int) { give_up("REJECTED more time than the checker allows, line 0\n"); });
  const rlimit seconds{most_seconds, most_seconds + 1}, memory{most_memory, most_memory};
  setrlimit(RLIMIT_CPU, &seconds);
  setrlimit(RLIMIT_AS, &memory);
}

}  // namespace

int main(int argc, char** argv) {
#ifndef __SANITIZE_ADDRESS__  // which takes more of both
  set_caps();
#endif
  return subcert_check::run({argv + (argc > 0), argv + argc}, std::cout, std::cerr);
}
