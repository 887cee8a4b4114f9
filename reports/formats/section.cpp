#include "section.hpp"

#include "html.hpp"

#include <subcert/proofs-checks/certificates/identity.hpp>

#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <nlohmann/json.hpp>

#include <map>

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

std::string script_name(const std::string& folder, const RowProof& proof) { return folder + "/" + proof.name + ".js"; }

nlohmann::json packed_files(const RowProof& proof) {
  nlohmann::json files;
  for (const auto& [name, text] : proof.files) files[name] = base64(gzipped(text));
  return files;
}

/// Empty for a proof without its file.
std::string certificate_id(const RowProof& proof) {
  for (const auto& [name, text] : proof.files)
    if (name == proof.name) return content_id(text);
  return {};
}

std::string button(const std::string& certificate, const RowProof& proof) {
  const std::string scheme = proof.scheme.empty() ? "" : " data-scheme=\"" + html(proof.scheme) + "\"";
  return "<button type=button class=check data-certificate=\"" + html(certificate) + "\" data-words=\"" +
         html(nlohmann::json(proof.words).dump()) + "\"" + scheme + ">check this proof here</button><output></output>";
}

}  // namespace

std::string check_button(const std::string& folder, const RowProof& proof) {
  if (proof.name.empty()) return "";
  return button(script_name(folder, proof), proof) + " <a href=\"" + html(folder + "/" + proof.name) +
         "\" title=\"SHA-256 " + certificate_id(proof) + "\">file</a>";
}

std::string check_button_inside(const RowProof& proof) {
  return button(proof.name, proof) + data_script("file:" + proof.name, packed_files(proof).dump());
}

std::string certificate_script(const std::string& folder, const RowProof& proof) {
  return "subcert_file(" + nlohmann::json(script_name(folder, proof)).dump() + ", " + packed_files(proof).dump() +
         ");\n";
}

}  // namespace subcert::formats
