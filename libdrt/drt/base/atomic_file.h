#pragma once
// Replacing a file so that readers, crashes and full disks only ever see the old contents or the new, never a part.

#include <functional>
#include <span>
#include <string>

namespace drt {

/// Replaces `path` by what `write(temporary)` leaves in the temporary file beside it: write -> fsync -> verify ->
/// rename -> fsync of the folder. `verify(temporary)` re-opens the file and throws when it does not hold what was
/// meant; it is needed because libraries report success for a file that a full disk cut short.
///
/// Whatever fails, the old file stays as it was and the temporary is removed. Exceptions of the callbacks pass
/// through; own failures are std::system_error. A symbolic link stays: the file that it leads to is replaced or, as by
/// a shell's redirection, made.
///
/// Temporaries are called `<name>.tmp.<place>.<pid>.<n>`, so that threads, processes and machines that share the folder
/// may write at once. `<place>` is where the process id means something: the running kernel and the pid namespace.
void replace_file(const std::string& path, const std::function<void(const std::string&)>& write,
                  const std::function<void(const std::string&)>& verify);

/// Creates or truncates `path` with these bytes. Throws std::system_error with the errno of whatever failed.
void write_bytes(const std::string& path, std::span<const unsigned char> bytes);

/// Throws std::runtime_error unless a file can be created beside `path` and `path` is absent or a regular file.
void check_replaceable(const std::string& path);

/// The file that `path` names: itself, or the end of its chain of symbolic links, whether there is a file or not.
/// Throws std::system_error (ELOOP) when the links lead in a circle.
std::string follow_links(const std::string& path);

/// Removes temporaries of `path` whose process is dead (killed while it wrote). Only those that were made under this
/// kernel and in this pid namespace can be told; others, of another machine, container or boot, may be in use and stay.
void remove_stale_temporaries(const std::string& path);

}  // namespace drt
