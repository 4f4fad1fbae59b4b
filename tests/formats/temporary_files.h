#pragma once
// A folder of files for one test, gone afterwards.

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace drt {

class TemporaryFiles {
public:
    TemporaryFiles() {
        const testing::TestInfo& info = *testing::UnitTest::GetInstance()->current_test_info();
        std::string name = std::to_string(getpid()) + '_' + info.test_suite_name() + '.' + info.name();
        for (char& c : name)
            if (c == '/') c = '_';
        folder_ = std::filesystem::path(testing::TempDir()) / ("drt_" + name);
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~TemporaryFiles() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    TemporaryFiles(const TemporaryFiles&) = delete;
    TemporaryFiles& operator=(const TemporaryFiles&) = delete;

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string folder() const { return folder_.string(); }

    std::string write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return path(name);
    }

    /// `text` with the folder's name taken out: "line 3 of /tmp/x/a.yaml" -> "line 3 of a.yaml".
    std::string without_folder(std::string text) const {
        const std::string prefix = folder() + '/';
        for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
        return text;
    }

private:
    std::filesystem::path folder_;
};

}  // namespace drt
