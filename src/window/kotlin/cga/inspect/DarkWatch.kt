package cga.inspect

import cga.framework.WindowState
import cga.inspect.doctor.Diagnosis
import cga.inspect.doctor.Evidence
import cga.inspect.doctor.EvidenceReader
import cga.inspect.doctor.Finding
import cga.inspect.view.Look
import cga.inspect.view.View
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryUtil

/**
 * Notices that the picture is black, or that the lights make no difference, and looks for causes.
 *
 * A whole look takes some tens of milliseconds: it is taken when something has changed, and once a second as long as the picture is dark.
 * In between a few rows of pixels are read.
 */
internal class DarkWatch(
    private val window: WindowState,
    private val look: Look,
    private val reader: EvidenceReader,
) : AutoCloseable {
    private var isDue = true
    private var next = 0.0
    private var isDark = false
    private var view = View.FULL
    private val rows = MemoryUtil.memAlloc(4 * MAX_WIDTH)

    /** Something has changed: look at the next picture. */
    fun changed() {
        isDue = true
    }

    /** After drawing the picture of [time] (seconds): the likely causes, or null for what the last call said. */
    fun look(time: Double): List<Finding>? {
        if (look.view != view) isDue = true
        view = look.view
        // A term alone may well be black, and a light may be switched off on purpose: then only what has changed is a reason to look.
        val isPart = view != View.FULL || !look.areAllOn
        if (!isDue && (isPart || time < next)) return null
        next = time + PAUSE
        if (!isDue && !isDark && !isBlack()) return null
        isDue = false
        val evidence = reader.read()
        isDark = isDark(evidence)
        return if (isDark) Diagnosis.of(evidence) else emptyList()
    }

    /** At a step without lights an unlit picture is what was asked for. */
    private fun isDark(evidence: Evidence) = evidence.isBlack || (evidence.hasLights && evidence.isUnlit)

    private fun isBlack(): Boolean {
        val width = minOf(window.framebufferWidth, MAX_WIDTH)
        for (row in 1 until ROWS) {
            rows.clear().limit(4 * width)
            glReadPixels(0, window.framebufferHeight * row / ROWS, width, 1, GL_RGBA, GL_UNSIGNED_BYTE, rows)
            for (i in 0 until 4 * width) if (i % 4 != 3 && (rows[i].toInt() and 0xFF) > 1) return false
        }
        return true
    }

    override fun close() {
        MemoryUtil.memFree(rows)
    }

    private companion object {
        const val PAUSE = 1.0
        const val ROWS = 12
        const val MAX_WIDTH = 8192
    }
}
