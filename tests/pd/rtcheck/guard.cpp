// Preloaded into Pd, counts what has no place in a perform routine: allocations, locks, waiting,
// and system calls of any kind. The sections to watch are marked by [realtime-mark~ 1] before and
// [realtime-mark~ 0] behind the objects in question, in one chain of signal cords.
//
// System calls are caught by Linux's syscall user dispatch: while the selector says BLOCK, each one
// raises SIGSYS. The first in a section is counted and carried out, the rest of the section let be.
// At the end it prints how many there were, and ends the process with code 86 if any.
#include <dlfcn.h>
#include <execinfo.h>
#include <pthread.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#ifndef PR_SET_SYSCALL_USER_DISPATCH
#define PR_SET_SYSCALL_USER_DISPATCH 59
#define PR_SYS_DISPATCH_ON 1
#endif

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void __libc_free(void*);
}

namespace {

constexpr char kAllow = 0;
constexpr char kBlock = 1;

volatile char selector = kAllow;
thread_local bool inside = false;
bool dispatching = false;
long violations = 0;
long sections = 0;

void note(const char* what) {
    inside = false;
    const char before = selector;
    selector = kAllow;
    if (++violations <= 5) {
        char text[120];
        const int n = std::snprintf(text, sizeof text, "rtcheck: %s in a perform routine\n", what);
        (void)!write(STDERR_FILENO, text, static_cast<std::size_t>(n));
        void* frames[16];
        backtrace_symbols_fd(frames, backtrace(frames, 16), STDERR_FILENO);
    }
    selector = before;
    inside = true;
}

void check(const char* what) {
    if (inside) {
        note(what);
    }
}

void on_system_call(int, siginfo_t* info, void* context) {
    selector = kAllow;  // for the rest of the section, the return from here included
    char what[40];
    std::snprintf(what, sizeof what, "system call %d", info->si_syscall);
    check(what);
    auto& r = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
    const long result = syscall(info->si_syscall, r[REG_RDI], r[REG_RSI], r[REG_RDX], r[REG_R10],
                                r[REG_R8], r[REG_R9]);
    r[REG_RAX] = result < 0 ? -errno : result;
}

void watch_system_calls() {
    struct sigaction action {};
    action.sa_sigaction = on_system_call;
    action.sa_flags = SA_SIGINFO;
    sigaction(SIGSYS, &action, nullptr);
    dispatching = prctl(PR_SET_SYSCALL_USER_DISPATCH, PR_SYS_DISPATCH_ON, 0UL, 0UL, &selector) == 0;
}

__attribute__((destructor)) void report() {
    if (sections == 0) {
        return;  // another process on the way to Pd
    }
    std::fprintf(stderr, "rtcheck: %ld sections, system calls %swatched, %ld violations\n",
                 sections, dispatching ? "" : "not ", violations);
    if (violations > 0) {
        std::fflush(stderr);
        _exit(86);
    }
}

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) void realtime_enter() {
    if (sections++ == 0) {
        void* frame[1];
        backtrace(frame, 1);  // loads what it needs, which allocates
        watch_system_calls();
    }
    inside = true;
    selector = kBlock;
}

__attribute__((visibility("default"))) void realtime_leave() {
    selector = kAllow;
    inside = false;
}

__attribute__((visibility("default"))) void* malloc(std::size_t size) {
    check("malloc");
    return __libc_malloc(size);
}

__attribute__((visibility("default"))) void* calloc(std::size_t count, std::size_t size) {
    check("calloc");
    return __libc_calloc(count, size);
}

__attribute__((visibility("default"))) void* realloc(void* memory, std::size_t size) {
    check("realloc");
    return __libc_realloc(memory, size);
}

__attribute__((visibility("default"))) void free(void* memory) {
    if (memory) {
        check("free");
    }
    __libc_free(memory);
}

__attribute__((visibility("default"))) int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
    static const auto real = next<int (*)(pthread_mutex_t*)>("pthread_mutex_lock");
    check("pthread_mutex_lock");
    return real(mutex);
}
}
