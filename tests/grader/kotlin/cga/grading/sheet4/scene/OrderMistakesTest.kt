package cga.grading.sheet4.scene

import cga.grading.capture.CapturedEvent
import cga.grading.capture.EventKind
import cga.grading.capture.Key
import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.ObservedFrame
import cga.grading.scene.ObservedLight
import cga.grading.scene.ObservedObject
import cga.grading.scene.ProgramFacts
import org.joml.Matrix4d
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What can be set too late or in vain. */
class OrderMistakesTest {
    /** Draws after every second update, and binds its lights after that. */
    private open class LateRig : Rig() {
        protected var seen: List<ObservedLight> = emptyList()
        private var bound: List<ObservedLight> = emptyList()
        private var updates = 0

        override fun update(dt: Double, t: Double, keys: Set<Key>) {
            super.update(dt, t, keys)
            if (++updates % 2 == 0) render(t)
        }

        private fun render(t: Double) {
            seen = bound
            bound = now(t, view())
        }

        private fun now(t: Double, view: Matrix4d) = lamps.map { observed(it, t, view) }

        override fun lights(moment: Moment, t: Double, view: Matrix4d): List<ObservedLight> {
            if (moment != Moment.FIRST) return seen
            bound = now(t, view)
            return bound.map { ObservedLight(it.name, Vector3d(), Vector3d(), Vector3d(), it.spot) }
        }
    }

    @Test
    fun `lights bound after the draws are missing in the first frame and late in all others`() {
        LateRig().verdict().assertMistake(Mistake.LIGHTS_AFTER_DRAWS)
    }

    @Test
    fun `lights that lack only their attenuation in the first frame`() {
        val rig = object : Rig() {
            override fun lights(moment: Moment, t: Double, view: Matrix4d): List<ObservedLight> {
                val right = super.lights(moment, t, view)
                if (moment != Moment.FIRST) return right
                return right.map { ObservedLight(it.name, it.position, it.color, Vector3d(), it.spot) }
            }
        }
        rig.verdict().assertMistake(Mistake.LIGHTS_AFTER_DRAWS)
    }

    @Test
    fun `lights bound between the ground and the motorcycle`() {
        val rig = object : LateRig() {
            override fun objects(t: Double, lights: List<ObservedLight>): List<ObservedObject> {
                val (ground, motorcycle) = super.objects(t, lights)
                val view = view()
                val now = lamps.map { observed(it, t, view) }
                return listOf(ground, ObservedObject(motorcycle.model, motorcycle.tint, now, motorcycle.vertices, motorcycle.buffers))
            }
        }
        rig.verdict().assertMistake(Mistake.LIGHTS_AFTER_DRAWS)
    }

    @Test
    fun `a view that is there from the second frame on`() {
        val rig = object : Rig() {
            override fun frame(moment: Moment, t: Double): ObservedFrame {
                val right = super.frame(moment, t)
                val view = if (moment == Moment.FIRST) Matrix4d().zero() else right.view
                return ObservedFrame(moment, t, view, right.projection, right.objects, right.lights)
            }
        }
        rig.verdict().assertMistake(Mistake.LIGHTS_AFTER_DRAWS)
    }

    @Test
    fun `uniforms set before their program is in use for the first time`() {
        class Rigged : Rig() {
            override fun lights(moment: Moment, t: Double, view: Matrix4d) =
                if (moment == Moment.FIRST) emptyList() else super.lights(moment, t, view)
        }
        val events = listOf(CapturedEvent(EventKind.UNIFORM_WITHOUT_PROGRAM, 0, "glUniform3f"))
        Rigged().verdict(events = events).assertMistake(Mistake.UNIFORM_BEFORE_USE)
        Rigged().verdict().assertMistake(Mistake.LIGHTS_AFTER_DRAWS)
    }

    @Test
    fun `uniforms that are never set because no program is in use`() {
        val rig = object : Rig() {
            override val lamps get() = listOf(own) + corners
        }
        val verdict = rig.verdict(events = listOf(CapturedEvent(EventKind.UNIFORM_WITHOUT_PROGRAM, -1, "glUniform3f")))
        assertEquals(listOf(Mistake.UNIFORM_BEFORE_USE), verdict.mistakes.map { it.mistake }, verdict.text())
        assertTrue(Check.SPOT_LIGHT in verdict.mistakes.single().explains.orEmpty(), verdict.text())
        assertEquals(1.0, verdict[Check.ORDER]?.error)
    }

    @Test
    fun `a count of lights that is sent too early leaves none, and a choice that is 0 explains nothing else`() {
        val rig = object : Rig() {
            override val lamps get() = emptyList<Lamp>()
        }
        val events = listOf(CapturedEvent(EventKind.UNIFORM_WITHOUT_PROGRAM, -1, "glUniform1i u_count"))
        val lost = rig.verdict(events = events, program = ProgramFacts(unset = emptySet(), idle = setOf("u_count")))
        assertEquals(listOf(Mistake.UNIFORM_BEFORE_USE), lost.mistakes.map { it.mistake }, lost.text())
        val other = rig.verdict(events = events, program = ProgramFacts(unset = emptySet(), idle = setOf("u_mode")))
        assertTrue(other[Mistake.LIGHT_MISSING] != null, other.text())
    }

    @Test
    fun `events that spoil nothing are notes`() {
        val events =
            listOf(
                CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "lightDirection"),
                CapturedEvent(EventKind.UNIFORM_WITHOUT_PROGRAM, -1, "glUniform1i"),
                CapturedEvent(EventKind.GL_ERROR, 2, "GL_INVALID_ENUM in glEnable"),
            )
        val verdict = Rig().verdict(events = events)
        verdict.assertRight()
        assertEquals(3, verdict.notes.size, verdict.text())
        assertTrue(verdict.notes.any { "GL_INVALID_ENUM in glEnable" in it.arguments })
    }

    @Test
    fun `numbers that arrive another time are not lost, whatever else is missing`() {
        val rig = object : Rig() {
            override val lamps get() = listOf(own) + corners
        }
        val events = listOf(CapturedEvent(EventKind.UNIFORM_WITHOUT_PROGRAM, -1, "glUniform1i sampler"))
        val verdict = rig.verdict(events = events, program = ProgramFacts(unset = setOf("spotColor")))
        assertEquals(listOf(Mistake.SPOT_MISSING), verdict.mistakes.map { it.mistake }, verdict.text())
    }

    @Test
    fun `places that are sent under another name are lost, and what that looks like is no mistake of its own`() {
        val rig = object : Rig() {
            override fun lights(moment: Moment, t: Double, view: Matrix4d) = super.lights(moment, t, view).map {
                ObservedLight(it.name, view.transformPosition(Vector3d()), it.color, it.k, it.spot, placedBy = "${it.name}.position")
            }
        }
        val events = rig.lamps.map { CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "${it.name}.pos") }
        val verdict = rig.verdict(events = events, program = ProgramFacts(unset = rig.lamps.map { "${it.name}.position" }.toSet()))
        val named = verdict.mistakes.map { it.mistake }
        assertTrue(Mistake.UNIFORM_ABSENT in named, verdict.text())
        assertTrue(named.none { it in setOf(Mistake.LIGHT_NOT_CHILD, Mistake.SPOT_NOT_CHILD, Mistake.LIGHT_IN_GROUND) }, verdict.text())
    }

    @Test
    fun `a light where the world begins may be meant, whatever else is sent to nobody`() {
        val rig = object : Rig() {
            override fun lights(moment: Moment, t: Double, view: Matrix4d) = super.lights(moment, t, view).map {
                val position = if (it.name == "corner[2]") view.transformPosition(Vector3d()) else it.position
                ObservedLight(it.name, position, it.color, it.k, it.spot, placedBy = "${it.name}.place")
            }
        }
        val events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "sunPosition"))
        rig.verdict(events = events, program = ProgramFacts(unset = setOf("corner[2].place"))).assertRight()
    }

    @Test
    fun `a number of the cone that waits while one of much the same name is sent is misspelt`() {
        val program = ProgramFacts(unset = setOf("spotInner"))
        val verdict = Rig().verdict(events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "spotlnner")), program = program)
        assertEquals(listOf(Mistake.UNIFORM_ABSENT), verdict.mistakes.map { it.mistake }, verdict.text())
        assertTrue(Check.CONE in verdict.mistakes.single().explains.orEmpty(), verdict.text())
        val half = ProgramFacts(unset = setOf("lamp.innerCutOff"))
        val shorter = Rig().verdict(events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "lamp.cutOff")), program = half)
        assertEquals(listOf(Mistake.UNIFORM_ABSENT), shorter.mistakes.map { it.mistake }, shorter.text())
        val other = Rig().verdict(events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "spotSize")), program = program)
        assertEquals(emptyList<Mistake>(), other.mistakes.map { it.mistake }, other.text())
    }

    @Test
    fun `an exponent that waits while one of much the same name is sent is misspelt`() {
        val program = ProgramFacts(unset = setOf("surf.shine"))
        val verdict = Rig().verdict(events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "surf.shininess")), program = program)
        assertEquals(listOf(Mistake.UNIFORM_ABSENT), verdict.mistakes.map { it.mistake }, verdict.text())
        assertEquals(setOf(Check.SPECULAR), verdict.mistakes.single().explains)
        assertEquals(1.0, verdict[Check.SPECULAR]?.error, verdict.text())
    }

    @Test
    fun `a first frame that was drawn without a matrix cannot be understood, and tells the order`() {
        fun verdict(vararg events: CapturedEvent) =
            SceneJudge.judge(Rig().play().drop(1), events.toList(), program = ProgramFacts(drawn = setOf(Moment.FIRST)))
        verdict().assertMistake(Mistake.LIGHTS_AFTER_DRAWS)
        verdict(CapturedEvent(EventKind.UNIFORM_WITHOUT_PROGRAM, 0, "glUniformMatrix4fv view")).assertMistake(Mistake.UNIFORM_BEFORE_USE)
    }

    @Test
    fun `a light bound after the draws has the colour of the frame before, which is no mistake of its colour`() {
        val rig = object : LateRig() {
            override fun lights(moment: Moment, t: Double, view: Matrix4d): List<ObservedLight> {
                val colors = previous
                previous = lamps.map { it.color(t) }
                return super.lights(moment, t, view).zip(colors.ifEmpty { previous }) { light, color ->
                    ObservedLight(light.name, light.position, if (moment == Moment.FIRST) Vector3d() else color, light.k, light.spot)
                }
            }

            private var previous: List<Vector3d> = emptyList()
        }
        rig.verdict().assertMistake(Mistake.LIGHTS_AFTER_DRAWS)
    }

    @Test
    fun `a shader that the driver refused is named, and nothing is said of what stands in for it`() {
        val dark = object : Rig() {
            override val lamps get() = emptyList<Lamp>()

            override fun motorcycleTint(t: Double) = null

            override fun groundTint(t: Double) = null
        }
        val warning = "0:3(1): warning: `n' used uninitialized"
        val log = "fragment shader (a stand-in takes its place)\n$warning\n0:9(4): error: no function 'saturate'\n"
        val verdict = dark.verdict(
            events = listOf(CapturedEvent(EventKind.SHADER_FAILED, -1, log)),
            program = ProgramFacts(isReplaced = true),
        )
        assertEquals(listOf(Mistake.SHADER_REFUSED), verdict.mistakes.map { it.mistake }, verdict.text())
        assertTrue("no function 'saturate'" in verdict.mistakes.single().where, verdict.text())
        assertTrue(verdict.isReplaced)
        assertNull(verdict[Check.POINT_LIGHT]?.error)
        assertEquals(0.0, verdict[Check.ORBIT]?.error)
    }

    @Test
    fun `a shader that only needed other words costs its own check, and all else is judged`() {
        val log = "fragment shader\n0:3(25): error: C-style initialization requires an extension\n"
        val verdict = Rig().verdict(events = listOf(CapturedEvent(EventKind.SHADER_DIALECT, -1, log)))
        verdict.assertMistake(Mistake.GLSL_DRIVER)
        assertTrue("C-style" in verdict.mistakes.single().where, verdict.text())
        assertFalse(verdict.isReplaced)
    }

    @Test
    fun `without the first two frames nothing is said of the order`() {
        assertNull(SceneJudge.judge(Rig().play().drop(1), emptyList())[Check.ORDER]?.error)
    }

    @Test
    fun `letters are counted as they must be changed`() {
        assertEquals(0, editDistance("lightPos", "LIGHTPOS"))
        assertEquals(2, editDistance("lightPos", "lihgtPos"))
        assertEquals(3, editDistance("kitten", "sitting"))
        assertEquals(4, editDistance("", "four"))
    }
}
