package cga.grading.likeness

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Test

class CodeShapeTest {
    private fun kotlin(code: String) = CodeShape.of(code, optional = ";,", without = setOf("package", "import"))

    @Test
    fun `names, blanks, imports and the way a number is written are taken away`() {
        val one = "package a\nimport b.c\nimport b.d\nval x = f(1, 0.50f) + arr[2]\n"
        val other = "package other.place\n\nval\n  größe =\tlicht( 1.0,.5 , ) + list [ 2 ];"
        assertEquals(kotlin(one), kotlin(other))
        assertEquals(kotlin("class A { }"), kotlin("package a ; import b.c; class B { }"))
        assertEquals(CodeShape.of("v = n.5 * a.x;"), CodeShape.of("  w=m .50\n*\nb . y ;"))
    }

    @Test
    fun `another number, sign or order is another shape`() {
        val shape = kotlin("val x = f(1.0) + a * b")
        for (other in listOf("val x = f(1.5) + a * b", "val x = f(1.0) - a * b", "val x = a * b + f(1.0)", "val x = f(-1.0) + a * b")) {
            assertNotEquals(shape, kotlin(other), other)
        }
        assertNotEquals(kotlin("f(1, 2)"), kotlin("f(12)"))
    }

    @Test
    fun `what is no number is what it is`() = assertEquals("1.0 0x1G 1.0 ..3.0 ", CodeShape.of("1 0x1G 1.0f .. 3"))
}
