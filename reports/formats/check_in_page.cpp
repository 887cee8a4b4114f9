#include "check_in_page.hpp"

#include "html.hpp"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <nlohmann/json.hpp>

#include <map>
#include <string_view>

namespace subcert {

extern const std::map<std::string, std::string_view> page_scripts;  // by the names of their files

}  // namespace subcert

namespace subcert::formats {
namespace {

std::string gzipped(const std::string& text) {
  std::string result;
  boost::iostreams::filtering_ostream stream;
  stream.push(
      boost::iostreams::gzip_compressor(boost::iostreams::gzip_params(boost::iostreams::gzip::best_compression)));
  stream.push(boost::iostreams::back_inserter(result));
  stream << text;
  stream.reset();
  return result;
}

std::string base64(const std::string& bytes) {
  using boost::archive::iterators::base64_from_binary;
  using boost::archive::iterators::transform_width;
  using Sextets = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Sextets(bytes.begin()), Sextets(bytes.end()));
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

std::string script_name(const std::string& folder, const RowProof& proof) { return folder + "/" + proof.name + ".js"; }

}  // namespace

std::string check_button(const std::string& folder, const RowProof& proof) {
  if (proof.name.empty()) return "";
  return "<button class=check data-certificate=\"" + html(script_name(folder, proof)) + "\" data-words=\"" +
         html(nlohmann::json(proof.words).dump()) + "\">check this proof here</button><output></output> <a href=\"" +
         html(folder + "/" + proof.name) + "\">file</a>";
}

std::string certificate_script(const std::string& folder, const RowProof& proof) {
  nlohmann::json files;
  for (const auto& [name, text] : proof.files) files[name] = base64(gzipped(text));
  return "subcert_certificate(" + nlohmann::json(script_name(folder, proof)).dump() + ", " + files.dump() + ");\n";
}

std::string check_scripts() {
  return "<script type=\"text/plain\" id=checker>\n" + std::string(page_scripts.at("checker")) +
         "</script>\n<script>\n" + std::string(page_scripts.at("check_here")) + "</script>\n";
}

}  // namespace subcert::formats
