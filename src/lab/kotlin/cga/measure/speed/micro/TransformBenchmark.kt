package cga.measure.speed.micro

import cga.exercise.components.geometry.NormalMatrix
import cga.exercise.components.geometry.Transformable
import org.joml.Matrix3f
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector3f
import org.openjdk.jmh.annotations.Benchmark
import org.openjdk.jmh.annotations.Scope
import org.openjdk.jmh.annotations.State

/** What a frame does with a [Transformable] that stands alone; each method is one operation. */
@State(Scope.Thread)
public open class TransformBenchmark {
    private val moved = Transformable()
    private val step = Vector3f(1e-3f, 0f, 0f)
    private val back = Vector3f(-1e-3f, 0f, 0f)
    private val point = Vector3f(1f, 2f, 3f)
    private val grow = Vector3f(1.25f)
    private val shrink = Vector3f(0.8f)
    private val placed = Matrix4f().rotateXYZ(0.1f, 0.2f, 0.3f).setTranslation(4f, 5f, 6f)
    private val modelView = Matrix4d().rotateXYZ(0.1, 0.2, 0.3).scale(0.8)
    private val normalMatrix = NormalMatrix()
    private val normals = Matrix3f()
    private val modelViewFloat = Matrix4f(modelView)

    /** There and back, so that the matrix stays what it is: two operations. */
    @Benchmark
    public fun translateLocalTwice(): Transformable {
        moved.translateLocal(step)
        moved.translateLocal(back)
        return moved
    }

    @Benchmark
    public fun rotateLocalTwice(): Transformable {
        moved.rotateLocal(0.001f, 0.002f, 0.003f)
        moved.rotateLocal(-0.001f, -0.002f, -0.003f)
        return moved
    }

    @Benchmark
    public fun rotateAroundPointTwice(): Transformable {
        moved.rotateAroundPoint(0.001f, 0.002f, 0.003f, point)
        moved.rotateAroundPoint(-0.001f, -0.002f, -0.003f, point)
        return moved
    }

    @Benchmark
    public fun scaleLocalTwice(): Transformable {
        moved.scaleLocal(grow)
        moved.scaleLocal(shrink)
        return moved
    }

    @Benchmark
    public fun setLocalModelMatrix(): Transformable {
        moved.setLocalModelMatrix(placed)
        return moved
    }

    @Benchmark
    public fun normalMatrix(): Matrix3f = normalMatrix.of(modelView, normals)

    /** The usual way, for comparison: JOML's inverse transpose in floats. */
    @Benchmark
    public fun normalMatrixOfJoml(): Matrix3f = modelViewFloat.normal(normals)
}
