// What the options do to the picture.
#include <cmath>

#include "render_programs.h"

namespace drt {
namespace {

const std::string example = DRT_TEST_DATA "/manual_example.txt";

double mean(const Image& image) {
    double sum = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) sum += double(image.pixel(x, y)[c]);
    return sum / (3.0 * image.width * image.height);
}

class RenderedPicture : public testing::Test {
protected:
    Image picture(const std::string& name, const std::vector<std::string>& options) {
        std::vector<std::string> all{scene_};
        all.insert(all.end(), options.begin(), options.end());
        return render_exr(folder_, name, all);
    }
    MetadataValue attribute(const std::string& name, const std::string& key) {
        return exr_attributes(folder_.file(name + ".exr"))[key];
    }

    TempFolder folder_;
    std::string scene_ = folder_.write("scene.yaml", small_scene);
};

TEST_F(RenderedPicture, IsWrittenInEveryFormatAskedFor) {
    const ProcessResult r = render({"-o", folder_.file("a.exr"), scene_, "-o", folder_.file("a.png")});
    ASSERT_EQ(r.exit_code, 0) << r.err;
    EXPECT_EQ(r.out, "");
    EXPECT_EQ(files_in(folder_), (std::vector<std::string>{"a.exr", "a.png", "scene.yaml"}));
    const Image exr = read_image_raw(folder_.file("a.exr")), png = read_image(folder_.file("a.png"));
    EXPECT_EQ(exr.width, 24);
    EXPECT_EQ(exr.height, 16);
    EXPECT_EQ(exr.channels, 4);
    EXPECT_EQ(png.width, 24);
    EXPECT_EQ(png.height, 16);
    for (int c = 0; c < 3; ++c)  // the upper left pixel shows the background; 8-bit sRGB is good for 1 %
        EXPECT_NEAR(png.pixel(0, 0)[c], exr.pixel(0, 0)[c], 0.004) << c;
}

TEST_F(RenderedPicture, SaysHowItWasMade) {
    picture("a", {"--frame", "3", "--seed", "4294967295", "--spp", "2"});
    const auto a = exr_attributes(folder_.file("a.exr"));
    EXPECT_EQ(a.at("drt:frame"), MetadataValue(3));
    EXPECT_EQ(a.at("drt:seed"), MetadataValue(4294967295.0));
    EXPECT_EQ(a.at("drt:spp"), MetadataValue(2));
    EXPECT_EQ(a.at("drt:videoTime"), MetadataValue(3 / 10.0));
    EXPECT_EQ(a.at("drt:sceneTime"), MetadataValue(3 / 10.0));
    EXPECT_EQ(a.at("drt:precision"), MetadataValue("single"));
    EXPECT_EQ(std::get<std::string>(a.at("drt:sceneHash")).size(), 32u);
    EXPECT_GE(std::get<float>(a.at("drt:renderSeconds")), 0);
    EXPECT_GT(std::get<float>(a.at("drt:rmse")), 0);
    EXPECT_TRUE(contains(render({"--version"}).out, std::get<std::string>(a.at("drt:version")) + " (" +
                                                        std::get<std::string>(a.at("drt:isa")) + ")"));
}

TEST_F(RenderedPicture, HashTellsScenesApartAndNotFiles) {
    picture("a", {});
    folder_.write("copy/b.yaml", small_scene);
    render_exr(folder_, "b", {folder_.file("copy/b.yaml")});
    std::string other = small_scene;
    other.replace(other.find("0.02"), 4, "0.03");
    render_exr(folder_, "c", {folder_.write("c.yaml", other)});
    EXPECT_EQ(attribute("a", "drt:sceneHash"), attribute("b", "drt:sceneHash"));
    EXPECT_NE(attribute("a", "drt:sceneHash"), attribute("c", "drt:sceneHash"));
}

TEST_F(RenderedPicture, OfALegacySceneIsThatOfItsConversion) {
    const std::string yaml = folder_.file("example.yaml");
    ASSERT_EQ(test::run_process(DRT_CONVERT, {example, "-o", yaml, "-q"}).exit_code, 0);
    const std::vector<std::string> options{"-r", "40x30", "--spp", "3", "--missing-textures", "checker", "-f", "2"};
    std::vector<std::string> direct{example}, converted{yaml};
    direct.insert(direct.end(), options.begin(), options.end());
    converted.insert(converted.end(), options.begin(), options.end());
    const Image a = render_exr(folder_, "direct", direct), b = render_exr(folder_, "converted", converted);
    EXPECT_GT(mean(a), 0);
    EXPECT_EQ(a.data, b.data);
}

TEST_F(RenderedPicture, TakesTheFlagsOf2008) {
    const ProcessResult r = render({"-p", "--frame", "4", "--scene", example, "--missing-textures", "checker", "-r",
                                    "16x12", "-o", folder_.file("a.exr")});
    ASSERT_EQ(r.exit_code, 0) << r.err;
    EXPECT_EQ(attribute("a", "drt:frame"), MetadataValue(4));
    EXPECT_EQ(attribute("a", "drt:spp"), MetadataValue(1));
    const ProcessResult s = render({"-f", "4", "-s", example, "--preview", "--missing-textures", "checker", "-r",
                                    "16x12", "-o", folder_.file("b.exr")});
    ASSERT_EQ(s.exit_code, 0) << s.err;
    EXPECT_EQ(read_image_raw(folder_.file("a.exr")).data, read_image_raw(folder_.file("b.exr")).data);
}

TEST_F(RenderedPicture, IsTheSameBitsForAnyNumberOfThreads) {
    const std::vector<std::string> size{"-r", "100x70", "--spp", "3", "-t"};
    const auto with = [&](const std::string& threads) {
        std::vector<std::string> options = size;
        options.push_back(threads);
        return picture("t" + threads, options).data;
    };
    const auto one = with("1");
    EXPECT_EQ(one.size(), 100u * 70 * 4);
    EXPECT_EQ(with("2"), one);
    EXPECT_EQ(with("7"), one);
}

TEST_F(RenderedPicture, SeedChangesTheNoiseAndNotTheMean) {
    const Image a = picture("a", {"--spp", "16"}), b = picture("b", {"--spp", "16", "--seed", "1"});
    EXPECT_NE(a.data, b.data);
    // Pixels are independent, so the means differ by a normal variable of this standard deviation (channels taken as
    // wholly dependent); 5 of them by chance once in 1.7 million.
    const double sd = std::get<float>(attribute("a", "drt:rmse")) * std::sqrt(2.0 / (24 * 16));
    EXPECT_NEAR(mean(a), mean(b), 5 * sd);
    EXPECT_LT(5 * sd, 0.1 * mean(a));  // the comparison says something
}

TEST_F(RenderedPicture, OfTheGeneralPlanIsTheSame) {
    const Image a = picture("a", {}), b = picture("b", {"--plan=general"});
    ASSERT_EQ(a.data.size(), b.data.size());
    for (size_t i = 0; i < a.data.size(); ++i) EXPECT_NEAR(a.data[i], b.data[i], 1e-4 * (1 + std::abs(a.data[i]))) << i;
}

TEST_F(RenderedPicture, PrecisionCanBeChosen) {
    const Image a = picture("a", {"--precision", "single"}), b = picture("b", {"--precision", "double"});
    EXPECT_EQ(attribute("a", "drt:precision"), MetadataValue("single"));
    EXPECT_EQ(attribute("b", "drt:precision"), MetadataValue("double"));
    EXPECT_NE(a.data, b.data);
    EXPECT_NEAR(mean(a), mean(b), 0.01 * mean(a));
}

TEST_F(RenderedPicture, PreviewHasNoChance) {
    const Image a = picture("a", {"-p"}), b = picture("b", {"--preview", "--seed", "9"});
    EXPECT_EQ(attribute("a", "drt:spp"), MetadataValue(1));
    EXPECT_EQ(a.data, b.data);
    EXPECT_NE(picture("c", {"--spp", "1"}).data, a.data);
    picture("d", {"-p", "--spp", "3"});
    EXPECT_EQ(attribute("d", "drt:spp"), MetadataValue(3));  // what the user says counts most
}

TEST_F(RenderedPicture, MaxDepthCutsReflections) {
    std::string mirror = small_scene;
    mirror.replace(mirror.find("diffuse: [0.7"), 0, "reflectance: 0.5, ");
    scene_ = folder_.write("mirror.yaml", mirror);
    const double none = mean(picture("none", {"--max-depth", "0"})), one = mean(picture("one", {"--max-depth", "1"}));
    EXPECT_GT(one, none * 1.02);
    EXPECT_GT(mean(picture("eight", {})), one);
}

TEST_F(RenderedPicture, ResolutionOverridesTheScene) {
    const Image a = picture("a", {"-r", "7x5"});
    EXPECT_EQ(a.width, 7);
    EXPECT_EQ(a.height, 5);
}

TEST_F(RenderedPicture, ExposureIsInStopsAndForDisplayPicturesOnly) {
    ASSERT_EQ(render({scene_, "-o", folder_.file("a.exr"), "-o", folder_.file("a.png")}).exit_code, 0);
    ASSERT_EQ(render({scene_, "-o", folder_.file("b.exr"), "-o", folder_.file("b.png"), "--exposure", "-2"}).exit_code,
              0);
    EXPECT_EQ(read_image_raw(folder_.file("a.exr")).data, read_image_raw(folder_.file("b.exr")).data);
    const Image a = read_image(folder_.file("a.png")), b = read_image(folder_.file("b.png"));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(b.pixel(0, 0)[c], a.pixel(0, 0)[c] / 4, 0.002) << c;
}

}  // namespace
}  // namespace drt
