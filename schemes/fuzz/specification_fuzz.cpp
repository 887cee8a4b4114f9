// Whatever the bytes, a specification is refused with SpecificationError or reads back as itself.

#include <subcert/schemes/specification.hpp>

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const subcert::Scheme once = subcert::make_scheme({reinterpret_cast<const char*>(data), size});
    const subcert::Scheme twice = subcert::make_scheme(once.specification);
    if (!(once.mask == twice.mask) || once.specification != twice.specification) std::abort();
  } catch (const subcert::SpecificationError&) {
  }
  return 0;
}
