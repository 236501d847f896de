package cga.inspect.knob

import org.joml.Vector3fc

/** [vector] as Kotlin code. */
internal fun literal(vector: Vector3fc): String = "Vector3f(${literal(vector.x())}, ${literal(vector.y())}, ${literal(vector.z())})"

/** [number] as Kotlin code: Kotlin's own text of a Float, which is read back as the same number. */
internal fun literal(number: Float): String = "${number}f"
