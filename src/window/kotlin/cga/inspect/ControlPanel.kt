package cga.inspect

import cga.exercise.game.Scene
import cga.inspect.knob.KnobGroup
import cga.inspect.light.InspectedLight
import cga.inspect.tune.TunedLight
import cga.inspect.tune.Tuning
import cga.inspect.ui.Columns
import cga.inspect.ui.Ui
import cga.inspect.ui.UiColor
import cga.inspect.ui.Widgets
import cga.inspect.view.Look
import cga.inspect.view.View
import org.joml.Vector3fc

/**
 * The panel on the right: what is shown, of which lights, and every number of the scene.
 *
 * @param copy is given the Kotlin code when it is asked for.
 */
internal class ControlPanel(
    private val scene: Scene,
    private val look: Look,
    private val tuning: Tuning,
    private val clock: Clock,
    private val copy: (String) -> Unit,
) {
    private val views = View.entries.map { it.title }

    fun draw(
        ui: Ui,
        width: Float,
        height: Float,
    ) {
        ui.panel(TITLE, width - WIDTH - MARGIN, MARGIN, WIDTH, height - 2 * MARGIN) {
            look()
            row(2)
            if (button("Reset all")) {
                look.reset()
                tuning.reset()
            }
            if (button("Copy as Kotlin")) copy(tuning.toKotlin())
            lights()
            numbers()
        }
    }

    private fun Widgets.look() {
        row(NAMED)
        label("show", UiColor.FAINT)
        look.view = View.entries[choice(views, look.view.ordinal)]
        paragraph(look.view.legend, WIDTH, UiColor.FAINT)
        row(1)
        look.isSplit = checkbox("Phong | Blinn-Phong, side by side", look.isSplit)
        row(2)
        look.hasGizmos = checkbox("light gizmos", look.hasGizmos)
        clock.isPaused = checkbox("pause time", clock.isPaused)
    }

    private fun Widgets.lights() {
        fold("Lights", true) {
            if (tuning.lights.isEmpty()) paragraph("None shines at this step.", WIDTH, UiColor.FAINT)
            for ((i, light) in tuning.lights.withIndex()) {
                row(LIGHT)
                swatch(color(light.light.lightColor))
                look.switch(i, checkbox(light.name, look.isOn(i)))
                if (button("alone")) look.solo(i)
                if (option("factors", look.light == i)) look.light = i
            }
        }
        for (light in tuning.lights) fold(light.name, false) { knobs(light) }
    }

    private fun Widgets.knobs(light: TunedLight) {
        for (group in light.groups) {
            if (group.title != InspectedLight.ATTENUATION || scene.step.attenuation) knobs(group)
        }
    }

    private fun Widgets.numbers() {
        fold("Material", false) { knobs(tuning.materials) }
        fold("Ambient, gamma", false) { knobs(tuning.picture) }
    }

    private fun Widgets.knobs(group: KnobGroup) {
        row(1)
        label(group.title, UiColor.FAINT)
        for (knob in group.knobs) {
            row(KNOB)
            label(knob.name)
            val value = slider(knob.value, knob.min, knob.max)
            if (value != knob.value) tuning.turn(knob, value)
        }
    }

    /** As bright as a screen can show it. */
    private fun color(light: Vector3fc): Long {
        val largest = maxOf(light.x(), light.y(), light.z(), 1f)
        var rgba = 0L
        for (i in 0..2) rgba = (rgba shl 8) or (light.get(i) / largest * 255).toLong().coerceIn(0, 255)
        return (rgba shl 8) or 0xFF
    }

    companion object {
        /** What it takes of the window, with the margin. */
        const val TAKES: Float = 374f
        const val TITLE: String = "The formula"
        private const val WIDTH = 360f
        private const val MARGIN = 7f
        private val NAMED = Columns(0.16f, 0.84f)
        private val LIGHT = Columns(0.07f, 0.42f, 0.21f, 0.28f)
        private val KNOB = Columns(0.24f, 0.38f, 0.38f)
    }
}

/** Whether the scene's time goes on. */
internal class Clock {
    var isPaused: Boolean = false
}
