// SPDX-License-Identifier: Apache-2.0
// Rays from text and answers to text: what is read, and what is refused with file, line and cause.
#include "cli/query_csv.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cli/command.hpp"

namespace castray::cli {
namespace {

constexpr std::size_t kPrimitives = 12;

RayText parse(const std::string& text) { return parse_rays("r.csv", text, kPrimitives); }

std::string error_of(const std::string& text) {
  try {
    parse(text);
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "no error";
}

TEST(QueryCsv, ReadsAllColumns) {
  const RayText text = parse("ox,oy,oz,dx,dy,dz,tmin,tmax,any,cull,ignore\n1,2.5,-3e2,0,1e-3,+4,0.25,8,1,1,11\n");
  ASSERT_EQ(text.rays.size(), 1u);
  const ListRay& ray = text.rays[0];
  EXPECT_EQ(ray.origin, Vec3(1, 2.5, -300));
  EXPECT_EQ(ray.direction, Vec3(0, 1e-3, 4));
  EXPECT_EQ(ray.tmin, 0.25);
  EXPECT_EQ(ray.tmax, 8);
  EXPECT_TRUE(ray.any);
  EXPECT_TRUE(ray.cull);
  EXPECT_EQ(ray.ignore, 11u);
  EXPECT_EQ(text.lines, std::vector<std::size_t>{2});
}

TEST(QueryCsv, DefaultsOfWhatIsNotGiven) {
  for (const std::string& text : {"ox,oy,oz,dx,dy,dz\n1,2,3,4,5,6\n", "ox,oy,oz,dx,dy,dz,tmin,tmax,any,cull,ignore\n1,2,3,4,5,6,,,,,\n",
                                  "ox,oy,oz,dx,dy,dz,tmax\n1,2,3,4,5,6,inf\n"}) {
    const ListRay ray = parse(text).rays.at(0);
    EXPECT_EQ(ray.tmin, 0);
    EXPECT_TRUE(std::isinf(ray.tmax));
    EXPECT_FALSE(ray.any || ray.cull || ray.ignore);
  }
}

TEST(QueryCsv, ColumnsByNameInAnyOrder) {
  const ListRay ray = parse("dz,any,oy,dx,ox,dy,oz\n1,0,2,3,4,5,6\n").rays.at(0);
  EXPECT_EQ(ray.origin, Vec3(4, 2, 6));
  EXPECT_EQ(ray.direction, Vec3(3, 5, 1));
}

// As spreadsheets and other systems write them; the last line without its end.
TEST(QueryCsv, LinesAndFieldsOfAllKinds) {
  const RayText text = parse("\xef\xbb\xbf# a comment\r\n\r\n ox , oy,\toz,\"dx\",dy,dz\r\n1, 2 ,\"3\",4,5,6\r\n \t\n  # another, with commas\n7,8,9,1,1,1");
  ASSERT_EQ(text.rays.size(), 2u);
  EXPECT_EQ(text.rays[0].origin, Vec3(1, 2, 3));
  EXPECT_EQ(text.rays[1].origin, Vec3(7, 8, 9));
  EXPECT_EQ(text.lines, (std::vector<std::size_t>{4, 7}));
}

TEST(QueryCsv, NumbersAreReadToTheLastBit) {
  const ListRay ray = parse("ox,oy,oz,dx,dy,dz\n0.1,1e-300,-0,1.7976931348623157e308,5e-324,-0.30000000000000004\n").rays.at(0);
  EXPECT_EQ(ray.origin, Vec3(0.1, 1e-300, 0));
  EXPECT_EQ(ray.direction, Vec3(1.7976931348623157e308, 5e-324, -0.1 - 0.2));
}

TEST(QueryCsv, TheFirstLine) {
  EXPECT_EQ(error_of(""), "r.csv:1: empty; its first line must name the columns ox,oy,oz,dx,dy,dz");
  EXPECT_EQ(error_of("\n \n#\n"), "r.csv:3: empty; its first line must name the columns ox,oy,oz,dx,dy,dz");
  EXPECT_EQ(error_of("ox,oy,oz,dx,dy,dz\n"), "r.csv:1: no rays below the columns' names");
  EXPECT_EQ(error_of("ox,oy,oz,dx,dy,dz\n# none\n\n"), "r.csv:3: no rays below the columns' names");
  EXPECT_EQ(error_of("ox,oy,dx,dy,dz\n1,2,3,4,5\n"), "r.csv:1: column 'oz' is missing");
  EXPECT_EQ(error_of("ox,oy,oz,dx,dy,dz,ox\n1,2,3,4,5,6,7\n"), "r.csv:1: column 'ox' stands twice");
  const std::string names = " is no column; there are ox,oy,oz,dx,dy,dz, and if wanted tmin,tmax,any,cull,ignore";
  EXPECT_EQ(error_of("# rays\nox,oy,oz,dx,dy,dz,mask\n"), "r.csv:2: 'mask'" + names);
  EXPECT_EQ(error_of("ox,oy,oz,dx,dy,dz,\n1,2,3,4,5,6,\n"), "r.csv:1: ''" + names);
  EXPECT_EQ(error_of("0,0,4,0,0,-1\n"), "r.csv:1: '0'" + names);
  EXPECT_EQ(error_of("OX,oy,oz,dx,dy,dz\n"), "r.csv:1: 'OX'" + names);
  EXPECT_EQ(error_of("ox;oy;oz;dx;dy;dz\n"), "r.csv:1: 'ox;oy;oz;dx;dy;dz'" + names);
}

TEST(QueryCsv, Fields) {
  const auto error = [](const std::string& line) { return error_of("ox,oy,oz,dx,dy,dz\n1,2,3,4,5,6\n" + line + "\n1,2,3,4,5,6\n"); };
  EXPECT_EQ(error("1,2,3,4,5"), "r.csv:3: 5 fields, the first line names 6 columns");
  EXPECT_EQ(error("1,2,3,4,5,6,7"), "r.csv:3: 7 fields, the first line names 6 columns");
  EXPECT_EQ(error("1,2,3,4,5,6,"), "r.csv:3: 7 fields, the first line names 6 columns");
  EXPECT_EQ(error("1"), "r.csv:3: 1 field, the first line names 6 columns");
  EXPECT_EQ(error("1,,3,4,5,6"), "r.csv:3: oy: empty");
  EXPECT_EQ(error("1,2,3,4,5, "), "r.csv:3: dz: empty");
  for (const std::string word : {"x", "1x", "1 2", "--1", "+-1", "+", "0x10", "1e", "1.2.3", "1;2"})
    EXPECT_EQ(error("1,2," + word + ",4,5,6"), "r.csv:3: oz: '" + word + "' is not a number");
  for (const std::string word : {"nan", "NaN", "-nan"}) EXPECT_EQ(error("1,2,3,4," + word + ",6"), "r.csv:3: dy: '" + word + "' is not a number");
  for (const std::string word : {"inf", "-inf", "Infinity"}) {
    EXPECT_EQ(error("1,2,3," + word + ",5,6"), "r.csv:3: dx: '" + word + "' is not finite");
    EXPECT_EQ(error(word + ",2,3,4,5,6"), "r.csv:3: ox: '" + word + "' is not finite");
  }
  EXPECT_EQ(error("1e400,2,3,4,5,6"), "r.csv:3: ox: '1e400' is beyond what a double holds");
  EXPECT_EQ(error("1,1e19,3,4,5,6"), "r.csv:3: oy: 1e+19 is outside the number range, +-2^60");
  EXPECT_EQ(error("1,2,3,0,-0,0.0"), "r.csv:3: the direction is zero");
}

TEST(QueryCsv, NothingInAMessageMovesACursor) {
  using namespace std::string_literals;
  EXPECT_EQ(error_of("ox,oy,oz,dx,dy,dz\n1\0002,2,3,4,5,6\n"s), "r.csv:2: ox: '1?2' is not a number");
  EXPECT_EQ(error_of("ox,oy,oz,dx,dy,dz\n\x1b[2J,2,3,4,5,6\n"), "r.csv:2: ox: '?[2J' is not a number");
  EXPECT_EQ(error_of("ox,oy,oz,dx,dy,dz\n" + std::string(1000, '1') + "x,2,3,4,5,6\n"), "r.csv:2: ox: '" + std::string(40, '1') + "...' is not a number");
  EXPECT_NE(error_of(std::string(1 << 16, '\0')), "no error");
}

TEST(QueryCsv, Ranges) {
  const auto error = [](const std::string& tmin, const std::string& tmax) {
    return error_of("ox,oy,oz,dx,dy,dz,tmin,tmax\n1,2,3,4,5,6," + tmin + "," + tmax + "\n");
  };
  EXPECT_EQ(error("1", "1.5"), "no error");
  EXPECT_EQ(error("-1", "1.5"), "no error");
  EXPECT_EQ(error("1", ""), "no error");
  EXPECT_EQ(error("2", "1.5"), "r.csv:2: empty range: tmin 2, tmax 1.5");
  EXPECT_EQ(error("2", "2"), "r.csv:2: empty range: tmin 2, tmax 2");
  EXPECT_EQ(error("", "0"), "r.csv:2: empty range: tmin 0, tmax 0");
  EXPECT_EQ(error("-2", "-1"), "r.csv:2: empty range: tmin -2, tmax -1");
  EXPECT_EQ(error("", "-inf"), "r.csv:2: empty range: tmin 0, tmax -inf");
  EXPECT_EQ(error("inf", ""), "r.csv:2: tmin: 'inf' is not finite");
  EXPECT_EQ(error("nan", "1"), "r.csv:2: tmin: 'nan' is not a number");
  EXPECT_EQ(error("0", "nan"), "r.csv:2: tmax: 'nan' is not a number");
}

TEST(QueryCsv, FlagsAndPrimitives) {
  const auto error = [](const std::string& any, const std::string& cull, const std::string& ignore) {
    return error_of("ox,oy,oz,dx,dy,dz,any,cull,ignore\n1,2,3,4,5,6," + any + "," + cull + "," + ignore + "\n");
  };
  EXPECT_EQ(error("0", "1", "0"), "no error");
  EXPECT_EQ(error("1", "0", "11"), "no error");
  for (const std::string word : {"2", "-1", "true", "1.0", "01"}) {
    EXPECT_EQ(error(word, "0", "0"), "r.csv:2: any: '" + word + "' is neither 0 nor 1");
    EXPECT_EQ(error("0", word, "0"), "r.csv:2: cull: '" + word + "' is neither 0 nor 1");
  }
  for (const std::string word : {"12", "-1", "4294967295", "99999999999999999999", "1.5", "x"})
    EXPECT_EQ(error("0", "0", word), "r.csv:2: ignore: '" + word + "' is no primitive's number; the scene has 12");
}

TEST(QueryCsv, Answers) {
  const std::vector<Answer> answers{{.hit = true, .prim = 7, .distance = 0.1, .t = 2.0625, .u = 0.25, .v = 0x1p-24},
                                    {},
                                    {.hit = true},
                                    {.hit = true, .prim = 0, .distance = 1e300, .u = 0, .v = 1}};
  EXPECT_EQ(text_of(answers),
            "hit,prim,distance,t,u,v\n"
            "1,7,0.1,2.0625,0.25,5.960464477539063e-08\n"
            "0,,,,,\n"
            "1,,,,,\n"
            "1,0,1e+300,,0,1\n");
  EXPECT_EQ(text_of(std::vector<Answer>{}), "hit,prim,distance,t,u,v\n");
}

}  // namespace
}  // namespace castray::cli
