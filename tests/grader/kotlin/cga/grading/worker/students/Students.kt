package cga.grading.worker.students

import cga.exercise.game.Game
import cga.grading.capture.Moment
import org.lwjgl.BufferUtils
import org.lwjgl.glfw.GLFW.GLFW_KEY_LEFT
import org.lwjgl.glfw.GLFW.GLFW_KEY_RIGHT
import org.lwjgl.glfw.GLFW.GLFW_KEY_UP
import org.lwjgl.glfw.GLFW.GLFW_KEY_W
import org.lwjgl.glfw.GLFW.glfwGetCurrentContext
import org.lwjgl.glfw.GLFW.glfwGetCursorPos
import org.lwjgl.glfw.GLFW.glfwGetKey
import org.lwjgl.glfw.GLFW.glfwGetTime
import org.lwjgl.glfw.GLFW.glfwSetCursorPos
import org.lwjgl.glfw.GLFW.glfwSetCursorPosCallback
import org.lwjgl.glfw.GLFW.glfwSetKeyCallback
import org.lwjgl.opengl.EXTTextureFilterAnisotropic.GL_TEXTURE_MAX_ANISOTROPY_EXT
import org.lwjgl.opengl.GL33C.*
import javax.sound.sampled.AudioFormat
import javax.sound.sampled.AudioSystem
import javax.sound.sampled.Clip
import javax.sound.sampled.DataLine
import javax.sound.sampled.FloatControl
import javax.sound.sampled.SourceDataLine
import kotlin.math.roundToInt
import kotlin.system.exitProcess

/** This project's own solution. */
internal object Solution {
    @JvmStatic
    fun main(args: Array<String>): Unit = Game().run()
}

/** Draws well, and tells what happens to it. */
internal class Listener : Painter() {
    private var updates = 0

    override fun update(
        dt: Float,
        t: Float,
    ) {
        updates++
        if (t != (updates / 60.0).toFloat()) say("update $updates at $t")
    }

    override fun onKey(
        key: Int,
        scancode: Int,
        action: Int,
        mode: Int,
    ): Unit = say("key $key action $action mode $mode held ${getKeyState(key)}")

    override fun onMouseMove(
        xpos: Double,
        ypos: Double,
    ): Unit = say("mouse $xpos $ypos is ${mousePos.xpos} ${mousePos.ypos}")

    override fun paint() {
        super.paint()
        say("frame $frame after $updates updates W ${getKeyState(GLFW_KEY_W)} mouse ${mousePos.xpos} ${mousePos.ypos}")
    }

    override fun shutdown(): Unit = say("end")

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Listener().run()
    }
}

/** Asks for time and keys past its window, and waits for time to pass. */
internal class Watcher : Painter() {
    override fun paint() {
        super.paint()
        val window = glfwGetCurrentContext()
        val clock = (glfwGetTime() * 100).roundToInt() / 100.0
        val before = System.nanoTime()
        while (System.nanoTime() < before + 1_000_000) Thread.onSpinWait()
        val hour = System.currentTimeMillis()
        say("frame $frame W ${glfwGetKey(window, GLFW_KEY_W)} at $clock hour ${hour - start}")
    }

    companion object {
        private val start = System.currentTimeMillis()

        @JvmStatic
        fun main(args: Array<String>): Unit = Watcher().run()
    }
}

/** Drives by the arrow keys, and by no others. */
internal class Rider : Painter() {
    private val keys = listOf(GLFW_KEY_UP, GLFW_KEY_LEFT, GLFW_KEY_RIGHT)
    private var held = emptyList<Boolean>()

    override fun update(
        dt: Float,
        t: Float,
    ) {
        held = keys.map(::getKeyState)
    }

    override fun paint() {
        super.paint()
        say("frame $frame up, left, right $held")
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Rider().run()
    }
}

/** Listens by callbacks of its own instead of the window's. */
internal class Caller : Painter() {
    override fun start() {
        super.start()
        val window = glfwGetCurrentContext()
        glfwSetKeyCallback(window) { _, key, _, action, mods -> say("key $key action $action mods $mods held ${getKeyState(key)}") }
        glfwSetCursorPosCallback(window) { _, x, y -> say("cursor $x $y") }
    }

    override fun onKey(
        key: Int,
        scancode: Int,
        action: Int,
        mode: Int,
    ): Unit = say("onKey")

    override fun onMouseMove(
        xpos: Double,
        ypos: Double,
    ): Unit = say("onMouseMove")

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Caller().run()
    }
}

/** Changes buffers and textures from frame to frame, by every way there is. */
internal class Changer : Painter(samples = 0) {
    private val textured =
        "#version 330 core\nin vec2 place;\nuniform vec3 color;\nuniform sampler2D map;\nout vec4 result;\n" +
            "void main() {\n    result = vec4(color * texture(map, place * 3.0).rgb, 1.0);\n}\n"
    private var indices = 0

    override fun start() {
        super.start()
        program = link(VERTEX, textured)
        indices = glGenBuffers()
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices)
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, shortArrayOf(0, 1, 2), GL_STATIC_DRAW)
        glBindTexture(GL_TEXTURE_2D, glGenTextures())
        upload(0)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR)
    }

    private fun upload(shade: Int) {
        val texels = IntArray(16 * 8) { 0xFF000000.toInt() or (it * 0x10203 + shade * 0x3F1F) }
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels)
        glGenerateMipmap(GL_TEXTURE_2D)
    }

    override fun paint() {
        color(1f, 1f, 1f)
        when (frame % 3) {
            0 -> glBufferSubData(GL_ARRAY_BUFFER, 0, triangle(1f - frame / 32f))
            1 -> glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY)?.let {
                it.asFloatBuffer().put(triangle(0.8f - frame / 32f))
                glUnmapBuffer(GL_ARRAY_BUFFER)
            }
            else -> glBufferData(GL_ARRAY_BUFFER, triangle(0.9f - frame / 32f), GL_DYNAMIC_DRAW)
        }
        glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, 0)
        upload(frame + 1)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, if (frame % 2 == 0) GL_REPEAT else GL_MIRRORED_REPEAT)
        glEnable(GL_BLEND)
        glBlendFunc(GL_ONE, GL_ONE)
        glDrawElementsBaseVertex(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, 0, 0)
        glDisable(GL_BLEND)
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Changer().run()
    }
}

/** Keeps what its shaders read in uniform blocks: matrices by column and by row, an array of structs, whole numbers and a truth value. */
internal class Blockhead : Painter() {
    private val vertex =
        "#version 330 core\nlayout(location = 0) in vec2 position;\nout vec2 place;\n" +
            "layout(std140) uniform Turn { mat2 turn; layout(row_major) mat2 shear; /* } */ } bend;\n" +
            "void main() {\n    place = position;\n    gl_Position = vec4(bend.shear * bend.turn * position, 0.0, 1.0);\n}\n"
    private val fragment =
        "#version 330 core\nin vec2 place;\nout vec4 result;\nstruct Lamp { vec3 color; float strength; };\n" +
            "layout(std140) uniform Lamps {\n    Lamp lamps[2];\n#ifdef NOBODY\n    vec4 more;\n#endif\n    int count; bool isOn;\n};\n" +
            "void main() {\n    vec3 sum = vec3(0.0);\n" +
            "    for (int i = 0; i < count; i++) sum += lamps[i].color * lamps[i].strength;\n" +
            "    result = vec4(isOn ? sum : vec3(1.0), 1.0);\n}\n"

    override fun start() {
        super.start()
        program = link(vertex, fragment)
        val numbers = BufferUtils.createByteBuffer(LAMPS + 3 * 16)
        // Each column of a matrix takes 16 bytes, and each row of one by rows.
        listOf(0.6f, 0.2f, 0f, 0f, -0.2f, 0.6f, 0f, 0f, 1f, 0.5f, 0f, 0f, 0f, 1f).forEachIndexed { i, it -> numbers.putFloat(4 * i, it) }
        listOf(1f, 0.5f, 0f, 0.5f, 0f, 0f, 1f, 0.25f).forEachIndexed { i, it -> numbers.putFloat(LAMPS + 4 * i, it) }
        numbers.putInt(LAMPS + 2 * 16, 2).putInt(LAMPS + 2 * 16 + 4, 1)
        val buffer = glGenBuffers()
        glBindBuffer(GL_UNIFORM_BUFFER, buffer)
        glBufferData(GL_UNIFORM_BUFFER, numbers, GL_DYNAMIC_DRAW)
        glUniformBlockBinding(program, glGetUniformBlockIndex(program, "Turn"), 3)
        glUniformBlockBinding(program, glGetUniformBlockIndex(program, "Lamps"), 1)
        glBindBufferRange(GL_UNIFORM_BUFFER, 3, buffer, 0, 4L * 16)
        glBindBufferRange(GL_UNIFORM_BUFFER, 1, buffer, LAMPS.toLong(), 3L * 16)
    }

    override fun paint() {
        glDrawArrays(GL_TRIANGLES, 0, 3)
        // One lamp more, one less, from picture to picture.
        glBufferSubData(GL_UNIFORM_BUFFER, LAMPS + 2L * 16, intArrayOf(1 + frame % 2))
    }

    companion object {
        private const val LAMPS = 256

        @JvmStatic
        fun main(args: Array<String>): Unit = Blockhead().run()
    }
}

/** Draws a sky from a cube map, with a sampler object, then into a part of the window and into some channels of it. */
internal class Stargazer : Painter() {
    private val sky =
        "#version 330 core\nin vec2 place;\nuniform vec3 color;\nuniform samplerCube stars;\nout vec4 result;\n" +
            "void main() {\n    result = vec4(color * texture(stars, vec3(place * 4.0, 1.0)).rgb, 1.0);\n}\n"

    override fun start() {
        super.start()
        program = link(VERTEX, sky)
        glActiveTexture(GL_TEXTURE3)
        glBindTexture(GL_TEXTURE_CUBE_MAP, glGenTextures())
        for (face in 0 until 6) {
            val texels = IntArray(4 * 4) { 0xFF000000.toInt() or ((it + 1) * 0x0A0602 + face * 0x23) }
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels)
        }
        val sampler = glGenSamplers()
        for (filter in listOf(GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER)) glSamplerParameteri(sampler, filter, GL_NEAREST)
        glBindSampler(3, sampler)
        glUseProgram(program)
        glUniform1i(glGetUniformLocation(program, "stars"), 3)
    }

    override fun paint() {
        glDepthFunc(GL_LEQUAL)
        super.paint()
        glEnable(GL_SCISSOR_TEST)
        glScissor(10, 20, 300, 200)
        glClearColor(0.2f, 0.4f, 0.6f, 1f)
        glClear(GL_COLOR_BUFFER_BIT)
        glColorMask(true, false, true, true)
        super.paint()
        glColorMask(true, true, true, true)
        glDisable(GL_SCISSOR_TEST)
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Stargazer().run()
    }
}

/** Plays music before it draws. */
internal class Musician : Painter() {
    override fun start() {
        super.start()
        val format = AudioFormat(44_100f, 16, 2, true, false)
        val clip = AudioSystem.getClip()
        clip.open(format, ByteArray(400), 0, 400)
        (clip.getControl(FloatControl.Type.MASTER_GAIN) as FloatControl).value = -10f
        clip.loop(Clip.LOOP_CONTINUOUSLY)
        val line = AudioSystem.getLine(DataLine.Info(SourceDataLine::class.java, format)) as SourceDataLine
        line.open(format)
        line.start()
        say("${clip.isOpen} ${line.write(ByteArray(100), 0, 100)} ${line.format == format}")
        clip.close()
        say(clip.isOpen)
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Musician().run()
    }
}

/** Draws into a framebuffer of its own, twice as large as the window, and shows that by a second program; as a [mirror] the scene is drawn again. */
internal open class PostProcessor(private val mirror: Boolean = false) : Painter() {
    private val shown =
        "#version 330 core\nin vec2 place;\nuniform vec3 color;\nuniform sampler2D scene;\nout vec4 result;\n" +
            "void main() {\n    result = vec4(color, 1.0) - texture(scene, place * 0.5 + 0.5);\n}\n"
    private var framebuffer = 0
    private var screen = 0
    private var scene = 0

    override fun start() {
        super.start()
        screen = link(VERTEX, shown)
        scene = program
        framebuffer = glGenFramebuffers()
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer)
        glBindTexture(GL_TEXTURE_2D, glGenTextures())
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2 * WIDTH, 2 * HEIGHT, 0, GL_RGB, GL_UNSIGNED_BYTE, 0L)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, glGetInteger(GL_TEXTURE_BINDING_2D), 0)
        glBindRenderbuffer(GL_RENDERBUFFER, glGenRenderbuffers())
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, 2 * WIDTH, 2 * HEIGHT)
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, glGetInteger(GL_RENDERBUFFER_BINDING))
        glBindFramebuffer(GL_FRAMEBUFFER, 0)
    }

    override fun paint() {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer)
        glViewport(0, 0, 2 * WIDTH, 2 * HEIGHT)
        glClearColor(0f, 0.5f, 0f, 1f)
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        glEnable(GL_DEPTH_TEST)
        color(1f, 0.5f, 0f)
        repeat(if (mirror) 1 else 2) { glDrawArrays(GL_TRIANGLES, 0, 3) }
        glBindFramebuffer(GL_FRAMEBUFFER, 0)
        glViewport(0, 0, WIDTH, HEIGHT)
        if (mirror) glDrawArrays(GL_TRIANGLES, 0, 3)
        glDisable(GL_DEPTH_TEST)
        glClear(GL_DEPTH_BUFFER_BIT)
        program = screen
        glUseProgram(program)
        color(1f, 1f, 1f)
        glDrawArrays(GL_TRIANGLES, 0, 3)
        program = scene
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = PostProcessor().run()
    }
}

/** Shows a scene that it also draws itself. */
internal object Mirrored {
    @JvmStatic
    fun main(args: Array<String>): Unit = PostProcessor(mirror = true).run()
}

/** Makes errors and asks for them. */
internal class Erring : Painter() {
    override fun paint() {
        super.paint()
        if (frame != 0) return
        glEnable(0x1234)
        glBindTexture(0x4321, 1)
        super.paint()
        say("${glGetError()} then ${glGetError()}")
        glUniform1f(glGetUniformLocation(program, "nowhere"), 1f)
        val other = link(VERTEX, FRAGMENT)
        val location = glGetUniformLocation(program, "color")
        glUseProgram(other)
        glUniform3f(location, 1f, 1f, 1f)
        glUseProgram(0)
        glUniform3f(location, 1f, 1f, 1f)
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Erring().run()
    }
}

/** Draws what no driver should be handed. */
internal class Reckless : Painter() {
    override fun paint() {
        super.paint()
        if (frame != 0) return
        glDrawArrays(GL_TRIANGLES, 0, 3_000_000)
        glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, 0)
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, glGenBuffers())
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, intArrayOf(0, 1, 3_000_000), GL_STATIC_DRAW)
        glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, 0)
        glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, 1 shl 20)
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0)
        glDrawArrays(0x99, 0, 3)
        say("alive, error ${glGetError()}")
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Reckless().run()
    }
}

/** Looks at the window's framebuffer, and draws into one of its own. */
internal class Framer : Painter() {
    override fun paint() {
        super.paint()
        if (frame != 0) return
        glBindFramebuffer(GL_FRAMEBUFFER, 0)
        glDrawBuffer(GL_BACK)
        glReadBuffer(GL_BACK)
        glDrawBuffers(intArrayOf(GL_BACK_LEFT))
        val pixel = IntArray(1)
        glReadPixels(WIDTH / 2, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel)
        say(
            "binding ${glGetInteger(GL_FRAMEBUFFER_BINDING)} read ${glGetInteger(GL_READ_BUFFER) == GL_BACK} " +
                "samples ${glGetInteger(GL_SAMPLES)} pixel ${Integer.toHexString(pixel[0])} error ${glGetError()}",
        )
        val own = glGenFramebuffers()
        glBindFramebuffer(GL_FRAMEBUFFER, own)
        val buffer = glGenRenderbuffers()
        glBindRenderbuffer(GL_RENDERBUFFER, buffer)
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, WIDTH, HEIGHT)
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer)
        glDrawArrays(GL_TRIANGLES, 0, 3)
        glReadPixels(WIDTH / 2, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel)
        say("own ${glGetInteger(GL_FRAMEBUFFER_BINDING) == own} pixel ${Integer.toHexString(pixel[0])} error ${glGetError()}")
        glBindFramebuffer(GL_FRAMEBUFFER, 0)
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Framer().run()
    }
}

/** Its fragment shader does not compile. */
internal class Misspelt : Painter() {
    override fun start() {
        super.start()
        val wrong =
            "#version 330 core\n#define COUNT 2\nstruct Light { vec3 color; float k[3]; };\nin vec2 place;\nuniform vec3 color;\n" +
                "uniform Light lights[COUNT];\nuniform mat4 a, b;\nuniform sampler2D map; // uniform vec3 not;\nout vec4 result;\n" +
                "void main() { result = vec3(color, 1.0) }\n"
        val shader = compile(GL_FRAGMENT_SHADER, wrong)
        program = link(VERTEX, wrong)
        say("compiled ${glGetShaderi(shader, GL_COMPILE_STATUS)} linked ${glGetProgrami(program, GL_LINK_STATUS)}")
    }

    override fun paint() {
        for (name in listOf("lights[1].color", "lights[0].k[2]", "a", "b", "map", "not")) {
            if (frame == 0) say("$name ${glGetUniformLocation(program, name) >= 0}")
        }
        super.paint()
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Misspelt().run()
    }
}

/** Its shader is one that some drivers accept; another asks for a later version. */
internal class Lenient : Painter() {
    override fun start() {
        super.start()
        val braces = FRAGMENT.replace("void main() {", "void main() { float half2[2] = { 0.5, 0.5 };")
        program = link(VERTEX, "\uFEFF// Malte\n$braces")
        val later = compile(GL_FRAGMENT_SHADER, FRAGMENT.replace("330", "430"))
        say("linked ${glGetProgrami(program, GL_LINK_STATUS)} later ${glGetShaderi(later, GL_COMPILE_STATUS)}")
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Lenient().run()
    }
}

/** Its fragment shader is written as only some drivers take it, in every way that is known. */
internal class Sloppy : Painter() {
    private val sloppy =
        FRAGMENT
            .replace("#version 330 core", "#version 330 compatibility")
            .replace("void main() {", "#ifdef NOBODY\n#else here\n#extension GL_ARB_gpu_shader5 : require\n#endif NOBODY\nvoid main() {")
            .replace("(0.5 + 0.5 * place.y)", "(half1 + 0.5 * (float)(int) filter * -(float) place.y / 0x2f)")
            .replace("result =", "float half1 = max(0f, 1f) / 2.f, filter = -(float) 0x2f; // 1f\n    result =")

    override fun start() {
        super.start()
        program = link(VERTEX, sloppy)
        say("linked ${glGetProgrami(program, GL_LINK_STATUS)}")
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Sloppy().run()
    }
}

/** Its fragment shader reads vectors that its vertex shader does not know, and has one interpolated otherwise. */
internal class Unwritten : Painter() {
    override fun start() {
        super.start()
        val fragment = FRAGMENT.replace("in vec2 place;", "in vec2 place; in vec3 toLight, toSun;\nflat in int kind;")
        val reads = fragment.replace("0.5 *", "0.5 * (1.0 + toLight.x + toSun.y + float(kind)) *")
        val vertex = compile(GL_VERTEX_SHADER, VERTEX.replace("out vec2", "smooth out vec2"))
        // Linked twice: the shaders are still what they were.
        val programs = List(2) {
            glCreateProgram().also { program ->
                glAttachShader(program, vertex)
                glAttachShader(program, compile(GL_FRAGMENT_SHADER, reads))
                glLinkProgram(program)
            }
        }
        program = programs.last()
        say("linked ${programs.map { glGetProgrami(it, GL_LINK_STATUS) }} ${"smooth" in glGetShaderSource(vertex)}")
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Unwritten().run()
    }
}

/** Asks for anisotropic filtering by every way there is. */
internal class Sharpener : Painter() {
    private val textured = FRAGMENT
        .replace(
            "uniform vec3",
            "uniform sampler2D map;\nuniform vec3",
        ).replace("vec4(color", "texture(map, place) * vec4(color")

    override fun start() {
        super.start()
        program = link(VERTEX, textured)
        glBindTexture(GL_TEXTURE_2D, glGenTextures())
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, IntArray(64) { -0x1000000 or it * 0x30401 })
        glGenerateMipmap(GL_TEXTURE_2D)
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 16f)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8)
        glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, floatArrayOf(4f, 0f, 0f, 0f))
        glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, intArrayOf(2, 0, 0, 0))
        val sampler = glGenSamplers()
        glSamplerParameterf(sampler, GL_TEXTURE_MAX_ANISOTROPY_EXT, 15f)
        glSamplerParameteri(sampler, GL_TEXTURE_MAX_ANISOTROPY_EXT, 14)
        glSamplerParameterfv(sampler, GL_TEXTURE_MAX_ANISOTROPY_EXT, floatArrayOf(13f, 0f, 0f, 0f))
        glSamplerParameteriv(sampler, GL_TEXTURE_MAX_ANISOTROPY_EXT, intArrayOf(12, 0, 0, 0))
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 0f)
        val texture = glGetTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT)
        say("in force $texture ${glGetSamplerParameterf(sampler, GL_TEXTURE_MAX_ANISOTROPY_EXT)} error ${glGetError()}")
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Sharpener().run()
    }
}

/** Puts the cursor back into the middle of its window after each move, hides it amid the script, and tells where it is. */
internal class Recentrer : Painter() {
    private val middle = 32.0 to 24.0

    override fun start() {
        super.start()
        recentre()
    }

    override fun onMouseMove(
        xpos: Double,
        ypos: Double,
    ) {
        say("moved ${xpos - middle.first} ${ypos - middle.second}, mouse ${mousePos.xpos} ${mousePos.ypos}")
        if (frame > Moment.ALT_RIGHT.ordinal) setCursorVisible(false) else recentre()
    }

    private fun recentre() {
        val window = glfwGetCurrentContext()
        glfwSetCursorPos(window, middle.first, middle.second)
        val (x, y) = DoubleArray(1) to DoubleArray(1)
        glfwGetCursorPos(window, x, y)
        if (x[0] to y[0] != middle) say("at ${x[0]} ${y[0]}")
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Recentrer().run()
    }
}

/** Its stages compile and do not fit together. */
internal class Misfit : Painter() {
    override fun start() {
        super.start()
        program = link(VERTEX.replace("vec2 place", "vec4 place").replace("place = position", "place = vec4(position, 0.0, 1.0)"), FRAGMENT)
        say("linked ${glGetProgrami(program, GL_LINK_STATUS)}")
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Misfit().run()
    }
}

/** Its fragment shader knows the vector of its vertex shader by another name. */
internal class Renamer : Painter() {
    override fun start() {
        super.start()
        program = link(VERTEX, FRAGMENT.replace(Regex("\\bplace\\b"), "spot"))
        say("linked ${glGetProgrami(program, GL_LINK_STATUS)}")
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Renamer().run()
    }
}

/** Ends the JVM in its third frame. */
internal class Quitter : Painter() {
    override fun paint() {
        super.paint()
        if (frame == 2) exitProcess(7)
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Quitter().run()
    }
}

/** Throws amid its third frame. */
internal class Thrower : Painter() {
    override fun paint() {
        super.paint()
        if (frame == 2) error("the student's own")
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>): Unit = Thrower().run()
    }
}

/** Throws before it has a window. */
internal object Stillborn {
    private val nothing: Any = error("no assets")

    @JvmStatic
    fun main(args: Array<String>): Unit = println(nothing)
}
