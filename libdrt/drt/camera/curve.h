#pragma once
// A value over the exposure, as a Chebyshev series: the plan finds as many coefficients as rounding can tell apart
// (few: an exposure is a small part of a camera's video), and rays sum them by a recurrence that is stable for any
// number.

#include <vector>

#include "drt/base/vec.h"

namespace drt {

/// c0 T0(x) + c1 T1(x) + ..., x in [-1, 1]. One coefficient: a constant.
template <class V>
using Curve = std::vector<V>;

/// Clenshaw, "A note on the summation of Chebyshev series", 1955.
template <class Value, class T, class V>
[[gnu::always_inline]] inline Value value_at(const Curve<V>& c, const T& x) {
    size_t k = c.size() - 1;
    Value next(c[k]), second_next{};
    if (k == 0) return next;
    const T x2 = T(2) * x;
    while (--k > 0) {
        const Value here = Value(c[k]) + next * x2 - second_next;
        second_next = next;
        next = here;
    }
    return Value(c[0]) + next * x - second_next;
}

template <class To, class From>
Curve<To> cast(const Curve<From>& c) {
    Curve<To> out;
    for (const From& v : c) out.push_back(To(v));
    return out;
}

}  // namespace drt
