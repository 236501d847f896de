package cga.exercise.components.geometry

import org.joml.Math.toRadians

fun <T : Transformable> T.attachedTo(newParent: Transformable): T = apply { parent = newParent }

fun <T : Transformable> T.tilted(degrees: Float): T = apply { rotateLocal(toRadians(degrees), 0.0f, 0.0f) }
