// Where replaced files and their temporaries end up. Faults while writing: tests/image/write_faults_test.cpp.
#include "drt/base/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <system_error>

namespace drt {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
protected:
    AtomicFile() {
        std::string name = (fs::temp_directory_path() / "drt_atomic_XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
    }
    ~AtomicFile() override { fs::remove_all(folder_); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }

    static void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

    static std::string read(const std::string& path) {
        std::ostringstream out;
        out << std::ifstream(path).rdbuf();
        return out.str();
    }

    /// Replaces `path` by a file that says `text`; the name of the temporary.
    static std::string replace(const std::string& path, const std::string& text) {
        std::string name;
        replace_file(
            path,
            [&](const std::string& temporary) {
                name = temporary;
                write(temporary, text);
            },
            [](const std::string&) {});
        return name;
    }

    fs::path folder_;
};

TEST_F(AtomicFile, ALinkStaysAndItsFileIsReplacedOrMade) {
    fs::create_directory(file("sub"));
    fs::create_symlink("sub/../sub/real", file("link"));
    fs::create_symlink(file("link"), file("link2"));
    for (const char* text : {"made", "replaced"}) {
        EXPECT_NO_THROW(check_replaceable(file("link2")));
        replace(file("link2"), text);
        EXPECT_TRUE(fs::is_symlink(file("link2")));
        EXPECT_TRUE(fs::is_symlink(file("link")));
        EXPECT_FALSE(fs::is_symlink(file("sub/real")));
        EXPECT_EQ(read(file("sub/real")), text);
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(file("sub")), {}), 1);
}

TEST_F(AtomicFile, LinksThatLeadNowhereAreErrors) {
    fs::create_symlink("none/real", file("link"));
    fs::create_symlink("b", file("a"));
    fs::create_symlink("a", file("b"));
    for (const char* name : {"link", "a"}) {
        EXPECT_THROW(check_replaceable(file(name)), std::runtime_error) << name;
        EXPECT_THROW(replace(file(name), "x"), std::system_error) << name;
        EXPECT_TRUE(fs::is_symlink(file(name))) << name;
    }
    EXPECT_EQ(follow_links(file("plain")), file("plain"));
}

TEST_F(AtomicFile, TemporariesCarryKernelNamespaceAndProcess) {
    const std::string first = replace(file("a"), "x"), second = replace(file("a"), "y");
    EXPECT_NE(first, second);
    const std::regex form("a\\.tmp\\.([0-9a-f]{12}-[0-9]+|unknown-[0-9]+)\\." + std::to_string(::getpid()) +
                          "\\.[0-9]+");
    EXPECT_TRUE(std::regex_match(fs::path(first).filename().string(), form)) << first;
    std::string boot;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;
    struct stat status = {};
    if (boot.empty() || ::stat("/proc/self/ns/pid", &status) != 0) GTEST_SKIP() << "no /proc";
    const std::string place = boot.substr(0, 8) + boot.substr(9, 4) + '-' + std::to_string(status.st_ino);
    EXPECT_NE(first.find(".tmp." + place + '.'), std::string::npos) << first;
}

TEST_F(AtomicFile, OnlyTemporariesOfDeadProcessesOfThisPlaceAreRemoved) {
    const std::string temporary = replace(file("a"), "x");
    const std::string own = temporary.substr(0, temporary.find_last_of('.', temporary.find_last_of('.') - 1));
    const std::string start = file("a.tmp.");
    std::string other_boot = own, other_namespace = own + '1';
    char& digit = other_boot[start.size()];
    digit = digit == '0' ? '1' : '0';
    const std::string pid = std::to_string(::getpid()), dead = ".2147483646.0";  // above the largest pid Linux allows
    const std::string stale = own + dead;
    const std::vector<std::string> kept = {own + '.' + pid + ".77",
                                           other_boot + dead,
                                           other_namespace + dead,
                                           start + "2147483646.0",
                                           own + ".backup",
                                           own + ".2147483646",
                                           file("b") + own.substr(start.size() - 5) + dead};
    write(stale, "x");
    for (const std::string& path : kept) write(path, "x");
    fs::create_symlink("a", file("link"));
    remove_stale_temporaries(file("link"));
    EXPECT_FALSE(fs::exists(stale));
    for (const std::string& path : kept) EXPECT_TRUE(fs::exists(path)) << path;
}

}  // namespace
}  // namespace drt
