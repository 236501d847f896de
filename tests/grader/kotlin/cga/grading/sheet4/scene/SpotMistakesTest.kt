package cga.grading.sheet4.scene

import cga.grading.capture.CapturedEvent
import cga.grading.capture.EventKind
import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.ObservedLight
import cga.grading.scene.ProgramFacts
import cga.grading.scene.rigidPart
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What can be wrong with the headlight and with how lights fade. */
class SpotMistakesTest {
    @Test
    fun `the headlight is missing`() {
        val rig = object : Rig() {
            override val lamps get() = listOf(own) + corners
        }
        val costs = arrayOf(Check.SPOT_LIGHT, Check.SPOT_LIGHT_CHILD, Check.SPOT_DIRECTION, Check.CONE, Check.ATTENUATION_SPOT)
        rig.verdict().assertMistake(Mistake.SPOT_MISSING, *costs)
    }

    @Test
    fun `a second light on the motorcycle is the headlight where the shaders could give it a cone`() {
        fun rig() = object : Rig() {
            private val bare = Lamp(head.name, head.body, SPOT_K) { HEAD_COLOR }
            override val lamps = listOf(own, bare) + corners
        }
        val verdict = rig().verdict(program = ProgramFacts(canCone = true))
        verdict.assertMistake(Mistake.CONE_NEVER_SENT, Check.CONE)
        assertEquals(listOf("headlight" to "headlight"), verdict.mistakes.map { verdict.spot to it.where })
        assertEquals(listOf(Mistake.SPOT_MISSING), rig().verdict().mistakes.map { it.mistake })
    }

    @Test
    fun `a cone that the motorcycle's point light or a corner got is missing at the headlight`() {
        fun verdict(coned: (Rig) -> Lamp) =
            object : Rig() {
                private val bare = Lamp(head.name, head.body, SPOT_K) { HEAD_COLOR }
                override val lamps = coned(this).let { lamp -> (listOf(own, bare) + corners).filter { it.name != lamp.name } + lamp }
            }.verdict()

        fun coned(lamp: Lamp) = Lamp(lamp.name, lamp.body, lamp.k, 0.2, 0.4, true, lamp.color)
        val costs = arrayOf(Check.SPOT_LIGHT, Check.SPOT_LIGHT_CHILD, Check.SPOT_DIRECTION, Check.CONE, Check.ATTENUATION_SPOT)
        for (verdict in listOf(verdict { coned(it.own) }, verdict { coned(it.corners[0]) })) {
            verdict.assertMistake(Mistake.SPOT_MISSING, *costs)
            assertEquals("headlight", verdict.mistakes.single().where)
        }
    }

    @Test
    fun `a headlight that is no child stays behind, and its direction costs nothing more`() {
        val rig = object : Rig() {
            val free = Lamp("lamp", lamp(Vector3f(0f, 0.9f, -1.6f), null), SPOT_K, 0.2, 0.4, true) { HEAD_COLOR }
            override val lamps get() = listOf(own, free) + corners
        }
        val verdict = rig.apply { free.body.rotateLocal(Rig.radians(-5.0), 0f, 0f) }.verdict()
        verdict.assertMistake(Mistake.SPOT_NOT_CHILD)
    }

    @Test
    fun `a headlight that moves with the motorcycle but does not turn around it`() {
        val rig = object : Rig() {
            override fun position(lamp: Lamp, view: Matrix4d): Vector3d {
                if (lamp !== head) return super.position(lamp, view)
                return view.transformPosition(Vector3d(motorcycle.getWorldPosition()).add(0.0, 0.8, -1.3))
            }
        }
        rig.verdict().assertMistake(Mistake.SPOT_NOT_CHILD)
    }

    @Test
    fun `a headlight that is bound once, before the first picture`() {
        val rig = object : Rig() {
            private val once by lazy { world(head) to super.direction(head, view()) }

            override fun position(lamp: Lamp, view: Matrix4d) =
                if (lamp === head) view.transformPosition(Vector3d(once.first)) else super.position(lamp, view)

            override fun direction(lamp: Lamp, view: Matrix4d) = Vector3d(once.second)
        }
        rig.verdict().assertMistake(Mistake.SPOT_NOT_CHILD)
    }

    @Test
    fun `a headlight that shines in another light's colour, or in no cone that can be told, is not called missing`() {
        val lamps = object : Rig() {
            override val lamps get() = listOf(own) + corners
        }
        val lent = lamps.verdict(program = ProgramFacts(lent = setOf("bike_lamp")))
        assertEquals(listOf(Mistake.UNKNOWN), lent.mistakes.map { it.mistake }, lent.text())
        assertEquals(1.0, lent[Check.SPOT_LIGHT]?.error, lent.text())
        assertTrue("bike_lamp" in lent[Check.SPOT_LIGHT]?.text.orEmpty(), lent.text())

        class Uneven : Rig() {
            val odd = Lamp("headlight", head.body, SPOT_K) { HEAD_COLOR }
            override val lamps get() = listOf(own, odd) + corners
        }
        val strange = Uneven().verdict(program = ProgramFacts(strange = setOf("headlight")))
        assertEquals(listOf(Mistake.UNKNOWN), strange.mistakes.map { it.mistake }, strange.text())
        assertEquals(1.0, strange[Check.CONE]?.error, strange.text())
        assertEquals(listOf(Mistake.SPOT_MISSING), Uneven().verdict().mistakes.map { it.mistake })
    }

    @Test
    fun `a headlight, or a camera, whose own matrix comes before the motorcycle's`() {
        val own = Matrix4d().translation(0.0, 0.9, -1.6).rotateX(Math.toRadians(-8.0))
        val swapped = object : Rig() {
            private fun turned() = Matrix4d(own).mul(rigidPart(motorcycle.getWorldModelMatrix(Matrix4d())))

            override fun position(lamp: Lamp, view: Matrix4d): Vector3d =
                if (lamp === head) view.transformPosition(turned().getTranslation(Vector3d())) else super.position(lamp, view)

            override fun direction(lamp: Lamp, view: Matrix4d): Vector3d =
                view.transformDirection(turned().transformDirection(Vector3d(0.0, 0.0, -1.0)))
        }
        val verdict = swapped.verdict()
        assertEquals(listOf(Mistake.UNKNOWN), verdict.mistakes.map { it.mistake }, verdict.text())
        assertEquals(1.0, verdict[Check.SPOT_LIGHT_CHILD]?.error, verdict.text())
        val camera = object : Rig() {
            private var angle = 0.0

            override fun orbit(dx: Double, dy: Double) {
                angle -= 0.002 * dx
            }

            override fun view(): Matrix4d {
                val local = Matrix4d().rotateY(angle).rotateX(Math.toRadians(-35.0)).translate(0.0, 0.0, 4.0)
                return local.mul(rigidPart(motorcycle.getWorldModelMatrix(Matrix4d()))).invert()
            }
        }
        val seen = camera.verdict()
        assertEquals(listOf(Mistake.UNKNOWN), seen.mistakes.map { it.mistake }, seen.text())
        assertEquals(1.0, seen[Check.ORBIT_PIVOT]?.error, seen.text())
    }

    @Test
    fun `the bind that sends neither cone nor direction costs the cone`() {
        val rig = object : Rig() {
            val odd = Lamp("lamp", head.body, SPOT_K, Double.NaN, Double.NaN, true) { HEAD_COLOR }
            override val lamps get() = listOf(own, odd) + corners

            override fun direction(lamp: Lamp, view: Matrix4d) = Vector3d(Double.NaN)
        }
        rig.verdict().assertMistake(Mistake.CONE_NEVER_SENT)
    }

    @Test
    fun `a headlight turned by degrees taken for radians points anywhere, and the report says by how many`() {
        val rig = Rig().apply { head.body.rotateLocal(Rig.radians(8.0) - 10f, 0f, 0f) }
        val verdict = rig.verdict()
        verdict.assertMistake(Mistake.UNKNOWN, Check.SPOT_DIRECTION)
        val text = verdict.checks.single { it.check == Check.SPOT_DIRECTION }.message
        assertEquals(listOf("scene.aim.radians", -10), listOf(text.key, text.arguments.last()))
        val down = Rig().apply { head.body.rotateLocal(Rig.radians(8.0 - 95.0), 0f, 0f) }.verdict()
        down.assertMistake(Mistake.UNKNOWN, Check.SPOT_DIRECTION)
        assertEquals("scene.aim.straight", down.checks.single { it.check == Check.SPOT_DIRECTION }.message.key)
        // Turned round by any other angle it points the wrong way, and that is all there is to say.
        val other = Rig().apply { head.body.rotateLocal(2.3f, 0f, 0f) }
        other.verdict().assertMistake(Mistake.SPOT_DIRECTION_SIGN)
    }

    @Test
    fun `a direction in world space`() {
        aimed { rig, _ -> rig.worldDirection(rig.head) }.assertMistake(Mistake.SPOT_DIRECTION_WORLD)
    }

    @Test
    fun `a direction in local space, untouched`() {
        aimed { _, _ -> Vector3d(0.0, -0.1, -1.0).normalize() }.assertMistake(Mistake.SPOT_DIRECTION_LOCAL)
    }

    @Test
    fun `a direction in local space that went through the view`() {
        aimed { _, view -> view.transformDirection(Vector3d(0.0, -0.1, -1.0).normalize()) }.assertMistake(Mistake.SPOT_DIRECTION_LOCAL)
    }

    @Test
    fun `a direction with its sign turned, and one that is tilted the wrong way`() {
        aimed { rig, view -> view.transformDirection(rig.worldDirection(rig.head)).negate() }.assertMistake(Mistake.SPOT_DIRECTION_SIGN)
        val up = object : Rig() {
            init {
                head.body.rotateLocal(radians(20.0), 0f, 0f)
            }
        }
        up.verdict().assertMistake(Mistake.SPOT_DIRECTION_SIGN)
    }

    @Test
    fun `a direction that is moved like a position is measured, though it has no name`() {
        val verdict = aimed { rig, view -> view.transformPosition(rig.worldDirection(rig.head)).normalize() }
        verdict.assertCosts(Check.SPOT_DIRECTION)
    }

    @Test
    fun `a direction that never arrives is explained by its name`() {
        val rig = object : Rig() {
            override fun direction(lamp: Lamp, view: Matrix4d) = Vector3d()
        }
        val verdict = rig.verdict(events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 3, "spotDirecton")))
        verdict.assertMistake(Mistake.UNIFORM_ABSENT, Check.SPOT_DIRECTION)
    }

    @Test
    fun `a cone inside out costs the cone only`() {
        val rig = object : Rig() {
            val odd = Lamp("lamp", head.body, SPOT_K, Math.toRadians(25.0), Math.toRadians(10.0), true) { HEAD_COLOR }
            override val lamps get() = listOf(own, odd) + corners
        }
        rig.verdict().assertMistake(Mistake.CONE_INSIDE_OUT)
    }

    @Test
    fun `the first light's K for all, the last one's, none, a linear one, swapped ones`() {
        val point = Rig.POINT_K
        val spot = Rig.SPOT_K
        val none = Vector3d(1.0, 0.0, 0.0)
        val both = arrayOf(Check.ATTENUATION_POINT, Check.ATTENUATION_SPOT)
        fading(point, point).assertMistake(Mistake.ATTENUATION_ONE_K)
        fading(spot, spot).assertMistake(Mistake.ATTENUATION_LAST_K)
        fading(none, none).assertMistake(Mistake.ATTENUATION_MISSING, *both)
        fading(Vector3d(1.0, 0.5, 0.0), spot).assertMistake(Mistake.ATTENUATION_LINEAR, Check.ATTENUATION_POINT)
        fading(spot, point).assertMistake(Mistake.ATTENUATION_OTHER_K, *both)
        fading(Vector3d(1.0, 0.14, 0.07), spot).assertMistake(Mistake.ATTENUATION_OTHER_K)
    }

    @Test
    fun `a K that is no number is not right, in any edition`() {
        val none = Vector3d(Double.NaN)
        for (profile in listOf(SceneProfile.SHEET, SceneProfile.LATER)) {
            val verdict = fading(none, none, profile)
            verdict.assertCosts(Check.ATTENUATION_POINT, Check.ATTENUATION_SPOT, least = 1.0)
        }
    }

    @Test
    fun `the later edition leaves the attenuation free, but wants one`() {
        val square = Vector3d(0.0, 0.0, 1.0)
        fading(square, square, SceneProfile.LATER).assertRight()
        val both = arrayOf(Check.ATTENUATION_POINT, Check.ATTENUATION_SPOT)
        val none = Vector3d(1.0, 0.0, 0.0)
        fading(none, none, SceneProfile.LATER).assertMistake(Mistake.ATTENUATION_MISSING, *both)
        assertEquals(2, fading(square, square).checks.count { it.check in both && (it.error ?: 0.0) > 0.5 })
    }

    @Test
    fun `where any K is right, one that another light's was sent over is not`() {
        fun rig() = object : Rig() {
            override fun lights(moment: Moment, t: Double, view: Matrix4d) =
                super.lights(moment, t, view).map { ObservedLight(it.name, it.position, it.color, SPOT_K, it.spot, fadedBy = setOf("k")) }
        }
        rig().verdict(SceneProfile.LATER).assertRight()
        val overwritten = CapturedEvent(EventKind.UNIFORM_OVERWRITTEN, 3, "k")
        rig().verdict(SceneProfile.LATER, listOf(overwritten)).assertMistake(Mistake.ATTENUATION_LAST_K)
    }

    private fun aimed(direction: (Rig, Matrix4d) -> Vector3d): SceneVerdict {
        val rig = object : Rig() {
            override fun direction(lamp: Lamp, view: Matrix4d) = direction(this, view)
        }
        return rig.verdict()
    }

    private fun fading(
        point: Vector3d,
        spot: Vector3d,
        profile: SceneProfile = SceneProfile.SHEET,
    ): SceneVerdict {
        val rig = object : Rig() {
            val fadingPoint = Lamp("point", own.body, point) { ownColor(it) }
            val fadingSpot = Lamp("spot", head.body, spot, 0.2, 0.4, true) { HEAD_COLOR }
            override val lamps get() = listOf(fadingPoint, fadingSpot) + corners
        }
        return rig.verdict(profile)
    }
}
