package cga.grading.sheet4.scene

import cga.grading.scene.ObservedCone
import cga.grading.scene.ObservedFrame
import cga.grading.scene.ObservedLight
import cga.grading.scene.ObservedObject
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.random.Random

/** What an observation may be like at its worst, and what its usual inaccuracy does. */
class HostileFramesTest {
    @Test
    fun `numbers that are none, too large or zero, and things that come and go end in a verdict`() {
        val frames = Rig().play()
        repeat(150) { seed ->
            val verdict = SceneJudge.judge(
                frames.map { spoilt(it, Random(seed * 100 + it.moment.ordinal), 0.02 * (seed % 20)) },
                emptyList(),
            )
            assertEquals(SceneJudge.CHECKS, verdict.checks.map { it.check }.toSet(), "seed $seed")
            for (check in verdict.checks) {
                assertTrue(
                    check.error?.let { it in 0.0..1.0 } ?: true,
                ) { "seed $seed: ${check.check} ${check.error}" }
            }
            for (found in verdict.mistakes) {
                assertTrue(
                    found.fit in 0.0..1.0 && found.difference in 0.0..1.0,
                ) { "seed $seed: ${found.mistake}" }
            }
        }
    }

    @Test
    fun `positions, directions and K that are off by a thousandth name no mistake`() {
        val frames = Rig().play()
        repeat(20) { seed ->
            val random = Random(seed)
            // The worst of the checks takes the difference of two frames over a turn of 0.2 rad.
            SceneJudge.judge(frames.map { shaken(it, random) }, emptyList()).assertRight(tolerance = 1e-2)
        }
    }

    private fun shaken(
        frame: ObservedFrame,
        random: Random,
    ): ObservedFrame {
        fun Vector3dc.shaken(): Vector3d {
            val size = 1e-3 * length() / 2
            return add(random.nextDouble(-size, size), random.nextDouble(-size, size), random.nextDouble(-size, size), Vector3d())
        }
        val lights =
            frame.lights.map { light ->
                val cone = light.spot?.let { ObservedCone(it.direction.shaken().normalize(), it.innerAngle + 1e-3, it.outerAngle - 1e-3) }
                ObservedLight(
                    light.name,
                    light.position.shaken(),
                    light.color,
                    Vector3d(light.k).mul(1 + random.nextDouble(-1e-3, 1e-3)),
                    cone,
                )
            }
        val objects = frame.objects.map { ObservedObject(it.model, it.tint, lights, it.vertices, it.buffers) }
        return ObservedFrame(frame.moment, frame.time, frame.view, frame.projection, objects, lights)
    }

    private fun spoilt(
        frame: ObservedFrame,
        random: Random,
        chance: Double,
    ): ObservedFrame {
        fun isHit() = random.nextDouble() < chance

        fun Double.spoilt() = if (isHit()) BAD.random(random) else this

        fun Vector3dc.spoilt() = Vector3d(x().spoilt(), y().spoilt(), z().spoilt())

        fun Matrix4dc.spoilt() = if (isHit()) Matrix4d().set(get(DoubleArray(16)).map { it.spoilt() }.toDoubleArray()) else this

        fun lights(all: List<ObservedLight>) =
            all.filter { !isHit() }.map { light ->
                val cone = light.spot?.let { ObservedCone(it.direction.spoilt(), it.innerAngle.spoilt(), it.outerAngle.spoilt()) }
                ObservedLight(light.name, light.position.spoilt(), light.color.spoilt(), light.k.spoilt(), cone.takeIf { !isHit() })
            }
        val objects =
            frame.objects.filter { !isHit() }.map { shown ->
                val vertices = shown.vertices.map { it.toDouble().spoilt().toFloat() }.toFloatArray()
                val buffers = if (isHit()) emptyList() else shown.buffers
                ObservedObject(shown.model.spoilt(), shown.tint?.spoilt().takeIf { !isHit() }, lights(shown.lights), vertices, buffers)
            }
        return ObservedFrame(frame.moment, frame.time, frame.view.spoilt(), frame.projection, objects, lights(frame.lights))
    }

    private companion object {
        val BAD = listOf(Double.NaN, Double.POSITIVE_INFINITY, 0.0, 1e30, -1e30, 1e300, 1e-300)
    }
}
