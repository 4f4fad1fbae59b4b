#pragma once

#include <cstddef>
#include <optional>

namespace drt {

/// Bytes that this process can still use before the system would have to end somebody: free and reclaimable memory and
/// swap, within the limit of its control group (a container's, a batch queue's). Nothing where the system does not say.
std::optional<std::size_t> available_memory();

}  // namespace drt
