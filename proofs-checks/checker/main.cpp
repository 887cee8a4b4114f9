#include "check.hpp"

#include <iostream>

int main(int argc, char** argv) { return subcert_check::run({argv + (argc > 0), argv + argc}, std::cout, std::cerr); }
