#include "drt/formats/legacy_element.h"

namespace drt {

const LegacyValue& LegacyElement::value(std::string_view attribute) const {
    return values.at(size_t(find_legacy_attribute(*type, attribute)));
}

bool LegacyElement::implicit(std::string_view attribute) const {
    return std::holds_alternative<std::monostate>(value(attribute).data);
}

double LegacyElement::real(std::string_view attribute) const { return std::get<double>(value(attribute).data); }

Vec3d LegacyElement::vector(std::string_view attribute) const { return std::get<Vec3d>(value(attribute).data); }

std::string_view LegacyElement::word(std::string_view attribute) const {
    const auto* word = std::get_if<std::string_view>(&value(attribute).data);
    return word ? *word : std::string_view{};
}

}  // namespace drt
