#pragma once
/// Which program made a page or an answer.

namespace subcert::formats {

const char* version();
/// The commit of the sources; empty where they were no repository.
const char* commit();
/// The day of that commit, as 2026-11-23; empty where there is none.
const char* date();

}  // namespace subcert::formats
