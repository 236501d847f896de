package cga.grading.sandbox

import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * The system calls that a job is refused, as a program for the kernel's own filter (classic BPF over `struct seccomp_data`).
 *
 * A refused call fails with EPERM, `clone3` with ENOSYS so that the C library falls back to `clone`, whose flags can be read. A call by
 * another architecture's numbers ends the process.
 */
internal object SeccompFilter {
    private const val LOAD = 0x20
    private const val JUMP_IF_EQUAL = 0x15
    private const val JUMP_IF_AT_LEAST = 0x35
    private const val JUMP_IF_ANY_BIT = 0x45
    private const val RETURN = 0x06

    private const val ALLOW = 0x7fff0000
    private const val KILL_PROCESS = 0x80000000.toInt()
    private const val ERROR = 0x00050000
    private const val EPERM = ERROR or 1
    private const val ENOSYS = ERROR or 38

    private const val NUMBER = 0
    private const val ARCHITECTURE = 4
    private const val FIRST_ARGUMENT = 16
    private const val SECOND_ARGUMENT = 24

    /** Numbers from here on are x32's, another way to the same calls. */
    private const val X32 = 0x40000000

    /** CLONE_NEWNS, NEWCGROUP, NEWUTS, NEWIPC, NEWUSER, NEWPID, NEWNET. */
    private const val NEW_NAMESPACES = 0x7e020000

    /** Typing into, and pasting on, the terminal that the grader may sit at. */
    private val TERMINAL_REQUESTS = listOf(0x5412, 0x541c)

    /** The program for this machine, or null on a processor whose calls are not in the table. */
    fun forThisMachine(): ByteArray? = Processor.here()?.let(::program)

    fun program(processor: Processor): ByteArray {
        val code = Assembler()
        code.load(ARCHITECTURE)
        code.answerUnless(processor.auditNumber, KILL_PROCESS)
        code.load(NUMBER)
        if (processor == Processor.X86_64) code.answerFrom(X32, EPERM)
        for (call in RefusedCall.entries) processor.number(call)?.let { code.answerIf(it, EPERM) }
        code.answerIf(CLONE3, ENOSYS)
        code.onlyFor(processor.clone) {
            load(FIRST_ARGUMENT)
            add(JUMP_IF_ANY_BIT, NEW_NAMESPACES, 0, 1)
            add(RETURN, EPERM)
            add(RETURN, ALLOW)
        }
        code.onlyFor(processor.ioctl) {
            load(SECOND_ARGUMENT)
            TERMINAL_REQUESTS.forEach { answerIf(it, EPERM) }
            add(RETURN, ALLOW)
        }
        code.add(RETURN, ALLOW)
        return code.bytes()
    }

    private const val CLONE3 = 435

    private class Assembler {
        private val code = mutableListOf<ByteArray>()

        fun add(operation: Int, value: Int, ifTrue: Int = 0, ifFalse: Int = 0) {
            val one = ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN)
            one.putShort(operation.toShort()).put(ifTrue.toByte()).put(ifFalse.toByte()).putInt(value)
            code += one.array()
        }

        fun load(offset: Int) = add(LOAD, offset)

        fun answerIf(value: Int, answer: Int) {
            add(JUMP_IF_EQUAL, value, 0, 1)
            add(RETURN, answer)
        }

        fun answerUnless(value: Int, answer: Int) {
            add(JUMP_IF_EQUAL, value, 1, 0)
            add(RETURN, answer)
        }

        fun answerFrom(value: Int, answer: Int) {
            add(JUMP_IF_AT_LEAST, value, 0, 1)
            add(RETURN, answer)
        }

        fun onlyFor(value: Int, body: Assembler.() -> Unit) {
            val inner = Assembler().apply(body)
            add(JUMP_IF_EQUAL, value, 0, inner.code.size)
            code += inner.code
        }

        fun bytes() = code.fold(ByteArray(0), ByteArray::plus)
    }
}
