package cga.imaging.golden

import java.io.File

/**
 * What decides the code that a software renderer makes, and with it the last bit of a picture. No names of hosts and no paths.
 *
 * @param renderer `GL_RENDERER`; llvmpipe's names LLVM's version and the width of its vectors.
 * @param driver the driver's version: `Mesa 22.3.6`.
 * @param cpu those of the processor's features that change the code, sorted.
 * @param settings environment variables that change the code.
 */
public data class Machine(
    val renderer: String,
    val driver: String,
    val cpu: List<String>,
    val settings: Map<String, String>,
) {
    public companion object {
        // What llvmpipe and LLVM choose instructions by: multiply and round, round, vectors, fused multiply-add, half floats. AVX-512 is not
        // among them: without it (GALLIUM_OVERRIDE_CPU_CAPS=avx) every golden comes out the same, bit for bit.
        private val FEATURES = setOf("ssse3", "sse4_1", "avx", "avx2", "fma", "f16c", "asimd", "sve")
        private val SETTINGS = Regex("GALLIVM_.*|GALLIUM_OVERRIDE_CPU_CAPS|GALLIUM_NOSSE|LP_.*")

        // The number of threads changes no bit.
        private const val THREADS = "LP_NUM_THREADS"

        /** This machine, with the strings that OpenGL gives for `GL_RENDERER` and `GL_VERSION`. */
        public fun of(
            renderer: String,
            version: String,
        ): Machine = of(renderer, version, cpuInfo(), System.getenv())

        internal fun of(
            renderer: String,
            version: String,
            cpuInfo: String,
            environment: Map<String, String>,
        ): Machine =
            Machine(
                renderer,
                // The rest says which OpenGL was asked for, and with which profile.
                Regex("""Mesa \S+""").find(version)?.value ?: version,
                features(cpuInfo),
                environment.filterKeys { SETTINGS.matches(it) && it != THREADS }.toSortedMap(),
            )

        /** x86 calls them flags, ARM features. */
        private fun features(cpuInfo: String): List<String> =
            Regex("""(?m)^(?:flags|Features)\s*:(.*)$""")
                .find(cpuInfo)
                ?.groupValues
                ?.get(1)
                .orEmpty()
                .split(' ')
                .filter { it in FEATURES }
                .sorted()

        /** Only Linux tells; elsewhere no two machines are known to be the same, and none runs llvmpipe as a rule. */
        private fun cpuInfo(): String = File("/proc/cpuinfo").takeIf { it.canRead() }?.readText().orEmpty()
    }
}
