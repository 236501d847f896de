package cga.testing

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.opentest4j.AssertionFailedError
import org.opentest4j.TestAbortedException

class NeedTest {
    @Test
    fun `a lack skips a test, with its key and the reason`() {
        for (environment in listOf(emptyMap(), mapOf("CI" to ""), mapOf("CGA_SKIPS" to "root"))) {
            val skipped = assertThrows(TestAbortedException::class.java) { Need.SANDBOX.skip("needs bubblewrap", environment) }
            assertEquals("sandbox: needs bubblewrap", skipped.message)
        }
    }

    @Test
    fun `in CI it fails, and says how to announce it`() {
        for (skips in listOf("", "root", "sandboxes root")) {
            val failed =
                assertThrows(AssertionFailedError::class.java) {
                    Need.SANDBOX.skip("needs bubblewrap", mapOf("CI" to "true", "CGA_SKIPS" to skips))
                }
            assertTrue("needs bubblewrap" in failed.message.orEmpty() && "CGA_SKIPS=\"sandbox\"" in failed.message.orEmpty())
        }
    }

    @Test
    fun `in CI it skips where it was announced`() {
        val environment = mapOf("CI" to "true", "CGA_SKIPS" to "root sandbox")
        assertThrows(TestAbortedException::class.java) { Need.SANDBOX.skip("needs bubblewrap", environment) }
    }
}
