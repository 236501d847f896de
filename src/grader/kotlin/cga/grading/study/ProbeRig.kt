package cga.grading.study

import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryUtil

/** Vertices for a probed program: by attribute location four floats a vertex. */
internal class Feed(val count: Int) {
    val attributes: MutableMap<Int, FloatArray> = sortedMapOf()

    /** The numbers of vertex [vertex] at [location]; those not given are (0, 0, 0, 1). */
    fun set(
        location: Int,
        vertex: Int,
        vararg numbers: Double,
    ) {
        val array = attributes.getOrPut(location) { FloatArray(4 * count) { if (it % 4 == 3) 1f else 0f } }
        numbers.forEachIndexed { i, number -> array[4 * vertex + i] = number.toFloat() }
    }
}

/**
 * Runs [ProbeProgram]s: colours of chosen vertices or triangles as unclamped floats, and where the program puts vertices.
 *
 * Textures are single texels of chosen colours. Needs a current context, changes its state freely, and owns what it makes.
 */
internal class ProbeRig : AutoCloseable {
    private val framebuffer = glGenFramebuffers()
    private val color = glGenRenderbuffers()
    private val vertexArray = glGenVertexArrays()
    private val buffer = glGenBuffers()
    private val feedback = glGenBuffers()
    private val textures = HashMap<Int, Int>()
    private val texels = HashMap<Int, FloatArray>()

    init {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer)
        glBindRenderbuffer(GL_RENDERBUFFER, color)
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, SIZE, SIZE)
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color)
        check(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) { "the driver has no float target to measure with" }
    }

    /** What the program makes of each vertex by itself: RGBA; NaN where it discards. */
    fun points(
        program: ProbeProgram,
        feed: Feed,
        values: Map<String, FloatArray>,
        texels: Map<String, FloatArray>,
    ): FloatArray {
        require(feed.count <= CAPACITY) { "${feed.count} samples are more than the $CAPACITY of one draw" }
        val pixels = FloatArray(2 * feed.count) { i -> ndc(if (i % 2 == 0) (i / 2) % SIZE else (i / 2) / SIZE, 0.0) }
        begin(program, values, texels)
        upload(program, feed, pixels)
        glDrawArrays(GL_POINTS, 0, feed.count)
        return read(feed.count, 1)
    }

    /** What the program makes of the middle of each triangle (three vertices in a row, equal weights): RGBA. */
    fun triangles(
        program: ProbeProgram,
        feed: Feed,
        values: Map<String, FloatArray>,
        texels: Map<String, FloatArray>,
    ): FloatArray {
        val count = feed.count / 3
        require(count <= (SIZE / STEP) * (SIZE / STEP)) { "$count triangles do not fit on the target" }
        val pixels = FloatArray(2 * feed.count) { i -> corner(i / 2, i % 2) }
        begin(program, values, texels)
        upload(program, feed, pixels)
        glDrawArrays(GL_TRIANGLES, 0, feed.count)
        return read(count, STEP)
    }

    /** gl_Position of each vertex as the submission's own main leaves it. */
    fun clip(
        program: ProbeProgram,
        feed: Feed,
        values: Map<String, FloatArray>,
    ): FloatArray {
        begin(program, values, emptyMap())
        upload(program, feed, FloatArray(2 * feed.count))
        glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, feedback)
        glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 16L * feed.count, GL_STREAM_READ)
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, feedback)
        glEnable(GL_RASTERIZER_DISCARD)
        glBeginTransformFeedback(GL_POINTS)
        glDrawArrays(GL_POINTS, 0, feed.count)
        glEndTransformFeedback()
        glDisable(GL_RASTERIZER_DISCARD)
        val result = FloatArray(4 * feed.count)
        glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0L, result)
        return result
    }

    override fun close() {
        glDeleteFramebuffers(framebuffer)
        glDeleteRenderbuffers(color)
        glDeleteVertexArrays(vertexArray)
        glDeleteBuffers(buffer)
        glDeleteBuffers(feedback)
        textures.values.forEach(::glDeleteTextures)
    }

    private fun begin(
        program: ProbeProgram,
        values: Map<String, FloatArray>,
        texels: Map<String, FloatArray>,
    ) {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer)
        glViewport(0, 0, SIZE, SIZE)
        for (capability in SWITCHED_OFF) glDisable(capability)
        glColorMask(true, true, true, true)
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)
        glClearColor(Float.NaN, Float.NaN, Float.NaN, 0f)
        glClear(GL_COLOR_BUFFER_BIT)
        glUseProgram(program.id)
        program.send(values)
        val samplers = program.samplers
        samplers.forEachIndexed { unit, sampler -> bindTexel(unit, texels[sampler.name] ?: BLACK) }
        program.depths.indices.forEach { bindTexel(samplers.size + it, WHITE) }
    }

    private fun bindTexel(
        unit: Int,
        rgb: FloatArray,
    ) {
        glActiveTexture(GL_TEXTURE0 + unit)
        glBindTexture(GL_TEXTURE_2D, textures.getOrPut(unit, ::glGenTextures))
        if (texels[unit].contentEquals(rgb)) return
        texels[unit] = rgb
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, floatArrayOf(rgb[0], rgb[1], rgb[2], 1f))
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST)
    }

    private fun upload(
        program: ProbeProgram,
        feed: Feed,
        pixels: FloatArray,
    ) {
        glBindVertexArray(vertexArray)
        glBindBuffer(GL_ARRAY_BUFFER, buffer)
        val arrays = feed.attributes.values
        glBufferData(GL_ARRAY_BUFFER, 4L * (arrays.sumOf { it.size } + pixels.size), GL_STREAM_DRAW)
        for (location in 0..15) glDisableVertexAttribArray(location)
        var offset = 0L
        for ((location, array) in feed.attributes) {
            glBufferSubData(GL_ARRAY_BUFFER, offset, array)
            glEnableVertexAttribArray(location)
            glVertexAttribPointer(location, 4, GL_FLOAT, false, 0, offset)
            offset += 4L * array.size
        }
        glBufferSubData(GL_ARRAY_BUFFER, offset, pixels)
        glEnableVertexAttribArray(program.pixelLocation)
        glVertexAttribPointer(program.pixelLocation, 2, GL_FLOAT, false, 0, offset)
    }

    private fun read(
        count: Int,
        step: Int,
    ): FloatArray {
        val perRow = SIZE / step
        val rows = ((count + perRow - 1) / perRow * step).coerceIn(1, SIZE)
        val pixels = MemoryUtil.memAllocFloat(4 * SIZE * rows)
        try {
            glReadPixels(0, 0, SIZE, rows, GL_RGBA, GL_FLOAT, pixels)
            return FloatArray(4 * count) { i ->
                val x = (i / 4) % perRow * step + step / 2
                val y = (i / 4) / perRow * step + step / 2
                pixels[4 * (y * SIZE + x) + i % 4]
            }
        } finally {
            MemoryUtil.memFree(pixels)
        }
    }

    /** Corners about the middle of a pixel, on multiples of 1/256 of one, so that nothing snaps: all weights in the middle are 1/3. */
    private fun corner(
        vertex: Int,
        axis: Int,
    ): Float {
        val triangle = vertex / 3
        val perRow = SIZE / STEP
        val pixel = (if (axis == 0) triangle % perRow else triangle / perRow) * STEP + STEP / 2
        return ndc(pixel, CORNERS[vertex % 3][axis])
    }

    private fun ndc(
        pixel: Int,
        offset: Double,
    ): Float = ((2.0 * (pixel + 0.5 + offset)) / SIZE - 1.0).toFloat()

    companion object {
        private const val SIZE = 256
        private const val STEP = 4
        private val CORNERS = arrayOf(doubleArrayOf(1.5, 0.0), doubleArrayOf(-0.75, 1.25), doubleArrayOf(-0.75, -1.25))
        private val BLACK = FloatArray(3)
        private val WHITE = floatArrayOf(1f, 1f, 1f)
        private val SWITCHED_OFF =
            intArrayOf(GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_DITHER, GL_FRAMEBUFFER_SRGB)

        /** The most samples that one draw holds. */
        const val CAPACITY: Int = SIZE * SIZE
    }
}
