package cga.grading.sheet4.scene

import cga.grading.capture.Key
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.rigidPart
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What can be wrong with the camera and the mouse. */
class OrbitMistakesTest {
    private val all = arrayOf(Check.ORBIT, Check.ORBIT_PIVOT, Check.ORBIT_HORIZON, Check.ORBIT_FACTOR, Check.ORBIT_START)

    @Test
    fun `the mouse does nothing`() {
        turning { _, _, _ -> }.assertMistake(Mistake.ORBIT_MISSING, *all, least = 1.0)
    }

    @Test
    fun `the mouse turns the motorcycle, the camera with it`() {
        val verdict = turning { rig, dx, _ -> rig.motorcycle.rotateLocal(0f, dx, 0f) }
        verdict.assertMistake(Mistake.ORBIT_MISSING, Check.ORBIT, least = 1.0)
        assertTrue("motorcycle" in verdict.mistakes.single().where, verdict.text())
    }

    @Test
    fun `the mouse pushes the camera aside`() {
        val verdict = turning { rig, dx, _ -> rig.camera.translateLocal(Vector3f(dx, 0f, 0f)) }
        verdict.assertMistake(Mistake.UNKNOWN, *all, least = 1.0)
    }

    @Test
    fun `the angle is that of the last movement and not of all`() {
        val rig = object : Rig() {
            private var last = 0.0

            override fun orbit(dx: Double, dy: Double) {
                camera.rotateAroundPoint(0f, (-0.002 * (dx - last)).toFloat(), 0f, Vector3f())
                last = dx
            }
        }
        rig.verdict().assertMistake(Mistake.MOUSE_FACTOR, least = 1.0)
    }

    @Test
    fun `every event takes the difference to the first position`() {
        val rig = object : Rig() {
            override fun mouse(x: Double, y: Double, alt: Boolean) {
                if (lastX.isNaN()) lastX = x
                orbit(x - lastX, 0.0)
            }
        }
        rig.verdict().assertMistake(Mistake.MOUSE_FACTOR)
    }

    @Test
    fun `about the camera's own axis on the spot, which costs the horizon and not the pivot too`() {
        turning { rig, dx, _ -> rig.camera.rotateLocal(0f, dx, 0f) }.assertMistake(Mistake.ORBIT_OWN_AXIS, least = 0.3)
    }

    @Test
    fun `about an axis through the motorcycle that is tilted with the camera`() {
        val verdict =
            turning { rig, dx, _ ->
                rig.camera.translateLocal(Vector3f(0f, 0f, -4f))
                rig.camera.rotateLocal(0f, dx, 0f)
                rig.camera.translateLocal(Vector3f(0f, 0f, 4f))
            }
        verdict.assertMistake(Mistake.ORBIT_OWN_AXIS, least = 0.3)
    }

    @Test
    fun `about the motorcycle's world position in the motorcycle's own space`() {
        val verdict = turning { rig, dx, _ -> rig.camera.rotateAroundPoint(0f, dx, 0f, rig.motorcycle.getWorldPosition()) }
        verdict.assertMistake(Mistake.ORBIT_PIVOT, least = 0.5)
        assertTrue("own space" in verdict.mistakes.single().where, verdict.text())
        assertTrue(verdict.mistakes.single().fit < 1e-3, verdict.text())
    }

    @Test
    fun `about the origin of the world`() {
        val rig = object : Rig() {
            override fun orbit(dx: Double, dy: Double) {
                val origin = motorcycle.getWorldModelMatrix().invert().transformPosition(Vector3f())
                camera.rotateAroundPoint(0f, (0.002 * dx).toFloat(), 0f, origin)
            }
        }
        val verdict = rig.verdict()
        verdict.assertMistake(Mistake.ORBIT_PIVOT, least = 0.5)
        assertTrue("origin" in verdict.mistakes.single().where, verdict.text())
    }

    @Test
    fun `on the spot with a level horizon`() {
        val verdict = turning { rig, dx, _ -> rig.camera.rotateAroundPoint(0f, dx, 0f, rig.camera.getPosition()) }
        verdict.assertMistake(Mistake.ORBIT_PIVOT, least = 0.5)
        assertTrue("camera itself" in verdict.mistakes.single().where, verdict.text())
    }

    @Test
    fun `the way to the side turns the camera up and down, or rolls it`() {
        turning { rig, dx, _ -> rig.camera.rotateAroundPoint(dx, 0f, 0f, Vector3f()) }
            .assertMistake(Mistake.UNKNOWN, Check.ORBIT, least = 0.9)
        val rolled = turning { rig, dx, _ -> rig.camera.rotateAroundPoint(0f, 0f, dx, Vector3f()) }
        rolled.assertMistake(Mistake.UNKNOWN, Check.ORBIT, least = 0.9)
    }

    @Test
    fun `half as fast, in degrees, and in degrees taken for radians`() {
        for (factor in listOf(0.5, Math.toRadians(1.0), 2.5)) {
            val verdict = turning { rig, dx, _ -> rig.camera.rotateAroundPoint(0f, (dx * factor).toFloat(), 0f, Vector3f()) }
            verdict.assertMistake(Mistake.MOUSE_FACTOR, least = 0.3)
        }
    }

    @Test
    fun `a turn that goes on while the mouse rests`() {
        val rig = object : Rig() {
            var speed = 0.0

            override fun orbit(dx: Double, dy: Double) {
                speed = dx
            }

            override fun update(dt: Double, t: Double, keys: Set<Key>) {
                super.update(dt, t, keys)
                camera.rotateAroundPoint(0f, (0.002 * speed).toFloat(), 0f, Vector3f())
            }
        }
        val verdict = rig.verdict()
        assertEquals(Mistake.MOUSE_FACTOR, verdict.mistakes.first().mistake, verdict.text())
        assertEquals(0.0, verdict[Check.ORBIT_PIVOT]?.error ?: 1.0, 1e-4, verdict.text())
    }

    @Test
    fun `a first event that is measured from the corner of the screen, or from -1`() {
        for (start in listOf(0.0, -1.0)) {
            val rig = object : Rig() {
                init {
                    lastX = start
                    lastY = start
                }
            }
            val verdict = rig.verdict()
            verdict.assertMistake(Mistake.MOUSE_JUMP, least = 0.9)
            assertTrue(verdict.mistakes.single().fit < 1e-3, verdict.text())
        }
    }

    @Test
    fun `a first event under Alt that is measured from the corner of the screen`() {
        val rig = object : Rig() {
            init {
                lastX = 0.0
                lastY = 0.0
            }

            override fun mouse(x: Double, y: Double, alt: Boolean) {
                if (alt) super.mouse(x, y, true)
            }
        }
        rig.verdict().assertMistake(Mistake.MOUSE_JUMP, least = 0.9)
    }

    @Test
    fun `pitch on the spot takes the motorcycle out of focus`() {
        val verdict =
            turning { rig, dx, dy ->
                rig.camera.rotateAroundPoint(0f, dx, 0f, Vector3f())
                rig.camera.rotateLocal(dy, 0f, 0f)
            }
        verdict.assertMistake(Mistake.ORBIT_PIVOT, least = 0.5)
    }

    @Test
    fun `pitch on the spot within narrow bounds is a freedom`() {
        val rig = object : Rig() {
            private var tilt = 0f

            override fun orbit(dx: Double, dy: Double) {
                camera.rotateAroundPoint(0f, (-0.002 * dx).toFloat(), 0f, Vector3f())
                val next = (tilt + (0.001 * dy).toFloat()).coerceIn(-0.15f, 0.15f)
                camera.rotateLocal(next - tilt, 0f, 0f)
                tilt = next
            }
        }
        val verdict = rig.verdict()
        assertEquals(emptyList<Mistake>(), verdict.mistakes.map { it.mistake }, verdict.text())
        assertEquals(0.0, verdict[Check.ORBIT_PIVOT]?.error ?: 1.0, 1e-4, verdict.text())
    }

    @Test
    fun `the way down turns the camera, and the way to the side does nothing`() {
        val verdict = turning { rig, _, dy -> rig.camera.rotateAroundPoint(0f, dy, 0f, Vector3f()) }
        verdict.assertMistake(Mistake.UNKNOWN, Check.ORBIT, least = 1.0)
        assertTrue(verdict.notes.none { it.key == "scene.orbit.late" }, "${verdict.notes}")
    }

    @Test
    fun `a first event whose position is not remembered`() {
        val rig = object : Rig() {
            private var isHeard = false

            init {
                lastX = 0.0
                lastY = 0.0
            }

            override fun mouse(x: Double, y: Double, alt: Boolean) {
                if (isHeard) super.mouse(x, y, alt)
                isHeard = true
            }
        }
        rig.verdict().assertMistake(Mistake.MOUSE_JUMP, least = 0.9)
    }

    @Test
    fun `pitch about the motorcycle's axis tilts the horizon`() {
        val verdict = turning { rig, dx, dy -> rig.camera.rotateAroundPoint(dy, dx, 0f, Vector3f()) }
        verdict.assertMistake(Mistake.ORBIT_OWN_AXIS)
        assertTrue("up or down" in verdict.mistakes.single().where, verdict.text())
    }

    /** A camera that goes round with the motorcycle on a circle of [eye] and keeps looking at [target]. */
    private open class Looking(
        private val eye: (Rig, Double) -> Vector3d,
        private val target: (Rig) -> Vector3d,
        private val pace: Double = 0.002,
    ) : Rig() {
        private var angle = 0.0

        override fun orbit(dx: Double, dy: Double) {
            angle -= pace * dx
        }

        override fun view(): Matrix4d = Matrix4d().lookAt(eye(this, angle), target(this), Vector3d(0.0, 1.0, 0.0))
    }

    private fun behind(rig: Rig, local: Vector3d) = rigidPart(rig.motorcycle.getWorldModelMatrix(Matrix4d())).transformPosition(local)

    private fun level(rig: Rig, angle: Double) = behind(rig, Vector3d(0.0, 2.5, 3.5).rotateY(angle))

    private val origin: (Rig) -> Vector3d = { Vector3d() }
    private val motorcycle: (Rig) -> Vector3d = { it.motorcycle.getWorldModelMatrix(Matrix4d()).getTranslation(Vector3d()) }

    @Test
    fun `a camera that goes with the motorcycle and looks at the middle of the world`() {
        val verdict = Looking(::level, origin).verdict()
        verdict.assertMistake(Mistake.ORBIT_PIVOT, least = 1.0)
        assertTrue("looks at (0.000, 0.000, 0.000)" in verdict.mistakes.single().where, verdict.text())
        val fast = Looking(::level, origin, pace = 0.004).verdict()
        assertEquals(setOf(Mistake.ORBIT_PIVOT, Mistake.MOUSE_FACTOR), fast.mistakes.map { it.mistake }.toSet(), fast.text())
        Looking(::level, motorcycle).verdict().assertRight()
    }

    @Test
    fun `a camera that looks at the motorcycle from a circle that is tilted`() {
        val tilted = Looking({ rig, angle -> behind(rig, Vector3d(0.0, 0.0, 4.0).rotateY(angle).rotateX(-0.6)) }, motorcycle)
        val verdict = tilted.verdict()
        verdict.assertMistake(Mistake.UNKNOWN, Check.ORBIT, least = 0.1)
        assertEquals("scene.orbit.rises", verdict[Check.ORBIT]?.message?.key, verdict.text())
    }

    /** Of a scene in which the mouse does [turn] with radians. */
    private fun turning(turn: (Rig, Float, Float) -> Unit): SceneVerdict {
        val rig = object : Rig() {
            override fun orbit(dx: Double, dy: Double) = turn(this, (0.002 * dx).toFloat(), (0.002 * dy).toFloat())
        }
        return rig.verdict()
    }
}
