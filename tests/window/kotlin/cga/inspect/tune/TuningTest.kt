package cga.inspect.tune

import cga.exercise.game.Scene
import cga.exercise.game.Step
import cga.framework.Frame
import cga.inspect.light.InspectedLight
import cga.testing.FLOAT_ROUNDING
import cga.testing.HeldKeys
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sin

/** The knobs turn the scene itself: what they say is what the scene's plain data says. */
class TuningTest {
    private val scene = Scene(HeldKeys()).apply { update(0.0, 5.0) }
    private val tuning = Tuning(scene)

    @Test
    fun `the lights are those of the step, by the names of the course`() {
        val corners = (1..4).map { "cornerLight$it" }
        assertEquals(listOf("pointLight") + corners + "spotLight", tuning.lights.map { it.name })
        val earlier = mapOf(Step.EMISSION to 0, Step.POINT_LIGHT to 1, Step.ORBIT to 2)
        for ((step, names) in earlier.mapValues { listOf("pointLight", "spotLight").take(it.value) }) {
            scene.step = step
            tuning.stepChanged()
            assertEquals(names, tuning.lights.map { it.name }, "$step")
        }
    }

    @Test
    fun `every knob changes the picture's data, and reset brings every number back`() {
        val before = numbers(scene.frame())
        val knobs = (tuning.lights.flatMap { it.groups } + tuning.picture + tuning.materials).flatMap { it.knobs }
        // Six lights with colour, position, K; a cone; ambient, gamma; two exponents.
        assertEquals(6 * 9 + 2 + 4 + 2, knobs.size)
        for (knob in knobs) {
            val old = numbers(scene.frame())
            val share = if (knob.value < (knob.min + knob.max) / 2) 0.9f else 0.1f
            val target = knob.min + share * (knob.max - knob.min)
            knob.value = target
            // Degrees are kept as radians.
            assertEquals(target, knob.value, 4 * abs(target) * FLOAT_ROUNDING.toFloat(), knob.name)
            assertNotEquals(old, numbers(scene.frame()), "${knob.name} changes nothing")
        }
        tuning.reset()
        assertEquals(before, numbers(scene.frame()))
    }

    @Test
    fun `ends of the sliders are values that the scene takes`() {
        for (knob in (tuning.lights.flatMap { it.groups } + tuning.picture + tuning.materials).flatMap { it.knobs }) {
            knob.value = knob.max
            knob.value = knob.min
        }
        scene.frame()
    }

    @Test
    fun `an inner angle beyond the outer one takes it along, and the other way round`() {
        val (inner, outer) = tuning.lights.last().groups.last().knobs
        inner.value = 80f
        assertEquals(80f, outer.value, 1e-5f)
        outer.value = 20f
        assertEquals(20f, inner.value, 1e-5f)
    }

    @Test
    fun `reset goes back to the attenuation of the step`() {
        scene.step = Step.SPOT_LIGHT
        tuning.stepChanged()
        val k = tuning.lights.first().groups.first { it.title == InspectedLight.ATTENUATION }.knobs
        k[1].value = 0.7f
        tuning.reset()
        assertEquals(listOf(1f, 0f, 0f), k.map { it.value })
    }

    @Test
    fun `the motorcycle's colour is held while its knob is turned, and goes with the time again after reset`() {
        val red = tuning.lights.first().groups.first().knobs.first()
        red.value = 0.123f
        scene.update(0.0, 9.0)
        assertEquals(0.123f, scene.frame().lights.first().color.x())
        assertEquals(0.123f, scene.frame().draws.last().tint.x())
        tuning.reset()
        assertEquals(abs(sin(9.0)).toFloat(), scene.frame().lights.first().color.x())
    }

    @Test
    fun `the Kotlin code makes the same lights again`() {
        tuning.lights.last().groups.last().knobs.first().value = 12.345f
        tuning.lights[1].groups.first().knobs[2].value = 3.75f
        scene.ambient = Vector3f(0.1f, 0.2f, 0.3f)
        // The motorcycle's light has its colour once a picture was made.
        val frame = scene.frame()
        val lines = tuning.toKotlin().lines()
        for ((i, light) in tuning.lights.withIndex()) {
            val line = lines.single { it.startsWith("val ${light.name} = ") }
            val numbers = NUMBER
                .findAll(
                    line.substringAfter('=').substringBefore("//"),
                ).map { it.value.removeSuffix("f").toFloat() }
                .toList()
            val position = light.light.getPosition()
            val data = frame.lights[i]
            val cone = data.cone?.let { listOf(it.innerAngle, it.outerAngle) }.orEmpty()
            assertEquals(
                listOf(position, data.color).flatMap { listOf(it.x(), it.y(), it.z()) } + cone +
                    data.attenuation.let { listOf(it.x(), it.y(), it.z()) },
                numbers,
                line,
            )
        }
        assertEquals("scene.ambient = Vector3f(0.1f, 0.2f, 0.3f)", lines.single { "ambient" in it })
    }

    /** Every number that a picture is made of. */
    private fun numbers(frame: Frame): List<Any> =
        listOf(frame.ambient, frame.gamma) +
            frame.lights.flatMap { listOf(it.position, it.color, it.attenuation) } +
            frame.lights.mapNotNull { it.cone }.flatMap { listOf(it.direction, it.innerAngle, it.outerAngle) } +
            frame.draws.flatMap { listOf(it.tint, it.material.shininess) }

    private companion object {
        val NUMBER = Regex("""(?<![A-Za-z])-?\d+(\.\d+)?(E-?\d+)?f""")
    }
}
