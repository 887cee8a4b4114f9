// Answers many command lines of subcert-check in one process, for tests that have millions: on standard input each is
// its number of words and then the words, all ended by a zero byte; on standard output a line with exit code and
// answer.
#include "check.hpp"

#include <algorithm>
#include <iostream>
#include <sstream>

int main() {
  std::ios::sync_with_stdio(false);
  for (std::string count; std::getline(std::cin, count, '\0');) {
    std::vector<std::string> words(std::stoul(count));
    for (std::string& word : words) std::getline(std::cin, word, '\0');
    std::ostringstream out, errors;
    const int code = subcert_check::run(words, out, errors);
    std::string answer = code > 1 ? errors.str() : out.str();
    std::replace(answer.begin(), answer.end(), '\n', ' ');
    std::cout << code << ' ' << answer << '\n';
    if (std::cin.rdbuf()->in_avail() <= 0) std::cout.flush();
  }
}
