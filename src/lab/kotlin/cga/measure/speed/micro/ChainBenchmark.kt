package cga.measure.speed.micro

import cga.exercise.components.geometry.Transformable
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.openjdk.jmh.annotations.Benchmark
import org.openjdk.jmh.annotations.Param
import org.openjdk.jmh.annotations.Scope
import org.openjdk.jmh.annotations.Setup
import org.openjdk.jmh.annotations.State

/** The world matrix of the last of a chain of parents. */
@State(Scope.Thread)
public open class ChainBenchmark {
    /** So many [Transformable]s, one the parent of the next. */
    @Param("1", "10", "100", "1000")
    public var length: Int = 0

    private lateinit var last: Transformable
    private val world = Matrix4d()

    @Setup
    public fun build() {
        last = Transformable(Matrix4f())
        repeat(length - 1) { last = Transformable(Matrix4f().rotateY(0.01f).translate(0.1f, 0f, 0f), last) }
    }

    /** In double precision, into a matrix that is there: as the frame loop does it. */
    @Benchmark
    public fun worldModelMatrix(): Matrix4d = last.getWorldModelMatrix(world)

    /** In the course's form: a new matrix of floats. */
    @Benchmark
    public fun newWorldModelMatrix(): Matrix4f = last.getWorldModelMatrix()
}
