package cga.reader.spirv

import cga.exercise.components.shader.ShaderSource
import cga.reader.Reading
import cga.reader.glsl.GlslCompiler
import cga.reader.run.Machine
import cga.reader.shader.Stage
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import java.nio.ByteBuffer
import java.nio.ByteOrder
import kotlin.random.Random

/** A module that is not as SPIR-V has it is refused with what is wrong; nothing else is thrown, and nothing hangs. */
class ModuleTest {
    private val text = ShaderSource.read("shaders/scene.frag").text
    private val sound = checkNotNull(GlslCompiler.compile("scene.frag", text, Stage.FRAGMENT).binary)

    @Test
    fun `a file of another kind is refused`() {
        assertEquals("3 bytes are no SPIR-V module", refusal(byteArrayOf(1, 2, 3)))
        assertEquals("SPIR-V begins with 07230203, not with 00000000", refusal(ByteArray(40)))
        assertEquals("the module has no entry point", refusal(sound.copyOf(20)))
    }

    @Test
    fun `an unknown instruction is named`() {
        assertEquals("SPIR-V's instruction 4000 is not known, at word 5", refusal(changed(5, 0x20000 + 4000)))
    }

    @Test
    fun `an instruction that runs past the end is named`() {
        assertEquals("CAPABILITY at word 5 has 65535 words, which cannot be", refusal(changed(5, (0xffff shl 16) + 17)))
        assertEquals("CAPABILITY at word 5 has 0 words, which cannot be", refusal(changed(5, 17)))
    }

    @Test
    fun `a module cut off or with any word changed is read or refused`() {
        val random = Random(7)
        var refused = 0
        repeat(200) { round ->
            val broken = if (round % 8 == 0) {
                sound.copyOf(4 * random.nextInt(sound.size / 4))
            } else {
                changed(random.nextInt(5, sound.size / 4), if (round % 2 == 0) random.nextInt(900) else random.nextInt())
            }
            try {
                Machine(Reading.ofSpirv(broken, Stage.FRAGMENT)).run(steps = 20_000)
            } catch (_: UnreadableException) {
                refused++
            }
        }
        assertTrue(refused in 50..199) { "$refused of 200 were refused" }
    }

    private fun refusal(binary: ByteArray): String =
        assertThrows<UnreadableException> { Reading.ofSpirv(binary, Stage.FRAGMENT) }.message.orEmpty()

    private fun changed(word: Int, to: Int): ByteArray =
        sound.copyOf().also { ByteBuffer.wrap(it).order(ByteOrder.LITTLE_ENDIAN).putInt(4 * word, to) }
}
