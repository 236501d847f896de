package cga.grading.sheet4.scene

import cga.exercise.components.geometry.Transformable
import cga.grading.capture.Key
import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.ObservedLight
import cga.grading.scene.ObservedObject
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.sin
import kotlin.random.Random

/** What the sheet leaves open earns full points. */
class FreedomsTest {
    @Test
    fun `random places, colours, cones, speeds, scales and pitches`() {
        repeat(40) { seed -> RandomRig(Random(seed)).verdict().assertRight() }
    }

    @Test
    fun `a light that hovers over the motorcycle, and further lights that rise and sink`() {
        fun rig(hovers: Rig.(String) -> Boolean) = object : Rig() {
            override fun lights(moment: Moment, t: Double, view: Matrix4d): List<ObservedLight> =
                super.lights(moment, t, view).map {
                    val lift = view.transformDirection(Vector3d(0.0, if (hovers(it.name)) 0.4 * sin(2 * t) else 0.0, 0.0))
                    ObservedLight(it.name, Vector3d(it.position).add(lift), it.color, it.k, it.spot)
                }
        }
        rig { it == own.name }.verdict().assertRight()
        rig { name -> corners.any { it.name == name } }.verdict().assertRight()
    }

    private class RandomRig(private val random: Random) : Rig(random.vector(1.0, 0.3..3.0)) {
        private val speed = random.between(1.0, 12.0)
        private val steering = random.between(0.5, 3.0)
        private val orbitSign = if (random.nextBoolean()) 1 else -1
        private val intensity = random.between(0.5, 10.0)
        private val rates = List(3) { random.nextDouble(0.2, 3.0) }
        private val tint = Vector3d(random.nextDouble(), random.nextDouble(0.2, 1.0), random.nextDouble(0.0, 0.8))

        init {
            motorcycle.scaleLocal(Vector3f(random.between(0.5, 2.0)))
            motorcycle.rotateLocal(0f, random.between(-3.0, 3.0), 0f)
            camera.rotateLocal(random.between(-0.3, 0.3), 0f, 0f)
            head.body.translateGlobal(Vector3f(random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(-1.0, 0.5)))
            head.body.rotateLocal(random.between(-0.6, 0.0), random.between(-0.5, 0.5), 0f)
            corners.forEach { it.body.translateGlobal(random.vector(9.0, 0.0..5.0)) }
        }

        override fun motorcycleTint(t: Double): Vector3d = Vector3d(
            sin(rates[0] * t),
            sin(rates[1] * t),
            sin(rates[2] * t),
        ).add(1.0, 1.0, 1.0)

        override fun ownColor(t: Double): Vector3d = motorcycleTint(t).mul(intensity.toDouble())

        override fun groundTint(t: Double) = tint

        override fun update(dt: Double, t: Double, keys: Set<Key>) {
            if (Key.FORWARD !in keys) return
            val steer = (if (Key.LEFT in keys) 1 else 0) - (if (Key.RIGHT in keys) 1 else 0)
            motorcycle.rotateLocal(0f, (steering * steer * dt).toFloat(), 0f)
            motorcycle.translateLocal(Vector3f(0f, 0f, (-speed * dt).toFloat()))
        }

        override fun orbit(dx: Double, dy: Double) = super.orbit(orbitSign * dx, dy)
    }

    @Test
    fun `pitch by the mouse about the camera's own level axis through the motorcycle`() {
        val rig = object : Rig() {
            var yaw = 0.0
            var pitch = -35.0

            override fun orbit(dx: Double, dy: Double) {
                yaw -= 0.002 * dx
                pitch -= Math.toDegrees(0.002 * dy)
                camera.setLocalModelMatrix(Matrix4f().rotateY(yaw.toFloat()).rotateX(radians(pitch)).translate(0f, 0f, 4f))
            }
        }
        rig.verdict().assertRight()
    }

    @Test
    fun `only while Alt is held, and only while it is not`() {
        for (wanted in listOf(true, false)) {
            val rig = object : Rig() {
                private var isAlt = false

                override fun mouse(x: Double, y: Double, alt: Boolean) {
                    isAlt = alt
                    super.mouse(x, y, alt)
                }

                override fun orbit(dx: Double, dy: Double) {
                    if (isAlt == wanted) super.orbit(dx, dy)
                }
            }
            rig.verdict().assertRight()
        }
    }

    @Test
    fun `events that are only looked at while Alt is not held`() {
        val rig = object : Rig() {
            override fun mouse(x: Double, y: Double, alt: Boolean) {
                if (!alt) super.mouse(x, y, false)
            }
        }
        rig.verdict().assertRight()
    }

    @Test
    fun `a first position that is taken to be the middle of the window`() {
        val rig = object : Rig() {
            init {
                lastX = 640.0
                lastY = 360.0
            }
        }
        rig.verdict().assertRight()
    }

    @Test
    fun `an orbit about the middle of the motorcycle instead of its origin`() {
        val rig = object : Rig() {
            override fun orbit(dx: Double, dy: Double) {
                camera.rotateAroundPoint(0f, (0.002 * dx).toFloat(), 0f, Vector3f(0.1f, 0.5f, -0.3f))
            }
        }
        rig.verdict().assertRight()
    }

    @Test
    fun `a camera that is no child but is put behind the motorcycle in every update`() {
        val rig = object : Rig() {
            var yaw = 0.0

            override fun orbit(dx: Double, dy: Double) {
                yaw += 0.002 * dx
            }

            override fun view(): Matrix4d {
                val at = motorcycle.getWorldPosition()
                return Matrix4d().translation(at).rotateY(yaw).rotateX(-0.6).translate(0.0, 0.0, 5.0).invert()
            }
        }
        rig.verdict().assertRight()
    }

    @Test
    fun `a camera that looks level from near`() {
        val rig = object : Rig() {
            init {
                camera.setLocalModelMatrix(Matrix4f().translation(0f, 0.5f, 2f))
            }
        }
        rig.verdict().assertRight()
    }

    @Test
    fun `more models, some that spin and some of many vertices, and a motorcycle of several parts`() {
        val rig = object : Rig() {
            val wheel = Transformable(parent = motorcycle).apply { translateGlobal(Vector3f(0f, 0.3f, -0.8f)) }
            val rider = Transformable(parent = motorcycle)

            override fun objects(t: Double, lights: List<ObservedLight>): List<ObservedObject> {
                wheel.rotateLocal(t.toFloat(), 0f, 0f)
                val house = FloatArray(3000) { (it % 7).toFloat() }
                val spinning = Matrix4d().translation(3.0, 1.0, 2.0).rotateY(t)
                return listOf(
                    ObservedObject(Matrix4d().translation(5.0, 0.0, 5.0), Vector3d(1.0), lights, house, listOf(8)),
                    ObservedObject(spinning, null, lights, house, listOf(9)),
                    ObservedObject(wheel.getWorldModelMatrix(Matrix4d()), Vector3d(1.0), lights, BIKE.copyOf(6), listOf(10)),
                    ObservedObject(wheel.getWorldModelMatrix(Matrix4d()), Vector3d(1.0), lights, BIKE.copyOf(6), listOf(10)),
                    ObservedObject(rider.getWorldModelMatrix(Matrix4d()), Vector3d(1.0), lights, BIKE.copyOf(9), listOf(11)),
                ) + super.objects(t, lights)
            }
        }
        rig.verdict().assertRight()
    }

    @Test
    fun `ground and motorcycle that start as one object of one matrix and colour`() {
        val rig = object : Rig() {
            init {
                motorcycle.setLocalModelMatrix(Matrix4f())
            }

            override fun motorcycleTint(t: Double): Vector3d = if (t < 1) Vector3d(0.0, 1.0, 0.0) else Vector3d(sin(t), 1.0, 0.0)

            override fun objects(t: Double, lights: List<ObservedLight>): List<ObservedObject> {
                val (ground, bike) = super.objects(t, lights)
                if (t >= 0.5) return listOf(ground, bike)
                val vertices = ground.vertices + bike.vertices
                return listOf(ObservedObject(ground.model, ground.tint, lights, vertices, ground.buffers + bike.buffers))
            }
        }
        rig.verdict().assertRight()
    }

    @Test
    fun `a ground that is scaled and lies lower, with the light just above it`() {
        val rig = object : Rig(Vector3f(0f, -0.5f, 0f)) {
            override fun objects(t: Double, lights: List<ObservedLight>): List<ObservedObject> {
                val (ground, bike) = super.objects(t, lights)
                val lower = Matrix4d().translation(0.0, -1.0, 0.0).scale(3.0)
                return listOf(bike, ObservedObject(lower, ground.tint, lights, ground.vertices, ground.buffers))
            }
        }
        rig.verdict().assertRight()
    }

    @Test
    fun `sines that go below zero, with a light that does not`() {
        val rig = object : Rig() {
            override fun motorcycleTint(t: Double) = Vector3d(sin(t), sin(1.3 * t), 0.7)

            override fun ownColor(t: Double): Vector3d = motorcycleTint(t).max(Vector3d())
        }
        rig.verdict().assertRight()
    }

    @Test
    fun `a light whose colour is that of the update before`() {
        val rig = object : Rig() {
            override fun ownColor(t: Double): Vector3d = motorcycleTint(maxOf(0.0, t - 1.0 / 60)) ?: Vector3d()
        }
        rig.verdict().assertRight()
    }

    @Test
    fun `a second light on the motorcycle, a light that flies about, a light beside the headlight`() {
        val rig = object : Rig() {
            val tail = Lamp("a_tail", lamp(Vector3f(0f, 0.6f, 1f), motorcycle), POINT_K) { Vector3d(1.0, 0.0, 0.0) }
            val flying = Lamp("flying", lamp(Vector3f(), null), POINT_K) { Vector3d(0.0, 1.0, 1.0) }
            val second = Lamp("second", lamp(Vector3f(0.2f, 0.9f, -1.6f), motorcycle), SPOT_K, 0.1, 0.2, true) { HEAD_COLOR }
            override val lamps get() = listOf(tail) + corners + listOf(second, own, head, flying)

            override fun update(dt: Double, t: Double, keys: Set<Key>) {
                super.update(dt, t, keys)
                flying.body.setLocalModelMatrix(Matrix4f().translation(8 * sin(t).toFloat(), 2f, 5 * sin(2 * t).toFloat()))
            }

            init {
                second.body.rotateLocal(-0.1f, 0f, 0f)
            }
        }
        val verdict = rig.verdict()
        verdict.assertRight()
        assertTrue("a_tail" !in (verdict[Check.LIGHT_COLOR]?.text ?: "a_tail"), verdict.text())
    }

    @Test
    fun `a further light that comes after the motorcycle, ever more slowly`() {
        val rig = object : Rig() {
            private val trail = Lamp("trail", lamp(Vector3f(0f, 2f, 3f), null), POINT_K) { Vector3d(0.0, 1.0, 1.0) }
            override val lamps get() = listOf(own, head) + corners + trail

            override fun update(dt: Double, t: Double, keys: Set<Key>) {
                super.update(dt, t, keys)
                val way = motorcycle.getWorldPosition().add(Vector3f(0f, 2f, 3f)).sub(trail.body.getWorldPosition())
                trail.body.translateGlobal(way.mul((1 - Math.exp(-dt)).toFloat()))
            }
        }
        rig.verdict().assertRight()
    }

    @Test
    fun `a headlight on the handlebar turns aside while a key steers`() {
        val rig = object : Rig() {
            private var steering = 0f

            override fun update(dt: Double, t: Double, keys: Set<Key>) {
                super.update(dt, t, keys)
                steering = if (Key.LEFT in keys) {
                    0.3f
                } else if (Key.RIGHT in keys) {
                    -0.3f
                } else {
                    0f
                }
            }

            override fun worldDirection(lamp: Lamp) = super.worldDirection(lamp).rotateY(steering.toDouble())
        }
        val verdict = rig.verdict()
        verdict.assertRight()
        assertTrue(verdict.notes.any { it.key == "scene.aim.swings" }, verdict.text())
    }

    @Test
    fun `a headlight on a fork that swings back slowly turns aside and moves a little`() {
        val verdict = Fork(back = 1.0).verdict()
        verdict.assertRight()
        assertTrue(verdict.notes.any { it.key == "scene.aim.swings" }, verdict.text())
    }

    @Test
    fun `a headlight that never swings back, or flies far aside, is no freedom`() {
        Fork(back = 0.0, lever = 0f).verdict().assertCosts(Check.SPOT_DIRECTION)
        val far = Fork(back = 1.0, lever = 6f).verdict()
        val place = far.checks.single { it.check == Check.POINT_LIGHT_POSITION }
        assertTrue((place.error ?: 0.0) > 0.01, far.text())
    }

    @Test
    fun `a headlight that swings is judged where it is straight, in a wrong space as well`() {
        val verdict = object : Fork(back = 1000.0, lever = 0f) {
            override fun direction(lamp: Lamp, view: Matrix4d) = worldDirection(lamp)
        }.verdict()
        assertEquals(listOf(Mistake.SPOT_DIRECTION_WORLD), verdict.mistakes.map { it.mistake }, verdict.text())
    }

    /** A headlight on a fork: it turns aside by up to 0.3 radians while a key steers, then comes [back] at so many radians a second. */
    private open class Fork(
        private val back: Double,
        private val lever: Float = 0.6f,
    ) : Rig() {
        private val head0 = Vector3d(0.0, 0.9, -1.6)
        private var steering = 0.0

        override fun update(
            dt: Double,
            t: Double,
            keys: Set<Key>,
        ) {
            super.update(dt, t, keys)
            val wanted = (if (Key.LEFT in keys) 0.3 else 0.0) - (if (Key.RIGHT in keys) 0.3 else 0.0)
            val pace = if (wanted == 0.0) back else 4.0
            steering += (wanted - steering).coerceIn(-pace * dt, pace * dt)
        }

        override fun worldDirection(lamp: Lamp) = super.worldDirection(lamp).rotateY(steering)

        override fun position(
            lamp: Lamp,
            view: Matrix4d,
        ): Vector3d {
            if (lamp !== head) return super.position(lamp, view)
            val onFork = Vector3d(0.0, 0.0, -lever.toDouble()).rotateY(steering).add(head0).add(0.0, 0.0, lever.toDouble())
            return view.transformPosition(motorcycle.getWorldModelMatrix(Matrix4d()).transformPosition(onFork))
        }
    }

    @Test
    fun `a headlight that takes the motorcycle's own direction is not tilted down`() {
        val rig = object : Rig() {
            init {
                head.body.setLocalModelMatrix(Matrix4f().translation(0f, 1f, -1f))
            }
        }
        val verdict = rig.verdict()
        verdict.assertMistake(Mistake.UNKNOWN, Check.SPOT_DIRECTION, least = 0.5)
        assertEquals("scene.aim.level", verdict[Check.SPOT_DIRECTION]?.message?.key)
    }

    @Test
    fun `a motorcycle that rolls on a little after the key is released`() {
        val rig = object : Rig() {
            private var speed = 0.0

            override fun update(dt: Double, t: Double, keys: Set<Key>) {
                speed = if (Key.FORWARD in keys) 6.0 else speed * 0.97
                if (Key.LEFT in keys) motorcycle.rotateLocal(0f, (1.5 * dt).toFloat(), 0f)
                motorcycle.translateLocal(Vector3f(0f, 0f, (-speed * dt).toFloat()))
            }
        }
        rig.verdict().assertRight()
    }

    @Test
    fun `a motorcycle that cannot be driven is guessed, and what needs the drive is not measured`() {
        val rig = object : Rig() {
            override fun update(dt: Double, t: Double, keys: Set<Key>) = Unit
        }
        val verdict = rig.verdict()
        assertEquals(emptyList<String>(), verdict.mistakes.map { it.mistake.id }, verdict.text())
        for (check in listOf(Check.POINT_LIGHT_CHILD, Check.SPOT_LIGHT_CHILD)) assertNull(verdict[check]?.error, verdict.text())
        assertTrue((verdict.checks - verdict.checks.filter { it.error == null }.toSet()).all { (it.error ?: 1.0) < 1e-3 }, verdict.text())
        assertTrue(verdict.notes.any { it.key == "scene.scene.not-driven" }, verdict.text())
        assertEquals("scene.color.changes", verdict[Check.MOTORCYCLE_COLOR]?.message?.key, verdict.text())
    }

    private companion object {
        fun Random.between(least: Double, most: Double) = nextDouble(least, most).toFloat()

        fun Random.vector(aside: Double, height: ClosedFloatingPointRange<Double>) =
            Vector3f(between(-aside, aside), between(height.start, height.endInclusive), between(-aside, aside))
    }
}
