package cga.grading.sandbox

/** A processor whose system calls are known here. [auditNumber] is how the kernel's filter names it. */
internal enum class Processor(
    val auditNumber: Int,
    val clone: Int,
    val ioctl: Int,
) {
    X86_64(0xc000003e.toInt(), 56, 16),
    AARCH64(0xc00000b7.toInt(), 220, 29),
    ;

    /** The number of [call] on this processor, null where it has no such call. */
    fun number(call: RefusedCall): Int? = (if (this == X86_64) call.x86 else call.arm).takeIf { it >= 0 }

    companion object {
        fun here(): Processor? =
            when (System.getProperty("os.arch")) {
                "amd64", "x86_64" -> X86_64
                "aarch64", "arm64" -> AARCH64
                else -> null
            }
    }
}

/**
 * System calls that neither a JVM nor Mesa needs and that open doors: other processes, namespaces, mounts, the kernel itself, the network,
 * memory that no process is charged for. Numbers from the kernel's tables, −1 where a processor lacks the call.
 */
internal enum class RefusedCall(
    val x86: Int,
    val arm: Int,
) {
    // Other processes.
    PTRACE(101, 117),
    PROCESS_VM_READV(310, 270),
    PROCESS_VM_WRITEV(311, 271),
    PROCESS_MADVISE(440, 440),
    PIDFD_GETFD(438, 438),
    KCMP(312, 272),
    MOVE_PAGES(279, 239),
    MIGRATE_PAGES(256, 238),

    // Namespaces and mounts.
    UNSHARE(272, 97),
    SETNS(308, 268),
    MOUNT(165, 40),
    UMOUNT2(166, 39),
    PIVOT_ROOT(155, 41),
    CHROOT(161, 51),
    OPEN_TREE(428, 428),
    MOVE_MOUNT(429, 429),
    FSOPEN(430, 430),
    FSCONFIG(431, 431),
    FSMOUNT(432, 432),
    FSPICK(433, 433),
    MOUNT_SETATTR(442, 442),
    NAME_TO_HANDLE_AT(303, 264),
    OPEN_BY_HANDLE_AT(304, 265),
    FANOTIFY_INIT(300, 262),
    FANOTIFY_MARK(301, 263),

    // The kernel itself.
    BPF(321, 280),
    PERF_EVENT_OPEN(298, 241),
    USERFAULTFD(323, 282),
    IO_URING_SETUP(425, 425),
    IO_URING_ENTER(426, 426),
    IO_URING_REGISTER(427, 427),
    KEXEC_LOAD(246, 104),
    KEXEC_FILE_LOAD(320, 294),
    CREATE_MODULE(174, -1),
    INIT_MODULE(175, 105),
    DELETE_MODULE(176, 106),
    FINIT_MODULE(313, 273),
    QUERY_MODULE(178, -1),
    GET_KERNEL_SYMS(177, -1),
    SYSLOG(103, 116),
    LOOKUP_DCOOKIE(212, 18),
    NFSSERVCTL(180, 42),
    SYSFS(139, -1),
    SYSCTL(156, -1),
    USELIB(134, -1),
    IOPL(172, -1),
    IOPERM(173, -1),
    MODIFY_LDT(154, -1),
    PERSONALITY(135, 92),
    VHANGUP(153, 58),

    // The machine.
    REBOOT(169, 142),
    SWAPON(167, 224),
    SWAPOFF(168, 225),
    ACCT(163, 89),
    QUOTACTL(179, 60),
    QUOTACTL_FD(443, 443),
    SETTIMEOFDAY(164, 170),
    CLOCK_SETTIME(227, 112),
    CLOCK_ADJTIME(305, 266),
    ADJTIMEX(159, 171),
    SETHOSTNAME(170, 161),
    SETDOMAINNAME(171, 162),

    // Keys, the network.
    ADD_KEY(248, 217),
    REQUEST_KEY(249, 218),
    KEYCTL(250, 219),
    SOCKET(41, 198),

    // Memory that shows in no process.
    SHMGET(29, 194),
    SHMAT(30, 196),
    MSGGET(68, 186),
    SEMGET(64, 190),
    MQ_OPEN(240, 180),
    MEMFD_SECRET(447, 447),
}
