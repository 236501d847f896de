package cga.grading.sheet4.scene

import cga.exercise.components.geometry.Transformable
import cga.grading.capture.CapturedEvent
import cga.grading.capture.EventKind
import cga.grading.capture.Key
import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.ObservedFrame
import cga.grading.scene.ObservedLight
import cga.grading.scene.ProgramFacts
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource

/** What can be wrong with the places of the lights. */
class LightMistakesTest {
    private val allOfPoint =
        arrayOf(Check.POINT_LIGHT, Check.POINT_LIGHT_CHILD, Check.POINT_LIGHT_POSITION, Check.LIGHT_COLOR)

    @Test
    fun `lights that are moved on by as much at each picture, and lights that fly about with time`() {
        fun rig(way: (Moment, Double) -> Double) = object : Rig() {
            override fun lights(moment: Moment, t: Double, view: Matrix4d): List<ObservedLight> =
                super.lights(moment, t, view).map {
                    val moved = view.transformDirection(Vector3d(0.0, way(moment, t), 0.0))
                    ObservedLight(it.name, Vector3d(it.position).add(moved), it.color, it.k, it.spot)
                }
        }
        val wandering = rig { moment, _ -> 1.2 * moment.ordinal }.verdict()
        assertEquals(listOf(Mistake.UNKNOWN), wandering.mistakes.map { it.mistake }, wandering.text())
        assertEquals(1.0, wandering[Check.POINT_LIGHT_POSITION]?.error, wandering.text())
        val flying = rig { _, t -> 0.3 * t }.verdict()
        assertEquals(emptyList<Mistake>(), flying.mistakes.map { it.mistake }, flying.text())
    }

    @Test
    fun `lights that are sorted by their distance from the camera in each picture`() {
        val verdict = object : Rig() {
            override fun lights(moment: Moment, t: Double, view: Matrix4d): List<ObservedLight> {
                val (fixed, further) = super.lights(moment, t, view).partition { light -> corners.none { it.name == light.name } }
                val sorted = further.sortedBy { it.position.length() }
                return fixed + sorted.mapIndexed { i, it -> ObservedLight(further[i].name, it.position, it.color, it.k, it.spot) }
            }
        }.verdict()
        assertEquals(emptyList<Mistake>(), verdict.mistakes.map { it.mistake }, verdict.text())
    }

    @Test
    fun `of lights all around the motorcycle none is its own, one that is much nearer is`() {
        fun verdict(near: Float): SceneVerdict {
            val places = listOf(Vector3f(5f, 1f, 5f), Vector3f(-5f, 1f, 5f), Vector3f(near, 1f, -near))
            return object : Rig() {
                override val lamps get() = listOf(head) + places.mapIndexed { i, place ->
                    Lamp("lamp[$i]", Transformable().apply { translateLocal(place) }, POINT_K) { Vector3d(i + 1.0, 2.0, 1.0) }
                }
            }.verdict()
        }
        assertNotNull(verdict(5f)[Mistake.LIGHT_MISSING])
        assertNotNull(verdict(1f)[Mistake.LIGHT_NOT_CHILD])
    }

    @Test
    fun `the motorcycle's light hangs on another vehicle, which has one of its own at the same place`() {
        val other = Transformable().apply { translateLocal(Vector3f(3f, 0f, 0f)) }
        val rig = object : Rig() {
            private val above = Transformable(parent = other).apply { translateLocal(Vector3f(0f, 1.6f, 0f)) }
            private val astray = Lamp("bike_lamp", above, POINT_K) { ownColor(it) }
            private val theirs = Lamp("other_lamp", above, POINT_K) { Vector3d(2.0, 0.0, 0.0) }
            override val lamps = listOf(astray, head, theirs) + corners

            override fun lights(
                moment: Moment,
                t: Double,
                view: Matrix4d,
            ) = super.lights(moment, t, view).map {
                ObservedLight(it.name, it.position, it.color, it.k, it.spot, placedBy = "${it.name}.place")
            }

            override fun update(
                dt: Double,
                t: Double,
                keys: Set<Key>,
            ) {
                super.update(dt, t, keys)
                other.translateLocal(Vector3f((dt * (1 + t)).toFloat(), 0f, (-2 * dt).toFloat()))
            }
        }
        val mistakes = rig.verdict().mistakes.map { it.mistake }
        assertTrue(Mistake.LIGHT_NOT_CHILD in mistakes && Mistake.LIGHT_POSITION_OVERWRITTEN !in mistakes, "$mistakes")
    }

    @Test
    fun `the point light is missing`() {
        val rig = object : Rig() {
            override val lamps get() = listOf(head) + corners
        }
        rig.verdict().assertMistake(Mistake.LIGHT_MISSING, *allOfPoint)
    }

    @Test
    fun `a headlight among the point lights shines twice, which is no position overwritten`() {
        val rig = object : Rig() {
            private val again = Lamp("point[1]", head.body, SPOT_K) { HEAD_COLOR }
            override val lamps = listOf(own, again, head) + corners
        }
        rig.verdict().assertMistake(Mistake.UNKNOWN, Check.SPOT_LIGHT, least = 1.0)
    }

    @Test
    fun `the point light is missing where another one only flies about`() {
        val flying = Transformable().apply { translateLocal(Vector3f(4f, 2f, 0f)) }
        val rig = object : Rig() {
            override val lamps get() = listOf(head, Lamp("flying", flying, POINT_K) { Vector3d(2.0, 1.0, 0.0) }) + corners

            override fun update(
                dt: Double,
                t: Double,
                keys: Set<Key>,
            ) {
                super.update(dt, t, keys)
                flying.rotateAroundPoint(0f, dt.toFloat(), 0f, Vector3f())
            }
        }
        rig.verdict().assertMistake(Mistake.LIGHT_MISSING, *allOfPoint)
    }

    @Test
    fun `without any point light that fades as it should nobody can say that they do`() {
        val rig = object : Rig() {
            override val lamps = listOf(head) + corners.map { Lamp(it.name, it.body, Vector3d(1.0, 0.0, 0.5), color = it.color) }
        }
        rig.verdict().assertMistake(Mistake.LIGHT_MISSING, *allOfPoint, Check.ATTENUATION_POINT)
    }

    @Test
    fun `the point light is black`() {
        val rig = object : Rig() {
            override fun ownColor(t: Double) = Vector3d()
        }
        rig.verdict().assertMistake(Mistake.LIGHT_MISSING, *allOfPoint)
    }

    @Test
    fun `a name that no program has explains a missing light, and the right name is guessed`() {
        val rig = object : Rig() {
            override fun ownColor(t: Double) = Vector3d()
        }
        val events = listOf("pointLigthColor", "material_emit").map { CapturedEvent(EventKind.UNIFORM_ABSENT, 0, it) }
        val verdict = rig.verdict(events = events, uniforms = setOf("pointLightColor", "pointLightPos", "view_matrix"))
        verdict.assertMistake(Mistake.UNIFORM_ABSENT, *allOfPoint)
        assertEquals("pointLigthColor (is pointLightColor meant?)", verdict.mistakes.single().where)
    }

    @Test
    fun `a name that the shader declares and does not need explains nothing`() {
        val rig = object : Rig() {
            override fun ownColor(t: Double) = Vector3d()
        }
        val events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "spotLight.angle"))
        val verdict = rig.verdict(events = events, program = ProgramFacts(setOf("bikeColor"), "spotLight.angle"::equals))
        verdict.assertMistake(Mistake.LIGHT_MISSING, *allOfPoint)
        assertEquals(setOf("bike_lamp", "bikeColor", "spotLight.angle"), verdict.unlit)
    }

    @Test
    fun `one name that nobody waits for earns nothing where nothing is`() {
        class Starter : Rig() {
            override val lamps get() = emptyList<Lamp>()

            override fun orbit(dx: Double, dy: Double) = Unit

            override fun groundTint(t: Double) = null

            override fun motorcycleTint(t: Double) = null
        }
        val events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "pointLight.color"))
        val verdict = Starter().verdict(events = events, program = ProgramFacts(unset = emptySet()))
        assertTrue(verdict[Mistake.UNIFORM_ABSENT] == null, verdict.text())
        val right = verdict.checks.filter { it.found && it.error == 0.0 }.map { it.check }
        assertEquals(listOf(Check.ORDER), right, verdict.text())
    }

    @Test
    fun `a name that nothing waits for explains nothing`() {
        val rig = object : Rig() {
            override fun ownColor(t: Double) = Vector3d()
        }
        val events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "old_lamp"))
        val facts = ProgramFacts(setOf("bikeColor", "bikePos"))
        rig.verdict(events = events, program = facts).assertMistake(Mistake.LIGHT_MISSING, *allOfPoint)
    }

    @Test
    fun `numbers that nobody sends and that make the picture black are explained by the name that they were sent to`() {
        val facts = ProgramFacts(setOf("corner4Att"), deadly = setOf("corner4Att"))
        val events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "corner0Att"))
        val verdict = Rig().verdict(events = events, uniforms = setOf("corner4Att"), program = facts)
        verdict.assertMistake(Mistake.UNIFORM_ABSENT, Check.POINT_LIGHT)
        val unsaid = Rig().verdict(program = facts)
        assertEquals(emptyList<Mistake>(), unsaid.mistakes.map { it.mistake })
        unsaid.assertCosts(Check.POINT_LIGHT)
        val dark = object : Rig() {
            override fun ownColor(t: Double) = Vector3d()
        }
        dark.verdict(program = facts).assertMistake(Mistake.LIGHT_MISSING, *allOfPoint)
    }

    @Test
    fun `further lights in the changing colour of the motorcycle's are there, and follow it`() {
        val rig = object : Rig() {
            override val lamps = listOf(own, head) + corners.map { Lamp(it.name, it.body, it.k, color = ::ownColor) }
        }
        val verdict = rig.verdict()
        verdict.assertMistake(Mistake.LATER_LIGHTS_FIRST_COLOR, Check.MORE_LIGHTS)
        assertEquals(setOf(Check.MORE_LIGHTS), verdict.mistakes.single().explains)
        val white = object : Rig() {
            override val lamps = listOf(own, head) + corners.map { Lamp(it.name, it.body, it.k) { Vector3d(1.0) } }
        }
        white.verdict().assertMistake(Mistake.MORE_LIGHTS_ALIKE, Check.MORE_LIGHTS)
    }

    @Test
    fun `positions in the parent's space are one mistake of both lights`() {
        val rig = object : Rig() {
            override fun position(lamp: Lamp, view: Matrix4d): Vector3d = view.transformPosition(Vector3d(lamp.body.getPosition()))
        }
        val verdict = rig.verdict()
        assertEquals(listOf(Mistake.LIGHT_NOT_CHILD), verdict.mistakes.map { it.mistake }, verdict.text())
        verdict.assertCosts(Check.POINT_LIGHT_CHILD)
    }

    @Test
    fun `two lights that are no children are two mistakes`() {
        val rig = object : Rig() {
            val free = Lamp("lamp", lamp(Vector3f(0f, 1.5f, 0f), null), POINT_K) { ownColor(it) }
            val front =
                Lamp(
                    "front",
                    lamp(
                        Vector3f(0f, 1f, -1.5f),
                        null,
                    ).apply { rotateLocal(-0.2f, 0f, 0f) },
                    SPOT_K, 0.2, 0.4, true,
                ) { HEAD_COLOR }
            override val lamps get() = listOf(free, front) + corners
        }
        val named = rig.verdict().mistakes.map { it.mistake }
        assertEquals(setOf(Mistake.LIGHT_NOT_CHILD, Mistake.SPOT_NOT_CHILD), named.toSet())
    }

    @Test
    fun `what is not there is not found`() {
        val rig = object : Rig() {
            override val lamps get() = emptyList<Lamp>()

            override fun orbit(dx: Double, dy: Double) = Unit

            override fun groundTint(t: Double) = null

            override fun motorcycleTint(t: Double) = null
        }
        val absent = rig.verdict().checks.filter { !it.found }.map { it.check }.toSet()
        assertEquals(SceneJudge.CHECKS - Check.ORDER, absent)
    }

    @Test
    fun `a point light that is no child stays behind`() {
        val rig = object : Rig() {
            val free = Lamp("lamp", lamp(Vector3f(0f, 1.5f, 0f), null), POINT_K) { ownColor(it) }
            override val lamps get() = listOf(free, head) + corners
        }
        val verdict = rig.verdict()
        verdict.assertMistake(Mistake.LIGHT_NOT_CHILD)
        assertEquals("lamp", verdict.mistakes.single().where)
    }

    @Test
    fun `a point light that was not raised`() {
        Rig(Vector3f()).verdict().assertMistake(Mistake.LIGHT_IN_GROUND)
    }

    @Test
    fun `a view that undoes the motorcycle's scale`() {
        val rig = object : Rig() {
            override fun view() = camera.getWorldModelMatrix(Matrix4d()).invert()

            override fun direction(lamp: Lamp, view: Matrix4d) = super.direction(lamp, view).normalize()
        }
        val verdict = rig.verdict()
        verdict.assertMistake(Mistake.VIEW_SCALED)
        assertEquals(0.25, verdict[Check.POINT_LIGHT_POSITION]?.error ?: 0.0, 1e-4, verdict.text())
    }

    @Test
    fun `lights that went through the stretched view while the vertices did not`() {
        val verdict = moved { rig, lamp, _ -> rig.camera.getWorldModelMatrix(Matrix4d()).invert().transformPosition(rig.world(lamp)) }
        verdict.assertMistake(Mistake.VIEW_SCALED)
    }

    @Test
    fun `world positions that never went through the view`() {
        moved { rig, lamp, _ -> rig.world(lamp) }.assertMistake(Mistake.TO_LIGHT_WORLD)
    }

    @Test
    fun `local positions that never went through the view`() {
        moved { _, lamp, _ -> Vector3d(lamp.body.getPosition()) }.assertMistake(Mistake.TO_LIGHT_WORLD)
    }

    @Test
    fun `positions that went through the view twice`() {
        moved { rig, lamp, view -> view.transformPosition(view.transformPosition(rig.world(lamp))) }.assertMistake(Mistake.TO_LIGHT_WORLD)
    }

    @Test
    fun `positions that are turned like directions`() {
        moved { rig, lamp, view -> view.transformDirection(rig.world(lamp)) }.assertMistake(Mistake.TO_LIGHT_WORLD)
    }

    @Test
    fun `positions that went through the camera's matrix`() {
        moved { rig, lamp, view -> view.invert(Matrix4d()).transformPosition(rig.world(lamp)) }.assertMistake(Mistake.TO_LIGHT_WORLD)
    }

    @Test
    fun `positions that went through the view matrix of the first picture`() {
        var first: Matrix4d? = null
        val verdict = moved { rig, lamp, view -> (first ?: Matrix4d(view).also { first = it }).transformPosition(rig.world(lamp)) }
        verdict.assertMistake(Mistake.TO_LIGHT_WORLD)
        assertTrue("place.first-view" in verdict[Check.POINT_LIGHT_POSITION]?.text.orEmpty(), verdict.text())
    }

    @Test
    fun `positions that stand to the left of the view matrix`() {
        moved { rig, lamp, view -> view.transpose(Matrix4d()).transformDirection(rig.world(lamp)) }.assertMistake(Mistake.TO_LIGHT_WORLD)
    }

    @Test
    fun `further lights that only move when the mouse turns the camera`() {
        val rig = object : Rig() {
            override fun position(lamp: Lamp, view: Matrix4d) =
                super.position(lamp, view).run { if (lamp in corners) mul(1.0, 1.0, -1.0) else this }
        }
        rig.verdict().assertMistake(Mistake.UNKNOWN, Check.POINT_LIGHT_POSITION)
    }

    @Test
    fun `one light that is fixed to the camera, which may be its parent`() {
        val rig = object : Rig() {
            override fun position(lamp: Lamp, view: Matrix4d) = if (lamp === own) Vector3d(0.0, 1.0, -2.0) else super.position(lamp, view)
        }
        val verdict = rig.verdict()
        verdict.assertMistake(Mistake.TO_LIGHT_WORLD)
        assertEquals(listOf(Mistake.LIGHT_NOT_CHILD), verdict.mistakes.single().alternatives)
    }

    @Test
    fun `local positions beside a camera that nobody can turn`() {
        val rig = object : Rig() {
            override val lamps get() = listOf(own, head)

            override fun orbit(dx: Double, dy: Double) = Unit

            override fun position(lamp: Lamp, view: Matrix4d) = Vector3d(lamp.body.getPosition())
        }
        val verdict = rig.verdict()
        assertTrue(verdict[Mistake.TO_LIGHT_WORLD] != null, verdict.text())
        assertTrue((verdict[Check.POINT_LIGHT_POSITION]?.error ?: 0.0) > 0.5, verdict.text())
    }

    @Test
    fun `a position that never arrives is explained by its name`() {
        val rig = object : Rig() {
            override fun position(lamp: Lamp, view: Matrix4d) = if (lamp === own) Vector3d() else super.position(lamp, view)
        }
        val events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, -1, "lightPositon"))
        val verdict = rig.verdict(events = events, uniforms = setOf("lightPosition"))
        assertEquals(Mistake.UNIFORM_ABSENT, verdict.mistakes.first().mistake, verdict.text())
        verdict.assertCosts(Check.POINT_LIGHT_POSITION)
    }

    @ParameterizedTest
    @ValueSource(doubles = [1.02, 0.98, 22.0])
    fun `a colour that is multiplied at each picture again keeps no strength`(factor: Double) {
        val color = Vector3d(9.0, 0.0, 0.0)
        val rig = object : Rig() {
            override val lamps =
                listOf(own, head) + Lamp("grown", corners[0].body, POINT_K) { Vector3d(color.mul(factor)) } + corners.drop(1)
        }
        val verdict = rig.verdict()
        verdict.assertMistake(Mistake.UNKNOWN, Check.MORE_LIGHTS)
        assertEquals("grown", verdict.mistakes.single().where)
    }

    @Test
    fun `a light that is sent and that no shader draws with is missing, and no other one is taken for it`() {
        open class Rest : Rig() {
            override val lamps =
                listOf(head, Lamp("near", lamp(Vector3f(2f, 1f, 2f), null), POINT_K) { Vector3d(3.0, 2.0, 1.0) }) + corners
        }
        // With nothing sent beside, the nearest one is the one that was meant.
        assertTrue(Rest().verdict()[Mistake.LIGHT_NOT_CHILD]?.where == "near")
        val rig = object : Rest() {
            override fun frame(moment: Moment, t: Double) = super.frame(moment, t).run {
                ObservedFrame(moment, t, view, projection, objects, lights, listOf(observed(own, t, Matrix4d(view))))
            }
        }
        rig.verdict().assertMistake(Mistake.LIGHT_MISSING, *allOfPoint)
    }

    @Test
    fun `numbers sent beside an array are missed by the element that waits for them, however many lights are left`() {
        val events = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "lampColors[-1]"))
        val waiting = ProgramFacts(setOf("lampColors[3]"))
        val verdict = Rig().verdict(events = events, uniforms = setOf("lampColors[3]"), program = waiting)
        verdict.assertMistake(Mistake.UNIFORM_ABSENT, Check.MORE_LIGHTS)
        // An array may be shorter than what is sent to it, where its own elements have all they need.
        assertEquals(
            emptyList<Mistake>(),
            Rig().verdict(events = events, program = ProgramFacts(setOf("other[3]"))).mistakes.map { it.mistake },
        )
    }

    @Test
    fun `the spotlight's position in the point light's uniform`() {
        val rig = object : Rig() {
            override fun position(lamp: Lamp, view: Matrix4d) = super.position(if (lamp === own) head else lamp, view)
        }
        rig.verdict().assertMistake(Mistake.LIGHT_POSITION_OVERWRITTEN)
    }

    @Test
    fun `both lights at one place are chosen where each is sent by itself, and overwritten where one was sent twice`() {
        fun rig(events: List<CapturedEvent>) =
            object : Rig() {
                override fun position(lamp: Lamp, view: Matrix4d) = super.position(if (lamp === own) head else lamp, view)

                override fun lights(moment: Moment, t: Double, view: Matrix4d) =
                    super.lights(moment, t, view).map { ObservedLight(it.name, it.position, it.color, it.k, it.spot, "${it.name}.place") }
            }.verdict(events = events)
        rig(emptyList()).assertRight()
        rig(listOf(CapturedEvent(EventKind.UNIFORM_OVERWRITTEN, 0, "bike_lamp.place"))).assertMistake(Mistake.LIGHT_POSITION_OVERWRITTEN)
    }

    @Test
    fun `the spotlight sends its place, its colour and perhaps its K under the point light's names, too`() {
        fun rig(k: Boolean) = object : Rig() {
            override fun lights(moment: Moment, t: Double, view: Matrix4d): List<ObservedLight> {
                val all = super
                    .lights(
                        moment,
                        t,
                        view,
                    ).map { ObservedLight(it.name, it.position, it.color, it.k, it.spot, "${it.name}.place") }
                val spot = all.single { it.spot != null }
                return all.map {
                    if (it.name ==
                        own.name
                    ) {
                        ObservedLight(it.name, spot.position, spot.color, if (k) spot.k else it.k, null, it.placedBy)
                    } else {
                        it
                    }
                }
            }
        }
        val events = listOf(CapturedEvent(EventKind.UNIFORM_OVERWRITTEN, 0, "bike_lamp.place"))
        rig(k = false).verdict(events = events).assertMistake(Mistake.LIGHT_POSITION_OVERWRITTEN)
        rig(k = true).verdict(events = events).assertMistake(Mistake.LIGHT_POSITION_OVERWRITTEN)
    }

    @Test
    fun `a further light that is sent under all of the motorcycle's names leaves none of it`() {
        fun rig() = object : Rig() {
            override val lamps get() = listOf(head) + corners

            override fun lights(moment: Moment, t: Double, view: Matrix4d) =
                super.lights(moment, t, view).map { ObservedLight(it.name, it.position, it.color, it.k, it.spot, "${it.name}.place") }
        }
        val events = listOf(CapturedEvent(EventKind.UNIFORM_OVERWRITTEN, 0, "corner[0].place"))
        rig().verdict(events = events).assertMistake(Mistake.LIGHT_POSITION_OVERWRITTEN, *allOfPoint)
        rig().verdict().assertMistake(Mistake.LIGHT_MISSING, *allOfPoint)
    }

    @Test
    fun `lights that nobody moved are at one place without one position for all`() {
        fun rig(place: Vector3d) =
            object : Rig() {
                override fun position(lamp: Lamp, view: Matrix4d) =
                    if (lamp in corners) view.transformPosition(Vector3d(place)) else super.position(lamp, view)

                override fun lights(moment: Moment, t: Double, view: Matrix4d) =
                    super.lights(moment, t, view).map { ObservedLight(it.name, it.position, it.color, it.k, it.spot, "${it.name}.place") }
            }.verdict()
        rig(Vector3d()).assertMistake(Mistake.MORE_LIGHTS_ALIKE)
        assertTrue(rig(Vector3d(5.0, 1.0, 5.0))[Mistake.LIGHT_POSITION_OVERWRITTEN] != null)
    }

    @Test
    fun `a corner's position in the point light's uniform`() {
        val rig = object : Rig() {
            override fun position(lamp: Lamp, view: Matrix4d) = super.position(if (lamp === own) corners.last() else lamp, view)
        }
        rig.verdict().assertMistake(Mistake.LIGHT_POSITION_OVERWRITTEN)
    }

    @Test
    fun `a headlight that hangs on the camera is no child of the motorcycle, if its place went through the view`() {
        fun rig(isViewed: Boolean) =
            object : Rig() {
                override fun position(lamp: Lamp, view: Matrix4d) =
                    if (lamp === head) Vector3d(0.0, 1.0, -2.0) else super.position(lamp, view)

                override fun direction(lamp: Lamp, view: Matrix4d) = Vector3d(0.0, 0.0, -1.0)

                override fun lights(moment: Moment, t: Double, view: Matrix4d) =
                    super.lights(moment, t, view).map { ObservedLight(it.name, it.position, it.color, it.k, it.spot, "place", isViewed) }
            }.verdict()
        rig(isViewed = true).assertMistake(Mistake.SPOT_NOT_CHILD)
        assertTrue(rig(isViewed = false)[Mistake.TO_LIGHT_WORLD] != null)
    }

    @Test
    fun `where every light has a cone the motorcycle's is the narrow one that keeps its colour`() {
        val rig = object : Rig() {
            override val lamps = listOf(wide(own), head) + corners.map(::wide)

            private fun wide(lamp: Lamp) = Lamp(lamp.name, lamp.body, lamp.k, 1.0, 2.0, isSpot = true, lamp.color)
        }
        val verdict = rig.verdict()
        assertEquals(emptyList<Mistake>(), verdict.mistakes.map { it.mistake }, verdict.text())
        verdict.assertCosts(Check.POINT_LIGHT)
    }

    @Test
    fun `one further light that is sent four times is no position overwritten`() {
        val rig = object : Rig() {
            override val lamps = listOf(own, head) + corners.map { Lamp(it.name, corners[0].body, it.k, color = corners[0].color) }

            override fun lights(moment: Moment, t: Double, view: Matrix4d) =
                super.lights(moment, t, view).map { ObservedLight(it.name, it.position, it.color, it.k, it.spot, "${it.name}.place") }
        }
        rig.verdict().assertMistake(Mistake.MORE_LIGHTS_ALIKE)
    }

    @Test
    fun `no further lights, one, several of one colour, several at one place`() {
        fun with(vararg further: Lamp) =
            object : Rig() {
                override val lamps get() = listOf(own, head) + further
            }.verdict()

        fun red(x: Float) = Lamp("red at $x", Rig.lamp(Vector3f(x, 1f, 9f), null), Rig.POINT_K) { Vector3d(x + 0.0, 0.0, 0.0) }

        fun blue(x: Float) = Lamp("blue at $x", Rig.lamp(Vector3f(x, 1f, 9f), null), Rig.POINT_K) { Vector3d(0.0, 0.0, 1.0) }
        with().assertMistake(Mistake.MORE_LIGHTS_MISSING, least = 1.0)
        with(red(9f)).assertMistake(Mistake.MORE_LIGHTS_MISSING, least = 0.5)
        with(red(9f), red(4f)).assertMistake(Mistake.MORE_LIGHTS_ALIKE, least = 0.5)
        with(red(9f), blue(4f)).assertRight()
        val samePlace = with(red(9f), blue(9f))
        assertEquals(0.5, samePlace[Check.MORE_LIGHTS]?.error, samePlace.text())
    }

    /** Of a scene whose light positions in view space are what [place] says. */
    private fun moved(place: (Rig, Lamp, Matrix4d) -> Vector3d): SceneVerdict {
        val rig = object : Rig() {
            override fun position(lamp: Lamp, view: Matrix4d) = place(this, lamp, view)
        }
        return rig.verdict()
    }
}
