package cga.grading.sheet4.scene

import cga.exercise.game.Step
import cga.grading.capture.CapturedEvent
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.GroundSpace
import cga.grading.scene.ObservedFrame
import cga.grading.scene.ObservedObject
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Test

/** Submissions that send model-view matrices only: view and model cannot be told apart, and the observation has no view. */
class GroundSpaceTest {
    private val noEvents = emptyList<CapturedEvent>()

    @Test
    fun `the reference without its view has no mistake`() {
        SceneJudge.judge(withoutView(OwnScene.play(Step.FINAL)), noEvents).assertRight(tolerance = 2e-5)
    }

    @Test
    fun `a scaled ground, and one that was modelled standing`() {
        val turned = Matrix4d().rotateX(-Math.PI / 2)
        for (model in listOf(Matrix4d().scale(3.0), turned, Matrix4d().rotateX(Math.PI / 2), Matrix4d().rotateZ(Math.PI / 2))) {
            SceneJudge.judge(withoutView(onGround(Rig(), model)), noEvents).assertRight()
        }
    }

    @Test
    fun `mistakes keep their names`() {
        val own = object : Rig() {
            override fun orbit(dx: Double, dy: Double) = camera.rotateLocal(0f, (0.002 * dx).toFloat(), 0f)
        }
        judged(own).assertMistake(Mistake.ORBIT_OWN_AXIS)
        val pivot = object : Rig() {
            override fun orbit(dx: Double, dy: Double) =
                camera.rotateAroundPoint(0f, (0.002 * dx).toFloat(), 0f, motorcycle.getWorldPosition())
        }
        judged(pivot).assertMistake(Mistake.ORBIT_PIVOT)
        val free = object : Rig() {
            val free = Lamp("lamp", lamp(Vector3f(0f, 1.5f, 0f), null), POINT_K) { ownColor(it) }
            override val lamps get() = listOf(free, head) + corners
        }
        judged(free).assertMistake(Mistake.LIGHT_NOT_CHILD)
        val world = object : Rig() {
            override fun position(lamp: Lamp, view: Matrix4d) = world(lamp)
        }
        judged(world).assertMistake(Mistake.TO_LIGHT_WORLD)
        judged(Rig(Vector3f())).assertMistake(Mistake.LIGHT_IN_GROUND)
    }

    @Test
    fun `a view that undoes the motorcycle's scale is seen by what it does to the ground`() {
        val rig = object : Rig() {
            override fun view() = camera.getWorldModelMatrix(Matrix4d()).invert()

            override fun direction(lamp: Lamp, view: Matrix4d) = super.direction(lamp, view).normalize()
        }
        val verdict = judged(rig)
        verdict.assertMistake(Mistake.VIEW_SCALED)
        assertEquals(0.25, verdict[Check.POINT_LIGHT_POSITION]?.error ?: 0.0, 1e-4, verdict.text())
    }

    @Test
    fun `frames that have a view are left alone`() {
        val frames = Rig().play()
        assertSame(frames, GroundSpace.settle(frames))
    }

    private fun judged(rig: Rig) = SceneJudge.judge(withoutView(rig.play()), noEvents)

    private fun withoutView(frames: List<ObservedFrame>): List<ObservedFrame> =
        frames.map { frame ->
            val objects =
                frame.objects.map { ObservedObject(Matrix4d(frame.view).mul(it.model), it.tint, it.lights, it.vertices, it.buffers) }
            ObservedFrame(frame.moment, frame.time, Matrix4d(), frame.projection, objects, frame.lights)
        }

    /** With a ground whose vertices were turned and scaled the other way before, so that it lies as it did. */
    private fun onGround(
        rig: Rig,
        model: Matrix4d,
    ): List<ObservedFrame> {
        val inverse = Matrix4d(model).invert()
        return rig.play().map { frame ->
            val objects =
                frame.objects.map { shown ->
                    val points = shown.vertices.toList().chunked(3).map { (x, y, z) -> Vector3d(x + 0.0, y + 0.0, z + 0.0) }
                    val vertices = points
                        .map(
                            inverse::transformPosition,
                        ).flatMap { listOf(it.x.toFloat(), it.y.toFloat(), it.z.toFloat()) }
                        .toFloatArray()
                    if (0 in shown.buffers) ObservedObject(model, shown.tint, shown.lights, vertices, shown.buffers) else shown
                }
            ObservedFrame(frame.moment, frame.time, frame.view, frame.projection, objects, frame.lights)
        }
    }
}
