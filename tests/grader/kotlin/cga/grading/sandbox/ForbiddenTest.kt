package cga.grading.sandbox

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ForbiddenTest {
    @Test
    fun `a setting of the kernel is named with its cure`() {
        assertEquals(
            "kernel.apparmor_restrict_unprivileged_userns = 1 forbids user namespaces: " +
                "type sudo sysctl -w kernel.apparmor_restrict_unprivileged_userns=0.",
            Forbidden.causes({ 1 }, isContainer = false),
        )
        val zero = Forbidden.causes({ 0 }, isContainer = false)
        assertTrue("kernel.unprivileged_userns_clone=1." in zero && "user.max_user_namespaces=" in zero) { zero }
        assertFalse("apparmor" in zero) { zero }
    }

    @Test
    fun `a container is told its options, beside the kernel's setting`() {
        val both = Forbidden.causes({ 1 }, isContainer = true)
        assertTrue("sysctl" in both && "Start this container with --cap-add SYS_ADMIN" in both) { both }
        val neither = Forbidden.causes({ null }, isContainer = false)
        assertTrue(neither.startsWith("If this is a container, start it with")) { neither }
    }
}
