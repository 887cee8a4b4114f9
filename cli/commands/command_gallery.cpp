// subcert gallery SCHEME...: what is known of schemes, drawn on one page

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/pages/plates.hpp>
#include <subcert/reports/gallery/gallery.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <iostream>

namespace subcert::cli {
namespace {

constexpr double gallery_budget = 5;

struct GalleryOptions : SearchOptions {
  std::vector<std::string> schemes;
  bool all = false;
  bool open = false;
};

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
  const std::vector<reports::GalleryScheme> schemes = wanted(options);
  const std::vector<reports::Plate> plates = make_plates(schemes, {options.budget, options.memory << 20, options.open},
                                                         options);
  if (options.json) {
    options.answer(plates_json(plates));
  } else {
    const std::string file = options.out.empty() ? "gallery.html" : options.out;
    runtime::write_file(file, reports::gallery_html(plates));
    if (!options.quiet) std::cout << file << ": " << plates.size() << (plates.size() == 1 ? " scheme\n" : " schemes\n");
  }
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
  command.existing("--out").describe("The page, gallery.html if not given; with --json the data");
  add_limits(command, *options);
}

}  // namespace subcert::cli
