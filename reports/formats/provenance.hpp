#pragma once
/// Which program made a page or an answer.

namespace subcert::formats {

const char* version();
/// The commit of the sources; empty where they were no repository.
const char* commit();

}  // namespace subcert::formats
