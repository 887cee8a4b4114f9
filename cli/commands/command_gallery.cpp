// subcert gallery SCHEME...: what is known of schemes, drawn on one page
// subcert gallery --vertices [--valence 3..8] [SCHEME|FILE.toml...]

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/pages/plates.hpp>
#include <subcert/cli/pages/vertex_gallery.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/cli/vertex_arguments.hpp>
#include <subcert/reports/gallery/gallery.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/format.h>

#include <iostream>

namespace subcert::cli {
namespace {

constexpr double gallery_budget = 5;
constexpr const char* usual_valences = "3..8";

struct GalleryOptions : SearchOptions {
  std::vector<std::string> schemes;
  bool all = false;
  bool open = false;
  bool vertices = false;
  std::string valence = usual_valences;
};

/// Writes the page, or the data, and says so.
void answer(const GalleryOptions& options, const Json& json, const std::string& page, std::size_t schemes) {
  if (options.json) return options.answer(json);
  const std::string file = options.out.empty() ? "gallery.html" : options.out;
  runtime::write_file(file, page);
  if (!options.quiet) std::cout << file << ": " << schemes << (schemes == 1 ? " scheme\n" : " schemes\n");
}

/// Schemes at vertices. Those of the list are what they are.
ExitCode run_vertices(const GalleryOptions& options) {
  if (options.open) fail(ErrorKind::usage, "--open: polygons are not drawn with --vertices");
  if (options.all && !options.schemes.empty())
    fail(ErrorKind::usage, "--all: takes no schemes, got '{}'", options.schemes.front());
  const std::vector<int> valences = parse_number_list("--valence", options.valence, smallest_valence, largest_valence);
  std::vector<VertexScheme> schemes;
  for (const std::string& scheme : options.schemes.empty() ? vertex_gallery_schemes() : options.schemes)
    require_values(schemes.emplace_back(read_vertex_scheme(scheme)), "gallery");
  const std::vector<VertexPlate> plates = make_vertex_plates(schemes, valences, options);
  answer(options, options.json ? vertex_plates_json(plates) : Json(),
         options.json ? std::string() : vertex_gallery_html(plates), plates.size());
  return options.schemes.empty() ? done : exit_code(plates);
}

std::vector<reports::GalleryScheme> wanted(const GalleryOptions& options) {
  if (options.schemes.empty()) return reports::gallery_schemes();
  if (options.all) fail(ErrorKind::usage, "--all: takes no schemes, got '{}'", options.schemes.front());
  std::vector<reports::GalleryScheme> result;
  for (const std::string& scheme : options.schemes) {
    static_cast<void>(make_refinable_scheme(scheme));  // errors before work
    result.push_back({scheme});
  }
  return result;
}

ExitCode run(const GalleryOptions& options) {
  if (options.vertices) return run_vertices(options);
  if (options.valence != usual_valences) fail(ErrorKind::usage, "--valence: needs --vertices beside it");
  const std::vector<reports::GalleryScheme> schemes = wanted(options);
  const std::vector<reports::Plate> plates = make_plates(schemes, {options.budget, options.memory << 20, options.open},
                                                         options);
  answer(options, options.json ? plates_json(plates) : Json(),
         options.json ? std::string() : reports::gallery_html(plates), plates.size());
  return exit_code(schemes, plates);
}

}  // namespace

void add_gallery(Command& app) {
  auto options = std::make_shared<GalleryOptions>();
  options->budget = gallery_budget;
  Command command = add_command(app, "gallery", "Schemes on one page, with pictures of their limits",
                                "subcert gallery primal:n=3 four-point:w=1/16 --out page.html", options,
                                [=] { return run(*options); });
  command.option("SCHEME", options->schemes, "Scheme specifications; none: forty schemes of the literature");
  command.flag("--all", options->all, "The forty schemes, as without arguments");
  command.flag("--open", options->open, "The polygon that is refined is an open one");
  command.flag("--vertices", options->vertices,
               "Surface schemes at vertices, with their characteristic maps; none named: seven of the literature");
  command
      .option("--valence", options->valence,
              fmt::format("With --vertices: valences, as 3..12 or 3,5,8..10, up to {}", largest_valence))
      .with_default();
  command.existing("--out").describe("The page, gallery.html if not given; with --json the data");
  add_limits(command, *options);
}

}  // namespace subcert::cli
