#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/folder.hpp>
#include <subcert/proofs-checks/atlas/atlas.hpp>
#include <subcert/proofs-checks/atlas/canonical_mask.hpp>

#include <fstream>

using namespace subcert;
using namespace subcert::atlas;
using subcert::testing::content;
using subcert::testing::error_kind;
using subcert::testing::Folder;

namespace {

Mask canonical(const char* text, int arity = 2) { return canonical_mask({LaurentPolynomial::parse_mask(text), arity}); }

/// What the program answers, shortened.
Json answers() {
  return Json::parse(R"({"scheme": "", "keys": {}, "errors": {}, "answers": {"regularity": {"converges": "yes",
    "holder": {"lower": "2", "upper": "2"}, "exact": true, "closed": true, "product": "0", "formula": null,
    "logarithm": {"at_least": 1, "at_most": 1, "reason": "growth"},
    "sobolev": {"exponent": {"lower": "2.4", "upper": "2.5"}}},
    "variance": {"sup": {"lower": "1", "upper": "1"}, "mean": "3/4"}}, "certificate": "a text"})");
}

Json entry(const Mask& mask) { return entry_of(mask, usual_plan(), answers(), "1.0"); }

}  // namespace

TEST_CASE("entry: what it says") {
  const Json found = entry(canonical("[-1,0,9,16,9,0,-1]/16"));
  for (const Member& member : entry_members()) CHECK((member.name == "names" || found.contains(member.name)));
  CHECK(found.size() + 1 == entry_members().size());
  CHECK(found.at("id") == entry_id(canonical("[-1,0,9,16,9,0,-1]/16")));
  CHECK(found.at("support") == "6");
  CHECK(found.at("interpolatory") == true);
  CHECK(found.at("non_negative") == false);
  CHECK(found.at("symmetry") == "odd");
  CHECK(found.at("sum_rules") == 4);
  CHECK(found.at("reproduction_degree") == 3);
  CHECK(found.at("remaining_factor") == "[-1,4,-1]/16@0");
  CHECK(found.at("holder").at("upper") == "2");
  CHECK(found.at("attained") == false);
  CHECK(found.at("stable") == "yes");
  CHECK(found.at("noise_factor").at("upper") == "1");
  CHECK_FALSE(is_open(found));
  CHECK(entry(canonical("[1,3,3,1]/4")).at("interpolatory") == false);
  CHECK(entry(canonical("[1,1]", 2)).at("interpolatory") == true);

  Json none = answers();
  none["answers"]["regularity"]["converges"] = "no";
  none["answers"]["regularity"]["closed"] = false;
  none["answers"].erase("variance");
  none.erase("certificate");
  const Json divergent = entry_of(canonical("[1,0,0,1]"), usual_plan(), none, "1.0");
  for (const char* name : {"holder", "attained", "sobolev", "noise_factor", "certificate"})
    CHECK(divergent.at(name).is_null());
  CHECK(divergent.at("stable") == "no");
  CHECK_FALSE(is_open(divergent));

  none["errors"]["regularity"] = "ended by signal 11";
  CHECK_THROWS_AS(entry_of(canonical("[1,1]"), usual_plan(), none, "1.0"), Error);
  for (const char* scheme : {"daubechies:n=2", "tensor:(dd:n=1)x(dd:n=1)x(dd:n=1)"})
    CHECK_THROWS_AS(mask_of_entry(make_linear_scheme(scheme)), Error);
}

TEST_CASE("database: entries, names and certificates") {
  const Folder folder;
  const std::string file = folder / "deep/atlas.sqlite";
  const Json one = entry(canonical("[1,2,1]/2")), two = entry(canonical("[1,3,3,1]/4")),
             other = entry(canonical("[1,1,1]", 3));
  {
    Database database(file, Database::Access::write);
    for (const Json& each : {other, two, one})
      database.put(each, "certificate of " + each.at("mask").get<std::string>());
    const auto id = two.at("id").get<std::string>();
    for (const char* name : {"dual:n=1,d=1", "chaikin", "chaikin"}) database.add_name(id, name);
    Json again = two;
    again["budget"] = 60.0;
    database.put(again, std::nullopt);
    CHECK_THROWS_AS(database.together([&] {
      database.add_name(id, "of no use");
      throw std::runtime_error("stopped");
    }),
                    std::runtime_error);
    Json twin = one;
    twin["id"] = id;
    CHECK(error_kind([&] { database.put(twin, std::nullopt); }) == ErrorKind::data);
  }
  const Database database(file, Database::Access::read);
  CHECK(database.count() == 3);
  const auto found = database.find(two.at("id").get<std::string>());
  REQUIRE(found);
  CHECK(found->at("names") == Json({"chaikin", "dual:n=1,d=1"}));
  CHECK(found->at("budget") == 60.0);
  CHECK_FALSE(database.find("0123456789ab"));
  CHECK_FALSE(database.certificate(two.at("id").get<std::string>()));
  CHECK(database.certificate(one.at("id").get<std::string>()) == "certificate of mask:[1,2,1]/2@0");
  std::vector<std::string> order;
  database.for_each([&](const Json& each) { order.push_back(each.at("mask").get<std::string>()); });
  CHECK(order == std::vector<std::string>{"mask:[1,2,1]/2@0", "mask:[1,3,3,1]/4@0", "mask:[1,1,1]@0,arity=3"});
}

TEST_CASE("database: one writes at a time") {
  const Folder folder;
  const std::string file = folder / "atlas.sqlite";
  Database first(file, Database::Access::write), second(file, Database::Access::write);
  const Json one = entry(canonical("[1,2,1]/2"));
  first.together([&] {
    first.put(one, std::nullopt);
    CHECK(second.count() == 0);  // what is not whole is not seen
    CHECK_FAILS(second.put(one, std::nullopt), usage);
  });
  CHECK(second.count() == 1);
}

TEST_CASE("database: what a killed process left half is taken back, also by those that read") {
  const Folder folder;
  const std::string file = folder / "atlas.sqlite", left = folder / "left.sqlite";
  Database database(file, Database::Access::write);
  database.put(entry(canonical("[1,2,1]/2")), std::nullopt);
  database.together([&] {
    for (int n = 1; n < 400; ++n)  // more than SQLite holds in memory
      database.put(entry(canonical_mask({LaurentPolynomial({1, n, 1 - n, 1}, 0), 2})), std::string(20'000, 'c'));
    for (const char* part : {"", "-journal"})  // as on disk if this process ended now
      std::filesystem::copy_file(file + part, left + part);
  });
  CHECK(database.count() == 400);
  CHECK(Database(left, Database::Access::read).count() == 1);
  const std::string empty = folder.write("empty", "");
  std::size_t count = 0;
  Atlas({empty, left}).for_each([&](const Json&) { ++count; });
  CHECK(count == 1);
}

TEST_CASE("database: what is no atlas is refused and left as it is") {
  const Folder folder;
  const auto opened = [](const std::string& file, Database::Access access) {
    return [=] { Database(file, access).count(); };
  };
  CHECK(error_kind(opened(folder / "none", Database::Access::read)) == ErrorKind::missing_file);
  CHECK(error_kind(opened(folder / "", Database::Access::write)) == ErrorKind::missing_file);
  const std::string text = folder.write("text", std::string(5000, 'x'));
  for (const auto access : {Database::Access::read, Database::Access::write})
    CHECK(error_kind(opened(text, access)) == ErrorKind::data);
  CHECK(content(text) == std::string(5000, 'x'));

  const std::string file = folder / "atlas.sqlite";
  {
    Database database(file, Database::Access::write);
    for (int n = 1; n < 200; ++n)
      database.put(entry(canonical_mask({LaurentPolynomial({1, n, 1 - n, 1}, 0), 2})), std::string(200, 'c'));
  }
  const std::string whole = content(file);
  std::string other = whole;
  other[63] = 9;  // the number of the tables
  CHECK(error_kind(opened(folder.write("other", other), Database::Access::write)) == ErrorKind::data);
  other = whole;
  other[68] = 1;  // whose file it is
  CHECK(error_kind(opened(folder.write("foreign", other), Database::Access::write)) == ErrorKind::data);
  // An entry that lacks a member, or has another kind of it.
  for (const auto& [from, to] : {std::pair("\"budget\":", "\"budgte\":"), std::pair("\"holder\":{", "\"holder\":[")}) {
    other = whole;
    for (std::size_t at = other.find(from); at != std::string::npos; at = other.find(from, at))
      other.replace(at, std::string(to).size(), to);
    CHECK(error_kind([&] {
            Database(folder.write("changed", other), Database::Access::read).for_each([](const Json&) {});
          }) == ErrorKind::data);
  }
  // Cut, or overwritten in the middle: every question either is answered or refused as bad data.
  for (std::size_t size : {100UL, whole.size() / 3, whole.size() - 5000}) {
    const std::string cut = folder.write("cut", whole.substr(0, size));
    CHECK(error_kind([&] { Database(cut, Database::Access::read).for_each([](const Json&) {}); }) == ErrorKind::data);
  }
  for (std::size_t at = 4096; at + 4096 < whole.size(); at += 4096) {
    std::string damaged = whole;
    damaged.replace(at, 4096, std::string(4096, '\xff'));
    const Database database(folder.write("damaged", damaged), Database::Access::read);
    try {
      database.for_each([](const Json&) {});
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::data);
    }
  }
}

TEST_CASE("what a build computes again") {
  sweeps::SweepPlan plan = usual_plan(), certified = plan;
  certified.certificates = true;
  Json closed = entry(canonical("[1,2,1]/2"));
  CHECK_FALSE(is_wanted(closed, certified));
  closed["certificate"] = nullptr;
  CHECK_FALSE(is_wanted(closed, plan));
  CHECK(is_wanted(closed, certified));
  certified.budget = 5;  // what it had was more
  CHECK_FALSE(is_wanted(closed, certified));
  certified.budget = 20;
  closed["certificate"] = "none";
  CHECK_FALSE(is_wanted(closed, certified));
  Json open = closed;
  open["closed"] = false;
  CHECK_FALSE(is_wanted(open, plan));
  CHECK(is_wanted(open, certified));
}

TEST_CASE("query: known names, exact, three answers") {
  const Json found = entry(canonical("[-1,0,9,16,9,0,-1]/16"));
  const auto truth = [&](const std::string& text) {
    return parse_query(text).holds([&](const std::string& name) { return sweeps::member_at(found, name); });
  };
  CHECK(truth("holder >= 2 and support <= 6 and interpolatory") == Truth::yes);
  CHECK(truth("holder > 2") == Truth::no);
  CHECK(truth("sobolev > 2.45") == Truth::unknown);
  CHECK(truth("symmetric and attained") == Truth::no);
  CHECK(truth("logarithm.at_least == 1") == Truth::yes);
  CHECK(truth("formula == none") == Truth::unknown);
  Json none = found;
  none["converges"] = "no";
  none["holder"] = nullptr;
  CHECK(atlas::meets(none, parse_query("holder > 2")) == Truth::no);
  CHECK(atlas::meets(none, parse_query("holder.lower > 2")) == Truth::no);
  CHECK(atlas::meets(none, parse_query("interpolatory and converges == no")) == Truth::yes);
  CHECK(atlas::meets(found, parse_query("formula == none")) == Truth::unknown);
  CHECK_THROWS_AS(parse_query("holdr > 2"), ParseError);
  CHECK_THROWS_AS(parse_query("holder 2"), ParseError);
  CHECK_THROWS_AS(parse_query(""), ParseError);
}
