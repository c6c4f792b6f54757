// Exact roots against Sturm's theorem, and where it is known what they are.
#include "collision/ccd/exact_root.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "collision/ccd/rational_polynomial.h"

namespace nuno {
namespace {

Polynomial polynomial(std::initializer_list<std::int64_t> coefficients)
{
    Polynomial p;
    for (const std::int64_t c : coefficients) p.c[p.count++] = Integer(c);
    p.trim();
    return p;
}

std::vector<double> sorted_bounds(std::vector<ExactRoot> roots)
{
    std::vector<double> bounds;
    for (ExactRoot& root : roots) {
        root.narrow();
        bounds.push_back(root.lower_bound());
    }
    std::sort(bounds.begin(), bounds.end());
    return bounds;
}

TEST(ExactRoots, of_lines_and_quadratics)
{
    EXPECT_EQ(sorted_bounds(roots_of(polynomial({-1, 4}))), std::vector<double>{0.25});
    EXPECT_EQ(sorted_bounds(roots_of(polynomial({0, 1}))), std::vector<double>{0});
    EXPECT_EQ(sorted_bounds(roots_of(polynomial({-3, 3}))), std::vector<double>{1});
    EXPECT_TRUE(roots_of(polynomial({-5, 4})).empty());
    EXPECT_TRUE(roots_of(polynomial({7})).empty());
    EXPECT_EQ(sorted_bounds(roots_of(polynomial({1, -4, 4}))), std::vector<double>{0.5});  // double
    EXPECT_EQ(sorted_bounds(roots_of(polynomial({0, -1, 1}))), (std::vector<double>{0, 1}));
    EXPECT_TRUE(roots_of(polynomial({1, -1, 1})).empty());  // not real
    const std::vector<double> both = sorted_bounds(roots_of(polynomial({1, -8, 8})));
    ASSERT_EQ(both.size(), 2u);
    EXPECT_NEAR(both[0], 0.5 - std::sqrt(0.125), 1e-14);
    EXPECT_NEAR(both[1], 0.5 + std::sqrt(0.125), 1e-14);
}

TEST(ExactRoots, of_cubics_with_multiple_roots)
{
    EXPECT_EQ(sorted_bounds(roots_of(polynomial({-1, 6, -12, 8}))), std::vector<double>{0.5});  // (2t-1)^3
    EXPECT_EQ(sorted_bounds(roots_of(polynomial({-1, 8, -20, 16}))),
              (std::vector<double>{0.25, 0.5}));                                                   // (4t-1)(2t-1)^2
    EXPECT_EQ(sorted_bounds(roots_of(polynomial({0, 0, -1, 2}))), (std::vector<double>{0, 0.5}));  // t^2 (2t-1)
    EXPECT_EQ(sorted_bounds(roots_of(polynomial({0, 0, 0, 5}))), std::vector<double>{0});
    EXPECT_EQ(sorted_bounds(roots_of(polynomial({-3, 22, -48, 32}))), (std::vector<double>{0.25, 0.5, 0.75}));
}

TEST(ExactRoots, that_are_closer_than_doubles_are_told_apart)
{
    // (t - 1/2)^2 = 2^-200: two roots 2^-99 apart.
    Polynomial p;
    p.count = 3;
    p.c[0] = (Integer(1) << 198) - Integer(1);
    p.c[1] = -(Integer(1) << 200);
    p.c[2] = Integer(1) << 200;
    std::vector<ExactRoot> roots = roots_of(p);
    ASSERT_EQ(roots.size(), 2u);
    // t - 1/2 is of different signs at them.
    EXPECT_EQ(roots[0].sign_of(polynomial({-1, 2})) * roots[1].sign_of(polynomial({-1, 2})), -1);
}

TEST(ExactRoots, next_to_zero_take_no_recursion)
{
    // t (2^4000 t - 1): roots 0 and 2^-4000.
    Polynomial p;
    p.count = 3;
    p.c[1] = Integer(-1);
    p.c[2] = Integer(1) << 4000;
    EXPECT_EQ(roots_of(p).size(), 2u);
    EXPECT_EQ(sorted_bounds(roots_of(p)), (std::vector<double>{0, 0}));
}

TEST(ExactRoots, give_the_sign_of_another_polynomial)
{
    const Polynomial root_of_half = polynomial({-1, 0, 2});  // sqrt(1/2)
    std::vector<ExactRoot> roots = roots_of(root_of_half);
    ASSERT_EQ(roots.size(), 1u);
    EXPECT_EQ(roots[0].sign_of(polynomial({-7, 10})), 1);
    EXPECT_EQ(roots[0].sign_of(polynomial({-71, 100})), -1);
    EXPECT_EQ(roots[0].sign_of(polynomial({1, 3, -2, -6})), 0);  // (1 + 3t)(1 - 2t^2)
    EXPECT_EQ(roots[0].sign_of(Polynomial{}), 0);
    EXPECT_EQ(roots[0].sign_of(polynomial({-4})), -1);
    EXPECT_EQ(roots[0].sign_of(polynomial({-131836323, 186444716})), -1);  // a convergent: 1e-17 off
}

TEST(ExactRoots, are_those_of_sturm)
{
    std::mt19937_64 random(3);
    int count = 0;
    for (int i = 0; i < 2000; ++i) {
        Polynomial p, h;
        RationalPolynomial their_p, their_h;
        const int range = i % 2 ? 5 : 1000;
        const auto draw = [&] { return static_cast<std::int64_t>(random() % unsigned(2 * range + 1)) - range; };
        for (int k = 0; k < 4; ++k) {
            const std::int64_t c = draw(), d = k < 3 ? draw() : 0;
            p.c[p.count++] = Integer(c);
            h.c[h.count++] = Integer(d);
            their_p.emplace_back(static_cast<long>(c));
            their_h.emplace_back(static_cast<long>(d));
        }
        p.trim();
        h.trim();
        their_p = their_p + RationalPolynomial{};
        their_h = their_h + RationalPolynomial{};
        if (p.is_zero()) continue;
        std::vector<ExactRoot> roots = roots_of(p);
        std::vector<RealRoot> their_roots = roots_between_0_and_1(their_p);
        ASSERT_EQ(roots.size(), their_roots.size()) << i;
        for (ExactRoot& root : roots) root.narrow();
        std::sort(roots.begin(), roots.end(),
                  [](const ExactRoot& a, const ExactRoot& b) { return a.lower_bound() < b.lower_bound(); });
        for (std::size_t k = 0; k < roots.size(); ++k, ++count) {
            EXPECT_EQ(roots[k].sign_of(h), sign_at_root(their_h, their_roots[k])) << i;
            EXPECT_TRUE(is_at_most(Rational(roots[k].lower_bound()), their_roots[k])) << i;
            EXPECT_FALSE(is_at_most(Rational(roots[k].lower_bound() + 5e-15), their_roots[k])) << i;
        }
    }
    EXPECT_GT(count, 500);
}

}  // namespace
}  // namespace nuno
