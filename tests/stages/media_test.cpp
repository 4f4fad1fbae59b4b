// Which media meet at a surface, and the bending of light there.

#include "drt/stages/media.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "drt/plan/plan.h"
#include "drt/stages/stages.h"
#include "support/scene_parts.h"

namespace drt {
namespace {

using Batch = RayBatch<float>;

// Bodies 0 and 1 are solids of falling rank (1 outranks 0), 2 is flat, 3 a solid that outranks all.
const std::vector<ContactRole> roles{{2, true, true}, {1, true, true}, {3, true, false}, {0, true, true}};

TEST(MediaStack, KeepsTheOwnerOnTop) {
    const auto batch = std::make_unique<Batch>(4);
    MediaStack<float> stack(*batch, 7);
    EXPECT_EQ(stack.size(), 0);
    EXPECT_EQ(stack.find(3), -1);
    for (const int body : {1, 3, 2, 0}) EXPECT_TRUE(stack.enter(body, roles));
    EXPECT_EQ(stack.size(), 4);
    const int by_rank[] = {2, 0, 1, 3};
    for (int i = 0; i < 4; ++i) EXPECT_EQ(stack.at(i), by_rank[i]);
    EXPECT_EQ(path_media(*batch).owner(7), 3);
    EXPECT_TRUE(path_media(*batch).holds(7, 2));
    stack.leave(stack.find(0));
    EXPECT_EQ(stack.size(), 3);
    EXPECT_EQ(stack.at(1), 1);
    EXPECT_FALSE(path_media(*batch).holds(7, 0));
    EXPECT_EQ(MediaStack<float>(*batch, 8).size(), 0);  // another path's
    EXPECT_EQ(path_media(*batch).owner(8), no_body);
}

TEST(MediaStack, IsNotOverfilled) {
    const auto batch = std::make_unique<Batch>(2);
    MediaStack<float> stack(*batch, batch_capacity - 1);
    EXPECT_TRUE(stack.enter(1, roles));
    EXPECT_TRUE(stack.enter(2, roles));
    EXPECT_FALSE(stack.enter(3, roles));
    EXPECT_EQ(stack.size(), 2);
    EXPECT_EQ(stack.find(3), -1);
}

struct Meeting {
    int body;
    bool entering;
    Interface expected;
};

// A path that meets one surface after another, and goes on through each.
void expect_meetings(const std::vector<Meeting>& meetings) {
    const auto batch = std::make_unique<Batch>(4);
    MediaStack<float> stack(*batch, 0);
    for (const Meeting& m : meetings) {
        const Interface i = interface_at<float>(stack, m.body, m.entering, roles);
        EXPECT_EQ(i.exists, m.expected.exists) << m.body;
        if (i.exists) {
            EXPECT_EQ(i.before, m.expected.before) << m.body;
            EXPECT_EQ(i.beyond, m.expected.beyond) << m.body;
        }
        EXPECT_TRUE(cross<float>(stack, m.body, m.entering, roles));
    }
}

TEST(Interface, NestedBodiesLeadBackIntoEachOther) {
    expect_meetings({{0, true, {true, no_body, 0}},
                     {1, true, {true, 0, 1}},
                     {1, false, {true, 1, 0}},
                     {0, false, {true, 0, no_body}}});
}

TEST(Interface, OfOverlappingBodiesOneOwnsThePlace) {
    // The owner last: its entry is seen, and the other's exit within it is not.
    expect_meetings(
        {{0, true, {true, no_body, 0}}, {1, true, {true, 0, 1}}, {0, false, {false}}, {1, false, {true, 1, no_body}}});
    // The owner first: the other is only seen where the owner ends.
    expect_meetings(
        {{1, true, {true, no_body, 1}}, {0, true, {false}}, {1, false, {true, 1, 0}}, {0, false, {true, 0, no_body}}});
}

TEST(Interface, ASolidIsNeitherEnteredNorLeftTwice) {
    expect_meetings(
        {{0, false, {false}}, {0, true, {true, no_body, 0}}, {0, true, {false}}, {0, false, {true, 0, no_body}}});
}

TEST(Interface, WhatIsFlatIsLeftThoughNeverEntered) {
    expect_meetings({{2, false, {true, 2, no_body}}, {2, true, {true, no_body, 2}}, {2, true, {true, 2, 2}}});
    expect_meetings({{3, true, {true, no_body, 3}}, {2, false, {false}}, {2, true, {false}}, {3, false, {true, 3, 2}}});
}

// ---- the scatter stage
// -----------------------------------------------------------------------------------------------

// One glass sphere, and a batch of rays that have met its surface at the origin, whose normal is +z.
class Glass {
public:
    Glass() {
        SceneDesc s;
        Material glass = matte("glass", Color(0.0f));
        glass.refraction = 1;
        s.materials = {glass};
        s.bodies = {body("ball", sphere({0, 0, -1}, 1), "glass")};
        s.cameras = {Camera{}};
        PlanOptions options;
        options.precision = PlanOptions::Precision::double_;
        plan_ = compile(s, options);
        world_ = std::get<std::unique_ptr<World<double>>>(plan_.world).get();
        batch_ = std::make_unique<RayBatch<double>>(world_->sampling.media_capacity);
    }

    // The directions after the surface of rays that come at these sines of the angle of incidence.
    std::vector<Vec3d> scatter(const std::vector<double>& sines, bool from_inside) {
        RayBatch<double>& b = *batch_;
        b.count = int(sines.size());
        b.bounce = 0;
        std::fill(b.slot.v.begin(), b.slot.v.end(), -1);
        std::fill(b.material.v.begin(), b.material.v.end(), -1);
        for (int i = 0; i < b.count; ++i) {
            const double s = sines[size_t(i)], c = std::sqrt((1 - s) * (1 + s));
            b.slot[i] = i;
            b.material[i] = 0;
            b.body[i] = 0;
            b.part[i] = 0;
            b.outward[i] = !from_inside;
            b.d.x[i] = s, b.d.y[i] = 0, b.d.z[i] = from_inside ? c : -c;
            b.n.x[i] = 0, b.n.y[i] = 0, b.n.z[i] = from_inside ? -1 : 1;
            b.throughput.x[i] = b.throughput.y[i] = b.throughput.z[i] = 1;
            b.media_count[size_t(i)] = 0;
            if (from_inside) MediaStack<double>(b, i).enter(0, world_->bodies.roles);
        }
        RenderCounters counters;
        StageContext<double> c;
        c.world = world_;
        c.batch = &b;
        c.counters = &counters;
        scatter_stage(c);
        EXPECT_EQ(b.count, int(sines.size()));
        std::vector<Vec3d> out;
        for (int i = 0; i < b.count; ++i) out.push_back({b.d.x[i], b.d.y[i], b.d.z[i]});
        return out;
    }

    RayBatch<double>& batch() { return *batch_; }

private:
    RenderPlan plan_;
    World<double>* world_ = nullptr;
    std::unique_ptr<RayBatch<double>> batch_;
};

TEST(Scatter, BendsLightAsSnellSays) {
    Glass glass;
    std::vector<double> sines;
    for (int i = 0; i < 100; ++i) sines.push_back(i / 100.0);
    const auto in = glass.scatter(sines, false);
    for (size_t i = 0; i < sines.size(); ++i) {
        EXPECT_NEAR(in[i].x, sines[i] / 1.5, 1e-15);
        EXPECT_NEAR(in[i].z, -std::sqrt(1 - sines[i] * sines[i] / 2.25), 1e-15);
        EXPECT_EQ(MediaStack<double>(glass.batch(), int(i)).size(), 1);
        EXPECT_FALSE(start::outward(glass.batch().start[int(i)]));
    }
}

TEST(Scatter, TurnsToTotalReflectionAtTheCriticalAngle) {
    constexpr double critical = 41.810314895778596;  // asin(1 / 1.5), degrees
    Glass glass;
    const auto sine = [](double degrees) { return std::sin(radians(degrees)); };
    const auto out = glass.scatter({sine(critical - 1e-9), sine(critical + 1e-9), 0.3, 0.9}, true);
    EXPECT_GT(out[0].z, 0);  // leaves, grazing
    EXPECT_LT(out[1].z, 0);  // stays
    EXPECT_NEAR(out[2].x, 0.45, 1e-15);
    EXPECT_GT(out[2].z, 0);
    EXPECT_NEAR(out[3].x, 0.9, 1e-15);
    EXPECT_NEAR(out[3].z, -std::sqrt(1 - 0.81), 1e-15);
    for (const int i : {0, 2}) {
        EXPECT_EQ(MediaStack<double>(glass.batch(), i).size(), 0);
        EXPECT_TRUE(start::outward(glass.batch().start[i]));
    }
    for (const int i : {1, 3}) {
        EXPECT_EQ(MediaStack<double>(glass.batch(), i).size(), 1);
        EXPECT_FALSE(start::outward(glass.batch().start[i]));
    }
}

}  // namespace
}  // namespace drt
