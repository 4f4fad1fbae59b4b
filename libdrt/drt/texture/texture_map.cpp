#include "drt/texture/texture_map.h"

#include <algorithm>
#include <array>
#include <limits>

#include "drt/base/diagnostic.h"

namespace drt {
namespace {

using Level = TextureMap::Level;

/// The texels of a longer side that one texel of a shorter side covers, with their shares (which sum to 1).
/// In units of 1 / (from * to) of the side all borders are integers, so every source texel gives away exactly itself.
struct Cover {
    std::int64_t first = 0;
    int count = 0;
    std::array<double, 4> share = {};  // a side shrinks to no less than a third
};

std::vector<Cover> covers(std::int64_t from, std::int64_t to) {
    std::vector<Cover> result(static_cast<size_t>(to));
    for (std::int64_t i = 0; i < to; ++i) {
        const std::int64_t begin = i * from, end = begin + from;
        Cover& cover = result[size_t(i)];
        cover.first = begin / to;
        for (std::int64_t j = cover.first; j * to < end; ++j)
            cover.share[size_t(cover.count++)] =
                double(std::min(end, (j + 1) * to) - std::max(begin, j * to)) / double(from);
    }
    return result;
}

std::vector<Level> plan_levels(std::int64_t width, std::int64_t height) {
    std::vector<Level> levels;
    for (std::int64_t offset = 0;;) {
        levels.push_back({std::int32_t(width), std::int32_t(height), std::int32_t(offset)});
        offset += width * height * floats_per_texel;
        if (offset > std::numeric_limits<std::int32_t>::max())
            throw Error(ErrorKind::asset, "the texture is too large");
        if (width == 1 && height == 1) return levels;
        width = std::max<std::int64_t>(width / 2, 1);
        height = std::max<std::int64_t>(height / 2, 1);
    }
}

void shrink(std::vector<float>& texels, const Level& from, const Level& to) {
    const std::vector<Cover> columns = covers(from.width, to.width), rows = covers(from.height, to.height);
    float* out = texels.data() + to.offset;
    for (const Cover& row : rows)
        for (const Cover& column : columns) {
            std::array<double, 3> sum = {};
            for (int j = 0; j < row.count; ++j)
                for (int i = 0; i < column.count; ++i) {
                    const double share = row.share[size_t(j)] * column.share[size_t(i)];
                    const std::int64_t index = (row.first + j) * from.width + column.first + i;
                    const float* in = texels.data() + from.offset + index * floats_per_texel;
                    for (size_t c = 0; c < 3; ++c) sum[c] += share * double(in[c]);
                }
            for (size_t c = 0; c < 3; ++c) out[c] = float(sum[c]);
            out += floats_per_texel;
        }
}

}  // namespace

TextureMap make_texture_map(const Image& image) {
    if (image.width < 1 || image.height < 1 || image.channels < 3)
        throw Error(ErrorKind::internal, "a texture needs a picture with pixels and three channels");
    TextureMap map;
    map.levels = plan_levels(image.width, image.height);
    const Level& last = map.levels.back();
    map.texels.resize(size_t(last.offset) + floats_per_texel);
    const size_t count = size_t(image.width) * size_t(image.height);
    for (size_t i = 0; i < count; ++i)
        std::copy_n(&image.data[i * size_t(image.channels)], 3, &map.texels[i * floats_per_texel]);
    for (size_t level = 1; level < map.levels.size(); ++level)
        shrink(map.texels, map.levels[level - 1], map.levels[level]);
    return map;
}

TextureMap make_checker(const Color& a, const Color& b, int squares, int texels_per_square) {
    const int side = squares * texels_per_square;
    Image image(side, side, 3);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const Color& c = (x / texels_per_square + y / texels_per_square) % 2 == 0 ? a : b;
            const float rgb[] = {c.r, c.g, c.b};
            std::copy_n(rgb, 3, image.pixel(x, y));
        }
    return make_texture_map(image);
}

TextureMap make_missing_texture() { return make_checker(Color(0.8f, 0.0f, 0.8f), Color(0.3f), 8, 8); }

}  // namespace drt
