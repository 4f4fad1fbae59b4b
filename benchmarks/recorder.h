#pragma once
// Records the packets that the renderer hands to Embree, by wrapping the library's own query functions at link time
// (-Wl,--wrap): the renderer knows nothing of it.

#include "bare_scene.h"

namespace drt {

/// One query as Embree saw it.
struct RecordedPacket {
    alignas(64) int valid[packet_width];
    alignas(64) float org[3][packet_width], dir[3][packet_width], tfar[packet_width], time[packet_width];
    bool shadow = false;
};

void start_recording(std::vector<RecordedPacket>&);
void stop_recording();

/// Asks the bare scene the same queries; returns the number of hits, so that nothing is optimised away.
std::size_t replay(const BareScene&, const std::vector<RecordedPacket>&);

}  // namespace drt
