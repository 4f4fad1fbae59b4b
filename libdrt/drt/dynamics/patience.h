#pragma once
// A bake must end. What could go on without end is counted.

namespace drt {

struct Patience {
    static constexpr int most_steps = 1000000;      ///< that were tried
    static constexpr int most_collisions = 500000;  ///< rounds of them
    static constexpr int most_at_once = 3000;       ///< of those, within the shortest step: a body is crushed
    static constexpr int most_renewals = 50000;     ///< of long tumbling paths
    static constexpr int most_jammed_steps = 50;    ///< in a row, after which bodies are still deep in each other

    int steps = 0, collisions = 0, at_once = 0, renewals = 0, jammed_steps = 0;
    bool is_lost = false;  ///< a velocity is not a number any more

    bool is_at_its_end() const {
        return steps > most_steps || collisions > most_collisions || at_once > most_at_once ||
               renewals > most_renewals || jammed_steps > most_jammed_steps || is_lost;
    }
};

}  // namespace drt
