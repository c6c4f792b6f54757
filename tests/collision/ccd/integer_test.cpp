// Integers of any length against those of GMP.
#include "collision/ccd/integer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include <gmpxx.h>

namespace nuno {
namespace {

// The same number twice, made by the same steps.
struct Twins
{
    Integer ours;
    mpz_class theirs;
};

// Up to `words` words of 32 bits, many of them 0 or all ones, so that carries run far.
Twins random_twins(std::mt19937_64& random, int words)
{
    Twins twins{Integer(0), 0};
    const int count = static_cast<int>(random() % static_cast<unsigned>(words + 1));
    for (int i = 0; i < count; ++i) {
        const std::uint64_t kind = random() % 4, any = random() & 0xffffffff;
        const std::uint64_t word = kind == 0 ? 0 : kind == 1 ? 0xffffffff : any;
        twins.ours <<= 32;
        twins.ours += Integer(static_cast<std::int64_t>(word));
        twins.theirs = (twins.theirs << 32) + mpz_class(static_cast<unsigned long>(word));
    }
    if (random() % 2) {
        twins.ours.negate();
        twins.theirs = -twins.theirs;
    }
    return twins;
}

bool are_equal(const Integer& ours, const mpz_class& theirs)
{
    Integer rest = ours;
    mpz_class value = theirs;
    if (rest.sign() != sgn(value)) return false;
    if (sgn(value) != 0 && rest.bit_count() != static_cast<int>(mpz_sizeinbase(value.get_mpz_t(), 2))) return false;
    Integer made(0);  // by words, as in random_twins
    const mpz_class magnitude = abs(value);
    for (int i = static_cast<int>(mpz_sizeinbase(magnitude.get_mpz_t(), 2)) / 32; i >= 0; --i) {
        const mpz_class word = (magnitude >> static_cast<unsigned>(32 * i)) & 0xffffffff;
        made <<= 32;
        made += Integer(static_cast<std::int64_t>(word.get_ui()));
    }
    if (sgn(value) < 0) made.negate();
    return (rest - made).sign() == 0;
}

TEST(Integers, sums_products_and_shifts_are_those_of_gmp)
{
    std::mt19937_64 random(1);
    for (int i = 0; i < 3000; ++i) {
        const int words = i % 3 == 0 ? 3 : i % 3 == 1 ? 20 : 150;
        const Twins a = random_twins(random, words), b = random_twins(random, words);
        const auto bits = static_cast<unsigned>(random() % 300);
        EXPECT_TRUE(are_equal(a.ours + b.ours, a.theirs + b.theirs)) << i;
        EXPECT_TRUE(are_equal(a.ours - b.ours, a.theirs - b.theirs)) << i;
        EXPECT_TRUE(are_equal(a.ours * b.ours, a.theirs * b.theirs)) << i;
        EXPECT_TRUE(are_equal(a.ours << bits, a.theirs << bits)) << i;
        EXPECT_TRUE(are_equal(-a.ours, -a.theirs)) << i;
        Integer sum = a.ours;
        sum.add_product(a.ours, b.ours, -1);
        EXPECT_TRUE(are_equal(sum, a.theirs - a.theirs * b.theirs)) << i;
        sum += sum;
        EXPECT_TRUE(are_equal(sum, 2 * (a.theirs - a.theirs * b.theirs))) << i;
        sum -= sum;
        EXPECT_EQ(sum.sign(), 0);
    }
}

TEST(Integers, the_comparison_with_gmp_sees_a_wrong_one)
{
    std::mt19937_64 random(2);
    const Twins a = random_twins(random, 40);
    EXPECT_TRUE(are_equal(a.ours, a.theirs));
    EXPECT_FALSE(are_equal(a.ours + Integer(1), a.theirs));
    EXPECT_FALSE(are_equal(-a.ours, a.theirs));
}

TEST(Integers, the_smallest_and_largest_words)
{
    const std::int64_t least = INT64_MIN;
    EXPECT_TRUE(are_equal(Integer(least), -(mpz_class(1) << 63)));
    EXPECT_TRUE(are_equal(Integer(INT64_MAX), (mpz_class(1) << 63) - 1));
    EXPECT_EQ(Integer(0).sign(), 0);
    EXPECT_EQ(Integer(0).bit_count(), 0);
    EXPECT_EQ(Integer(-1).bit_count(), 1);
    EXPECT_EQ((Integer(0) << 100).sign(), 0);
    EXPECT_EQ((Integer(7) * Integer(0)).sign(), 0);
}

TEST(Integers, round_towards_zero_to_a_double)
{
    const Integer just_below = (Integer(1) << 100) - Integer(1);
    EXPECT_EQ(just_below.rounded().exponent, 100);
    EXPECT_EQ(just_below.rounded().mantissa, 1 - 0x1p-53);
    EXPECT_EQ((-just_below).rounded().mantissa, -(1 - 0x1p-53));
    EXPECT_EQ((Integer(1) << 100).rounded().exponent, 101);
    EXPECT_EQ((Integer(1) << 100).rounded().mantissa, 0.5);
    EXPECT_EQ(Integer(0).rounded().mantissa, 0);
    EXPECT_EQ(std::ldexp(Integer(12345).rounded().mantissa, Integer(12345).rounded().exponent), 12345);
}

TEST(Integers, keep_their_value_when_copied_and_moved)
{
    for (const unsigned bits : {3u, 5000u}) {
        Integer a = Integer(5) << bits;
        Integer b = a;
        EXPECT_EQ((a - b).sign(), 0);
        Integer c = std::move(a);
        EXPECT_EQ((c - b).sign(), 0);
        Integer d(1);
        d = std::move(c);
        EXPECT_EQ((d - b).sign(), 0);
        d = Integer(4);
        EXPECT_EQ((d - Integer(4)).sign(), 0);
        b = b;  // NOLINT
        EXPECT_EQ((b - (Integer(5) << bits)).sign(), 0);
    }
}

}  // namespace
}  // namespace nuno
