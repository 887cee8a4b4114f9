#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("certificates are written and verified") {
  const Folder folder;
  const std::string file = folder / "file.cert";
  for (const char* scheme : {"dd:n=3", "four-point:w=1/20"}) {
    CHECK(run(std::string("regularity ") + scheme + " --certificate " + file).code == 0);
    CHECK(run("verify " + file).code == 0);
  }
  CHECK(run("regularity dual-odd:n=2 --certificate " + file).code == 0);
  const Run verified = run("verify " + file);
  CHECK(verified.code == 0);
  CHECK(verified.out.find(": VERIFIED ") != std::string::npos);
  // One digit of one vertex changed.
  std::string text = content(file);
  const std::size_t vertex = text.find("vertex ") + 12;
  text[vertex] = text[vertex] == '1' ? '2' : '1';
  std::ofstream(file, std::ios::binary) << text;
  const Run rejected = run("verify " + file);
  CHECK(rejected.code == 1);
  CHECK(rejected.out.find(": REJECTED ") != std::string::npos);
  std::ofstream(file, std::ios::binary) << "nonsense\n";
  CHECK(run("verify " + file).code == 65);
  std::filesystem::remove(file);
  CHECK(run("verify " + file).code == 66);
  CHECK(run("regularity 'mask:[1,1]' --certificate " + file).code == 64);
  CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("the certificate of a surface is verified by its claim line") {
  const Folder folder;
  const std::string file = folder / "hat.cert";
  const std::string text =
      "subcert-certificate 3\nsurface [1,2,1]/2@-1 [2]\nbounds 1 1\nsum-rules 2\ndigits 0 1\nspace 1\n"
      "vector -1:1 0:-2 1:1\ngram 0:4 1:1\nproduct 0 1/2 0 0\nblock 0 norm 1\nend\n";
  std::ofstream(file, std::ios::binary) << text;
  const Run verified = run("verify " + file);
  CHECK(verified.code == 0);
  CHECK(verified.out.find(": VERIFIED 1 <= Hoelder exponent <= 1 of [1,2,1]/2@-1 with dilation [2]") !=
        std::string::npos);
  std::ofstream(file, std::ios::binary) << text.substr(0, text.find("gram")) + text.substr(text.find("product"));
  CHECK(run("verify " + file).code == 1);
}
