// Whatever the bytes, a specification is refused with SpecificationError or reads back as itself.

#include <subcert/schemes/specification.hpp>

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const subcert::AnyScheme once = subcert::make_any_scheme({reinterpret_cast<const char*>(data), size});
    const subcert::AnyScheme twice = subcert::make_any_scheme(subcert::specification_of(once));
    const auto same = [&](const auto& scheme) {
      const auto& again = std::get<std::decay_t<decltype(scheme)>>(twice);
      if constexpr (requires { scheme.mask; })
        return scheme.mask == again.mask;
      else
        return scheme.title == again.title;
    };
    if (subcert::specification_of(once) != subcert::specification_of(twice) || !std::visit(same, once)) std::abort();
  } catch (const subcert::SpecificationError&) {
  }
  return 0;
}
