package cga.reference

import cga.framework.Frame
import cga.framework.FrameMaterial
import org.joml.Vector2d
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * From a triangle and a point of the window to a colour: interpolation, textures, lighting. Each thread has its own.
 *
 * @param spacing distance between samples, in pixels: what the change of texture coordinates from one pixel to the next is multiplied with.
 */
public class FragmentShader(
    frame: Frame,
    private val triangles: Triangles,
    private val spacing: Double = 1.0,
) {
    private val lighting = Lighting(frame)
    private val surfaces = frame.draws.map { Surface(it.material, Vector3d(it.tint)) }
    private val projected = Projected()
    private var number = ReferencePicture.NO_SURFACE

    public fun newPoint(): ShadedPoint = lighting.newPoint()

    /** Fills [point] with what triangle [number] shows at the window point ([x], [y]), which it covers. */
    public fun shade(
        number: Int,
        x: Double,
        y: Double,
        point: ShadedPoint,
    ) {
        if (number != this.number) projected.look(triangles, number)
        this.number = number
        projected.at(x, y)
        interpolate(point)
        val surface = surfaces[point.draw]
        surface.look(point)
        lighting.shade(point, surface.tint, surface.shininess)
    }

    private fun interpolate(point: ShadedPoint) {
        point.draw = triangles.draw(number)
        point.triangle = triangles.numberInDraw(number)
        point.depth = projected.depth
        val i0 = triangles.corner(number, 0)
        val i1 = triangles.corner(number, 1)
        val i2 = triangles.corner(number, 2)
        val vertices = triangles.vertices(number)
        val b0 = projected.b0
        val b1 = projected.b1
        val b2 = projected.b2
        mix(vertices.position, i0, i1, i2, b0, b1, b2, point.position)
        mix(vertices.normal, i0, i1, i2, b0, b1, b2, point.normal)
        mix(vertices.texCoord, i0, i1, i2, b0, b1, b2, point.texCoord)
        mix(vertices.texCoord, i0, i1, i2, projected.b0dx, projected.b1dx, projected.b2dx, point.texCoordDx).mul(spacing)
        mix(vertices.texCoord, i0, i1, i2, projected.b0dy, projected.b1dy, projected.b2dy, point.texCoordDy).mul(spacing)
    }

    /** Σ b_i·f_i of three-component data. */
    private fun mix(
        data: DoubleArray,
        i0: Int,
        i1: Int,
        i2: Int,
        b0: Double,
        b1: Double,
        b2: Double,
        dest: Vector3d,
    ) {
        dest.x = b0 * data[3 * i0] + b1 * data[3 * i1] + b2 * data[3 * i2]
        dest.y = b0 * data[3 * i0 + 1] + b1 * data[3 * i1 + 1] + b2 * data[3 * i2 + 1]
        dest.z = b0 * data[3 * i0 + 2] + b1 * data[3 * i1 + 2] + b2 * data[3 * i2 + 2]
    }

    /** The same of two-component data. */
    private fun mix(
        data: DoubleArray,
        i0: Int,
        i1: Int,
        i2: Int,
        b0: Double,
        b1: Double,
        b2: Double,
        dest: Vector2d,
    ): Vector2d {
        dest.x = b0 * data[2 * i0] + b1 * data[2 * i1] + b2 * data[2 * i2]
        dest.y = b0 * data[2 * i0 + 1] + b1 * data[2 * i1 + 1] + b2 * data[2 * i2 + 1]
        return dest
    }

    /** The material of a draw, ready to be sampled. */
    private class Surface(
        material: FrameMaterial,
        val tint: Vector3dc,
    ) {
        private val emissive = TextureSampler(material.emissive)
        private val diffuse = TextureSampler(material.diffuse)
        private val specular = TextureSampler(material.specular)
        val shininess = material.shininess.toDouble()

        /** Reads M_e, M_d and M_s. */
        fun look(point: ShadedPoint) {
            emissive.sample(point.texCoord, point.texCoordDx, point.texCoordDy, point.emissive)
            diffuse.sample(point.texCoord, point.texCoordDx, point.texCoordDy, point.diffuse)
            specular.sample(point.texCoord, point.texCoordDx, point.texCoordDy, point.specular)
        }
    }
}
