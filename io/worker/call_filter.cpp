#include "io/worker/call_filter.h"

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace knead {

namespace {

#if defined(__x86_64__) && !defined(__ILP32__)
constexpr std::uint32_t ownMachine = AUDIT_ARCH_X86_64;
constexpr std::uint32_t otherNumbers = 0x40000000; ///< a bit in those of x32, which the same machine takes too
#elif defined(__aarch64__)
constexpr std::uint32_t ownMachine = AUDIT_ARCH_AARCH64;
constexpr std::uint32_t otherNumbers = 0;
#else
constexpr std::uint32_t ownMachine = 0;
constexpr std::uint32_t otherNumbers = 0;
#endif

constexpr std::uint32_t refusedWith = SECCOMP_RET_ERRNO | EPERM;
constexpr std::uint32_t unknownCall = SECCOMP_RET_ERRNO | ENOSYS;
constexpr std::uint32_t changesFiles = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;

/// Refused whatever they are called with.
constexpr std::uint32_t refusedCalls[] = {
    // sockets
    SYS_socket,
    SYS_socketpair,
    SYS_connect,
    SYS_bind,
    SYS_listen,
    SYS_accept,
    SYS_accept4,
    SYS_sendto,
    SYS_sendmsg,
    SYS_sendmmsg,
    SYS_recvfrom,
    SYS_recvmsg,
    SYS_recvmmsg,
    SYS_getsockopt,
    SYS_setsockopt,
    // programs and processes
    SYS_execve,
    SYS_execveat,
    SYS_unshare,
    SYS_setns,
    SYS_ptrace,
    SYS_process_vm_readv,
    SYS_process_vm_writev,
    SYS_kcmp,
    SYS_tkill,
    SYS_rt_sigqueueinfo,
    SYS_rt_tgsigqueueinfo,
    SYS_pidfd_open,
    SYS_pidfd_getfd,
    SYS_pidfd_send_signal,
    SYS_process_madvise,
    SYS_personality,
    SYS_setpriority,
    SYS_setpgid,
    SYS_setsid,
    // files
    SYS_truncate,
    SYS_unlinkat,
    SYS_renameat2,
    SYS_linkat,
    SYS_symlinkat,
    SYS_mkdirat,
    SYS_mknodat,
    SYS_fchmod,
    SYS_fchmodat,
    SYS_fchown,
    SYS_fchownat,
    SYS_utimensat,
    SYS_setxattr,
    SYS_lsetxattr,
    SYS_fsetxattr,
    SYS_removexattr,
    SYS_lremovexattr,
    SYS_fremovexattr,
    SYS_chroot,
    SYS_name_to_handle_at,
    SYS_open_by_handle_at,
    SYS_fanotify_init,
    SYS_inotify_init1,
    SYS_quotactl,
    SYS_swapon,
    SYS_swapoff,
    SYS_acct,
    // mounts
    SYS_mount,
    SYS_umount2,
    SYS_pivot_root,
    SYS_move_mount,
    SYS_open_tree,
    SYS_fsopen,
    SYS_fsconfig,
    SYS_fsmount,
    SYS_fspick,
    SYS_mount_setattr,
    // parts of the kernel that are attacked from within
    SYS_bpf,
    SYS_perf_event_open,
    SYS_keyctl,
    SYS_add_key,
    SYS_request_key,
    SYS_io_uring_setup,
    SYS_io_uring_enter,
    SYS_io_uring_register,
    SYS_io_setup,
    SYS_io_submit,
    SYS_userfaultfd,
    SYS_vmsplice,
    // the machine
    SYS_init_module,
    SYS_finit_module,
    SYS_delete_module,
    SYS_kexec_load,
    SYS_reboot,
    SYS_settimeofday,
    SYS_clock_settime,
    SYS_clock_adjtime,
    SYS_adjtimex,
    SYS_sethostname,
    SYS_setdomainname,
    SYS_syslog,
    SYS_vhangup,
    // other identities
    SYS_setuid,
    SYS_setgid,
    SYS_setreuid,
    SYS_setregid,
    SYS_setresuid,
    SYS_setresgid,
    SYS_setfsuid,
    SYS_setfsgid,
    SYS_setgroups,
    SYS_capset,
    // memory and queues shared with others
    SYS_shmget,
    SYS_shmat,
    SYS_shmctl,
    SYS_msgget,
    SYS_msgsnd,
    SYS_msgrcv,
    SYS_msgctl,
    SYS_semget,
    SYS_semop,
    SYS_semctl,
    SYS_semtimedop,
    SYS_mq_open,
    SYS_mq_unlink,
#ifdef SYS_renameat
    SYS_renameat,
#endif
#ifdef SYS_kexec_file_load
    SYS_kexec_file_load,
#endif
#ifdef __x86_64__ // older forms of some of these
    SYS_fork,
    SYS_vfork,
    SYS_creat,
    SYS_unlink,
    SYS_rmdir,
    SYS_rename,
    SYS_link,
    SYS_symlink,
    SYS_mkdir,
    SYS_mknod,
    SYS_chmod,
    SYS_chown,
    SYS_lchown,
    SYS_utime,
    SYS_utimes,
    SYS_futimesat,
    SYS_inotify_init,
    SYS_iopl,
    SYS_ioperm,
    SYS_modify_ldt,
    SYS_uselib,
#endif
};

/// A program for the kernel, which runs it before each system call.
class FilterProgram {
public:
    FilterProgram()
    {
        load(offsetof(seccomp_data, arch));
        skipUnlessNot(ownMachine);
        result(SECCOMP_RET_KILL_PROCESS);
        loadNumber();
        if (otherNumbers != 0)
            when(BPF_JSET, otherNumbers, SECCOMP_RET_KILL_PROCESS);
    }

    void answer(std::uint32_t call, std::uint32_t with) { when(BPF_JEQ, call, with); }

    /// Refuses a call unless an argument of it, of 32 bits, has none of some bits.
    void refuseBits(std::uint32_t call, unsigned argument, std::uint32_t bits)
    {
        beginCall(call, 4);
        loadArgument(argument);
        when(BPF_JSET, bits, refusedWith);
        loadNumber();
    }

    /// Refuses a call when an argument has none of some bits.
    void requireBits(std::uint32_t call, unsigned argument, std::uint32_t bits)
    {
        beginCall(call, 4);
        loadArgument(argument);
        m_code.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, bits, 1, 0));
        result(refusedWith);
        loadNumber();
    }

    /// Refuses a call when an argument is not one of some numbers.
    void requireOneOf(std::uint32_t call, unsigned argument, std::initializer_list<std::uint32_t> numbers)
    {
        const auto count = static_cast<std::uint8_t>(numbers.size());
        beginCall(call, count + 3);
        loadArgument(argument);
        std::uint8_t left = count;
        for (const std::uint32_t number : numbers)
            m_code.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, number, left--, 0));
        result(refusedWith);
        loadNumber();
    }

    /// Refuses a call when an argument is some number.
    void refuseNumber(std::uint32_t call, unsigned argument, std::uint32_t number)
    {
        beginCall(call, 4);
        loadArgument(argument);
        when(BPF_JEQ, number, refusedWith);
        loadNumber();
    }

    /// Lets all other calls pass, and hands the program to the kernel. @return false when that takes none
    bool install()
    {
        result(SECCOMP_RET_ALLOW);
        const sock_fprog program{static_cast<unsigned short>(m_code.size()), m_code.data()};
        return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program) == 0;
    }

private:
    void load(std::size_t place)
    {
        m_code.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(place)));
    }
    void loadNumber() { load(offsetof(seccomp_data, nr)); }
    /// Its lower half: both machines have it first.
    void loadArgument(unsigned argument) { load(offsetof(seccomp_data, args) + argument * sizeof(std::uint64_t)); }
    void result(std::uint32_t value) { m_code.push_back(BPF_STMT(BPF_RET | BPF_K, value)); }
    void skipUnlessNot(std::uint32_t number) { m_code.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, number, 1, 0)); }
    /// What follows, of some length, is of one call only.
    void beginCall(std::uint32_t call, std::uint8_t length)
    {
        m_code.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, length));
    }
    void when(std::uint16_t comparison, std::uint32_t number, std::uint32_t value)
    {
        m_code.push_back(BPF_JUMP(static_cast<std::uint16_t>(BPF_JMP | comparison | BPF_K), number, 0, 1));
        result(value);
    }

    std::vector<sock_filter> m_code;
};

} // namespace

bool canFilterCalls()
{
    std::uint32_t action = SECCOMP_RET_KILL_PROCESS;
    return ownMachine != 0 && syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

bool filterCalls()
{
    if (!canFilterCalls())
        return false;
    FilterProgram program;
    for (const std::uint32_t call : refusedCalls)
        program.answer(call, refusedWith);
    for (const std::uint32_t call : {SYS_clone3, SYS_openat2}) // what they are to do is not in their arguments
        program.answer(call, unknownCall);
    program.requireBits(SYS_clone, 0, CLONE_THREAD);
#ifdef SYS_open
    program.refuseBits(SYS_open, 1, changesFiles);
#endif
    program.refuseBits(SYS_openat, 2, changesFiles);
    const auto self = static_cast<std::uint32_t>(getpid());
    program.requireOneOf(SYS_kill, 0, {self});
    program.requireOneOf(SYS_tgkill, 0, {self});
    program.requireOneOf(SYS_prlimit64, 0, {0, self});
    for (const std::uint32_t request : {TIOCSTI, TIOCLINUX}) // would type into the terminal
        program.refuseNumber(SYS_ioctl, 1, request);
    for (const std::uint32_t command : {F_SETOWN, F_SETOWN_EX}) // would have signals sent to others
        program.refuseNumber(SYS_fcntl, 1, command);
    for (const std::uint32_t option : {PR_SET_DUMPABLE, PR_SET_PDEATHSIG}) // stay as they are
        program.refuseNumber(SYS_prctl, 0, option);
    return program.install();
}

} // namespace knead
