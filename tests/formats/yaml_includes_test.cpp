#include <gtest/gtest.h>

#include "drt/formats/formats.h"
#include "formats/temporary_files.h"

namespace drt {
namespace {

std::string errors_of(const TemporaryFiles& files, const std::string& path, ErrorKind kind = ErrorKind::scene) {
    try {
        read_yaml_scene(path);
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), kind);
        return files.without_folder(e.what());
    }
    return "was read";
}

TEST(YamlIncludes, ListsAreJoinedAndFilesResolvedWhereTheyAreNamed) {
    const TemporaryFiles files;
    files.write("parts/paint.yaml",
                "drt: 1\n"
                "textures:\n"
                "  - {name: wood, file: images/wood.png}\n"
                "materials:\n"
                "  - name: red\n"
                "  - {name: planks, texture: wood}\n");
    files.write("camera.yml", "drt: 1\nrender: {width: 10}\ncameras: [{name: left}]\n");
    const std::string path = files.write("scene.yaml",
                                         "drt: 1\n"
                                         "include: [parts/paint.yaml, camera.yml]\n"
                                         "render: {height: 20}\n"
                                         "materials:\n"
                                         "  - name: blue\n"
                                         "bodies:\n"
                                         "  - {type: sphere, material: red, radius: 2}\n"
                                         "ambient_light: 1\n"
                                         "cameras: [{name: right, video_start: 9}]\n");
    const SceneRead read = read_yaml_scene(path);
    const SceneDesc& scene = read.scene;
    EXPECT_EQ(scene.textures.at(0).file, files.path("parts/images/wood.png"));
    ASSERT_EQ(scene.materials.size(), 3u);
    EXPECT_EQ(scene.materials[0].name, "red");
    EXPECT_EQ(scene.materials[2].name, "blue");
    EXPECT_EQ(scene.render.width, 10);
    EXPECT_EQ(scene.render.height, 20);
    EXPECT_EQ(scene.sources.find("bodies[0].radius"), (Location{path, 7, 43}));
    EXPECT_EQ(scene.sources.find("materials[1].texture"), (Location{files.path("parts/paint.yaml"), 6, 29}));
    EXPECT_EQ(scene.sources.find("materials[2].name"), (Location{path, 5, 11}));
    EXPECT_EQ(read.files, (std::vector<std::string>{path, files.path("parts/paint.yaml"), files.path("camera.yml")}));
    ASSERT_EQ(read.notes.size(), 1u);
    EXPECT_EQ(files.without_folder(to_string(read.notes[0])),
              "scene.yaml:9:38: warning: 'right' and 'left' record at the same time; 'left' comes first and does");
}

TEST(YamlIncludes, AnIncludeMayBeASingleName) {
    const TemporaryFiles files;
    files.write("camera.yaml", "drt: 1\ncameras: [{}]\n");
    EXPECT_EQ(read_yaml_scene(files.write("scene.yaml", "drt: 1\ninclude: camera.yaml\n")).scene.cameras.size(), 1u);
}

TEST(YamlIncludes, WhatTwoFilesIncludeIsThereOnce) {
    const TemporaryFiles files;
    files.write("base.yaml", "drt: 1\ncameras: [{name: main}]\n");
    files.write("a.yaml", "drt: 1\ninclude: base.yaml\n");
    files.write("b.yaml", "drt: 1\ninclude: [./base.yaml]\n");
    const std::string path = files.write("scene.yaml", "drt: 1\ninclude: [a.yaml, b.yaml]\n");
    EXPECT_EQ(read_yaml_scene(path).scene.cameras.size(), 1u);
}

TEST(YamlIncludes, ASettingInTwoFilesIsAnError) {
    const TemporaryFiles files;
    files.write("a.yaml", "drt: 1\nrender: {spp: 16, filter: {kind: box}}\nbackground: 1\n");
    const std::string path = files.write("scene.yaml",
                                         "drt: 1\n"
                                         "include: a.yaml\n"
                                         "render:\n"
                                         "  spp: 16\n"
                                         "  filter: {kind: box, radius: 1}\n"
                                         "background: [1, 2, 3]\n"
                                         "cameras: [{}]\n");
    EXPECT_EQ(
        errors_of(files, path),
        "scene.yaml:4:8: error: set a second time \"render.spp\"; expected it in one file only; it was first set "
        "at a.yaml:2:15\n"
        "scene.yaml:5:18: error: set a second time \"render.filter.kind\"; expected it in one file only; it was "
        "first set at a.yaml:2:34\n"
        "scene.yaml:6:13: error: set a second time \"background\"; expected it in one file only; it was first set "
        "at a.yaml:3:13");
}

TEST(YamlIncludes, ANameInTwoFilesIsAnErrorThatNamesBoth) {
    const TemporaryFiles files;
    files.write("a.yaml", "drt: 1\nmaterials: [{name: red}]\n");
    const std::string path =
        files.write("scene.yaml", "drt: 1\ninclude: a.yaml\ncameras: [{}]\nmaterials:\n  - name: red\n");
    EXPECT_EQ(errors_of(files, path),
              "scene.yaml:5:11: error: duplicate name of a material \"red\"; expected another name; it was first used "
              "at a.yaml:2:20");
}

TEST(YamlIncludes, CirclesAreFound) {
    const TemporaryFiles files;
    files.write("a.yaml", "drt: 1\ninclude: scene.yaml\n");
    const std::string path = files.write("scene.yaml", "drt: 1\ninclude:\n  - a.yaml\ncameras: [{}]\n");
    EXPECT_EQ(errors_of(files, path),
              "a.yaml:2:10: error: the file includes itself, directly or through others \"scene.yaml\"; expected a "
              "file that does not include this one");
}

TEST(YamlIncludes, DepthIsLimited) {
    const TemporaryFiles files;
    for (int i = 0; i < 40; ++i)
        files.write(std::to_string(i) + ".yaml",
                    "drt: 1\ninclude: " + std::to_string(i + 1) + ".yaml\n" + (i == 0 ? "cameras: [{}]\n" : ""));
    EXPECT_EQ(errors_of(files, files.path("0.yaml")),
              "31.yaml:2:10: error: includes too deep \"32.yaml\"; expected at most 32 files that include each other");
}

TEST(YamlIncludes, MissingFilesAreAssetsNamedWhereTheyAreWanted) {
    const TemporaryFiles files;
    const std::string path = files.write("scene.yaml",
                                         "drt: 1\n"
                                         "include: [nowhere.yaml, '.']\n"
                                         "bodies: [{type: sphere, material: from_nowhere, colour: red}]\n");
    EXPECT_EQ(errors_of(files, path, ErrorKind::asset),
              "scene.yaml:2:11: error: cannot read the file (No such file or directory) \"nowhere.yaml\"\n"
              "scene.yaml:2:25: error: cannot read the file (it is a directory) \"\"\n"
              "scene.yaml:3:49: error: unknown key \"colour\"; expected a key of body sphere: name, type, material, "
              "priority, "
              "motion, physics, center, radius, pole, meridian");
    EXPECT_EQ(errors_of(files, files.path("none.yaml"), ErrorKind::asset),
              "none.yaml: error: cannot read the file (No such file or directory)");
}

TEST(YamlIncludes, IncludedFilesHaveTheirOwnVersionAndFaults) {
    const TemporaryFiles files;
    files.write("a.yaml", "render: {spp: 0}\n");
    files.write("b.yaml", "drt: 1\nrender: [\n");
    files.write("c.yaml", "");
    const std::string path = files.write("scene.yaml", "drt: 1\ninclude: [a.yaml, b.yaml, c.yaml, [d], ]\nfoo: 1\n");
    EXPECT_EQ(
        errors_of(files, path),
        "a.yaml:1:1: error: missing key \"drt\"; expected `drt: 1`, the version of this format\n"
        "b.yaml:3:1: error: a list in brackets does not go on like this; expected ',' or ']'\n"
        "c.yaml: error: the file is empty; expected `drt: 1` and a scene\n"
        "scene.yaml:2:35: error: include is a list; expected names of files\n"
        "scene.yaml:3:1: error: unknown key \"foo\"; expected a key of scene: drt, include, render, ambient_light, "
        "background, units, gravity, simulation, textures, materials, bodies, lights, cameras");
}

}  // namespace
}  // namespace drt
