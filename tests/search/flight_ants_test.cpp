// Flights as ants see them, against the walk over the ground that the search makes.
#include "search/interval/flight_ants.hpp"

#include <gtest/gtest.h>

#include "alate/core/stream.hpp"
#include "search/interval/flight_pool.hpp"
#include "support/hand_made_sites.hpp"

namespace alate {
namespace {

/// All that a space of ants needs, over a site.
struct Sky {
  explicit Sky(const Site& site)
      : world(site),
        band(world),
        cost(band),
        run(executor, {}),
        to_go(world, band.slopes(), run),
        end{.goal = site.mission.goal, .tolerance_m = site.mission.tolerance_m - 1e-3},
        ants(cost, to_go,
             {{{planar_pose(site.mission.start.x(), site.mission.start.y(), kPi / 2 - site.mission.heading_rad)},
               AltitudeLabel::at(site.mission.start.z())},
              end},
             {.bin_m = 100, .ahead_m = 300}) {}

  World world;
  BandWalk band;
  FlightCost cost;
  Executor executor;
  RunContext run;
  ClimbField to_go;
  FlightEnd end;
  FlightAnts ants;
};

using Actions = std::vector<std::uint32_t>;

constexpr std::size_t kShot = 6;

/// The shot where it may be flown, once the walk is long enough; else now and then any move, mostly the best.
std::size_t draw(const Choices& choices, bool may_shoot, Stream& random) {
  if (may_shoot && choices.cost[kShot] < 1e30F) return kShot;
  if (random.uniform() < 0.3) return random.below(kShot);
  std::size_t best = 0;
  for (std::size_t k = 1; k < kShot; ++k)
    if (choices.cost[k] + choices.guide[k] < choices.cost[best] + choices.guide[best]) best = k;
  return best;
}

/// A walk that arrives.
Actions walk(const FlightAnts& ants, std::uint64_t seed) {
  Stream random(seed, 0, 0);
  Choices choices;
  for (int trial = 0; trial < 100; ++trial) {
    Actions actions{0};
    FlightNode state = ants.next(ants.start(), 0);
    for (int look = 0; look < 1000 && !FlightAnts::is_goal(state); ++look) {
      ants.look(state, choices);
      const std::size_t action = draw(choices, actions.size() >= 10, random);
      const FlightNode to = ants.next(state, action);
      if (!FlightAnts::is_free(state, to)) continue;
      actions.push_back(static_cast<std::uint32_t>(action));
      state = to;
    }
    if (FlightAnts::is_goal(state)) return actions;
  }
  return {};
}

std::vector<Eigen::Vector3f> moves_of(const FlightAnts& ants, const Actions& actions) {
  std::vector<Eigen::Vector3f> moves;
  FlightNode state = ants.start();
  for (const std::uint32_t action : actions) {
    state = ants.next(state, action);
    moves.push_back(FlightAnts::place(state));
  }
  return moves;
}

TEST(FlightAnts, SeeWhatTheyWillFly) {
  for (const Site& site : {test::open_air_site(), test::ridge_site()}) {
    const Sky sky(site);
    Choices choices;
    int seen = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      FlightNode state = sky.ants.start();
      for (const std::uint32_t action : walk(sky.ants, seed)) {
        sky.ants.look(state, choices);
        const FlightNode to = sky.ants.next(state, action);
        // The threat is priced at one altitude along the move, where the flight may have to climb.
        EXPECT_NEAR(choices.cost[action], to.cost, 0.02 * to.cost + 1e-3);
        EXPECT_EQ(Eigen::Vector3f(choices.x[action], choices.y[action], choices.z[action]), FlightAnts::place(to));
        for (std::size_t k = sky.ants.actions(); k < choices.cost.size(); ++k) EXPECT_FALSE(choices.cost[k] < 1e30F);
        state = to;
        ++seen;
      }
    }
    EXPECT_GT(seen, 100);
  }
}

TEST(FlightAnts, ChooseAHeadingWhereNoneIsGiven) {
  Site site = test::open_air_site();
  const Sky sky(site);
  FlightStart start{.poses = {}, .label = AltitudeLabel::at(site.mission.start.z())};
  for (int k = 0; k < 16; ++k) start.poses.push_back(planar_pose(0, 0, 2 * kPi * k / 16));
  const FlightAnts ants(sky.cost, sky.to_go, {start, sky.end}, {.bin_m = 100, .ahead_m = 300});
  Choices choices;
  ants.look(ants.start(), choices);
  const auto best = std::ranges::min_element(choices.guide) - choices.guide.begin();
  EXPECT_TRUE(best <= 3 || best >= 13) << best;  // the goal lies in the east, a threat before it
  EXPECT_GT(choices.guide[8], choices.guide[static_cast<std::size_t>(best)] + 300);
}

/// A way of primitives that is learnt as it was flown is told by other actions, but by the same moves at the same
/// costs, but for the shot, which is learnt in shorter pieces: floors are bounded piece by piece.
TEST(FlightAnts, LearnFlightsByTheSameMoves) {
  Sky sky(test::ridge_site());
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Actions walked = walk(sky.ants, seed);
    ASSERT_FALSE(walked.empty());
    const Track track = sky.ants.track(walked);
    const Actions learnt = sky.ants.learn(track, sky.end);
    const auto once = sky.ants.fly(walked);
    const auto again = sky.ants.fly(learnt);
    ASSERT_TRUE(once && again);
    EXPECT_NEAR(length_of(sky.ants.track(learnt)), length_of(track), 1e-6);
    EXPECT_EQ(again->moves, learnt.size());
    const auto moves = moves_of(sky.ants, walked);
    const auto same = moves_of(sky.ants, learnt);
    for (std::size_t i = 0; i + 2 < moves.size(); ++i) {
      EXPECT_EQ(moves[i + 1], same[i]) << i;
      EXPECT_FLOAT_EQ(again->costs[i], once->costs[i + 1]) << i;
    }
  }
}

TEST(FlightAnts, KnowTheFlightThatIsKeptWhateverTheyLearn) {
  Sky sky(test::open_air_site());
  const Actions first = sky.ants.learn(sky.ants.track(walk(sky.ants, 1)), sky.end);
  sky.ants.keep_learnt();
  const auto before = sky.ants.fly(first);
  ASSERT_TRUE(before);
  for (const std::uint64_t seed : {2U, 3U}) {
    const Actions other = sky.ants.learn(sky.ants.track(walk(sky.ants, seed)), sky.end);
    ASSERT_TRUE(sky.ants.fly(first) && sky.ants.fly(other));
    EXPECT_EQ(before->cost, sky.ants.fly(first)->cost);
    EXPECT_NE(before->cost, sky.ants.fly(other)->cost);
  }
}

TEST(FlightAnts, NoFlightEndsShortOfTheGoal) {
  const Sky sky(test::open_air_site());
  Actions actions = walk(sky.ants, 3);
  ASSERT_TRUE(sky.ants.fly(actions));
  actions.pop_back();
  EXPECT_FALSE(sky.ants.fly(actions));
}

TEST(Joined, LeadsAsFarWithFewerPieces) {
  const Sky sky(test::ridge_site());
  const Track track = sky.ants.track(walk(sky.ants, 4));
  const Track one = joined(track);
  EXPECT_LT(one.size(), track.size());
  EXPECT_NEAR(length_of(one), length_of(track), 1e-9 * length_of(track));
  EXPECT_LT((one.back().end().position() - track.back().end().position()).norm(), 1e-6);
  for (const PlanarPiece& piece : one)
    EXPECT_TRUE(piece.steering == Steering::straight || piece.length_m < 2 * kPi * piece.radius_m);
}

TEST(FlightPool, BettersWaysByTurnsAndKeepsOneOfThoseAlike) {
  Sky sky(test::open_air_site());
  const double z = sky.ants.start_m();
  Stream random(1, 0, 0);
  FlightPool pool(100, 300);
  EXPECT_TRUE(pool.empty());
  const FlightPath path(sky.cost, sky.end, joined(sky.ants.track(walk(sky.ants, 5))), z);
  pool.add_bettered(path, random, sky.run);
  ASSERT_FALSE(pool.empty());
  EXPECT_LT(pool.best().cost(), path.cost());
  double before = pool.best().cost();
  for (int round = 0; round < 20; ++round) {
    pool.better(random, sky.run);
    EXPECT_LE(pool.best().cost(), before + 1e-4);
    before = pool.best().cost();
  }
  pool.add_bettered(FlightPath(sky.cost, sky.end, pool.best().track(), z), random, sky.run);
  EXPECT_EQ(pool.size(), 1U);
}

}  // namespace
}  // namespace alate
