#pragma once
// The media stack of a path: the refracting bodies it is inside of, outermost first. Nested and overlapping bodies
// need it: leaving one of them leads back into another, not into vacuum (model.md section 2).

#include "drt/stages/ray_batch.h"

namespace drt {

/// The refraction indices on this side (n1) and on the far side (n2) of the surface that a path meets.
struct Interface {
    float n1 = 1, n2 = 1;
};

template <class Real>
class MediaStack {
public:
    MediaStack(RayBatch<Real>& batch, int slot) : batch_(batch), slot_(slot) {}

    int size() const { return batch_.media_count[size_t(slot_)]; }
    int at(int depth) const { return batch_.media[size_t(depth) * batch_capacity + size_t(slot_)]; }

    /// False when the stack is full: the body is then not entered.
    bool push(int body) {
        const size_t top = size_t(size());
        if ((top + 1) * batch_capacity > batch_.media.size()) return false;
        batch_.media[top * batch_capacity + size_t(slot_)] = body;
        ++batch_.media_count[size_t(slot_)];
        return true;
    }

    /// Position of the body's topmost entry, or -1.
    int find(int body) const {
        for (int i = size() - 1; i >= 0; --i)
            if (at(i) == body) return i;
        return -1;
    }

    void erase(int depth) {
        for (int i = depth; i + 1 < size(); ++i) batch_.media[size_t(i) * batch_capacity + size_t(slot_)] = at(i + 1);
        --batch_.media_count[size_t(slot_)];
    }

private:
    RayBatch<Real>& batch_;
    int slot_;
};

/// Entering: from the top of the stack into the body. Leaving: from the body into what is on top once it is gone; a
/// body that was never entered (the camera began inside it) is left all the same.
template <class Real, class IndexOf>
Interface interface_at(const MediaStack<Real>& stack, int body, bool entering, IndexOf index_of) {
    const auto top_without = [&](int skipped) {
        for (int i = stack.size() - 1; i >= 0; --i)
            if (i != skipped) return index_of(stack.at(i));
        return 1.0f;
    };
    const float own = index_of(body);
    if (entering) return {top_without(-1), own};
    return {own, top_without(stack.find(body))};
}

}  // namespace drt
