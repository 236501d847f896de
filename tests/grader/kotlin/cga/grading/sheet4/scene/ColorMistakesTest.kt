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
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sin

/** What can be wrong with the colours of task 4.4. */
class ColorMistakesTest {
    @Test
    fun `a motorcycle that never changes its colour`() {
        val rig = object : Rig() {
            override fun motorcycleTint(t: Double) = Vector3d(1.0, 0.0, 1.0)
        }
        rig.verdict().assertMistake(Mistake.COLOR_CONSTANT)
    }

    @Test
    fun `neither the motorcycle nor its light ever change their white`() {
        val rig = object : Rig() {
            override fun motorcycleTint(t: Double) = Vector3d(1.0)
        }
        rig.verdict().assertMistake(Mistake.COLOR_CONSTANT, Check.MOTORCYCLE_COLOR, Check.LIGHT_COLOR)
    }

    @Test
    fun `a colour of the time since the last picture does not change with time`() {
        val rig = object : Rig() {
            private var step = 0.0

            override fun frame(moment: Moment, t: Double): ObservedFrame {
                step = moment.seconds
                return super.frame(moment, t)
            }

            override fun motorcycleTint(t: Double) = Vector3d(abs(sin(step + 1)), abs(sin(step + 2)), abs(sin(step + 3)))
        }
        rig.verdict().assertMistake(Mistake.COLOR_CONSTANT)
    }

    @Test
    fun `a colour that is only set while the motorcycle is driven`() {
        val rig = object : Rig() {
            private var driven = 0.0

            override fun update(dt: Double, t: Double, keys: Set<Key>) {
                super.update(dt, t, keys)
                if (Key.FORWARD in keys) driven = t
            }

            override fun motorcycleTint(t: Double) = super.motorcycleTint(driven + 1)
        }
        val verdict = rig.verdict()
        verdict.assertMistake(Mistake.COLOR_CONSTANT)
        assertEquals("scene.color.only-driven", verdict[Check.MOTORCYCLE_COLOR]?.message?.key, verdict.text())
    }

    @Test
    fun `a light that changes while the motorcycle does not costs the motorcycle only`() {
        val rig = object : Rig() {
            override fun motorcycleTint(t: Double) = Vector3d(1.0)

            override fun ownColor(t: Double) = Vector3d(0.5 + 0.5 * sin(t), 1.0, 0.2)
        }
        rig.verdict().assertMistake(Mistake.COLOR_CONSTANT)
    }

    @Test
    fun `a light of another colour, and one of other sines`() {
        val white = object : Rig() {
            override fun ownColor(t: Double) = Vector3d(1.0)
        }
        white.verdict().assertMistake(Mistake.LIGHT_COLOR_DIFFERS)
        val other = object : Rig() {
            override fun ownColor(t: Double) = Vector3d(0.5 + 0.5 * sin(t), 0.5, 0.5 + 0.5 * sin(2 * t))
        }
        other.verdict().assertMistake(Mistake.LIGHT_COLOR_DIFFERS)
    }

    /** A light in the colour that the motorcycle had some pictures before. */
    private class Lagging(private val pictures: Int) : Rig() {
        private val tints = ArrayList<Vector3d>()

        override fun frame(moment: Moment, t: Double): ObservedFrame {
            tints += super.ownColor(t)
            return super.frame(moment, t)
        }

        override fun ownColor(t: Double): Vector3d = Vector3d(tints[maxOf(0, tints.size - 1 - pictures)])
    }

    @Test
    fun `a light whose colour lags by one picture, or by two, is another colour`() {
        Lagging(0).verdict().assertRight()
        for (pictures in 1..2) {
            val verdict = Lagging(pictures).verdict()
            verdict.assertMistake(Mistake.LIGHT_COLOR_DIFFERS)
            val said = verdict[Check.LIGHT_COLOR]?.message
            assertEquals(listOf("scene.color.light-lags", pictures), listOf(said?.key, said?.arguments?.last()))
        }
    }

    @Test
    fun `red and blue exchanged`() {
        val rig = object : Rig() {
            override fun ownColor(t: Double): Vector3d {
                val tint = motorcycleTint(t) ?: Vector3d()
                return Vector3d(tint.z, tint.y, tint.x)
            }
        }
        rig.verdict().assertMistake(Mistake.LIGHT_COLOR_DIFFERS)
    }

    @Test
    fun `white everywhere is no colour, and what was sent in vain explains it`() {
        val rig = object : Rig() {
            override fun motorcycleTint(t: Double) = Vector3d(1.0)

            override fun groundTint(t: Double) = Vector3d(1.0)
        }
        val events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "tint"))
        val found = rig.verdict(events = events, program = ProgramFacts(declares = { it == "tint" }))[Mistake.EMISSION_COLOR_IGNORED]
        assertEquals(setOf(Check.GROUND_COLOR, Check.MOTORCYCLE_COLOR), found?.explains)
        assertEquals(null, rig.verdict(events = events)[Mistake.EMISSION_COLOR_IGNORED])
    }

    @Test
    fun `a colour written into the shader lets none through that is sent`() {
        val rig = object : Rig() {
            override fun motorcycleTint(t: Double) = Vector3d(0.0, 1.0, 0.0)

            override fun ownColor(t: Double) = Vector3d(abs(sin(t)), abs(sin(t / 2)), 0.5)

            override fun objects(t: Double, lights: List<ObservedLight>) =
                super.objects(t, lights).map { ObservedObject(it.model, it.tint, it.lights, it.vertices, it.buffers, isTintWritten = true) }
        }
        rig.verdict().assertMistake(Mistake.EMISSION_COLOR_IGNORED, Check.MOTORCYCLE_COLOR)
    }

    @Test
    fun `no colours at all`() {
        val rig = object : Rig() {
            override fun motorcycleTint(t: Double): Vector3d? = null

            override fun groundTint(t: Double): Vector3d? = null
        }
        val costs = arrayOf(Check.GROUND_COLOR, Check.MOTORCYCLE_COLOR, Check.LIGHT_COLOR)
        rig.verdict().assertMistake(Mistake.EMISSION_COLOR_IGNORED, *costs)
    }

    @Test
    fun `a colour that never arrives leaves everything black, and its name is guessed`() {
        class Black : Rig() {
            override fun motorcycleTint(t: Double) = Vector3d()

            override fun groundTint(t: Double) = Vector3d()

            override fun ownColor(t: Double) = Vector3d(abs(sin(t)), abs(sin(t / 2)), 0.5)
        }
        val costs = arrayOf(Check.GROUND_COLOR, Check.MOTORCYCLE_COLOR)
        Black().verdict().assertMistake(Mistake.EMISSION_MISSING, *costs)
        val events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "sceneColor"))
        val told = Black().verdict(events = events, uniforms = setOf("scneColor"), program = ProgramFacts(setOf("scneColor")))
        told.assertMistake(Mistake.EMISSION_MISSING, *costs)
        assertEquals(listOf("scene.event.no-program sceneColor (is scneColor meant?)"), told.notes.map { "$it" })
    }

    @Test
    fun `a motorcycle in the ground's colour, its own sent to a name that no program has`() {
        class Worn : Rig() {
            override fun motorcycleTint(t: Double) = Vector3d(0.0, 1.0, 0.0)

            override fun ownColor(t: Double) = Vector3d(abs(sin(t)), abs(sin(t / 2)), 0.5)
        }

        fun verdict(sent: String) =
            Worn().verdict(
                events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, sent)),
                uniforms = setOf("emissionColor", "shininess"),
            )
        val told = verdict("emissionFarbe")
        told.assertMistake(Mistake.UNIFORM_ABSENT, Check.MOTORCYCLE_COLOR)
        assertEquals("emissionFarbe (is emissionColor meant?)", told.mistakes.single().where)
        verdict("material_shininess").assertMistake(Mistake.COLOR_CONSTANT)
    }

    @Test
    fun `a white ground, a black one, one without a colour, one in the motorcycle's colours`() {
        fun ground(color: (Rig, Double) -> Vector3d?): SceneVerdict {
            val rig = object : Rig() {
                override fun groundTint(t: Double) = color(this, t)
            }
            return rig.verdict()
        }
        for (color in listOf(Vector3d(1.0), Vector3d(), null)) {
            val verdict = ground { _, _ -> color }
            verdict.assertCosts(Check.GROUND_COLOR, least = 1.0)
            assertEquals(emptyList<Mistake>(), verdict.mistakes.map { it.mistake })
        }
        ground { rig, t -> rig.motorcycleTint(t) }.assertCosts(Check.GROUND_COLOR, least = 0.5)
    }

    @Test
    fun `a colour that is sent when its thing has been drawn is worn by the next one, which costs once`() {
        val rig = object : Rig() {
            override fun motorcycleTint(t: Double) = if (t == 0.0) Vector3d() else Vector3d(0.0, 1.0, 0.0)

            override fun groundTint(t: Double) = Vector3d(abs(sin(t + 1)), abs(sin(t / 2 + 1)), abs(sin(t / 3 + 1)))

            override fun ownColor(t: Double) = groundTint(t)
        }
        rig.verdict().assertMistake(Mistake.COLOR_CONSTANT)
    }
}
