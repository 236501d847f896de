package cga.inspect

import cga.coach.ui.Columns
import cga.coach.ui.Ui
import cga.coach.ui.UiColor
import cga.coach.ui.Widgets
import cga.coach.ui.say
import cga.exercise.game.Scene
import cga.exercise.game.Step
import cga.inspect.knob.KnobGroup
import cga.inspect.light.InspectedLight
import cga.inspect.tune.TunedLight
import cga.inspect.tune.Tuning
import cga.inspect.view.Look
import cga.inspect.view.View
import org.joml.Vector3fc
import org.lwjgl.glfw.GLFW.GLFW_KEY_1
import org.lwjgl.glfw.GLFW.GLFW_KEY_B
import org.lwjgl.glfw.GLFW.GLFW_KEY_F12
import org.lwjgl.glfw.GLFW.GLFW_KEY_F9
import org.lwjgl.glfw.GLFW.GLFW_KEY_H
import org.lwjgl.glfw.GLFW.GLFW_KEY_R
import org.lwjgl.glfw.GLFW.GLFW_KEY_TAB

/** The panel on the right: what is shown, of which lights, every number of the scene, and a button for everything that a key does. */
internal class ControlPanel(
    private val scene: Scene,
    private val look: Look,
    private val tuning: Tuning,
    private val clock: Clock,
    private val actions: Actions,
) {
    private val views = View.entries.map { it.title }
    private val steps = Step.entries.map { "${it.sheet}  ${it.title}" }
    private val buttons =
        listOf(
            "Phong / Blinn-Phong (B)" to GLFW_KEY_B,
            say("shaders anew (R)", "Shader neu (R)") to GLFW_KEY_R,
            say("save picture (F12)", "Bild sichern (F12)") to GLFW_KEY_F12,
            say("save input (F9)", "Eingaben sichern (F9)") to GLFW_KEY_F9,
            say("all keys (H)", "alle Tasten (H)") to GLFW_KEY_H,
            say("close panel (Tab)", "Tafel zu (Tab)") to GLFW_KEY_TAB,
        )

    fun draw(
        ui: Ui,
        width: Float,
        height: Float,
    ) {
        ui.panel(TITLE, width - WIDTH - MARGIN, MARGIN, WIDTH, height - 2 * MARGIN) {
            look()
            row(2)
            if (button(say("reset all", "alles zurück"))) {
                look.reset()
                tuning.reset()
            }
            if (button(say("copy as Kotlin (C)", "als Kotlin kopieren (C)"))) actions.copy(tuning.toKotlin())
            lights()
            numbers()
            others()
        }
    }

    private fun Widgets.others() {
        fold(say("Window", "Fenster"), true) {
            row(2)
            for ((name, key) in buttons) if (button(name)) actions.press(key)
        }
    }

    private fun Widgets.look() {
        row(NAMED)
        label(say("step", "Schritt"), UiColor.FAINT)
        val step = choice(steps, scene.step.ordinal)
        if (step != scene.step.ordinal) actions.press(GLFW_KEY_1 + step)
        label(say("show", "zeigen"), UiColor.FAINT)
        look.view = View.entries[choice(views, look.view.ordinal)]
        paragraph(look.view.legend, WIDTH, UiColor.FAINT)
        row(1)
        val isSplit = checkbox(say("Phong | Blinn-Phong, side by side (F)", "Phong | Blinn-Phong nebeneinander (F)"), look.isSplit)
        if (isSplit != look.isSplit) actions.split(isSplit)
        row(2)
        look.hasGizmos = checkbox(say("light gizmos (G)", "Lichter zeigen (G)"), look.hasGizmos)
        clock.isPaused = checkbox(say("pause time (P)", "Zeit anhalten (P)"), clock.isPaused)
    }

    private fun Widgets.lights() {
        fold(say("Lights", "Lichter"), true) {
            if (tuning.lights.isEmpty()) {
                paragraph(
                    say("None shines at this step.", "Bei diesem Schritt leuchtet keines."),
                    WIDTH,
                    UiColor.FAINT,
                )
            }
            for ((i, light) in tuning.lights.withIndex()) {
                row(LIGHT)
                swatch(color(light.light.lightColor))
                look.switch(i, checkbox(light.name, look.isOn(i)))
                if (button(say("alone", "allein"))) look.solo(i)
                if (option(say("factors", "Faktoren"), look.light == i)) look.light = i
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
        fold(say("Ambient, gamma", "Umgebungslicht, Gamma"), false) { knobs(tuning.picture) }
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
        const val TAKES: Float = 334f
        const val TITLE: String = "The formula"
        private const val WIDTH = 320f
        private const val MARGIN = 7f
        private val NAMED = Columns(0.19f, 0.81f)
        private val LIGHT = Columns(0.07f, 0.42f, 0.21f, 0.28f)
        private val KNOB = Columns(0.24f, 0.38f, 0.38f)
    }
}

/**
 * What the panel's buttons have done by the window.
 *
 * @param press does what the key does.
 * @param copy is given the Kotlin code when it is asked for.
 * @param split shows Phong beside Blinn-Phong, or not.
 */
internal class Actions(
    val press: (Int) -> Unit,
    val copy: (String) -> Unit,
    val split: (Boolean) -> Unit,
)

/** Whether the scene's time goes on. */
internal class Clock {
    var isPaused: Boolean = false
}
