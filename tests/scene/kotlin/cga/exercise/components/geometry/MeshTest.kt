package cga.exercise.components.geometry

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Test

class MeshTest {
    @Test
    fun `it is made and thrown away without OpenGL`() {
        val vertices = floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f)
        val indices = intArrayOf(0, 1, 2)
        val mesh = Mesh(vertices, indices, arrayOf(VertexAttribute(3, 12, 0)))
        assertSame(vertices, mesh.vertexdata)
        assertSame(indices, mesh.indexdata)
        assertNull(mesh.material)
        // Any OpenGL call here would end the test: there is no context.
        mesh.cleanup()
    }

    @Test
    fun `an attribute keeps what it is told`() {
        val attribute = VertexAttribute(2, 32, 12)
        assertEquals(listOf(2, 32, 12), with(attribute) { listOf(n, stride, offset) })
    }
}
