package cga.imaging.golden

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class MachineTest {
    @Test
    fun `only what decides the code is kept`() {
        val environment =
            mapOf("LP_NUM_THREADS" to "2", "HOME" to "/home/me", "GALLIVM_PERF" to "no_opt", "LP_NATIVE_VECTOR_WIDTH" to "128")
        val machine = Machine.of("llvmpipe", "3.3 (Core Profile) Mesa 22.3.6", X86, environment)
        assertEquals("Mesa 22.3.6", machine.driver)
        assertEquals(listOf("avx", "avx2", "fma", "sse4_1", "ssse3"), machine.cpu)
        assertEquals(mapOf("GALLIVM_PERF" to "no_opt", "LP_NATIVE_VECTOR_WIDTH" to "128"), machine.settings)
    }

    @Test
    fun `ARM has features, another driver its whole version, and where nothing is told nothing is known`() {
        assertEquals(listOf("asimd"), Machine.of("r", "v", "Features\t: fp asimd evtstrm\n", emptyMap()).cpu)
        assertEquals("3.3.0 NVIDIA 535.1", Machine.of("r", "3.3.0 NVIDIA 535.1", "", emptyMap()).driver)
        assertEquals(emptyList<String>(), Machine.of("r", "v", "", emptyMap()).cpu)
    }

    private companion object {
        const val X86 = "model name\t: an avx512f\nflags\t\t: fpu sse ssse3 fma sse4_1 avx f16 avx2 avx512f\nbugs\t\t: sse\n"
    }
}
