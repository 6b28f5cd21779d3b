// SPDX-License-Identifier: Apache-2.0
// What is no list: illegal registers, windows that are too small, flags that are none, errors on the bus,
// a ray that visits too much; and what is no ray, by name. The job ends, and the next list is good.
// Cores: l1c32t3p1m0
#include "frame/list.hpp"
#include "model_device.hpp"

namespace castray::tb {
namespace {

const SceneImage& image() {
  static const SceneImage image = compile(load_scene("scenes/spheres.json"), 24, 16);
  return image;
}
const std::vector<ray_record_t>& rays() {
  static const std::vector<ray_record_t> rays = random_rays(image(), 90, 2);
  return rays;
}

sim::Answers run(sim::Driver& driver) {
  driver.go();
  EXPECT_EQ(driver.device().wait_interrupt({}), sim::Wait::kInterrupt) << "no interrupt";
  return driver.finish_query();
}
void load(sim::Driver& driver) {
  driver.load(image());
  driver.load_rays(sim::bytes_of(rays()));
  driver.set_list_arguments({});
}
void expect_good_list(Core& core) {
  core.device.memory().set_faults({});
  expect_list(core, image(), rays());
}

// ---- Registers ----
struct Register {
  const char* name;
  error_t error;
  std::function<void(sim::Driver&)> spoil;
};
void PrintTo(const Register& entry, std::ostream* os) { *os << entry.name; }
const Register kRegisters[] = {
    {"NoRays", ErrRegister, [](auto& d) { d.set(RegRayCount, 0); }},
    {"TooManyRays", ErrRegister, [](auto& d) { d.set(RegRayCount, MaxRays + 1); }},
    {"CountStrayBit", ErrRegister, [](auto& d) { d.set(RegRayCount, 90 | 1u << 31); }},
    {"RaysUnaligned", ErrRegister, [](auto& d) { d.set_pointer(RegRays, d.rays_buffer().address + 32); }},
    {"RaysAboveTheBus", ErrRegister, [](auto& d) { d.set_pointer(RegRays, std::uint64_t{1} << 40); }},
    {"RaysPastTheEnd", ErrRegister, [](auto& d) { d.set_pointer(RegRays, (std::uint64_t{1} << 40) - 64); }},
    {"HitsUnaligned", ErrRegister, [](auto& d) { d.set_pointer(RegHits, d.answers_buffer().address + 32); }},
    {"HitsAboveTheBus", ErrRegister, [](auto& d) { d.set_pointer(RegHits, std::uint64_t{1} << 40); }},
    {"UnknownOption", ErrRegister, [](auto& d) { d.set(RegOptions, 1u << OptionList | 1u << NumOptions); }},
    {"RayWindow", ErrRayWindow, [](auto& d) { d.set(RegRayBytes, 90 * RayBytes - 1); }},
    {"HitWindow", ErrHitWindow, [](auto& d) { d.set(RegHitsBytes, 90 * HitBytes - 1); }},
    {"Steps", ErrSteps, [](auto& d) { d.set(RegSteps, 1); }},
};
class ListRegisters : public testing::TestWithParam<Register> {};
INSTANTIATE_TEST_SUITE_P(Table, ListRegisters, testing::ValuesIn(kRegisters), [](const auto& info) { return std::string(info.param.name); });

TEST_P(ListRegisters, EndTheJobWithTheirCode) {
  Core core(core_of(1, "uniform"));
  load(core.driver);
  GetParam().spoil(core.driver);
  EXPECT_EQ(run(core.driver).error, GetParam().error);
  const auto& bus = core.device.memory().counters();
  if (GetParam().error == ErrRegister) EXPECT_EQ(bus.reads + bus.writes, 0u) << "memory was touched";
  EXPECT_TRUE(kept_the_rules(core.device));
  expect_good_list(core);

  sim::ModelDevice model;
  sim::Driver driver(model);
  load(driver);
  GetParam().spoil(driver);
  EXPECT_EQ(run(driver).error, GetParam().error) << "the model";
}

TEST(ListErrors, AFlagThatIsNone) {
  for (const std::size_t at : {std::size_t{0}, std::size_t{41}, rays().size() - 1}) {
    std::vector<ray_record_t> bad = rays();
    bad[at].flags |= 1u << 7;
    Core core(core_of(1, "uniform"));
    core.driver.load(image());
    EXPECT_EQ(core.driver.query(sim::bytes_of(bad)).error, ErrRay);
    EXPECT_EQ(sim::query_model(image(), sim::bytes_of(bad)).error, ErrRay);
    EXPECT_TRUE(kept_the_rules(core.device));
    expect_good_list(core);
  }
}

// ---- The bus ----
struct Fault {
  const char* name;
  error_t error;
  std::function<std::uint64_t(sim::Driver&)> address;
};
void PrintTo(const Fault& entry, std::ostream* os) { *os << entry.name; }
const Fault kFaults[] = {
    {"FirstRay", ErrReadBus, [](auto& d) { return d.rays_buffer().address; }},
    {"ARay", ErrReadBus, [](auto& d) { return d.rays_buffer().address + 50 * RayBytes + 32; }},
    {"LastRay", ErrReadBus, [](auto& d) { return d.rays_buffer().address + 90 * RayBytes - 16; }},
    {"FirstHit", ErrWriteBus, [](auto& d) { return d.answers_buffer().address; }},
    {"LastHit", ErrWriteBus, [](auto& d) { return d.answers_buffer().address + 89 * HitBytes; }},
};
class ListBusErrors : public testing::TestWithParam<Fault> {};
INSTANTIATE_TEST_SUITE_P(Table, ListBusErrors, testing::ValuesIn(kFaults), [](const auto& info) { return std::string(info.param.name); });

TEST_P(ListBusErrors, EndTheJobAndTheNextListIsGood) {
  for (const std::string stalls : {"none", "turn"}) {
    Core core(core_of(1, stalls, 5));
    load(core.driver);
    core.device.memory().set_faults({{GetParam().address(core.driver), 1, sim::kSlvErr}});
    EXPECT_EQ(run(core.driver).error, GetParam().error);
    EXPECT_TRUE(core.device.memory().idle());
    EXPECT_TRUE(kept_the_rules(core.device));
    expect_good_list(core);
  }
}

TEST(ListBusErrors, WindowsWithoutMemory) {
  Core core(core_of(1));
  load(core.driver);
  core.driver.set_pointer(RegRays, 0x1000'0000);
  EXPECT_EQ(run(core.driver).error, ErrReadBus);
  core.driver.set_list_arguments({});
  core.driver.set_pointer(RegHits, 0x1000'0000);
  EXPECT_EQ(run(core.driver).error, ErrWriteBus);
  expect_good_list(core);
}

// ---- What is no ray ----
struct NoRay {
  const char* name;
  std::function<void(ray_record_t&)> spoil;
};
void PrintTo(const NoRay& entry, std::ostream* os) { *os << entry.name; }
const NoRay kNoRays[] = {
    {"ZeroDirection", [](auto& r) { r.dir_x = r.dir_y = r.dir_z = 0; }},
    {"OriginOutside", [](auto& r) { r.org_x = 1u << CoordW; }},
    {"OriginFarOutside", [](auto& r) { r.org_z |= 0x80000000; }},
    {"DirectionTooLong", [](auto& r) { r.dir_x = std::int64_t{1} << (dir_comp_t_bits - 1); }},
    {"DirectionFarTooLong", [](auto& r) { r.dir_y ^= std::int64_t{1} << 62; }},
    {"RangeEmpty", [](auto& r) { r.tmin = r.tmax = 500; }},
    {"RangeReversed", [](auto& r) { r.tmin = 1 << 20, r.tmax = 1 << 19; }},
    {"RangeBehindTheOrigin", [](auto& r) { r.tmin = -1000, r.tmax = -1; }},
    {"RangeEndsAtTheOrigin", [](auto& r) { r.tmin = -1000, r.tmax = 0; }},
    {"RangeBeyondAllDistances", [](auto& r) { r.tmin = TMax, r.tmax = 0x7fffffff; }},
};
class NoRays : public testing::TestWithParam<NoRay> {};
INSTANTIATE_TEST_SUITE_P(Table, NoRays, testing::ValuesIn(kNoRays), [](const auto& info) { return std::string(info.param.name); });

// All rays of a list, and every third.
TEST_P(NoRays, AreMissesAndTheOthersHit) {
  Core core(core_of(1, "uniform"));
  for (const std::size_t step : {1, 3}) {
    std::vector<ray_record_t> list = camera_rays(image());
    for (std::size_t i = 0; i < list.size(); i += step) GetParam().spoil(list[i]);
    for (std::size_t i = 0; i < list.size(); i += 4) list[i].flags |= 1u << RayAnyHit;
    ASSERT_NO_FATAL_FAILURE(expect_list(core, image(), list));
    const sim::Answers answers = core.driver.query(sim::bytes_of(list));
    hit_record_t miss;
    miss.t = TMax, miss.prim = miss.instance_id = NoHit;
    for (std::size_t i = 0; i < list.size(); i += step) ASSERT_TRUE(answers.hit(i) == miss) << i;
    if (step != 1) EXPECT_GT(answers.counters[CntHits], 100u);
  }
}

}  // namespace
}  // namespace castray::tb
