package cga.exercise.components.geometry

import org.joml.Vector3f

// JOML changes its vectors in place, these do not

operator fun Vector3f.component1() = x
operator fun Vector3f.component2() = y
operator fun Vector3f.component3() = z

operator fun Vector3f.times(factor: Float): Vector3f = mul(factor, Vector3f())
operator fun Vector3f.unaryMinus(): Vector3f = negate(Vector3f())

/** 0xRRGGBB as a colour between 0 and 1. */
fun rgb(hex: Int) = Vector3f((hex shr 16 and 0xFF) / 255f, (hex shr 8 and 0xFF) / 255f, (hex and 0xFF) / 255f)

/** `45.degrees`, in radians. */
val Int.degrees: Float get() = Math.toRadians(toDouble()).toFloat()
