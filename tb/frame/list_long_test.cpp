// SPDX-License-Identifier: Apache-2.0
// Random rays in random scenes as lists: in the model the hierarchy against brute force, CASTRAY_RAYS of them,
// and a tenth of them through three lanes. Any-hit rays say yes exactly where there is a nearest hit.
// Cores: l3c32t3p2m128
// Long: CASTRAY_RAYS=1000000
#include "frame/list.hpp"
#include "frame/random_scene.hpp"

namespace castray::tb {
namespace {

constexpr std::size_t kListed = 1000;   // rays of one scene

std::size_t rays_asked_for() {
  const char* text = std::getenv("CASTRAY_RAYS");
  return text ? static_cast<std::size_t>(std::atoll(text)) : 20000;
}

// What was compared.
struct Totals {
  std::size_t rays = 0, hits = 0, any = 0, yes = 0, culled = 0, limited = 0, ignoring = 0;
  void add(const std::vector<ray_record_t>& list, const sim::Answers& answers) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      const bool any_hit = list[i].flags >> RayAnyHit & 1, hit = is_yes(answers.hit(i));
      ++rays;
      hits += hit;
      any += any_hit;
      yes += any_hit && hit;
      culled += list[i].flags >> RayCull & 1;
      limited += list[i].tmin > 0 || list[i].tmax < TMax;
      ignoring += list[i].ignore != static_cast<std::uint64_t>(NoHit);
    }
  }
  void print(const char* what) const {
    std::printf("%s: %zu rays, %zu hit; %zu any-hit rays, %zu say yes; %zu cull, %zu have limits, %zu ignore a primitive: 0 records differ\n", what,
                rays, hits, any, yes, culled, limited, ignoring);
    for (const std::size_t part : {hits, any - yes, yes, culled, limited, ignoring}) EXPECT_GT(part, rays / 50);
  }
};

struct List {
  SceneImage image;
  std::vector<ray_record_t> rays;
};
List random_list(unsigned seed) {
  const RandomScene random = random_scene(seed);
  List list{compile(random.scene, random.scene.width, random.scene.height), {}};
  list.rays = random_rays(list.image, kListed, seed);
  return list;
}

TEST(LongLists, HierarchyEqualsBruteForceInTheModel) {
  Totals totals;
  for (unsigned seed = 0; totals.rays < rays_asked_for(); ++seed) {
    const List list = random_list(seed);
    const auto bytes = sim::bytes_of(list.rays);
    const sim::Answers tree = sim::query_model(list.image, bytes), brute = sim::query_model(list.image, bytes, {.mode = sim::Mode::kBrute});
    ASSERT_TRUE(equal(tree, brute, list.rays)) << "seed " << seed;
    ASSERT_NO_FATAL_FAILURE(expect_any_is_nearest(list.image, list.rays, tree)) << "seed " << seed;
    totals.add(list.rays, tree);
  }
  totals.print("the model, hierarchy against brute force");
}

TEST(LongLists, ThreeLanesEqualTheModelAndBruteForce) {
  Core core(core_of(3));
  Totals totals;
  std::uint64_t cycles = 0;
  for (unsigned seed = 0; totals.rays < rays_asked_for() / 10; ++seed) {
    const List list = random_list(seed);
    core.driver.load(list.image);
    const auto bytes = sim::bytes_of(list.rays);
    const sim::Answers rtl = core.driver.query(bytes);
    ASSERT_TRUE(equal(rtl, sim::query_model(list.image, bytes), list.rays)) << "seed " << seed;
    ASSERT_TRUE(equal(rtl, sim::query_model(list.image, bytes, {.mode = sim::Mode::kBrute}), list.rays)) << "seed " << seed;
    ASSERT_TRUE(kept_the_rules(core.device));
    totals.add(list.rays, rtl);
    cycles += rtl.cycles();
  }
  totals.print("three lanes against the model and brute force");
  std::printf("%.2f cycles a ray\n", double(cycles) / double(totals.rays));
}

}  // namespace
}  // namespace castray::tb
