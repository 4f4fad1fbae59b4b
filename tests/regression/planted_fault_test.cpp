#include "regression/planted_fault_test.h"

#include <algorithm>

#include "regression/regression.h"

namespace drt {

void expect_seen(const PlantedFault& fault) {
    const Shot& shot = find_shot(fault.shot);
    SceneDesc scene = read_shot(shot);
    const CompareResult sound = compare_with_reference(shot, scene, fault.seeds, test_seed);
    EXPECT_TRUE(sound.same) << "without the fault: " << sound.report;
    fault.plant(scene);
    const CompareResult faulty = compare_with_reference(shot, scene, fault.seeds, test_seed);
    EXPECT_FALSE(faulty.same) << faulty.report;
}

void PrintTo(const PlantedFault& fault, std::ostream* out) { *out << fault.name << " in " << fault.shot; }

std::string test_name(const ::testing::TestParamInfo<PlantedFault>& fault) {
    std::string name = fault.param.shot + "_" + fault.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

}  // namespace drt
