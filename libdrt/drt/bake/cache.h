#pragma once
// Motion that was computed once is kept in a file of its own. Its name is a hash of all that the motion depends on
// (input_text()): what was changed since is another file, what was not is found again.

#include "drt/bake/bake.h"

namespace drt {

/// $XDG_CACHE_HOME/drt, or $HOME/.cache/drt; "" when neither is set.
std::string default_bake_cache();

struct CachedMotion {
    BakedMotion motion;
    std::string file;  ///< where it is kept; "" without a folder
    bool found = false;
    std::string found_not_because;  ///< "there is none", or what is wrong with the file
    std::string kept_not_because;   ///< why it could not be written; else empty
};

/// The motion from `folder`, or else computed and kept there; then the folder is pruned (cache_folder.h). A file that
/// is damaged, cut short or something else is replaced; what is no file stays, and a folder that cannot be made or
/// written to is no error. With folder "" nothing is sought or kept.
CachedMotion cached_motion(const BakeInput&, const std::string& folder);

}  // namespace drt
