#pragma once
// Bodies that have come to rest need no steps. Those in contact that are all slower than a share of sqrt(g L), at their
// rims too, for a share of sqrt(L / g) sleep until something changes the motion of one of them. Without gravity nothing
// sleeps: slow is not at rest.

#include <cstdint>

#include "drt/dynamics/contact_world.h"

namespace drt {

class Rest {
public:
    explicit Rest(const RigidScene&);

    bool asleep(int body) const { return bed_[std::size_t(body)] != awake; }

    /// Bodies that hold each other, directly or through others, sleep together or not at all. `held`: by body. Those
    /// that sleep from now on, or still do, lose their velocity. Returns the bodies that fell asleep or woke up.
    std::vector<int> update(std::vector<RigidState>&, const std::vector<bool>& held,
                            const std::vector<Contact>& holding, double time);

    /// And those that fell asleep with it, which it may carry. Returns them all, the body included.
    std::vector<int> wake(int body);

private:
    static constexpr std::int64_t awake = -1;
    bool is_quiet(int body, const RigidState&) const;

    const RigidScene& scene_;
    std::vector<double> quiet_since_;
    std::vector<std::int64_t> bed_;  // who sleeps together
    std::int64_t beds_ = 0;
};

}  // namespace drt
