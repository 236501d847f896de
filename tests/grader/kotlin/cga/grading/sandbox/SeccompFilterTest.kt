package cga.grading.sandbox

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Runs the filter as the kernel would: `struct seccomp_data` in, an answer out. */
internal class SeccompFilterTest {
    @ParameterizedTest
    @EnumSource(Processor::class)
    fun `what a JVM needs passes, and what opens doors does not`(processor: Processor) {
        for (call in RefusedCall.entries) processor.number(call)?.let { assertEquals(EPERM, answer(processor, it), "$call") }
        val harmless = if (processor ==
            Processor.X86_64
        ) {
            listOf(0, 1, 2, 9, 11, 57, 59, 202, 231, 257, 319)
        } else {
            listOf(29, 56, 57, 63, 64, 98, 222, 226)
        }
        for (number in harmless) assertEquals(ALLOW, answer(processor, number), "call $number")
        assertEquals(ENOSYS, answer(processor, 435), "clone3")
    }

    @ParameterizedTest
    @EnumSource(Processor::class)
    fun `clone makes threads and processes but no namespaces`(processor: Processor) {
        assertEquals(ALLOW, answer(processor, processor.clone, 0x3d0f00), "pthread_create")
        assertEquals(ALLOW, answer(processor, processor.clone, 0x01200011), "fork")
        for (flag in listOf(0x00020000L, 0x02000000L, 0x04000000L, 0x08000000L, 0x10000000L, 0x20000000L, 0x40000000L)) {
            assertEquals(EPERM, answer(processor, processor.clone, flag or 0x11), "flag ${flag.toString(16)}")
        }
    }

    @ParameterizedTest
    @EnumSource(Processor::class)
    fun `the terminal cannot be typed into`(processor: Processor) {
        assertEquals(EPERM, answer(processor, processor.ioctl, 0, 0x5412))
        assertEquals(EPERM, answer(processor, processor.ioctl, 0, 0x541c))
        assertEquals(ALLOW, answer(processor, processor.ioctl, 0, 0x5401))
    }

    @Test
    fun `calls by another numbering do not slip through`() {
        val x86 = SeccompFilter.program(Processor.X86_64)
        assertEquals(KILL, run(x86, 0x40000003, 26), "32-bit ptrace")
        assertEquals(EPERM, answer(Processor.X86_64, 0x40000000 + 521), "x32 ptrace")
        assertEquals(KILL, run(x86, Processor.AARCH64.auditNumber, 0))
    }

    @Test
    fun `every call has one number and one only`() {
        for (processor in Processor.entries) {
            val numbers = RefusedCall.entries.mapNotNull(processor::number)
            assertEquals(numbers.distinct(), numbers)
        }
    }

    private fun answer(processor: Processor, call: Int, vararg arguments: Long) =
        run(SeccompFilter.program(processor), processor.auditNumber, call, *arguments)

    private fun run(program: ByteArray, architecture: Int, call: Int, vararg arguments: Long): Int {
        val data = ByteBuffer.allocate(64).order(ByteOrder.LITTLE_ENDIAN).putInt(call).putInt(architecture).putLong(0)
        arguments.forEach(data::putLong)
        val code = ByteBuffer.wrap(program).order(ByteOrder.LITTLE_ENDIAN)
        var register = 0
        var at = 0
        while (true) {
            val operation = code.getShort(at * 8).toInt()
            val ifTrue = code.get(at * 8 + 2).toInt() and 0xff
            val ifFalse = code.get(at * 8 + 3).toInt() and 0xff
            val value = code.getInt(at * 8 + 4)
            at++
            when (operation) {
                0x20 -> register = data.getInt(value)
                0x15 -> at += if (register == value) ifTrue else ifFalse
                0x35 -> at += if (Integer.compareUnsigned(register, value) >= 0) ifTrue else ifFalse
                0x45 -> at += if (register and value != 0) ifTrue else ifFalse
                0x06 -> return value
                else -> error("operation $operation")
            }
        }
    }

    private companion object {
        const val ALLOW = 0x7fff0000
        const val EPERM = 0x00050001
        const val ENOSYS = 0x00050026
        const val KILL = 0x80000000.toInt()
    }
}
