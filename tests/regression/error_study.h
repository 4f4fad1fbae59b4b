#pragma once
// What a picture states of its error against its true error, over many seeds (docs/sampling.md).

#include <string>
#include <vector>

#include "drt/film/error_estimate.h"
#include "drt/scene/scene_desc.h"

namespace drt {

/// A scene of the study: a shipped one, or one of rare bright light (fireflies/).
struct StudyScene {
    std::string name;
    SceneDesc scene;  ///< without physics
    int frame = 0;
};

std::vector<StudyScene> shipped_scenes_to_study();
std::vector<StudyScene> fireflies_to_study();

/// One picture.
struct ErrorTrial {
    int spp = 0;
    ErrorEstimate stated;
    double rmse = 0;  ///< against the mean of all seeds' last pictures

    /// Less than half of the true error, and not said to be a lower bound.
    bool misleads() const { return !stated.at_least && stated.rmse < rmse / 2; }
};

struct StudyOptions {
    int width = 40, height = 30;
    int seeds = 200;
    int most_spp = 1024;  ///< from 2 in powers of 2
};

/// Pictures of every seed and number of samples.
std::vector<ErrorTrial> study_errors(const StudyScene&, const StudyOptions&);

}  // namespace drt
