package cga.grading.worker

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Class files are changed where they ask for the time, and nowhere else. */
class ReroutingTest {
    /** Asks for the time, and has a constant of two places in its pool. */
    internal class Asking : () -> Long {
        override fun invoke(): Long = System.nanoTime() - System.nanoTime() + 1234567890123L
    }

    /** Asks for nothing. */
    internal class Quiet : () -> Long {
        override fun invoke(): Long = 42
    }

    private fun file(type: Class<*>): ByteArray =
        type.getResourceAsStream("/${type.name.replace('.', '/')}.class")!!.use { it.readBytes() }

    /** A class loader that knows [bytes] only, and what the test knows. */
    private class Single(private val name: String, private val bytes: ByteArray) : ClassLoader(Single::class.java.classLoader) {
        override fun loadClass(name: String): Class<*> =
            if (name == this.name) findLoadedClass(name) ?: defineClass(name, bytes, 0, bytes.size) else super.loadClass(name)
    }

    @Test
    fun `a class that asks for the time is answered by the script`() {
        val changed = Rerouting.of(file(Asking::class.java))
        val name = Asking::class.java.name
        val constructor = Single(name, changed).loadClass(name).getDeclaredConstructor().apply { isAccessible = true }

        @Suppress("UNCHECKED_CAST")
        val asking = constructor.newInstance() as () -> Long
        // Between two questions of the script's clock lies a thousand nanoseconds, and of the machine's another number each time.
        assertEquals(List(5) { 1234567890123L - 1000 }, List(5) { asking() })
    }

    @Test
    fun `all but the pool stays as it is`() {
        val file = file(Asking::class.java)
        val changed = Rerouting.of(file)
        assertEquals(file.size + 3 + "cga/grading/worker/ScriptedCalls".length + 3, changed.size)
        assertArrayEquals(file.takeLast(200).toByteArray(), changed.takeLast(200).toByteArray())
    }

    @Test
    fun `a class that asks for nothing, and what is no class, is left as it is`() {
        for (file in listOf(file(Quiet::class.java), ByteArray(0), ByteArray(100), file(Asking::class.java).copyOf(60))) {
            assertSame(file, Rerouting.of(file))
        }
    }

    @Test
    fun `each question takes a little of the script's time`() {
        val before = ScriptedCalls.nanoTime()
        assertTrue(ScriptedCalls.nanoTime() > before)
        assertFalse(ScriptedCalls.glfwGetTime() < 0)
    }
}
