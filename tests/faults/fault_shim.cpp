// Loaded into a program with LD_PRELOAD, it makes the disk misbehave at a chosen moment. What counts is
// every call that changes something below SPLITSUM_FAULT_FOLDER: call number SPLITSUM_FAULT_AT (from 0)
// and what follows meet SPLITSUM_FAULT:
//   kill       the process ends there as by kill -9, a write half done
//   full       nothing can be made or written any more (ENOSPC), a write half done
//   read-only  nothing can be changed any more (EROFS)
//   terminate  SIGTERM comes at that call, which itself works
// At its end the program appends the number of these calls to the file SPLITSUM_FAULT_COUNT.
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace {

enum class Fault { none, kill, full, read_only, terminate };

/// What a call needs of the disk.
enum class Need { space, change };

std::string_view setting(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

Fault fault_of(std::string_view name) {
    if (name == "kill") return Fault::kill;
    if (name == "full") return Fault::full;
    if (name == "read-only") return Fault::read_only;
    if (name == "terminate") return Fault::terminate;
    return Fault::none;
}

// The real function behind the one that is defined here.
template <typename Function>
Function* real(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool is_below(std::string_view path) {
    static const std::string_view folder = setting("SPLITSUM_FAULT_FOLDER");
    return !folder.empty() && path.starts_with(folder) &&
           (path.size() == folder.size() || path[folder.size()] == '/');
}

bool concerns(const char* path) {
    if (path[0] == '/') return is_below(path);
    char folder[PATH_MAX];
    return getcwd(folder, sizeof folder) && is_below(folder);
}

bool concerns(int descriptor) {
    char link[64], path[PATH_MAX];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    const ssize_t length = readlink(link, path, sizeof path);
    return length > 0 && is_below({path, static_cast<size_t>(length)});
}

bool concerns(int folder, const char* path) {
    return path[0] == '/' || folder == AT_FDCWD ? concerns(path) : concerns(folder);
}

struct Verdict {
    bool strikes = false;  // this very call meets the fault first
    int error = 0;         // what it must fail with
};

std::atomic<long> calls = 0;

__attribute__((destructor)) void write_count() {
    const std::string_view file = setting("SPLITSUM_FAULT_COUNT");
    if (file.empty()) return;
    if (std::FILE* stream = std::fopen(file.data(), "a")) {
        std::fprintf(stream, "%ld\n", calls.load());
        std::fclose(stream);
    }
}

// Counts the call. A process that is to be killed at a call that writes nothing ends here.
Verdict judge(Need need, bool writes = false) {
    static const Fault fault = fault_of(setting("SPLITSUM_FAULT"));
    static const long at = std::atol(setting("SPLITSUM_FAULT_AT").data());
    const long call = calls++;
    if (fault == Fault::none || call < at) return {};
    const bool first = call == at;
    if (fault == Fault::kill && !(writes && first)) raise(SIGKILL);
    if (fault == Fault::terminate && first) raise(SIGTERM);
    if (fault == Fault::full && need == Need::space) return {first, ENOSPC};
    if (fault == Fault::read_only) return {first, EROFS};
    return {first && fault == Fault::kill, 0};
}

int fail(int error) {
    errno = error;
    return -1;
}

bool changes(int flags) {
    return (flags & (O_CREAT | O_TRUNC | O_WRONLY | O_RDWR | O_APPEND)) != 0;
}

}  // namespace

extern "C" {

int openat(int folder, const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    if (changes(flags) && concerns(folder, path))
        if (const Verdict verdict = judge(flags & O_CREAT ? Need::space : Need::change);
            verdict.error)
            return fail(verdict.error);
    return real<int(int, const char*, int, ...)>("openat")(folder, path, flags, mode);
}

int openat64(int folder, const char* path, int flags, ...) __attribute__((alias("openat")));

int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return openat(AT_FDCWD, path, flags, mode);
}

int open64(const char* path, int flags, ...) __attribute__((alias("open")));

ssize_t write(int descriptor, const void* data, size_t size) {
    const auto real_write = real<ssize_t(int, const void*, size_t)>("write");
    if (concerns(descriptor)) {
        const Verdict verdict = judge(Need::space, true);
        // The first write that meets the fault gets half of its bytes out.
        if (verdict.strikes && verdict.error != EROFS && size > 1) {
            const ssize_t half = real_write(descriptor, data, size / 2);
            if (verdict.error == 0) raise(SIGKILL);
            return half;
        }
        if (verdict.error) return fail(verdict.error);
        if (verdict.strikes) raise(SIGKILL);
    }
    return real_write(descriptor, data, size);
}

ssize_t writev(int descriptor, const iovec* parts, int count) {
    if (concerns(descriptor))
        if (const Verdict verdict = judge(Need::space); verdict.error) return fail(verdict.error);
    return real<ssize_t(int, const iovec*, int)>("writev")(descriptor, parts, count);
}

ssize_t sendfile(int out, int in, off_t* offset, size_t size) {
    if (concerns(out))
        if (const Verdict verdict = judge(Need::space); verdict.error) return fail(verdict.error);
    return real<ssize_t(int, int, off_t*, size_t)>("sendfile")(out, in, offset, size);
}

ssize_t sendfile64(int, int, off_t*, size_t) __attribute__((alias("sendfile")));

ssize_t copy_file_range(int in, off64_t* from, int out, off64_t* to, size_t size, unsigned flags) {
    if (concerns(out))
        if (const Verdict verdict = judge(Need::space); verdict.error) return fail(verdict.error);
    return real<ssize_t(int, off64_t*, int, off64_t*, size_t, unsigned)>("copy_file_range")(
        in, from, out, to, size, flags);
}

int ftruncate(int descriptor, off_t size) {
    if (concerns(descriptor))
        if (const Verdict verdict = judge(Need::change); verdict.error) return fail(verdict.error);
    return real<int(int, off_t)>("ftruncate")(descriptor, size);
}

int ftruncate64(int, off_t) __attribute__((alias("ftruncate")));

int fsync(int descriptor) {
    if (concerns(descriptor))
        if (const Verdict verdict = judge(Need::space); verdict.error) return fail(verdict.error);
    return real<int(int)>("fsync")(descriptor);
}

int mkdir(const char* path, mode_t mode) {
    if (concerns(path))
        if (const Verdict verdict = judge(Need::space); verdict.error) return fail(verdict.error);
    return real<int(const char*, mode_t)>("mkdir")(path, mode);
}

int rmdir(const char* path) {
    if (concerns(path))
        if (const Verdict verdict = judge(Need::change); verdict.error) return fail(verdict.error);
    return real<int(const char*)>("rmdir")(path);
}

int unlink(const char* path) {
    if (concerns(path))
        if (const Verdict verdict = judge(Need::change); verdict.error) return fail(verdict.error);
    return real<int(const char*)>("unlink")(path);
}

int unlinkat(int folder, const char* path, int flags) {
    if (concerns(folder, path))
        if (const Verdict verdict = judge(Need::change); verdict.error) return fail(verdict.error);
    return real<int(int, const char*, int)>("unlinkat")(folder, path, flags);
}

int remove(const char* path) {
    if (concerns(path))
        if (const Verdict verdict = judge(Need::change); verdict.error) return fail(verdict.error);
    return real<int(const char*)>("remove")(path);
}

int link(const char* from, const char* to) {
    if (concerns(to))
        if (const Verdict verdict = judge(Need::space); verdict.error) return fail(verdict.error);
    return real<int(const char*, const char*)>("link")(from, to);
}

int rename(const char* from, const char* to) {
    if (concerns(to))
        if (const Verdict verdict = judge(Need::change); verdict.error) return fail(verdict.error);
    return real<int(const char*, const char*)>("rename")(from, to);
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) {
    if (concerns(to_folder, to))
        if (const Verdict verdict = judge(Need::change); verdict.error) return fail(verdict.error);
    return real<int(int, const char*, int, const char*)>("renameat")(from_folder, from, to_folder,
                                                                     to);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
    if (concerns(to_folder, to))
        if (const Verdict verdict = judge(Need::change); verdict.error) return fail(verdict.error);
    return real<int(int, const char*, int, const char*, unsigned)>("renameat2")(
        from_folder, from, to_folder, to, flags);
}

}  // extern "C"
