#pragma once
// The order of parallel work, for the thread sanitizer. The distributions' TBB and Embree are not built with it, so it
// sees neither that tasks (callbacks) begin after their loop was entered nor that the loop ends after its tasks:
// everything that passes from one to the other would be a race to it. What tasks do to each other is not told, so that
// races among them are found. Nothing in other builds.

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace drt::task_order {

#if defined(__SANITIZE_THREAD__)
inline char entered, ended;  // only their addresses matter
inline void before_loop() { __tsan_release(&entered); }
inline void task_begins() { __tsan_acquire(&entered); }
inline void task_ends() { __tsan_release(&ended); }
inline void after_loop() { __tsan_acquire(&ended); }
#else
inline void before_loop() {}
inline void task_begins() {}
inline void task_ends() {}
inline void after_loop() {}
#endif

/// Within a task, from its first to its last line.
struct Task {
    Task() { task_begins(); }
    ~Task() { task_ends(); }
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;
};

}  // namespace drt::task_order
