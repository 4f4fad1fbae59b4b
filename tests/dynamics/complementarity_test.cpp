// Impulses between their limits: random problems of the kind that contacts make, with more rows than the bodies have
// ways to move, are solved to rounding, and by pivoting alone.

#include "drt/dynamics/complementarity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace drt {
namespace {

// A = J J^T of rank `freedom`, a few normal impulses with two rows of friction each. b is a velocity of the bodies,
// along the rows: only such problems are sure to have a solution.
Complementarity random_problem(int normals, int freedom, double friction, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const int n = 3 * normals;
    std::vector<double> J(size_t(n * freedom)), velocity(static_cast<size_t>(freedom));
    for (double& v : J) v = normal(random);
    for (double& v : velocity) v = normal(random);
    Complementarity c;
    c.n = n;
    for (int i = 0; i < n; ++i) {
        const double* row = &J[size_t(i * freedom)];
        for (int j = 0; j < n; ++j) c.A.push_back(std::inner_product(row, row + freedom, &J[size_t(j * freedom)], 0.0));
        c.b.push_back(std::inner_product(row, row + freedom, velocity.begin(), 0.0));
        c.normal.push_back(i % 3 == 0 ? -1 : i - i % 3);
        c.limit.push_back(i % 3 == 0 ? 0 : friction);
        c.x.push_back(0);
    }
    return c;
}

double largest(const std::vector<double>& v) {
    double out = 0;
    for (const double x : v) out = std::max(out, std::abs(x));
    return out;
}

// Word for word what the header says a solution is.
void expect_solution(const Complementarity& c, double allowed) {
    const double scale = largest(c.b), tiny = 1e-6 * largest(c.x);
    for (int i = 0; i < c.n; ++i) {
        const double x = c.x[size_t(i)], w = c.w(i);
        EXPECT_GE(x, c.low(i) - tiny);
        EXPECT_LE(x, c.high(i) + tiny);
        EXPECT_TRUE(x <= c.low(i) + tiny || w <= allowed * scale) << i << ": " << w;
        EXPECT_TRUE(x >= c.high(i) - tiny || w >= -allowed * scale) << i << ": " << w;
    }
}

TEST(Complementarity, OfContactsIsSolved) {
    for (unsigned seed = 0; seed < 40; ++seed)
        for (const double friction : {0.0, 0.3, 1.5}) {
            Complementarity c = random_problem(4 + int(seed % 12), 6 + int(seed % 7), friction, seed);
            EXPECT_LE(solve(c), 1e-7 * largest(c.b)) << seed << " " << friction;
            expect_solution(c, 2e-6);
        }
}

TEST(Complementarity, PivotingAloneSolvesIt) {
    int solved = 0, all = 0;
    for (unsigned seed = 100; seed < 140; ++seed)
        for (const double friction : {0.3, 1.5}) {
            Complementarity c = random_problem(4 + int(seed % 12), 12, friction, seed);
            ++all;
            if (!solve_by_pivoting(c, 1e-10)) continue;
            ++solved;
            expect_solution(c, 1e-6);
        }
    EXPECT_EQ(solved, all);
}

// A weight on two supports that could also be pushed from the side: by hand.
TEST(Complementarity, AWeightIsHeldAndABlockBreaksAway) {
    // Mass 1: a normal row and one of friction 0.5. Falls at 1, slides at 0.3 or at 2.
    for (const double slide : {0.3, 2.0}) {
        Complementarity c;
        c.n = 2;
        c.A = {1, 0, 0, 1};
        c.b = {-1, slide};
        c.x = {0, 0};
        c.normal = {-1, 0};
        c.limit = {0, 0.5};
        EXPECT_LE(solve(c), 1e-12);
        EXPECT_NEAR(c.x[0], 1, 1e-12);
        EXPECT_NEAR(c.x[1], -std::min(slide, 0.5), 1e-12);
    }
}

}  // namespace
}  // namespace drt
