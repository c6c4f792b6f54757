// Integers of any length, for what double cannot decide. Short ones need no memory of their own.
#pragma once

#include <cstdint>
#include <memory>

namespace nuno {

class Integer
{
  public:
    Integer() = default;  // 0
    Integer(std::int64_t value);
    Integer(const Integer& other) { *this = other; }
    Integer(Integer&& other) noexcept { *this = static_cast<Integer&&>(other); }
    Integer& operator=(const Integer& other);
    Integer& operator=(Integer&& other) noexcept;
    ~Integer() = default;

    int sign() const { return (count_ > 0) - (count_ < 0); }
    int bit_count() const;  // of the magnitude; 0 for 0
    void negate() { count_ = -count_; }

    // The value is mantissa * 2^exponent, rounded towards 0, with 0.5 <= |mantissa| < 1 or mantissa = 0.
    struct Rounded
    {
        double mantissa;
        int exponent;
    };
    Rounded rounded() const;

    Integer& operator+=(const Integer& other) { return set_sum(*this, other, 1); }
    Integer& operator-=(const Integer& other) { return set_sum(*this, other, -1); }
    Integer& operator<<=(unsigned bits);
    // Adds factor * other without an integer between.
    Integer& add_product(const Integer& a, const Integer& b, int sign = 1);

    friend Integer operator+(const Integer& a, const Integer& b)
    {
        Integer sum;
        sum.set_sum(a, b, 1);
        return sum;
    }
    friend Integer operator-(const Integer& a, const Integer& b)
    {
        Integer difference;
        difference.set_sum(a, b, -1);
        return difference;
    }
    friend Integer operator*(const Integer& a, const Integer& b)
    {
        Integer product;
        product.set_product(a, b);
        return product;
    }
    friend Integer operator<<(const Integer& a, unsigned bits)
    {
        Integer shifted(a);
        shifted <<= bits;
        return shifted;
    }
    friend Integer operator-(const Integer& a)
    {
        Integer negative(a);
        negative.negate();
        return negative;
    }

  private:
    using Limb = std::uint64_t;
    static constexpr int kOwnLimbs = 20;

    Limb* limbs() { return heap_ ? heap_.get() : own_; }
    const Limb* limbs() const { return heap_ ? heap_.get() : own_; }
    int size() const { return count_ < 0 ? -count_ : count_; }
    void reserve(int limb_count)
    {
        if (limb_count > capacity_) grow(limb_count);
    }
    void grow(int limb_count);  // keeps the value
    void set_size(int limb_count, int sign);

    Integer& set_sum(const Integer& a, const Integer& b, int sign_of_b);
    void set_sum_of_magnitudes(const Integer& a, const Integer& b, int sign);
    void set_difference_of_magnitudes(const Integer& larger, const Integer& smaller, int sign);
    void set_product(const Integer& a, const Integer& b);  // neither may be *this
    static int compare_magnitudes(const Integer& a, const Integer& b);

    int count_ = 0;  // limbs in use, least first; its sign is that of the value
    int capacity_ = kOwnLimbs;
    std::unique_ptr<Limb[]> heap_;  // in place of own_ once that is too short
    Limb own_[kOwnLimbs];
};

}  // namespace nuno
