package cga.grading.compile

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class CompilerCacheTest {
    @Test
    fun `the newest compiler is the one that this program is built with`() = assertEquals("${KotlinVersion.CURRENT}", CompilerCache.NEWEST)
}
