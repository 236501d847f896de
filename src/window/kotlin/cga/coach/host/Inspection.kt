package cga.coach.host

import cga.coach.calls.Call
import cga.coach.ui.say
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryUtil

/**
 * One picture of a program, looked at call by call: what a picture alone does not show, with the lines of the student's that it comes from.
 *
 * @param isTheirs tells the student's classes.
 */
internal class Inspection(private val isTheirs: (String) -> Boolean) {
    private var draws = 0
    private val errors = LinkedHashSet<String>()
    private val made = LinkedHashSet<String>()
    private val absent = LinkedHashSet<String>()

    /** Notes [call], which the driver has answered. */
    fun note(call: Call) {
        val name = call.name
        val error = if (name == "glGetError") GL_NO_ERROR else glGetError()
        when {
            error != GL_NO_ERROR -> errors += "$name: ${name(error)}${place()}"
            name.startsWith("glDraw") || name.startsWith("glMultiDraw") -> draws++
            (name.startsWith("glGen") && name != "glGenerateMipmap") || name.startsWith("glCreate") -> made += "$name${place()}"
            name == "glGetUniformLocation" && call.answer < 0 -> noteAbsent(call.int(0), MemoryUtil.memASCII(call.long(1)))
        }
    }

    /** What the shaders declare and do not use yet is no mistake. */
    private fun noteAbsent(
        program: Int,
        name: String,
    ) {
        val shaders = IntArray(MOST_SHADERS)
        val count = IntArray(1)
        glGetAttachedShaders(program, count, shaders)
        val declared = Regex("""\b${Regex.escape(name.substringBefore('.').substringBefore('['))}\b""")
        if ((0 until count[0]).none { declared.containsMatchIn(glGetShaderSource(shaders[it])) }) absent += "$name${place()}"
    }

    private fun place(): String {
        val frames = StackWalker.getInstance().walk { all -> all.filter { isTheirs(it.className) }.limit(MOST_FRAMES).toList() }
        // What they all call to send a number says nothing of which it is.
        val frame = frames.firstOrNull { !it.className.endsWith(".ShaderProgram") } ?: frames.firstOrNull() ?: return ""
        return ", ${frame.fileName}:${frame.lineNumber}"
    }

    /**
     * What there is to say, the most important first.
     *
     * @param isGrowing whether the program makes more objects than it deletes.
     */
    fun remarks(isGrowing: Boolean): List<Trouble> =
        listOfNotNull(
            remark(errors.isNotEmpty(), say("OpenGL refuses a call", "OpenGL lehnt einen Aufruf ab"), errors),
            remark(
                draws == 0,
                say("Nothing is drawn", "Es wird nichts gezeichnet"),
                listOf(say("render() makes no draw call.", "In render() steht kein Draw-Call.")),
            ),
            remark(isGrowing, say("Objects are made in every picture, and stay", "In jedem Bild entstehen Objekte, und sie bleiben"), made),
            remark(
                absent.isNotEmpty(),
                say("Sent, but no shader uses it", "Gesendet, aber kein Shader verwendet es"),
                absent,
            ),
        )

    private fun remark(
        isSo: Boolean,
        title: String,
        lines: Collection<String>,
    ): Trouble? = if (isSo) Trouble(title, lines.take(MOST_LINES), Trouble.AGAIN) else null

    private fun name(error: Int): String =
        when (error) {
            GL_INVALID_ENUM -> "GL_INVALID_ENUM"
            GL_INVALID_VALUE -> "GL_INVALID_VALUE"
            GL_INVALID_OPERATION -> "GL_INVALID_OPERATION"
            GL_INVALID_FRAMEBUFFER_OPERATION -> "GL_INVALID_FRAMEBUFFER_OPERATION"
            else -> "0x%X".format(error)
        }

    private companion object {
        const val MOST_LINES = 6
        const val MOST_SHADERS = 8
        const val MOST_FRAMES = 4L
    }
}
