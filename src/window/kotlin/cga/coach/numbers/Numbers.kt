package cga.coach.numbers

import cga.coach.calls.Call
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack
import org.lwjgl.system.MemoryUtil

/**
 * The numbers that a program sends to its shaders, whatever their names: looked at, and changed on the way. Needs the context.
 *
 * What is held belongs to the uniform's name, so it outlives the program that sends it.
 */
internal class Numbers : AutoCloseable {
    private val byName = LinkedHashMap<String, Sent>()
    private val programs = HashMap<Int, Array<Sent?>>()
    private val changed = MemoryUtil.memAllocFloat(MOST_FLOATS)
    private var picture = 0L

    /** All that have been sent, in the order in which they were first. */
    val all: Collection<Sent> get() = byName.values

    /** Whether anything reaches the shaders otherwise than it is sent. */
    val isAnyChanged: Boolean get() = byName.values.any { it.isChanged }

    /** A new picture begins. */
    fun nextPicture() {
        picture++
    }

    /** Other programs are there: what is held is held for them. */
    fun forgetPrograms() {
        programs.clear()
        byName.values.removeIf { !it.isChanged }
    }

    /** Changes [call], one of [FUNCTIONS], to what is to reach the shaders. */
    fun change(call: Call) {
        val location = call.int(0)
        if (location < 0) return
        val sent = sentTo(location) ?: return
        if (sent.picture != picture) sent.varies = false
        if (call.name.endsWith('v')) changeArray(call, sent) else changeNumbers(call, sent)
        sent.picture = picture
    }

    private fun changeNumbers(
        call: Call,
        sent: Sent,
    ) {
        for (i in 0 until sent.size) {
            sent.note(i, call.float(1 + i), picture)
            call.setFloat(1 + i, sent.value(i))
        }
    }

    /** Of an array only the first element is looked at. */
    private fun changeArray(
        call: Call,
        sent: Sent,
    ) {
        val floats = call.int(1) * sent.size
        if (floats > MOST_FLOATS) return
        val from = call.long(2)
        for (i in 0 until floats) {
            val value = MemoryUtil.memGetFloat(from + i * Float.SIZE_BYTES.toLong())
            if (i < sent.size) sent.note(i, value, picture)
            changed.put(i, if (i < sent.size) sent.value(i) else value)
        }
        call.setLong(2, MemoryUtil.memAddress(changed))
    }

    private fun sentTo(location: Int): Sent? {
        val program = glGetInteger(GL_CURRENT_PROGRAM)
        val places = programs[program] ?: places(program).also { programs[program] = it }
        return places.getOrNull(location)
    }

    /** The uniforms of [program] by their locations. */
    private fun places(program: Int): Array<Sent?> =
        MemoryStack.stackPush().use { stack ->
            val size = stack.mallocInt(1)
            val type = stack.mallocInt(1)
            val found = HashMap<Int, Sent>()
            for (i in 0 until glGetProgrami(program, GL_ACTIVE_UNIFORMS)) {
                val name = glGetActiveUniform(program, i, size, type)
                val floats = SIZES[type[0]] ?: continue
                val names = if (name.endsWith("[0]")) List(size[0]) { "${name.dropLast(ZERO)}[$it]" } else listOf(name)
                for (element in names) found[glGetUniformLocation(program, element)] = byName.getOrPut(element) { Sent(element, floats) }
            }
            Array((found.keys.maxOrNull() ?: 0).coerceIn(0, MOST_LOCATIONS) + 1) { found[it] }
        }

    override fun close() {
        MemoryUtil.memFree(changed)
    }

    companion object {
        /** The functions that [change] is for. */
        val FUNCTIONS: Set<String> = (1..4).flatMap { listOf("glUniform${it}f", "glUniform${it}fv") }.toSet()
        private val SIZES = mapOf(GL_FLOAT to 1, GL_FLOAT_VEC2 to 2, GL_FLOAT_VEC3 to 3, GL_FLOAT_VEC4 to 4)
        private const val ZERO = "[0]".length
        private const val MOST_FLOATS = 4096
        private const val MOST_LOCATIONS = 100_000
    }
}
