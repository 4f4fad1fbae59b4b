#pragma once
// The media that a path is inside of, and what it meets at the surface of one of them. Where media overlap, the one of
// lowest rank (plan/rank.h) owns the place, and the surfaces of the others do not exist there: a path goes through
// them and only remembers that it has entered, or left. After Schmidt and Budge, "Simple Nested Dielectrics in Ray
// Traced Images", Journal of Graphics Tools 7(2), 2002.

#include <span>

#include "drt/stages/ray_batch.h"

namespace drt {

/// Entries by rank, the owner on top.
template <class Real>
class MediaStack {
public:
    MediaStack(RayBatch<Real>& batch, int slot) : batch_(batch), slot_(slot) {}

    int size() const { return batch_.media_count[size_t(slot_)]; }
    int at(int depth) const { return batch_.media[size_t(depth) * batch_capacity + size_t(slot_)]; }

    /// Position of the body's topmost entry, or -1.
    int find(int body) const {
        for (int i = size() - 1; i >= 0; --i)
            if (at(i) == body) return i;
        return -1;
    }

    /// False when the stack is full: the body is then not entered.
    bool enter(int body, std::span<const ContactRole> roles) {
        const int top = size();
        if ((size_t(top) + 1) * batch_capacity > batch_.media.size()) return false;
        int place = top;
        for (; place > 0 && roles[size_t(at(place - 1))].rank < roles[size_t(body)].rank; --place)
            put(place, at(place - 1));
        put(place, body);
        ++batch_.media_count[size_t(slot_)];
        return true;
    }

    void leave(int depth) {
        for (int i = depth; i + 1 < size(); ++i) put(i, at(i + 1));
        --batch_.media_count[size_t(slot_)];
    }

private:
    void put(int depth, int body) { batch_.media[size_t(depth) * batch_capacity + size_t(slot_)] = body; }

    RayBatch<Real>& batch_;
    int slot_;
};

/// The surface of a medium as a path meets it: with the medium before (n1) and beyond (n2) as bodies, no_body for
/// vacuum.
struct Interface {
    bool exists = true;  ///< false: the path goes on as if nothing were there
    int before = no_body, beyond = no_body;
};

/// A surface without volume bounds a medium on one side, and is left without ever having been entered.
template <class Real>
Interface interface_at(const MediaStack<Real>& stack, int body, bool entering, std::span<const ContactRole> roles) {
    const int top = stack.size() - 1;
    const int owner = top >= 0 ? stack.at(top) : no_body;
    const bool outranked = owner != no_body && roles[size_t(owner)].rank < roles[size_t(body)].rank;
    const bool known = stack.find(body) >= 0;
    if (entering) return {!outranked && !(known && roles[size_t(body)].solid), owner, body};
    if (owner == body) return {true, body, top > 0 ? stack.at(top - 1) : no_body};
    return {!known && !outranked && !roles[size_t(body)].solid, body, owner};
}

/// To the other side of the surface. False when the body cannot be entered because the stack is full.
template <class Real>
bool cross(MediaStack<Real>& stack, int body, bool entering, std::span<const ContactRole> roles) {
    const int depth = stack.find(body);
    if (entering) return (depth >= 0 && roles[size_t(body)].solid) || stack.enter(body, roles);
    if (depth >= 0) stack.leave(depth);
    return true;
}

}  // namespace drt
